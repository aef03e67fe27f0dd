// SPDX-License-Identifier: Apache-2.0
// T-junctions: where a contour passes behind another one.
//
// Facets decide what is visible, but contours are drawn on the surface. Two that cross at a small angle, as near a
// cusp, cross there up to some facets away from where those of the facets do. What is visible of the one behind ends
// where both cross as they are drawn.
#pragma once

#include <array>
#include <vector>

#include "drawing/ink.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

/// Which ends of a piece are where they belong.
using SettledEnds = std::array<bool, 2>;

/// Moves the change between visible and hidden along contours to the visible contours that hide them. Pieces are in the
/// order of edges and of their places on them, with the hidden ones of moved contours, and stay so. Returns which ends
/// are settled, by piece.
std::vector<SettledEnds> move_t_junctions(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                          std::vector<Piece>& pieces);

}  // namespace epura::drawing
