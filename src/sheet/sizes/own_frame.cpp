// SPDX-License-Identifier: Apache-2.0
#include "sizes/own_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

/// The directions of faces, each once, with their area; the largest first.
using Directions = std::vector<std::pair<double, Vec3>>;

Directions directions_of(const std::vector<surfaces::PartFace>& faces) {
  Directions directions;
  for (const surfaces::PartFace& face : faces) {
    if (face.surface.kind != surfaces::SurfaceKind::plane && !surfaces::has_axis(face.surface.kind)) continue;
    const auto same = std::find_if(directions.begin(), directions.end(), [&](const auto& one) {
      return features::are_parallel(one.second, face.surface.axis);
    });
    if (same == directions.end())
      directions.emplace_back(face.area, face.surface.axis);
    else
      same->first += face.area;
  }
  std::stable_sort(directions.begin(), directions.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return directions;
}

// Of these alone frames are made: a gear has one for each flank.
std::span<const Directions::value_type> largest_of(const Directions& directions) {
  constexpr std::size_t most = 12;
  return std::span(directions).first(std::min(directions.size(), most));
}

bool has(const Directions& directions, double area, const Vec3& direction) {
  return std::ranges::any_of(largest_of(directions), [&](const auto& one) {
    return features::are_parallel(one.second, direction) && features::are_same(one.first, area);
  });
}

// Faces that mirror each other in a plane of the frame count half: an angle gives what lengths would.
double area_along(const Directions& directions, const Mat3& frame) {
  double area = 0;
  for (const auto& [own, direction] : directions) {
    double share = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 mirrored = glm::reflect(direction, frame[axis]);
      if (features::are_parallel(direction, frame[axis])) share = 1;
      if (share == 0 && !features::are_parallel(direction, mirrored) && has(directions, own, mirrored)) share = 0.5;
    }
    area += share * own;
  }
  return area;
}

// Of two directions that are square to each other; of the sum and the difference of those of equal faces, which mirror
// each other; or of one and an axis of the world as far as it is square to it.
std::vector<Mat3> frames_of(const Directions& directions) {
  std::vector<Mat3> frames;
  const auto add = [&](const Vec3& first, const Vec3& second) {
    frames.emplace_back(first, second, glm::cross(first, second));
  };
  for (const auto& [own, first] : largest_of(directions)) {
    for (const auto& [other, second] : largest_of(directions))
      if (std::abs(glm::dot(first, second)) <= features::parallel)
        add(first, glm::normalize(second - glm::dot(first, second) * first));
      else if (!features::are_parallel(first, second) && features::are_same(own, other))
        add(glm::normalize(first + second), glm::normalize(first - second));
    for (int axis = 0; axis < 3; ++axis)
      if (const Vec3 flat = Mat3(1)[axis] - first[axis] * first; glm::length(flat) > 0.5)
        add(first, glm::normalize(flat));
  }
  return frames;
}

// The axes of a frame in that order and with these signs in which it is turned least against the world.
Mat3 nearest_to_world(const Mat3& frame) {
  Mat3 nearest = frame;
  double largest = -HUGE_VAL;
  std::array order{0, 1, 2};
  do {
    for (const double first : {-1.0, 1.0})
      for (const double second : {-1.0, 1.0}) {
        const Vec3 x = first * frame[order[0]], y = second * frame[order[1]];
        const Mat3 one(x, y, glm::cross(x, y));
        const double trace = one[0][0] + one[1][1] + one[2][2];
        if (trace <= largest + features::parallel) continue;
        nearest = one;
        largest = trace;
      }
  } while (std::next_permutation(order.begin(), order.end()));
  return nearest;
}

// Turns about z, y and x, one after the other, that bring the axes of a frame to those of the world.
std::string turns_of(const Mat3& frame) {
  const std::array<std::pair<const char*, double>, 3> turns{
      {{"z", portable_atan2(-frame[0][1], frame[0][0])},
       {"y", portable_atan2(frame[0][2], std::hypot(frame[0][0], frame[0][1]))},
       {"x", portable_atan2(-frame[1][2], frame[2][2])}}};
  std::string text;
  for (const auto& [axis, turn] : turns) {
    if (std::abs(turn) <= features::parallel * features::parallel) continue;
    text += std::string(text.empty() ? "" : " ") + "rotate:" + axis + "," + format_fixed(turn * degrees, 6);
  }
  return text;
}

}  // namespace

std::string transform_to_own_frame(const world::World& world) {
  if (world.models.size() != 1 || world.models.front().part == nullptr) return {};
  const auto part = world::place_part(world.models.front());
  if (!part) return {};
  const Directions directions = directions_of(part->faces);
  Mat3 best(1);
  double largest = area_along(directions, best) * (1 + features::same_size);
  for (const Mat3& frame : frames_of(directions))
    if (const double area = area_along(directions, frame); area > largest * (1 + features::same_size)) {
      best = frame;
      largest = area;
    }
  check(std::abs(glm::determinant(best) - 1) <= features::parallel,
        "a frame is right-handed, its axes are unit vectors");
  return turns_of(nearest_to_world(best));
}

}  // namespace epura::sheet
