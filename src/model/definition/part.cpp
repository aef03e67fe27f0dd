// SPDX-License-Identifier: Apache-2.0
#include "definition/part.hpp"

#include <cstddef>
#include <utility>

#include "definition/limits.hpp"

namespace epura::definition {

namespace {

using surfaces::SurfaceKind;

bool has_direction(SurfaceKind kind) { return kind == SurfaceKind::plane || surfaces::has_axis(kind); }

int find_or_add(Directions& found, const Vec3& direction, int face) {
  for (std::size_t i = 0; i < found.directions.size(); ++i)
    if (glm::length(glm::cross(found.directions[i], direction)) <= drawn_parallel) return static_cast<int>(i);
  found.directions.push_back(direction);
  found.first_face.push_back(face);
  return static_cast<int>(found.directions.size()) - 1;
}

}  // namespace

bool has_place_along(const surfaces::PartSurface& surface, const Vec3& along) {
  const double cosine = std::abs(glm::dot(surface.axis, along));
  switch (surface.kind) {
    case SurfaceKind::plane:
      return cosine > 1 - drawn_parallel * drawn_parallel;
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
      return cosine <= drawn_parallel;
    case SurfaceKind::torus:
      return cosine <= drawn_parallel || cosine > 1 - drawn_parallel * drawn_parallel;
    case SurfaceKind::sphere:
      return true;
    case SurfaceKind::free_form:
      break;
  }
  return false;
}

Directions find_directions(const std::vector<Face>& faces) {
  Directions found;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const surfaces::PartSurface& surface = faces[i].surface;
    found.of_face.push_back(has_direction(surface.kind) ? find_or_add(found, surface.axis, static_cast<int>(i)) : -1);
  }
  return found;
}

Part with_common_directions(Part part, const Directions& directions) {
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    if (directions.of_face[i] < 0) continue;
    surfaces::PartSurface& surface = part.faces[i].surface;
    const Vec3& common = directions.directions[static_cast<std::size_t>(directions.of_face[i])];
    // About the middle of the face, which thus stays where it is.
    if (surface.kind == SurfaceKind::plane) surface.origin = part.faces[i].at;
    if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::cone) {
      const double along = glm::dot(part.faces[i].at - surface.origin, surface.axis);
      surface.origin += along * surface.axis;
      surface.radius += along * (surface.kind == SurfaceKind::cone ? surface.slope : 0);
    }
    surface.axis = glm::dot(surface.axis, common) < 0 ? -common : common;
  }
  return part;
}

}  // namespace epura::definition
