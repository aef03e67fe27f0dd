// SPDX-License-Identifier: Apache-2.0
// Cylinders seen along their axes: on paper, each is one circle, which all its rims draw.
//
// Two rims with different facets draw polygons that peep out from behind each other, by as much as the circle rises
// over their chords; so do contours of facets between them. At each angle, one of them is drawn: visible ones before
// hidden ones, rims before contours, and the longest first.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

/// Removes what is drawn twice. Remainders shorter than `least` mm are dropped. Returns within which distance of what
/// was removed there is ink, mm. Throws OutOfTime.
double draw_circles_once(const visibility::ResolvedView& lines, const view::PaperMap& paper, double least,
                         std::vector<Piece>& pieces, const Progress& progress = {});

}  // namespace epura::drawing
