// SPDX-License-Identifier: Apache-2.0
#include "features/opposite_sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "features/tolerances.hpp"

namespace epura::features {

namespace {

/// Two levels, by their numbers.
struct SidePair {
  double width;
  std::size_t low, high;
};

bool are_one_behind_the_other(const AxialFace& a, const AxialFace& b, double slack) {
  bool alike = false, all_have_an_end = true;
  for (int across = 0; across < 3; ++across) {
    if (across == a.axis) continue;
    const bool low = std::abs(a.box.min[across] - b.box.min[across]) <= slack,
               high = std::abs(a.box.max[across] - b.box.max[across]) <= slack;
    alike = alike || (low && high);
    all_have_an_end = all_have_an_end && (low || high);
  }
  return alike && all_have_an_end;
}

// Those of one body that are square to one axis are opposite only to each other.
std::tuple<int, int, int> family_of(const AxialFace& face) { return {face.model, face.body, face.axis}; }

bool are_opposite(const AxialFace& a, const AxialFace& b, double slack) {
  return a.is_high != b.is_high && std::abs(a.at - b.at) > slack && are_one_behind_the_other(a, b, slack);
}

// The level at a place along an axis, or the number of levels.
std::size_t level_of(const std::vector<LevelFeature>& levels, int axis, double at, double slack) {
  const auto level = std::lower_bound(
      levels.begin(), levels.end(), std::pair(axis, at - slack),
      [](const LevelFeature& one, const std::pair<int, double>& least) { return std::pair(one.axis, one.at) < least; });
  const bool is_on_it = level != levels.end() && level->axis == axis && level->at <= at + slack;
  return is_on_it ? static_cast<std::size_t>(level - levels.begin()) : levels.size();
}

/// A face on a level.
struct Side {
  const AxialFace* face;
  std::size_t level;
};

// By family.
std::vector<Side> sides_on_levels(const std::vector<LevelFeature>& levels, std::span<const AxialFace> faces,
                                  double slack) {
  std::vector<Side> sides;
  for (const AxialFace& face : faces)
    if (const std::size_t level = level_of(levels, face.axis, face.at, slack); level < levels.size())
      sides.push_back({&face, level});
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return family_of(*a.face) < family_of(*b.face); });
  return sides;
}

// Whether a face around the axis of a cylinder is at one of its ends, and looks along the axis of the world or against
// it.
bool has_shoulder(const std::vector<Side>& sides, std::size_t level, const CylinderFeature& cylinder, bool is_high) {
  const auto is_around = [&](const AxialFace& face) {
    for (int across = 0; across < 3; ++across)
      if (across != face.axis &&
          (cylinder.from[across] < face.box.min[across] || cylinder.from[across] > face.box.max[across]))
        return false;
    return true;
  };
  return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
    return side.level == level && side.face->is_high == is_high && side.face->model == cylinder.model &&
           is_around(*side.face);
  });
}

// Shoulders that look at each other over a cylinder that both end.
std::vector<SidePair> sides_of_necks(const std::vector<LevelFeature>& levels, const std::vector<Side>& sides,
                                     std::span<const CylinderFeature> cylinders, double slack) {
  std::vector<SidePair> pairs;
  for (const CylinderFeature& cylinder : cylinders) {
    const int axis = axis_along(cylinder.axis);
    if (axis < 0) continue;
    const auto [from, to] = std::minmax({cylinder.from[axis], cylinder.to[axis]});
    const std::size_t low = level_of(levels, axis, from, slack), high = level_of(levels, axis, to, slack);
    if (low < high && high < levels.size() && has_shoulder(sides, low, cylinder, true) &&
        has_shoulder(sides, high, cylinder, false))
      pairs.push_back({levels[high].at - levels[low].at, low, high});
  }
  return pairs;
}

}  // namespace

std::vector<AxialFace> find_axial_faces(int model, std::span<const PlaneFace> faces) {
  std::vector<AxialFace> found;
  for (const PlaneFace& face : faces) {
    const int axis = axis_along(face.normal);
    if (axis < 0 || face.corners.empty()) continue;
    AxialFace one{model, face.body, axis, face.normal[axis] > 0, face.corners.front()[axis], {}};
    for (const Vec3& corner : face.corners) one.box.add(corner);
    found.push_back(one);
  }
  return found;
}

std::vector<LevelFeature> with_opposite_sides(std::vector<LevelFeature> levels, std::span<const AxialFace> faces,
                                              std::span<const CylinderFeature> cylinders, double slack) {
  const std::vector<Side> sides = sides_on_levels(levels, faces, slack);
  std::vector<SidePair> pairs = sides_of_necks(levels, sides, cylinders, slack);
  for (auto one = sides.begin(); one != sides.end(); ++one)
    for (auto other = one + 1; other != sides.end() && family_of(*other->face) == family_of(*one->face); ++other)
      if (are_opposite(*one->face, *other->face, slack)) {
        const auto& [low, high] = one->face->at < other->face->at ? std::pair(*one, *other) : std::pair(*other, *one);
        pairs.push_back({high.face->at - low.face->at, low.level, high.level});
      }
  std::sort(pairs.begin(), pairs.end(), [](const SidePair& a, const SidePair& b) {
    return std::tuple(a.width, a.low, a.high) < std::tuple(b.width, b.low, b.high);
  });
  for (const SidePair& pair : pairs) {
    LevelFeature &low = levels[pair.low], &high = levels[pair.high];
    if (low.partner || high.partner) continue;
    low.partner = high.at;
    high.partner = low.at;
  }
  return levels;
}

}  // namespace epura::features
