// SPDX-License-Identifier: Apache-2.0
#include "definition/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "definition/limits.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::definition {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

// How a kind of surface can change: along and across its normal or axis.
struct Freedoms {
  bool moves_along, moves_across, turns;
  std::vector<UnknownKind> sizes{};
};

// A cone that moves along its axis has another radius at its anchor.
Freedoms freedoms_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return {true, false, true};
    case SurfaceKind::cylinder:
      return {false, true, true, {UnknownKind::radius}};
    case SurfaceKind::cone:
      return {false, true, true, {UnknownKind::radius, UnknownKind::angle}};
    case SurfaceKind::sphere:
      return {true, true, false, {UnknownKind::radius}};
    case SurfaceKind::torus:
      return {true, true, true, {UnknownKind::radius, UnknownKind::minor}};
    case SurfaceKind::free_form:
      break;
  }
  return {false, false, false};
}

Vec3 anchor_of(const Face& face) {
  const PartSurface& surface = face.surface;
  const double along = glm::dot(face.at - surface.origin, surface.axis);
  if (surface.kind == SurfaceKind::plane) return face.at - along * surface.axis;
  if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::cone)
    return surface.origin + along * surface.axis;
  return surface.origin;
}

Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3(0);
}

// How far a surface is from a point along a direction, close by.
double way_to(const PartSurface& surface, const Vec3& point, const Vec3& along) {
  constexpr int steps = 8;  // of Newton's method, which doubles the digits with each
  double way = 0;
  for (int step = 0; step < steps; ++step) {
    const surfaces::Nearness near = surfaces::nearness_of(surface, point + way * along);
    const double slope = glm::dot(near.normal, along);
    if (std::abs(slope) < good_base) break;
    way -= near.distance / slope;
  }
  return way;
}

}  // namespace

void add(Row& row, const Row& more, double factor) {
  for (const Term& term : more) row.push_back({term.unknown, factor * term.factor});
}

Row tidy(Row row) {
  std::stable_sort(row.begin(), row.end(), [](const Term& a, const Term& b) { return a.unknown < b.unknown; });
  double largest = 0;
  for (const Term& term : row) largest = std::max(largest, std::abs(term.factor));
  Row sums;
  for (const Term& term : row)
    if (!sums.empty() && sums.back().unknown == term.unknown)
      sums.back().factor += term.factor;
    else
      sums.push_back(term);
  std::erase_if(sums, [largest](const Term& term) { return std::abs(term.factor) <= rounding * largest; });
  return sums;
}

Unknowns::Unknowns(const Part& part, const Directions& directions) : part_(part) {
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    const int face = static_cast<int>(i), direction = directions.of_face[i];
    const Vec3 along = direction < 0 ? Vec3(0, 0, 1) : directions.directions[static_cast<std::size_t>(direction)];
    const auto [u, v] = surfaces::square_to(along);
    const Freedoms freedoms = freedoms_of(part.faces[i].surface.kind);
    first_.push_back(count());
    anchors_.push_back(anchor_of(part.faces[i]));
    if (freedoms.moves_along) all_.push_back({face, UnknownKind::move, along});
    for (const Vec3& across : {u, v})
      if (freedoms.moves_across) all_.push_back({face, UnknownKind::move, across});
    for (const Vec3& across : {u, v})
      if (freedoms.turns) all_.push_back({face, UnknownKind::turn, across});
    for (const UnknownKind size : freedoms.sizes) all_.push_back({face, size});
  }
  first_.push_back(count());
  if (!anchors_.empty()) centre_ = surfaces::mean_of(anchors_);
}

Vec3 Unknowns::radial(int face, const Vec3& point) const {
  const Vec3 off = point - anchor(face);
  const PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
  return unit_or_zero(off - glm::dot(off, surface.axis) * surface.axis);
}

// Where a point of the surface goes as a size grows by 1.
Vec3 Unknowns::size_motion(const Unknown& unknown, const Vec3& point) const {
  const PartSurface& surface = part_.faces[static_cast<std::size_t>(unknown.face)].surface;
  const Vec3 off = point - anchor(unknown.face), out = radial(unknown.face, point);
  if (unknown.kind == UnknownKind::minor) return unit_or_zero(off - surface.radius * out);
  if (unknown.kind == UnknownKind::angle)
    return glm::dot(off, surface.axis) / part_.size * (1 + surface.slope * surface.slope) * out;
  return surface.kind == SurfaceKind::sphere ? unit_or_zero(off) : out;
}

Unknowns Unknowns::changed_by(std::vector<double> values) const {
  check(values.size() == all_.size(), "each unknown has a value");
  Unknowns changed = *this;
  changed.values_ = std::move(values);
  return changed;
}

void Unknowns::add_change(Row& row, double change) const {
  if (!values_.empty() && !row.empty()) row.push_back({count(), change});
}

Vec3 Unknowns::sum_of(int face, UnknownKind kind) const {
  Vec3 sum(0);
  for (int i = first(face); i < first(face + 1); ++i)
    if (const Unknown& unknown = (*this)[i]; unknown.kind == kind && !values_.empty())
      sum += values_[static_cast<std::size_t>(i)] * unknown.along;
  return sum;
}

