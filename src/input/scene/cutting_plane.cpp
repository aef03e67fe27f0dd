// SPDX-License-Identifier: Apache-2.0
#include "scene/cutting_plane.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"

namespace epura::scene {

std::optional<Vec3> parse_vector(std::string_view text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  const Vec3 vector((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  return is_usable(vector) ? std::optional(vector) : std::nullopt;
}

CuttingPlane make_cutting_plane(const SectionDescription& section) {
  const std::string& where = section.name.where;
  if (!finite(section.point) || !finite(section.normal))
    throw Error(ErrorKind::input, where, "has a number that is not finite");
  const Vec3 size = glm::abs(section.normal);
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0)) throw Error(ErrorKind::input, where, "the normal has no direction", "0,-1,0 removes the front");
  const Vec3 normal = glm::normalize(section.normal / largest);
  // The axis that is closest to the plane: if the normal is along an axis, so are the directions in the plane.
  Vec3 axis(0);
  axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
  const Vec3 right = glm::normalize(glm::cross(axis, normal));
  return {section.point, normal, right, glm::cross(normal, right), *section.name, where};
}

SectionDescription parse_section(std::string_view text, const std::string& where) {
  const auto parts = split(text, ':');
  const auto point = parts.size() == 2 ? parse_vector(parts[0]) : std::nullopt;
  const auto normal = parts.size() == 2 ? parse_vector(parts[1]) : std::nullopt;
  if (!point || !normal)
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a cutting plane",
                "write a point and a normal, X,Y,Z:NX,NY,NZ; the side that the normal points to is removed");
  return {{"A", where}, *point, *normal};
}

}  // namespace epura::scene
