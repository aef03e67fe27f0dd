// SPDX-License-Identifier: Apache-2.0
#include "sizes/turned_prisms.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/range.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::are_same;
using features::parallel;
using features::PlaneFeature;
using features::same_size;

Range span_along(const std::vector<Vec3>& points, const Vec3& direction) {
  Range span;
  for (const Vec3& p : points) span.add(glm::dot(p, direction));
  return span;
}

/// Two parallel faces with the same ends.
struct FacePair {
  int model;
  Vec3 axis, normal, across;  ///< the axis of the world to which both are parallel; perpendicular to each other
  Range along, beside;        ///< the normal, and `across`
  Range height;               ///< along the axis, where both are
  bool inwards;
};

bool is_slope(const PlaneFeature& plane, const features::PartFeatures& features) {
  return std::any_of(features.bevels.begin(), features.bevels.end(), [&](const features::BevelFeature& bevel) {
    return bevel.model == plane.model && are_parallel(bevel.normal, plane.normal) &&
           std::abs(glm::dot(bevel.ends[0] - plane.corners.front(), plane.normal)) <= same_size * bevel.leg();
  });
}

std::optional<FacePair> pair_of(const PlaneFeature& a, const PlaneFeature& b) {
  const int world = features::axis_beside(a.normal);
  if (a.model != b.model || world < 0 || glm::dot(a.normal, b.normal) > -1 + parallel * parallel) return std::nullopt;
  FacePair pair{a.model, Mat3(1)[world], a.normal, {}, {}, {}, {}, false};
  pair.across = glm::cross(pair.axis, pair.normal);
  const double at = glm::dot(a.corners.front(), pair.normal), other = glm::dot(b.corners.front(), pair.normal);
  pair.along = {std::min(at, other), std::max(at, other)};
  pair.inwards = other > at;
  pair.beside = span_along(a.corners, pair.across);
  const Range beside = span_along(b.corners, pair.across), height = span_along(a.corners, pair.axis),
              other_height = span_along(b.corners, pair.axis);
  pair.height = {std::max(height.from, other_height.from), std::min(height.to, other_height.to)};
  const double slack = same_size * (pair.along.size() + pair.beside.size());
  const bool ends_alike =
      std::abs(beside.from - pair.beside.from) <= slack && std::abs(beside.to - pair.beside.to) <= slack;
  return ends_alike && pair.height.size() > 0 && pair.along.size() > slack ? std::optional(pair) : std::nullopt;
}

// Rounded corners leave the sides shorter. The flats of a polygon, and the ends of one rib of several, are shorter than
// half of what they would bound.
bool is_side_of(const Range& side, const Range& width, double slack) {
  return side.size() <= width.size() + slack && side.size() >= width.size() / 2;
}

std::optional<TurnedPrism> prism_of(const FacePair& a, const FacePair& b) {
  if (a.model != b.model || a.inwards != b.inwards || !are_parallel(a.axis, b.axis) ||
      std::min(a.height.to, b.height.to) <= std::max(a.height.from, b.height.from) ||
      std::abs(glm::dot(a.normal, b.normal)) > parallel)
    return std::nullopt;
  const double way = glm::dot(a.across, b.normal) < 0 ? -1 : 1;
  const double middle = way * b.along.middle(), slack = same_size * (a.along.size() + b.along.size());
  const double other = glm::dot(b.across, a.normal) * b.beside.middle();
  if (std::abs(a.beside.middle() - middle) > slack || std::abs(a.along.middle() - other) > slack ||
      !is_side_of(a.beside, b.along, slack) || !is_side_of(b.beside, a.along, slack))
    return std::nullopt;
  const Vec3 centre = a.along.middle() * a.normal + middle * a.across + a.height.middle() * a.axis;
  return TurnedPrism{a.model, centre, a.axis, {a.normal, way * b.normal}, {a.along.size(), b.along.size()}, a.inwards};
}

}  // namespace

