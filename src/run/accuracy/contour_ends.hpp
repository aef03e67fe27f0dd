// SPDX-License-Identifier: Apache-2.0
// How far contours of facets may end from where those of the surfaces do.
#pragma once

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

/// Returns the largest distance on paper, mm, of contours that are drawn in their places on the mesh.
double off_at_cusps(const ViewToJudge& judged);

}  // namespace epura::accuracy
