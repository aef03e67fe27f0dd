// SPDX-License-Identifier: Apache-2.0
// How far contours may end, or begin to be seen, from where those of the surfaces do.
#pragma once

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

/// Returns the largest distance on paper, mm.
double off_at_ends_of_contours(const ViewToJudge& judged);

}  // namespace epura::accuracy
