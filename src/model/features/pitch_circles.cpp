// SPDX-License-Identifier: Apache-2.0
#include "features/pitch_circles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>

#include "features/tolerances.hpp"

namespace epura::features {

namespace {

bool are_equal(const HoleSize& a, const HoleSize& b) {
  return std::equal(a.radii.begin(), a.radii.end(), b.radii.begin(), b.radii.end(),
                    [](double r, double s) { return std::abs(r - s) <= same_size * std::max(r, s); });
}

Vec3 spoke_to(const CentredRound& hole, const CentredRound& hub) {
  const Vec3 d = hole.rings.front().centre - hub.rings.front().centre;
  return d - glm::dot(d, hub.axis) * hub.axis;
}

/// Equal holes with parallel axes, as indices of their features.
using Pattern = std::vector<int>;

std::vector<Pattern> patterns_of(std::span<const CentredRound> features, std::span<const HoleSize> sizes) {
  std::vector<Pattern> patterns;
  std::vector<const HoleSize*> first;
  for (const HoleSize& size : sizes) {
    if (size.radii.empty()) continue;
    const CentredRound& feature = features[size.feature];
    std::size_t at = 0;
    while (at < patterns.size() &&
           !(features[first[at]->feature].model == feature.model && are_equal(*first[at], size) &&
             are_parallel(features[first[at]->feature].axis, feature.axis)))
      ++at;
    if (at == patterns.size()) {
      patterns.emplace_back();
      first.push_back(&size);
    }
    patterns[at].push_back(size.feature);
  }
  std::erase_if(patterns, [](const Pattern& pattern) { return pattern.size() < fewest_holes; });
  return patterns;
}

// Whether the spokes lead to three or four corners of a rectangle that is not square: rows and columns give their
// places. Opposite spokes make one line; those of a square are perpendicular.
bool is_oblong(const std::vector<Vec3>& spokes) {
  if (spokes.size() != 3 && spokes.size() != 4) return false;
  const double radius = glm::length(spokes[0]);
  int opposite = 0, perpendicular = 0;
  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (std::size_t j = i + 1; j < spokes.size(); ++j) {
      opposite += glm::length(spokes[i] + spokes[j]) <= 8 * same_size * radius ? 1 : 0;
      perpendicular += std::abs(glm::dot(spokes[i], spokes[j])) <= 8 * same_size * radius * radius ? 1 : 0;
    }
  return 2 * opposite + 1 >= static_cast<int>(spokes.size()) && opposite > 0 && 2 * opposite != perpendicular;
}

// Whether all spokes are equally far from the next ones: none is nearer.
bool are_even(const std::vector<Vec3>& spokes) {
  const double radius = glm::length(spokes[0]);
  const double next = std::cos(2 * std::numbers::pi / static_cast<double>(spokes.size())) + 8 * same_size;
  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (std::size_t j = i + 1; j < spokes.size(); ++j)
      if (glm::dot(spokes[i], spokes[j]) > next * radius * radius) return false;
  return true;
}

// The circles about one hub on which holes of a pattern lie.
std::vector<PitchCircle> circles_about(std::span<const CentredRound> features, const Pattern& pattern,
                                       const CentredRound& hub) {
  std::vector<PitchCircle> circles;
  std::vector<std::pair<double, int>> by_distance;
  for (const int hole : pattern) by_distance.emplace_back(glm::length(spoke_to(features[hole], hub)), hole);
  std::sort(by_distance.begin(), by_distance.end());
  for (std::size_t i = 0, end = 0; i < by_distance.size(); i = end) {
    const double radius = by_distance[i].first;
    PitchCircle circle{hub.rings.front().centre, hub.axis, radius, {}};
    std::vector<Vec3> spokes;
    for (end = i; end < by_distance.size() && by_distance[end].first - radius <= same_size * radius; ++end) {
      circle.holes.push_back(by_distance[end].second);
      spokes.push_back(spoke_to(features[by_distance[end].second], hub));
    }
    std::sort(circle.holes.begin(), circle.holes.end());
    if (spokes.size() < fewest_holes || !(radius > 0) || is_oblong(spokes)) continue;
    // Of a grid, some holes are always on a circle about another one.
    if (spokes.size() == pattern.size() || are_even(spokes)) circles.push_back(std::move(circle));
  }
  return circles;
}

}  // namespace

std::vector<PitchCircle> find_pitch_circles(std::span<const CentredRound> features, std::span<const HoleSize> sizes,
                                            const Progress& progress) {
  std::vector<PitchCircle> circles;
  for (const Pattern& pattern : patterns_of(features, sizes)) {
    const CentredRound& hole = features[pattern.front()];
    for (int hub = 0; hub < static_cast<int>(features.size()); ++hub) {
      progress.expect_time();
      if (features[hub].model != hole.model || std::binary_search(pattern.begin(), pattern.end(), hub) ||
          !are_parallel(features[hub].axis, hole.axis))
        continue;
      for (PitchCircle& circle : circles_about(features, pattern, features[hub])) circles.push_back(std::move(circle));
    }
  }
  std::stable_sort(circles.begin(), circles.end(), [](const PitchCircle& a, const PitchCircle& b) {
    return std::tuple(b.holes.size(), a.radius) < std::tuple(a.holes.size(), b.radius);
  });
  std::vector<char> taken(features.size(), 0);
  std::vector<PitchCircle> chosen;
  for (PitchCircle& circle : circles) {
    if (std::any_of(circle.holes.begin(), circle.holes.end(), [&](int hole) { return taken[hole] != 0; })) continue;
    for (const int hole : circle.holes) taken[hole] = 1;
    chosen.push_back(std::move(circle));
  }
  return chosen;
}

}  // namespace epura::features
