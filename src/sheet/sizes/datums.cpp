// SPDX-License-Identifier: Apache-2.0
#include "sizes/datums.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/hole_walls.hpp"

namespace epura::sheet {

namespace {

// The ends whose radius a view can give.
std::vector<RoundEnd> seen_ends(std::span<const RoundEnd> ends, std::span<const NamedProjection* const> views) {
  std::vector<RoundEnd> seen;
  std::copy_if(ends.begin(), ends.end(), std::back_inserter(seen), [&](const RoundEnd& end) {
    return std::any_of(views.begin(), views.end(), [&](const NamedProjection* view) {
      return !view->aligned() && features::are_parallel(view->projection.n, end.axis);
    });
  });
  return seen;
}

Datum usual_datum(int axis, const features::Extent& extent, std::span<const RoundEnd> ends,
                  std::span<const NamedProjection* const> views) {
  bool low = true;
  for (const NamedProjection* view : views)
    if (const Vec3& u = view->projection.u, &v = view->projection.v; world_axis(u) == axis || world_axis(v) == axis) {
      low = (world_axis(u) == axis ? u : v)[axis] > 0;
      break;
    }
  const auto bulging = [&](int side) {
    const RoundEnd* end = end_along(ends, axis, side, extent);
    return end != nullptr && end->bulges(axis, side) ? end : nullptr;
  };
  const RoundEnd *own = bulging(low ? 0 : 1), *other = bulging(low ? 1 : 0);
  if (own != nullptr && other != nullptr) return {own->centre[axis], own->centre};
  return {low == (own == nullptr) ? extent.from : extent.to, std::nullopt};
}

// Whether three of them meet in one point.
bool have_corner(std::span<const Vec3> normals) {
  std::vector<Vec3> apart;
  for (const Vec3& normal : normals) {
    if (apart.size() == 2 &&
        std::abs(glm::dot(normal, glm::normalize(glm::cross(apart[0], apart[1])))) <= features::parallel)
      continue;
    if (apart.size() == 1 && features::are_parallel(apart[0], normal)) continue;
    apart.push_back(normal);
    if (apart.size() == 3) return true;
  }
  return false;
}

// Those at a place that somebody has written; of a corner that is rounded off, the planes that would meet there.
std::vector<FaceOfModel> datum_faces(const HoleWalls& walls, const Vec3& place) {
  for (const double slack : walls.written_slacks())
    if (std::vector<FaceOfModel> found = walls.faces_at(place, slack); !found.empty()) return found;
  for (std::size_t model = 0; model < walls.parts().size(); ++model) {
    std::vector<FaceOfModel> planes;
    std::vector<Vec3> normals;
    if (!walls.parts()[model]) continue;
    const std::vector<surfaces::PartFace>& faces = walls.parts()[model]->faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const surfaces::PartSurface& surface = faces[i].surface;
      if (surface.kind != surfaces::SurfaceKind::plane ||
          std::abs(glm::dot(place - surface.origin, surface.axis)) > walls.slack())
        continue;
      planes.push_back({model, static_cast<int>(i)});
      normals.push_back(surface.axis);
    }
    check(normals.size() == planes.size(), "each plane has its normal");
    if (have_corner(normals)) return planes;
  }
  return {};
}

}  // namespace

bool is_on_models(const world::World& world, const Vec3& place) {
  const HoleWalls walls(world);
  const auto is_near = [&](int vertex) {
    return glm::distance(world.points[static_cast<std::size_t>(vertex)], place) <= walls.slack();
  };
  return !datum_faces(walls, place).empty() || std::ranges::any_of(world.triangles, [&](const auto& corners) {
    return std::ranges::any_of(corners, is_near);
  });
}

std::array<Datum, 3> usual_datums(const DimensionSubject& subject, std::span<const RoundEnd> ends,
                                  std::span<const NamedProjection* const> views) {
  const std::vector<RoundEnd> seen = seen_ends(ends, views);
  std::array<Datum, 3> datums;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<std::size_t>(axis);
    datums[along] = usual_datum(axis, subject.extents[along], seen, views);
    check(std::isfinite(datums[along].at), "places are measured from somewhere");
  }
  return datums;
}

ChosenDatums chosen_datums(const scene::DimensionDescription& wanted, const DimensionSubject& subject) {
  ChosenDatums chosen;
  if (wanted.anchors.empty()) return chosen;
  const auto& circle = wanted.circle;
  const Vec3 place = circle ? circle->centre : position_of(subject.world, wanted.anchors.front(), wanted.where);
  check(std::isfinite(glm::length(place)), "a datum is in the world");
  const HoleWalls walls(subject.world);
  for (const std::size_t axis : {0, 1, 2}) {
    const int along = static_cast<int>(axis);
    const bool is_axis = circle && std::abs(circle->axis[along]) <= features::parallel;
    if (is_axis) chosen[axis] = Datum{place[along], place};
    for (const double end : {subject.extents[axis].from, subject.extents[axis].to})
      if (!circle && std::abs(place[along] - end) <= walls.slack()) chosen[axis] = Datum{end, std::nullopt};
  }
  if (!circle)
    for (const FaceOfModel& at : datum_faces(walls, place)) {
      const surfaces::PartSurface& surface = walls.parts()[at.model]->faces[static_cast<std::size_t>(at.face)].surface;
      const int axis = surface.kind == surfaces::SurfaceKind::plane ? features::axis_along(surface.axis) : -1;
      if (axis >= 0) chosen[static_cast<std::size_t>(axis)] = Datum{surface.origin[axis], std::nullopt};
    }
  if (std::ranges::none_of(chosen, [](const auto& one) { return one.has_value(); }))
    throw Error(ErrorKind::input, wanted.where,
                "nothing is there from which positions along x, y or z could be measured",
                "name a corner, a plane face across one of these axes, or a hole along one");
  return chosen;
}

}  // namespace epura::sheet