double Unknowns::size_of(int face, UnknownKind kind) const {
  for (int i = first(face); i < first(face + 1); ++i)
    if ((*this)[i].kind == kind && !values_.empty()) return values_[static_cast<std::size_t>(i)];
  return 0;
}

// By Rodrigues' formula.
Vec3 Unknowns::turned(int face, const Vec3& direction) const {
  const Vec3 turn = sum_of(face, UnknownKind::turn);
  const double angle = glm::length(turn);
  if (!(angle > 0)) return direction;
  const Vec3 about = turn / angle;
  return std::cos(angle) * direction + std::sin(angle) * glm::cross(about, direction) +
         (1 - std::cos(angle)) * glm::dot(about, direction) * about;
}

PartSurface Unknowns::changed(int face) const {
  PartSurface surface = part_.faces[static_cast<std::size_t>(face)].surface;
  if (first(face) == first(face + 1)) return surface;
  if (surface.kind == SurfaceKind::cone)
    surface.radius += surface.slope * glm::dot(anchor(face) - surface.origin, surface.axis);
  surface.origin = anchor(face) + part_.size * sum_of(face, UnknownKind::move);
  surface.axis = turned(face, surface.axis);
  surface.radius += part_.size * size_of(face, UnknownKind::radius);
  surface.minor += part_.size * size_of(face, UnknownKind::minor);
  surface.slope = std::tan(std::atan(surface.slope) + size_of(face, UnknownKind::angle));
  return surface;
}

Row Unknowns::axis_motion(int face, const Vec3& point, const Vec3& along) const {
  Row row = body_motion(face, point, along);
  if (values_.empty()) return row;
  const PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
  Vec3 now = anchor(face) + part_.size * sum_of(face, UnknownKind::move) + turned(face, point - anchor(face));
  // The point of an axis is the one that is level with where it was.
  if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::cone) {
    const Vec3 axis = turned(face, surface.axis);
    now -= glm::dot(now - point, surface.axis) / glm::dot(axis, surface.axis) * axis;
  }
  add_change(row, glm::dot(now - point, along) / part_.size);
  return row;
}

Row Unknowns::body_motion(int face, const Vec3& point, const Vec3& along) const {
  const Vec3 arm = (point - anchor(face)) / part_.size;
  Row row;
  for (int i = first(face); i < first(face + 1); ++i) {
    const Unknown& unknown = (*this)[i];
    if (unknown.kind == UnknownKind::move) row.push_back({i, glm::dot(unknown.along, along)});
    if (unknown.kind == UnknownKind::turn) row.push_back({i, glm::dot(glm::cross(unknown.along, arm), along)});
  }
  return row;
}

Row Unknowns::surface_motion(int face, const Vec3& point, const Vec3& normal) const {
  Row row = body_motion(face, point, normal);
  for (int i = first(face); i < first(face + 1); ++i)
    if (const Unknown& unknown = (*this)[i]; unknown.kind > UnknownKind::turn)
      row.push_back({i, glm::dot(size_motion(unknown, point), normal)});
  if (!values_.empty()) {
    const PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
    add_change(row, (way_to(changed(face), point, normal) - way_to(surface, point, normal)) / part_.size);
  }
  return row;
}

Row Unknowns::turn(int face, const Vec3& about) const {
  Row row;
  for (int i = first(face); i < first(face + 1); ++i)
    if ((*this)[i].kind == UnknownKind::turn) row.push_back({i, glm::dot((*this)[i].along, about)});
  if (!values_.empty()) {
    const Vec3& axis = part_.faces[static_cast<std::size_t>(face)].surface.axis;
    add_change(row, glm::dot(about, glm::cross(axis, turned(face, axis))));
  }
  return row;
}

Row Unknowns::side_turn(int face, const Vec3& point, const Vec3& about) const {
  Row row = turn(face, about);
  const PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
  if (surface.kind == SurfaceKind::cone)
    add(row, growth(face, UnknownKind::angle), glm::dot(about, glm::cross(surface.axis, radial(face, point))));
  return row;
}

Row Unknowns::growth(int face, UnknownKind size) const {
  for (int i = first(face); i < first(face + 1); ++i)
    if ((*this)[i].kind == size) {
      Row row{{i, 1.0}};
      add_change(row, size_of(face, size));
      return row;
    }
  return {};
}

std::array<double, 6> Unknowns::rigid(int number) const {
  const Unknown& unknown = (*this)[number];
  const Vec3 arm = (anchor(unknown.face) - centre_) / part_.size;
  const PartSurface& surface = part_.faces[static_cast<std::size_t>(unknown.face)].surface;
  std::array<double, 6> values{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto move = static_cast<std::size_t>(axis), turn = move + 3;
    const Vec3 direction = Mat3(1)[axis], turned = glm::cross(direction, arm);
    if (unknown.kind == UnknownKind::move) {
      values[move] = glm::dot(unknown.along, direction);
      values[turn] = glm::dot(unknown.along, turned);
    } else if (unknown.kind == UnknownKind::turn) {
      values[turn] = glm::dot(unknown.along, direction);
    } else if (unknown.kind == UnknownKind::radius && surface.kind == SurfaceKind::cone) {
      values[move] = -surface.slope * glm::dot(surface.axis, direction);
      values[turn] = -surface.slope * glm::dot(surface.axis, turned);
    }
  }
  return values;
}

}  // namespace epura::definition
