// SPDX-License-Identifier: Apache-2.0
#include "features/hexagons.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/range.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

Range range_of(const std::vector<Vec3>& points, const Vec3& direction) {
  Range range;
  for (const Vec3& p : points) range.add(glm::dot(p, direction));
  return range;
}

/// The flats of one body that are parallel to an axis, as far as one hexagon may have them: those of six directions.
class FlatsAround {
 public:
  FlatsAround(const std::vector<const PlaneFace*>& faces, const PlaneFace& first, const Vec3& axis) : axis_(axis) {
    const Vec3 across = glm::normalize(first.normal - glm::dot(first.normal, axis) * axis);
    const double half = 0.5, rise = std::numbers::sqrt3 / 2;
    const Vec3 aside = glm::cross(axis, across);
    normals_ = {across, half * across + rise * aside, rise * aside - half * across};
    for (int side = 0; side < 3; ++side) normals_[side + 3] = -normals_[side];
    for (const PlaneFace* face : faces)
      for (int side = 0; side < 6; ++side)
        if (glm::distance(face->normal, normals_[side]) <= parallel)
          flats_[side].push_back({face, range_of(face->corners, normals_[side]).middle()});
  }

  // The hexagon of which a face is the first flat.
  [[nodiscard]] std::optional<HexagonFeature> around(const PlaneFace& first) const {
    const double place = range_of(first.corners, normals_[0]).middle();
    for (const Flat& next : flats_[1])
      for (const Flat& last : flats_[2])
        if (const auto hexagon = hexagon_at({place, next.place, last.place})) return hexagon;
    return std::nullopt;
  }

 private:
  struct Flat {
    const PlaneFace* face;
    double place;  ///< along its normal
  };

  // Three planes in a row determine a hexagon: n1 = n0 + n2, so its half width is d0 + d2 - d1, below zero for a
  // socket.
  [[nodiscard]] std::optional<HexagonFeature> hexagon_at(const std::array<double, 3>& places) const {
    const double half = places[0] + places[2] - places[1], slack = same_size * std::abs(half);
    if (!(slack > 0)) return std::nullopt;
    const double x = places[0] - half, y = (2 * (places[1] - half) - x) / std::numbers::sqrt3;
    HexagonFeature found{
        0, x * normals_[0] + y * glm::cross(axis_, normals_[0]), axis_, {}, 2 * std::abs(half), 0, 0, half < 0};
    std::copy(normals_.begin(), normals_.begin() + 3, found.normals.begin());
    Range along{-HUGE_VAL, HUGE_VAL};
    for (int side = 0; side < 6; ++side) {
      const Vec3 &normal = normals_[side], sideways = glm::cross(axis_, normal);
      const double place = glm::dot(found.centre, normal) + half, middle = glm::dot(found.centre, sideways);
      const double half_side = std::abs(half) / std::numbers::sqrt3;
      Range width, height;
      for (const Flat& flat : flats_[side]) {
        if (std::abs(flat.place - place) > slack) continue;
        const Range own = range_of(flat.face->corners, sideways), up = range_of(flat.face->corners, axis_);
        if (own.from < middle - half_side - slack || own.to > middle + half_side + slack) continue;
        width.add(own.from), width.add(own.to);
        height.add(up.from), height.add(up.to);
        found.vertices.insert(found.vertices.end(), flat.face->vertices.begin(), flat.face->vertices.end());
      }
      if (!(width.size() >= 2 * min_flat * half_side)) return std::nullopt;
      found.half_flat = std::max({found.half_flat, width.to - middle, middle - width.from});
      along.from = std::max(along.from, height.from);
      along.to = std::min(along.to, height.to);
    }
    if (!(along.size() > slack)) return std::nullopt;
    found.centre += along.middle() * axis_;
    found.half_height = along.size() / 2;
    std::sort(found.vertices.begin(), found.vertices.end());
    found.vertices.erase(std::unique(found.vertices.begin(), found.vertices.end()), found.vertices.end());
    return found;
  }

  Vec3 axis_;
  std::array<Vec3, 6> normals_;
  std::array<std::vector<Flat>, 6> flats_;
};

bool are_same_hexagon(const HexagonFeature& a, const HexagonFeature& b) {
  const double slack = 2 * same_size * a.across_flats;
  return std::abs(a.across_flats - b.across_flats) <= slack && a.inwards == b.inwards &&
         distance_from_line(a.centre, b.centre, a.axis) <= slack && glm::distance(a.axis, b.axis) <= parallel;
}

}  // namespace

double HexagonFeature::reach(const Vec3& direction) const {
  double most = 0;  // of the cosines to its corners, which are between flats
  for (const Vec3& corner : {normals[0] + normals[1], normals[1] + normals[2], normals[2] - normals[0]})
    most = std::max(most, std::abs(glm::dot(glm::normalize(corner), direction)));
  return across_flats / std::numbers::sqrt3 * most;
}

std::vector<HexagonFeature> find_hexagons(int model, const std::vector<PlaneFace>& faces) {
  int bodies = 0;
  for (const PlaneFace& face : faces) bodies = std::max(bodies, face.body + 1);
  std::vector<HexagonFeature> found;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::vector<const PlaneFace*>> flats(static_cast<std::size_t>(bodies));
    for (const PlaneFace& face : faces)
      if (!face.corners.empty() && std::abs(face.normal[axis]) <= parallel)
        flats[static_cast<std::size_t>(face.body)].push_back(&face);
    for (const auto& of_body : flats) {
      if (of_body.size() < 6 || of_body.size() > max_flats) continue;
      for (const PlaneFace* first : of_body) {
        auto hexagon = FlatsAround(of_body, *first, Mat3(1)[axis]).around(*first);
        if (!hexagon) continue;
        hexagon->model = model;
        if (std::none_of(found.begin(), found.end(),
                         [&](const auto& known) { return are_same_hexagon(known, *hexagon); }))
          found.push_back(*hexagon);
      }
    }
  }
  return found;
}

}  // namespace epura::features
