// SPDX-License-Identifier: Apache-2.0
#include "sizes/noted_chamfers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"
#include "scene/choices.hpp"

namespace epura::sheet {

namespace {

using surfaces::PartFace;
using surfaces::SurfaceKind;

// How far a face reaches along a direction.
double extent_of(const FaceOfModel& at, const Vec3& along, const HoleWalls& walls, const world::World& world) {
  const world::PlacedPart& part = *walls.parts()[at.model];
  const auto first = static_cast<std::size_t>(world.first_triangle[at.model]);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t) {
    if (part.face_of_triangle[t] != at.face) continue;
    for (const int corner : world.triangles[first + t]) {
      const double place = glm::dot(world.points[static_cast<std::size_t>(corner)], along);
      low = std::min(low, place);
      high = std::max(high, place);
    }
  }
  check(low <= high, "a face has triangles");
  return high - low;
}

void add_of_plane(std::vector<ChamferLegs>& found, const FaceOfModel& at, const HoleWalls& walls,
                  const world::World& world) {
  const std::vector<PartFace>& faces = walls.parts()[at.model]->faces;
  const Vec3& normal = faces[static_cast<std::size_t>(at.face)].surface.axis;
  for (const surfaces::PartBorder& border : world.models[at.model].part->borders)
    for (const std::size_t side : {0, 1}) {
      if (border.faces[side] != at.face || border.faces[1 - side] < 0) continue;
      const surfaces::PartSurface& beside = faces[static_cast<std::size_t>(border.faces[1 - side])].surface;
      const double turn = std::acos(std::min(1.0, std::abs(glm::dot(normal, beside.axis))));
      const bool is_slanted = std::abs(std::sin(2 * turn)) > features::parallel;
      if (beside.kind != SurfaceKind::plane || !is_slanted) continue;
      const double width =
          extent_of(at, glm::normalize(glm::cross(normal, glm::cross(normal, beside.axis))), walls, world);
      found.push_back({width * std::cos(turn), width * std::sin(turn), turn * degrees});
    }
}

}  // namespace

bool ChamferLegs::suits(const NotedText& note, double doubt, double of_angle) const {
  const NotedElement* size = note.size();
  if (size == nullptr) return false;
  for (const NotedElement& one : note.all_understood()) {
    if (one.role == NotedRole::angle && one.of <= 0) {
      const bool is_leg = size->allows(along, doubt) || size->allows(across, doubt);
      return is_leg && (one.allows(angle, of_angle) || one.allows(90 - angle, of_angle));
    }
    if (one.role == NotedRole::length && one.of <= 0)
      return (size->allows(along, doubt) && one.allows(across, doubt)) ||
             (size->allows(across, doubt) && one.allows(along, doubt));
  }
  return false;
}

std::string ChamferLegs::text(const Notation& notation) const {
  return format_rounded(along / scene::millimetres(notation.unit), 4) + "×" + format_rounded(angle, 4) + "°";
}

std::vector<ChamferLegs> chamfers_at(const Vec3& point, const HoleWalls& walls, const world::World& world) {
  std::vector<ChamferLegs> found;
  for (const double within : walls.written_slacks()) {
    for (const FaceOfModel& at : walls.faces_at(point, within)) {
      const PartFace& face = walls.parts()[at.model]->faces[static_cast<std::size_t>(at.face)];
      const double slope = std::abs(face.surface.slope), length = face.to - face.from;
      if (face.surface.kind == SurfaceKind::cone) found.push_back({length, length * slope, std::atan(slope) * degrees});
      if (face.surface.kind == SurfaceKind::plane) add_of_plane(found, at, walls, world);
    }
    if (!found.empty()) break;
  }
  return found;
}

}  // namespace epura::sheet
