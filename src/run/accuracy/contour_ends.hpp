// SPDX-License-Identifier: Apache-2.0
// How far contours of triangles may end from where those of the unknown surfaces do.
#pragma once

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

/// Returns the largest distance on paper, mm, of contours of models without recognised faces.
double off_at_cusps(const ViewToJudge& judged);

}  // namespace epura::accuracy
