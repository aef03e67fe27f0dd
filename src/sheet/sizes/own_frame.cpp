// SPDX-License-Identifier: Apache-2.0
#include "sizes/own_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
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

/// Of faces; that of many is their mean: each face of a mesh is turned by the rounding of its own vertices.
struct Direction {
  double area;
  Vec3 along;
  int faces = 1;
};
using Directions = std::vector<Direction>;  // each once, the largest first

Directions directions_of(const std::vector<surfaces::PartFace>& faces) {
  Directions directions;
  for (const surfaces::PartFace& face : faces) {
    if (face.surface.kind != surfaces::SurfaceKind::plane && !surfaces::has_axis(face.surface.kind)) continue;
    const auto same = std::ranges::find_if(
        directions, [&](const Direction& one) { return features::are_parallel(one.along, face.surface.axis); });
    if (same == directions.end()) {
      directions.push_back({face.area, face.surface.axis});
      continue;
    }
    const double way = glm::dot(same->along, face.surface.axis) < 0 ? -face.area : face.area;
    same->along = glm::normalize(same->area * same->along + way * face.surface.axis);
    same->area += face.area;
    ++same->faces;
  }
  std::ranges::stable_sort(directions, std::ranges::greater{}, &Direction::area);
  check(std::ranges::all_of(directions, [](const Direction& one) { return one.area >= 0 && one.faces > 0; }),
        "a direction is that of faces");
  return directions;
}

// Of these alone frames are made: a gear has one for each flank.
std::span<const Directions::value_type> largest_of(const Directions& directions) {
  constexpr std::size_t most = 12;
  return std::span(directions).first(std::min(directions.size(), most));
}

bool has(const Directions& directions, double area, const Vec3& direction) {
  return std::ranges::any_of(largest_of(directions), [&](const Direction& one) {
    return features::are_parallel(one.along, direction) && features::are_same(one.area, area);
  });
}

/// What lies along the axes of a frame.
struct Share {
  double area = 0;
  int faces = 0;
  std::array<bool, 3> axes{};  ///< along which faces lie
};

// The area of faces that mirror each other in a plane of the frame counts half: an angle gives what lengths would.
Share along_axes_of(const Mat3& frame, const Directions& directions) {
  Share all;
  for (const Direction& one : directions) {
    double share = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 mirrored = glm::reflect(one.along, frame[axis]);
      if (features::are_parallel(one.along, frame[axis])) {
        share = 1;
        all.axes[static_cast<std::size_t>(axis)] = true;
      }
      if (share == 0 && !features::are_parallel(one.along, mirrored) && has(directions, one.area, mirrored))
        share = 0.5;
    }
    all.area += share * one.area;
    if (share > 0) all.faces += one.faces;
  }
  check(all.faces >= std::ranges::count(all.axes, true), "along an axis lies a face");
  return all;
}

// Of the sum and the difference of the directions of equal faces, which mirror each other; of two that are square to
// each other; or of one and an axis of the world as far as it is square to it. Of frames that are equally good the
// first one counts: a lever lies along its middle line, not along one of its flanks.
std::vector<Mat3> frames_of(const Directions& directions) {
  std::vector<Mat3> frames;
  const auto add = [&](const Vec3& first, const Vec3& second) {
    check(std::abs(glm::dot(first, second)) <= features::parallel, "axes of a frame are square to each other");
    frames.emplace_back(first, second, glm::cross(first, second));
  };
  const auto are_square = [](const Vec3& a, const Vec3& b) { return std::abs(glm::dot(a, b)) <= features::parallel; };
  for (const auto& [own, first, faces] : largest_of(directions))
    for (const auto& [other, second, others] : largest_of(directions))
      if (!are_square(first, second) && !features::are_parallel(first, second) && features::are_same(own, other))
        add(glm::normalize(first + second), glm::normalize(first - second));
  for (const auto& [own, first, faces] : largest_of(directions)) {
    for (const auto& [other, second, others] : largest_of(directions))
      if (are_square(first, second)) add(first, glm::normalize(second - glm::dot(first, second) * first));
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

}  // namespace

std::optional<Mat4> turn_to_own_frame(const world::World& world) {
  if (world.models.size() != 1 || world.models.front().part == nullptr) return std::nullopt;
  const auto part = world::place_part(world.models.front());
  if (!part) return std::nullopt;
  const Directions directions = directions_of(part->faces);
  const Share as_it_lies = along_axes_of(Mat3(1), directions);
  if (std::ranges::count(as_it_lies.axes, true) > 1) return std::nullopt;
  double whole = 0;
  for (const surfaces::PartFace& face : part->faces) whole += face.area;
  std::optional<Mat3> best;
  double largest = std::max(whole / 2, as_it_lies.area * (1 + features::same_size));
  for (const Mat3& frame : frames_of(directions))
    if (const Share share = along_axes_of(frame, directions);
        share.area > largest * (1 + features::same_size) && share.faces > as_it_lies.faces + 1) {
      best = frame;
      largest = share.area;
    }
  if (!best) return std::nullopt;
  check(std::abs(glm::determinant(*best) - 1) <= features::parallel,
        "a frame is right-handed, its axes are unit vectors");
  return Mat4(glm::transpose(nearest_to_world(*best)));
}

// Turns about z, y and x, one after the other.
std::string words_of_turn(const Mat4& turn) {
  const Mat3 frame = glm::transpose(Mat3(turn));
  const std::array<std::pair<const char*, double>, 3> turns{
      {{"z", portable_atan2(-frame[0][1], frame[0][0])},
       {"y", portable_atan2(frame[0][2], std::hypot(frame[0][0], frame[0][1]))},
       {"x", portable_atan2(-frame[1][2], frame[2][2])}}};
  std::string text;
  for (const auto& [axis, angle] : turns) {
    if (std::abs(angle) <= features::parallel * features::parallel) continue;
    text += std::string(text.empty() ? "" : " ") + "rotate:" + axis + "," + format_fixed(angle * degrees, 6);
  }
  return text;
}

}  // namespace epura::sheet
