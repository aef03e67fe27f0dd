// SPDX-License-Identifier: Apache-2.0
#include "features/opposite_sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "base/error.hpp"
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

bool are_opposite(const AxialFace& a, const AxialFace& b, double slack) {
  return a.model == b.model && a.body == b.body && a.axis == b.axis && a.is_high != b.is_high &&
         std::abs(a.at - b.at) > slack && are_one_behind_the_other(a, b, slack);
}

// The levels on which faces are, by face; the number of levels for those that are on none.
std::vector<std::size_t> levels_of_faces(const std::vector<LevelFeature>& levels, std::span<const AxialFace> faces,
                                         double slack) {
  std::vector<std::size_t> numbers;
  for (const AxialFace& face : faces) {
    const auto level = std::find_if(levels.begin(), levels.end(), [&](const LevelFeature& one) {
      return one.axis == face.axis && std::abs(one.at - face.at) <= slack;
    });
    numbers.push_back(static_cast<std::size_t>(level - levels.begin()));
  }
  check(numbers.size() == faces.size(), "each face is on a level or on none");
  return numbers;
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
                                              double slack) {
  const std::vector<std::size_t> numbers = levels_of_faces(levels, faces, slack);
  std::vector<SidePair> pairs;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size() && numbers[i] < levels.size(); ++j)
      if (numbers[j] < levels.size() && are_opposite(faces[i], faces[j], slack)) {
        const auto [low, high] = faces[i].at < faces[j].at ? std::tuple(i, j) : std::tuple(j, i);
        pairs.push_back({faces[high].at - faces[low].at, numbers[low], numbers[high]});
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