double TurnedPrism::reach(const Vec3& direction) const {
  return (widths[0] * std::abs(glm::dot(normals[0], direction)) +
          widths[1] * std::abs(glm::dot(normals[1], direction))) /
         2;
}

bool TurnedPrism::has_side(const Vec3& point, const Vec3& normal) const {
  for (const std::size_t side : {0U, 1U})
    if (are_parallel(normal, normals[side]) &&
        are_same(std::abs(glm::dot(point - centre, normals[side])), widths[side] / 2))
      return true;
  return false;
}

bool TurnedPrism::is_beside(const Vec3& from, const Vec3& to, std::size_t side) const {
  const Vec3 &along = normals[side], &across = normals[1 - side];
  if (!are_parallel(glm::normalize(to - from), along)) return false;
  const double off = std::abs(glm::dot(from - centre, across));
  if (off > same_size * widths[1 - side] && !are_same(off, widths[1 - side] / 2)) return false;
  const double begin = glm::dot(from - centre, along), end = glm::dot(to - centre, along);
  return std::min(begin, end) < widths[side] / 2 && std::max(begin, end) > -widths[side] / 2;
}

bool has_directions_of(const features::TurnedPart& part, const TurnedPrism& prism) {
  return are_parallel(prism.axis, part.axis) &&
         (are_parallel(prism.normals[0], part.directions[0]) || are_parallel(prism.normals[0], part.directions[1]));
}

bool is_ended_by(const features::TurnedPart& part, const TurnedPrism& prism) {
  return !prism.inwards && std::ranges::all_of(part.ends, [&](const auto& both) {
    return std::ranges::all_of(
        both, [&](const PlaneFeature* end) { return prism.has_side(end->corners.front(), end->normal); });
  });
}

std::vector<TurnedPrism> find_turned_prisms(const features::PartFeatures& features) {
  std::vector<FacePair> pairs;
  const std::vector<PlaneFeature>& planes = features.inclined;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (is_slope(planes[i], features)) continue;
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      if (const auto pair = pair_of(planes[i], planes[j]); pair && !is_slope(planes[j], features))
        pairs.push_back(*pair);
  }
  std::vector<TurnedPrism> prisms;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j)
      if (const auto prism = prism_of(pairs[i], pairs[j])) prisms.push_back(*prism);
  return prisms;
}

bool are_equal(const TurnedPrism& a, const TurnedPrism& b) {
  return a.model == b.model && a.inwards == b.inwards && are_parallel(a.axis, b.axis) &&
         are_parallel(a.normals[0], b.normals[0]) && are_same(a.widths[0], b.widths[0]) &&
         are_same(a.widths[1], b.widths[1]);
}

bool is_width_of(const AnchoredDimension& dimension, const TurnedPrism& prism, std::size_t side) {
  if (dimension.type != DimensionType::aligned || dimension.arrangement) return false;
  check(dimension.points.size() == 2, "an aligned dimension has two ends");
  const Vec3& normal = prism.normals[side];
  const double half = prism.widths[side] / 2, from = glm::dot(dimension.points[0] - prism.centre, normal),
               to = glm::dot(dimension.points[1] - prism.centre, normal);
  return are_parallel(glm::normalize(dimension.points[1] - dimension.points[0]), normal) &&
         are_same(std::abs(from), half) && are_same(std::abs(to), half) && from * to < 0;
}

bool is_angle_of(const AnchoredDimension& dimension, const TurnedPrism& prism) {
  if (dimension.type != DimensionType::angular) return false;
  check(dimension.points.size() == 3, "an angle has a corner and two legs");
  const Vec3& corner = dimension.points[0];
  for (const std::size_t leg : {1U, 2U}) {
    const Vec3& end = dimension.points[leg];
    if (features::axis_along(glm::normalize(dimension.points[3 - leg] - corner)) >= 0 &&
        (prism.is_beside(corner, end, 0) || prism.is_beside(corner, end, 1)))
      return true;
  }
  return false;
}

}  // namespace epura::sheet
