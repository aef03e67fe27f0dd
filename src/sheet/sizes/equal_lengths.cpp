// SPDX-License-Identifier: Apache-2.0
#include "sizes/equal_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/feature_table.hpp"

namespace epura::sheet {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

constexpr std::size_t most_compared = 2000;  ///< each is compared with each other one
constexpr double same_angle = 0.01;          ///< degrees

// Between parallel planes and axes; nothing for others.
std::optional<double> distance_between(const PartSurface& a, const PartSurface& b) {
  const bool is_plane = a.kind == SurfaceKind::plane, is_other_plane = b.kind == SurfaceKind::plane;
  const double turn = std::abs(glm::dot(a.axis, b.axis));
  const Vec3 off = b.origin - a.origin;
  if (is_plane != is_other_plane)
    return turn > features::parallel ? std::nullopt : std::optional(std::abs(glm::dot(off, (is_plane ? a : b).axis)));
  if (!features::are_parallel(a.axis, b.axis)) return std::nullopt;
  return is_plane ? std::abs(glm::dot(off, a.axis)) : glm::length(off - glm::dot(off, a.axis) * a.axis);
}

}  // namespace

EqualLengths::EqualLengths(const std::vector<std::optional<world::PlacedPart>>& parts, const world::World& world,
                           double slack)
    : world_(world), slack_(slack) {
  for (std::size_t model = 0; model < parts.size(); ++model) {
    if (!parts[model]) continue;
    const std::size_t first = faces_.size();
    for (const surfaces::PartFace& one : parts[model]->faces) faces_.push_back({one.surface, {}, one.to - one.from, 0});
    const auto triangle = static_cast<std::size_t>(world.first_triangle[model]);
    for (std::size_t t = 0; t < parts[model]->face_of_triangle.size(); ++t)
      if (const int number = parts[model]->face_of_triangle[t]; number >= 0) {
        Face& face = faces_[first + static_cast<std::size_t>(number)];
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
          corners[i] = world.points[static_cast<std::size_t>(world.triangles[triangle + t][i])];
          face.box.add(corners[i]);
        }
        face.area += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
      }
  }
  std::erase_if(faces_, [](const Face& face) {
    return face.surface.kind != SurfaceKind::plane && !surfaces::has_axis(face.surface.kind);
  });
  if (faces_.size() > most_compared) faces_.clear();
  for (const Face& face : faces_) check(face.area >= 0, "a face has an area");
}

int EqualLengths::lengths(double value) const {
  DisjointSets sets(faces_.size());
  int count = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto distance = distance_between(faces_[i].surface, faces_[j].surface);
      if (!distance || !(agree(*distance, value) || std::abs(*distance - value) <= slack_)) continue;
      const int one = sets.root(static_cast<int>(i)), other = sets.root(static_cast<int>(j));
      if (one == other) continue;
      sets.join(one, other);
      ++count;
    }
  return count;
}

double EqualLengths::thickness() const {
  const auto larger = [](const Face* one, const Face& other) { return one == nullptr || other.area > one->area; };
  const Face *largest = nullptr, *opposite = nullptr;
  for (const Face& one : faces_)
    if (one.surface.kind == SurfaceKind::plane && larger(largest, one)) largest = &one;
  const auto depth = [&](const Face& one) {
    return glm::dot(largest->surface.origin - one.surface.origin, largest->surface.axis);
  };
  for (const Face& one : faces_)
    if (one.surface.kind == SurfaceKind::plane && glm::dot(one.surface.axis, largest->surface.axis) < 0 &&
        features::are_parallel(one.surface.axis, largest->surface.axis) && depth(one) > slack_ && larger(opposite, one))
      opposite = &one;
  return opposite == nullptr ? 0 : depth(*opposite);
}

int EqualLengths::angles(double value, const Vec3& corner, const Vec3& leg, const Vec3& sight) const {
  const Vec3 across_leg = glm::cross(sight, leg);
  std::vector<Vec3> legs{leg, -leg, across_leg, -across_leg};  // then each direction once
  const std::size_t drawn = legs.size();
  for (const Face& face : faces_) {
    const Vec3 off = face.surface.origin - corner, across = off - glm::dot(off, sight) * sight;
    if (face.surface.kind == SurfaceKind::plane || !features::are_parallel(face.surface.axis, sight) ||
        glm::length(across) <= slack_)
      continue;
    const Vec3 own = glm::normalize(across);
    if (std::none_of(legs.begin() + static_cast<std::ptrdiff_t>(drawn), legs.end(),
                     [&](const Vec3& one) { return glm::distance(one, own) <= features::parallel; }))
      legs.push_back(own);
  }
  check(legs.size() <= drawn + faces_.size(), "each axis has one leg at most");
  int count = 0;
  for (std::size_t i = drawn; i < legs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(std::acos(std::clamp(glm::dot(legs[i], legs[j]), -1.0, 1.0)) * degrees - value) <= same_angle)
        ++count;
  const auto is_it = [&](double angle) {
    return std::abs(angle - value) <= same_angle || std::abs(180 - angle - value) <= same_angle ||
           std::abs(90 - angle - value) <= same_angle || std::abs(90 + angle - value) <= same_angle;
  };
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double half = std::atan(std::abs(faces_[i].surface.slope)) * degrees;
    if (faces_[i].surface.kind == SurfaceKind::cone && (is_it(half) || is_it(2 * half))) ++count;
    for (std::size_t j = 0; j < i; ++j) {
      const double cosine = std::abs(glm::dot(faces_[i].surface.axis, faces_[j].surface.axis));
      if (is_it(std::acos(std::min(1.0, cosine)) * degrees)) ++count;
    }
  }
  return count;
}

int EqualLengths::slopes(double value) const {
  const auto is_it = [&](double length) { return agree(length, value) || std::abs(length - value) <= slack_; };
  return static_cast<int>(std::count_if(faces_.begin(), faces_.end(), [&](const Face& face) {
    if (face.surface.kind == SurfaceKind::cone)
      return is_it(face.length) || is_it(face.length * std::abs(face.surface.slope));
    if (face.surface.kind != SurfaceKind::plane || features::axis_along(face.surface.axis) >= 0) return false;
    const Vec3 size = face.box.size();
    return is_it(size.x) || is_it(size.y) || is_it(size.z);
  }));
}

bool EqualLengths::has_place(const Vec3& place, const Vec3& along, double slack) const {
  const auto is_there = [&](const Vec3& point) { return std::abs(glm::dot(point - place, along)) <= slack + slack_; };
  if (std::ranges::any_of(faces_, [&](const Face& face) {
        const bool is_plane = face.surface.kind == SurfaceKind::plane;
        const bool has_it = is_plane ? features::are_parallel(face.surface.axis, along)
                                     : std::abs(glm::dot(face.surface.axis, along)) <= features::parallel;
        return has_it && is_there(face.surface.origin);
      }))
    return true;
  return std::ranges::any_of(world_.points, is_there);
}

}  // namespace epura::sheet
