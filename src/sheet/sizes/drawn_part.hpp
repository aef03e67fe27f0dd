// SPDX-License-Identifier: Apache-2.0
// A part with what a sheet draws beside its faces: pitch circles, planes of symmetry through centre lines, and
// hexagons.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "definition/rules.hpp"
#include "sizes/coverage.hpp"

namespace epura::sheet {

struct DrawnPart {
  definition::Part part;  ///< what is only drawn follows the faces of the model
  std::size_t faces;      ///< of the model
  definition::Marks marks;
};

/// A diameter through the axes of two or more faces is a pitch circle. Planes that are equally far from the axis of a
/// round part, whose centre line the sheet draws, are symmetrical to it; so are those nearest to where a length ends
/// amid faces without having a face there. Three pairs of planes of one width about one axis, at 60 degrees to each
/// other, are a hexagon.
DrawnPart with_drawn_lines(definition::Part part, std::span<const DimensionsInView> views,
                           std::span<const features::Extent, 3> extents);

/// Each face is compared with each other one.
inline constexpr std::size_t most_faces = 10'000;

/// The only model of a world with what is drawn beside its faces, none of which are drawn if it has more than
/// `most_faces`; what is drawn parallel is parallel. Walls of letters, which are given by their text, are of free form.
/// Nothing for an assembly, and without recognised faces.
std::optional<DrawnPart> part_on_sheets(std::span<const DimensionsInView> views, const world::World& world,
                                        std::span<const features::Extent, 3> extents);

/// How far apart what is the same on a drawing may be.
double slack_of(const definition::Part& part);

}  // namespace epura::sheet
