// SPDX-License-Identifier: Apache-2.0
// The plane of a section.
#pragma once

#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "scene/description.hpp"

namespace epura::scene {

/// The side that the normal points to is removed.
struct CuttingPlane {
  Vec3 point;
  Vec3 normal;        ///< of length 1
  Vec3 right, up;     ///< directions in the plane: right x up = normal
  std::string name;   ///< "A"
  std::string where;  ///< it was described, for errors
};

/// Throws Error{input} for a normal that is not a direction and for numbers that are not finite.
CuttingPlane make_cutting_plane(const SectionDescription& section);

/// "X,Y,Z:NX,NY,NZ": a point of the plane and its normal. Throws Error{input} that names `where` the text comes from.
SectionDescription parse_section(std::string_view text, const std::string& where);

}  // namespace epura::scene
