// SPDX-License-Identifier: Apache-2.0
#include "features/interrupted_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

// The largest angle around the axis without any of the parts, degrees.
double largest_gap(const std::vector<RoundFace>& round, const std::vector<int>& parts) {
  const RoundFace& first = round[static_cast<std::size_t>(parts.front())];
  const Vec3 u = first.middle, v = glm::cross(first.face.surface.axis, u);
  std::vector<std::pair<double, double>> arcs;  // begin and end, degrees
  for (const int part : parts) {
    const RoundFace& one = round[static_cast<std::size_t>(part)];
    const double middle = portable_atan2(glm::dot(one.middle, v), glm::dot(one.middle, u)) * 180 / std::numbers::pi;
    for (const double turn : {0.0, 360.0})
      arcs.emplace_back(middle - one.face.sweep / 2 + turn, middle + one.face.sweep / 2 + turn);
  }
  std::sort(arcs.begin(), arcs.end());
  double gap = 0, end = arcs.front().second;
  for (const auto& [begins, ends] : arcs) {
    gap = std::max(gap, begins - end);
    end = std::max(end, ends);
  }
  return gap > 0 ? gap : arcs.front().first + 720 - end;
}

}  // namespace

bool are_one_turn(const RoundFace& a, const RoundFace& b) {
  const surfaces::PartSurface &s = a.face.surface, &t = b.face.surface;
  return s.kind == t.kind && a.face.inwards == b.face.inwards &&
         std::abs(s.radius - t.radius) <= same_size * s.radius && std::abs(s.minor - t.minor) <= same_size * s.minor &&
         std::abs(s.slope - t.slope) <= same_size && are_parallel(s.axis, t.axis) &&
         distance_from_line(t.origin, s.origin, s.axis) <= same_size * s.radius &&
         (s.kind == SurfaceKind::cylinder || glm::length(t.origin - s.origin) <= same_size * s.radius);
}

std::vector<InterruptedFace> find_interrupted(const std::vector<RoundFace>& round, SurfaceKind kind) {
  check(kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::torus,
        "only these have an axis");
  std::vector<char> done(round.size(), 0);
  std::vector<InterruptedFace> found;
  for (std::size_t i = 0; i < round.size(); ++i) {
    const RoundFace& first = round[i];
    if (done[i] != 0 || first.face.surface.kind != kind) continue;
    InterruptedFace interrupted{{}, HUGE_VAL, -HUGE_VAL};
    bool has_whole = false;
    for (std::size_t j = i; j < round.size(); ++j) {
      if (done[j] != 0 || !are_one_turn(first, round[j])) continue;
      done[j] = 1;
      has_whole = has_whole || round[j].is_whole();
      interrupted.parts.push_back(static_cast<int>(j));
      for (const double height : {round[j].from, round[j].to}) {
        const double along = glm::dot(round[j].at(height) - first.face.surface.origin, first.face.surface.axis);
        interrupted.from = std::min(interrupted.from, along);
        interrupted.to = std::max(interrupted.to, along);
      }
    }
    if (!has_whole && largest_gap(round, interrupted.parts) < 360 - longest_arc)
      found.push_back(std::move(interrupted));
  }
  return found;
}

}  // namespace epura::features
