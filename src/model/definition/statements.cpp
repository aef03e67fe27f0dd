// SPDX-License-Identifier: Apache-2.0
#include "definition/statements.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "definition/limits.hpp"

namespace epura::definition {

namespace {

struct Hold {
  int face;
  Vec3 normal;
};

std::vector<Hold> holds_of(const Part& part, const End& end) {
  std::vector<Hold> holds;
  for (const int face : end.faces) {
    const Vec3 normal = surfaces::normal_near(part.faces[static_cast<std::size_t>(face)].surface, end.at);
    if (glm::length(normal) > 0) holds.push_back({face, normal});
  }
  return holds;
}

// The direction as a sum of two or three normals, if it is one.
std::optional<std::vector<double>> sum_of(const std::vector<const Hold*>& holds, const Vec3& along) {
  Mat3 normals(0);
  for (std::size_t i = 0; i < holds.size(); ++i) normals[static_cast<int>(i)] = holds[i]->normal;
  if (holds.size() == 1) {
    const double cosine = glm::dot(normals[0], along);
    if (glm::length(along - cosine * normals[0]) > drawn_parallel) return std::nullopt;
    return std::vector<double>{cosine};
  }
  if (holds.size() == 2) normals[2] = glm::cross(normals[0], normals[1]);
  if (std::abs(glm::determinant(normals)) < good_base * good_base) return std::nullopt;
  const Vec3 factors = glm::inverse(normals) * along;
  if (holds.size() == 2 && std::abs(factors.z) > drawn_parallel) return std::nullopt;
  return holds.size() == 2 ? std::vector<double>{factors.x, factors.y}
                           : std::vector<double>{factors.x, factors.y, factors.z};
}

// Near to a point, by going to one surface after the other.
Vec3 meeting_near(Vec3 point, const std::vector<surfaces::PartSurface>& all) {
  constexpr int rounds = 100;
  for (int round = 0; round < rounds; ++round)
    for (const surfaces::PartSurface& one : all) {
      const surfaces::Nearness near = surfaces::nearness_of(one, point);
      point -= near.distance * near.normal;
    }
  return point;
}

/// A place between faces, and the direction in which it goes as a sum of their normals.
struct Held {
  Vec3 at, along;
  std::vector<double> factors;
};

// As faces have changed, a corner is where they meet now, not where their changes along their normals would take it.
Row motion_of(const Unknowns& unknowns, const Part& part, const std::vector<const Hold*>& holds, const Held& held) {
  Row row;
  for (std::size_t i = 0; i < holds.size(); ++i)
    add(row, unknowns.surface_motion(holds[i]->face, held.at, holds[i]->normal), held.factors[i]);
  const auto is_change = [&unknowns](const Term& term) { return term.unknown == unknowns.count(); };
  if (holds.size() == 1 || std::none_of(row.begin(), row.end(), is_change)) return row;
  std::vector<surfaces::PartSurface> before, now;
  for (const Hold* hold : holds) {
    before.push_back(part.faces[static_cast<std::size_t>(hold->face)].surface);
    now.push_back(unknowns.changed(hold->face));
  }
  std::erase_if(row, is_change);
  const Vec3 change = meeting_near(held.at, now) - meeting_near(held.at, before);
  row.push_back({unknowns.count(), glm::dot(change, held.along) / part.size});
  return row;
}

// An axis leads the place along as its plane moves.
Row crossing_motion(const Unknowns& unknowns, const Part& part, const End& end, const Vec3& along) {
  const Vec3 &axis = part.faces[static_cast<std::size_t>(end.faces[0])].surface.axis,
             &normal = part.faces[static_cast<std::size_t>(end.faces[1])].surface.axis;
  const double lead = glm::dot(axis, along) / glm::dot(axis, normal);
  Row row = unknowns.axis_motion(end.faces[0], end.at, along - lead * normal);
  add(row, unknowns.surface_motion(end.faces[1], end.at, normal), lead);
  return row;
}

}  // namespace

// The fewest faces that hold the place along the direction, and of these the first ones.
Row end_motion(const Unknowns& unknowns, const Part& part, const End& end, const Vec3& along) {
  if (end.is_axis && end.faces.size() > 1) return crossing_motion(unknowns, part, end, along);
  if (end.is_axis) return unknowns.axis_motion(end.faces.front(), end.at, along);
  const std::vector<Hold> holds = holds_of(part, end);
  const std::size_t count = holds.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const auto factors = sum_of({&holds[i]}, along))
      return motion_of(unknowns, part, {&holds[i]}, {end.at, along, *factors});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (const auto factors = sum_of({&holds[i], &holds[j]}, along))
        return motion_of(unknowns, part, {&holds[i], &holds[j]}, {end.at, along, *factors});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k)
        if (const auto factors = sum_of({&holds[i], &holds[j], &holds[k]}, along))
          return motion_of(unknowns, part, {&holds[i], &holds[j], &holds[k]}, {end.at, along, *factors});
  return {};
}

Row length(const Unknowns& unknowns, const Part& part, const std::array<End, 2>& ends, const Vec3& along,
           int direction_face) {
  Row row = end_motion(unknowns, part, ends[1], along);
  const Row other = end_motion(unknowns, part, ends[0], along);
  if (row.empty() || other.empty()) return {};
  add(row, other, -1);
  const Vec3 across = glm::cross(along, (ends[1].at - ends[0].at) / part.size);
  if (direction_face >= 0) add(row, unknowns.turn(direction_face, across));
  return tidy(std::move(row));
}

Row diameter(const Unknowns& unknowns, const Part& part, const std::array<End, 2>& ends) {
  return length(unknowns, part, ends, glm::normalize(ends[1].at - ends[0].at), -1);
}

Row angle(const Unknowns& unknowns, const std::array<End, 2>& sides, const Vec3& sight) {
  Row row = unknowns.side_turn(sides[1].faces.front(), sides[1].at, sight);
  add(row, unknowns.side_turn(sides[0].faces.front(), sides[0].at, sight), -1);
  return tidy(std::move(row));
}

}  // namespace epura::definition
