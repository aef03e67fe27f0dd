// SPDX-License-Identifier: Apache-2.0
// Finds contours that are drawn away from their faces.
//
// Contours of curved faces are drawn on the surface, beside their edges of the mesh (edges/smooth_contours.hpp),
// whereas the other tests judge lines where they are in the mesh. This one judges them where they are drawn, from
// triangles alone: a contour must lie over the facets around its edge, as near as these are to a surface that bends as
// they do.
#pragma once

#include "base/progress.hpp"
#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// Adds to the findings, as unfounded, the parts of contours that leave the facets of their faces. The drawing of
/// `input` must be the one that the user gets. Throws OutOfTime.
void add_stray_contours(const VerifyInput& input, const Tolerance& tolerance, report::OutlineCheck& check,
                        const Progress& progress = {});

}  // namespace epura::verify
