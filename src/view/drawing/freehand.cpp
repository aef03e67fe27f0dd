// SPDX-License-Identifier: Apache-2.0
#include "drawing/freehand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// A point of the Catmull-Rom curve between p[1] and p[2].
Vec2 on_curve(const std::vector<Vec2>& points, std::size_t i, double t) {
  const std::size_t n = points.size();
  const Vec2 &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n], &d = points[(i + 2) % n];
  const Vec2 out = (c - a) / 2.0, in = (d - b) / 2.0;
  const double u = 1 - t;
  return u * u * (1 + 2 * t) * b + t * t * (3 - 2 * t) * c + t * u * (u * out - t * in);
}

double length_of(const std::vector<Vec2>& ring) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
  return length;
}

// The closed curve, in steps of equal length.
std::vector<Vec2> even_curve(const std::vector<Vec2>& points) {
  std::vector<Vec2> fine;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double apart = glm::distance(points[i], points[(i + 1) % points.size()]);
    const int count = std::max(16, static_cast<int>(std::ceil(2 * apart / wave_step)));
    for (int k = 0; k < count; ++k) fine.push_back(on_curve(points, i, static_cast<double>(k) / count));
  }
  const double length = length_of(fine);
  const int count = std::max(32, static_cast<int>(std::ceil(length / wave_step)));
  std::vector<Vec2> even;
  double passed = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Vec2 &a = fine[i], &b = fine[(i + 1) % fine.size()];
    const double here = glm::distance(a, b);
    for (double next = length * static_cast<double>(even.size()) / count;
         next < passed + here && static_cast<int>(even.size()) < count;
         next = length * static_cast<double>(even.size()) / count)
      even.push_back(a + (next - passed) / here * (b - a));
    passed += here;
  }
  check(static_cast<int>(even.size()) <= count, "an even curve has no more points than wanted");
  return even;
}

}  // namespace

std::vector<Vec2> freehand_around(const std::vector<Vec2>& points) {
  const std::vector<Vec2> curve = even_curve(points);
  const double length = length_of(curve), turn = 2 * std::numbers::pi / static_cast<double>(curve.size());
  const double high = std::min(freehand_wave, max_of_turn * length / (2 * std::numbers::pi));
  const double longs = std::max(2.0, std::round(length / long_wave));
  const double shorts = std::max(3.0, std::round(length / short_wave));
  std::vector<Vec2> line;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec2 along = curve[(i + 1) % curve.size()] - curve[(i + curve.size() - 1) % curve.size()];
    const double at = turn * static_cast<double>(i), size = glm::length(along);
    const double wave = share_of_long * portable_sin(longs * at) +
                        (1 - share_of_long) * portable_sin(shorts * at + phase_of_short_wave);
    line.push_back(curve[i] + (size > 0 ? high * wave / size * Vec2(along.y, -along.x) : Vec2(0)));
  }
  return line;
}

double freehand_offset(double place) {
  const double turn = 2 * std::numbers::pi * place;
  return freehand_wave * (share_of_long * portable_sin(turn / long_wave) +
                          (1 - share_of_long) * portable_sin(turn / short_wave + phase_of_short_wave));
}

std::vector<Vec2> freehand_along(int along, const Vec2& from, const Vec2& to) {
  const int count = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / wave_step)));
  std::vector<Vec2> line;
  for (int i = 0; i <= count; ++i) {
    Vec2 p = i == count ? to : from + static_cast<double>(i) / count * (to - from);
    p[1 - along] += freehand_offset(p[along]);
    line.push_back(p);
  }
  return line;
}

std::vector<Vec2> points_on_circle(const Vec2& centre, double radius) {
  constexpr int count = 24;
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(centre + radius * Vec2(portable_cos(angle), portable_sin(angle)));
  }
  return points;
}

}  // namespace epura::drawing
