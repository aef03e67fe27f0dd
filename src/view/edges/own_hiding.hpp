// SPDX-License-Identifier: Apache-2.0
// Where a recognised surface hides its own contours (Koenderink: What does the occluding contour tell us about solid
// shape?, Perception 13, 1984).
#pragma once

#include <array>

#include "edges/find_edges.hpp"
#include "surfaces/recognise.hpp"

namespace epura::edges {

/// Whether a surface is a torus that does not meet itself. What bends inwards of another torus is recognised by chance:
/// nearly a sphere.
bool is_ring_torus(const surfaces::PartSurface& surface);

/// Sets FeatureEdge::hollow and clear of a contour on a face of a solid, drawn between two places. `views` are the
/// directions towards the viewer there, of unit length. Where the surface bends away from the viewer along the
/// projector, it hides its own contour; where it bends like a ball, it lies behind it as far as the projector does not
/// meet it again: a tangent of a sphere never does, one of a torus up to twice.
void judge_own_hiding(const surfaces::PartFace& face, const std::array<Vec3, 2>& ends, const std::array<Vec3, 2>& views,
                      FeatureEdge& contour);

}  // namespace epura::edges
