// SPDX-License-Identifier: Apache-2.0
// The cutting plane of a section.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "scene/description.hpp"

namespace epura::scene {

/// The side to which the normal points is removed.
struct CuttingPlane {
  Vec3 point;
  Vec3 normal;        ///< unit normal
  Vec3 right, up;     ///< directions in the plane: right x up = normal
  std::string name;   ///< "A"
  std::string where;  ///< location of its description, for errors
};

/// Parses "X,Y,Z"; nothing if it is not three numbers.
std::optional<Vec3> parse_vector(std::string_view text);

/// Throws Error{input} for a zero normal and for numbers that are not finite.
CuttingPlane make_cutting_plane(const SectionDescription& section);

/// Parses "X,Y,Z:NX,NY,NZ": a point of the plane and its normal. Throws Error{input} with `where` as the location.
SectionDescription parse_section(std::string_view text, const std::string& where);

}  // namespace epura::scene
