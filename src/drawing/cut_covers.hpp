// SPDX-License-Identifier: Apache-2.0
// Cut faces of bodies that overlap, as a screw of its full diameter in the core of its hole: the smaller one, which is
// inserted, covers the larger one. ISO 6410-1.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Numbers of two cut faces that overlap by more than 0.1 mm on paper.
struct CoveredFace {
  std::size_t covered, covering;
};

/// In order of the covered ones.
std::vector<CoveredFace> covered_faces(std::span<const CutFace> faces);

/// The area of a face.
std::vector<PaperTriangle> triangles_of(const CutFace& face);

/// The parts of a line that are inside a face by more than 0.1 mm, as parameters from 0 to 1, ascending.
std::vector<std::array<double, 2>> parts_inside(const CutFace& face, const Vec2& from, const Vec2& to);

}  // namespace epura::drawing
