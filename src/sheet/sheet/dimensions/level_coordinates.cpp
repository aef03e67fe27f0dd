// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/level_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;

// Corners of a step where a view shows them.
std::vector<Vec3> points_shown(const features::LevelFeature& level, const NamedProjection& view) {
  std::vector<Vec3> points;
  for (const Vec3& point : level.points)
    if (const auto shown = shown_point(view, point)) points.push_back(*shown);
  return points;
}

// The view in which a step is nearest to the viewer, so that little can hide it; the first one of several. Otherwise
// the first aligned section that shows it.
const NamedProjection* view_of_level(const features::LevelFeature& level, const ViewChoice& views,
                                     const std::vector<Vec3>& all_points, double slack) {
  check(level.axis >= 0 && level.axis < 3 && !level.points.empty(), "a step has an axis and corners");
  const Vec3 axis = Mat3(1)[level.axis];
  const NamedProjection* best = nullptr;
  double least = HUGE_VAL;
  for (const NamedProjection* view : views.all()) {
    const projection::Projection& projection = view->projection;
    if (!are_parallel(projection.u, axis) && !are_parallel(projection.v, axis)) continue;
    const auto depth = [&](const Vec3& p) { return glm::dot(p, projection.n); };
    double front = -HUGE_VAL, nearest = -HUGE_VAL;
    for (const Vec3& p : all_points) front = std::max(front, depth(p));
    for (const Vec3& p : level.points) nearest = std::max(nearest, depth(p));
    const double behind = front - nearest;
    if (best != nullptr && behind >= least - slack) continue;
    best = view;
    least = behind;
  }
  if (best != nullptr) return best;
  for (const NamedProjection* view : views.aligned())
    if (keeps_positions(*view, level.axis) && !points_shown(level, *view).empty()) return view;
  return nullptr;
}

}  // namespace

double min_area(const Box& box) {
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z}), least = std::min({size.x, size.y, size.z});
  return min_level * largest * (size.x + size.y + size.z - largest - least);
}

std::vector<Coordinate> level_coordinates(const DimensionSubject& subject, const ViewChoice& views,
                                          const Coordinates& known) {
  const Box box = features::box_of_faces(subject.world);
  const std::vector<Vec3> all_points = features::points_of_faces(subject.world);
  const double slack = features::same_size * glm::length(box.size());
  std::map<std::pair<std::string, int>, std::vector<std::pair<double, Coordinate>>> by_view;
  for (const features::LevelFeature& level : subject.features.levels) {
    const NamedProjection* view = view_of_level(level, views, all_points, slack);
    if (view == nullptr || known.is_known(level.axis, level.at) || level.area < min_area(box)) continue;
    const bool horizontal = std::abs(view->projection.u[level.axis]) > 0.5;
    const Vec3 towards = horizontal ? -view->projection.v : view->projection.u;
    const std::vector<Vec3> points = points_shown(level, *view);
    const auto [high, low] = std::minmax_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
      return glm::dot(a, towards) < glm::dot(b, towards);
    });
    by_view[{view->name, level.axis}].emplace_back(
        -level.area, Coordinate{view, level.axis, level.at, *low, -1, *high, level.other_side, level.partner});
  }
  std::vector<Coordinate> coordinates;
  for (auto& [key, levels] : by_view) {
    check(!levels.empty(), "a view has the steps for which it was chosen");
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < std::min(levels.size(), max_levels); ++i) coordinates.push_back(levels[i].second);
  }
  return coordinates;
}

}  // namespace epura::sheet
