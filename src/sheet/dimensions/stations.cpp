// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/stations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/text.hpp"

namespace epura::sheet {

namespace {

constexpr double parallel = 1e-6;
constexpr double same_place = 1e-5;  // relative to the size of the models

bool is_horizontal(const Station& station) {
  return std::abs(station.view->projection.u[station.axis]) > 0.5;
}

// Prefers points below, or on the right.
double rank(const Station& station, const Vec3& point) {
  const projection::Projection& projection = station.view->projection;
  return is_horizontal(station) ? -glm::dot(point, projection.v) : glm::dot(point, projection.u);
}

scene::DimensionDescription distance(const Station& from, const Vec3& begin, const Vec3& end, const std::string& where) {
  scene::DimensionDescription dimension;
  dimension.where = where;
  dimension.view = {from.view->name, where};
  dimension.type = {DimensionType::linear, where};
  dimension.direction = {is_horizontal(from) ? DimensionDirection::horizontal : DimensionDirection::vertical, where};
  dimension.anchors = {begin, end};
  return dimension;
}

// Whether three or more stations are equally spaced.
bool are_a_row(std::span<const Station> stations, double slack) {
  if (stations.size() < 3) return false;
  const double pitch = (stations.back().at - stations.front().at) / static_cast<double>(stations.size() - 1);
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (!stations[i].in_row || std::abs(stations[i].at - stations.front().at - pitch * static_cast<double>(i)) > slack)
      return false;
  return true;
}

}  // namespace

int world_axis(const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(std::abs(direction[axis]) - 1) <= parallel * parallel + 1e-9) return axis;
  return -1;
}

bool is_plain(const projection::Projection& projection) {
  return !projection.central &&
         glm::length(glm::cross(projection.projector, projection.n)) <= 1e-9 * glm::length(projection.projector);
}

Stations::Stations(const DimensionSubject& subject)
    : subject_(subject), slack_(same_place * glm::length(subject.world.box.size())) {
  for (int axis = 0; axis < 3; ++axis) {
    const scene::Extent& extent = subject.extents[axis];
    known_[axis] = {extent.from, extent.to};
    // The middle of a shaft needs no dimension.
    if (extent.form != scene::ExtentForm::length) known_[axis].push_back((extent.from + extent.to) / 2);
  }
}

void Stations::know(int axis, double at) { known_[axis].push_back(at); }

bool Stations::is_known(int axis, double at) const {
  return std::any_of(known_[axis].begin(), known_[axis].end(),
                     [&](double known) { return std::abs(known - at) <= slack_; });
}

void Stations::add(const Station& station) {
  for (Station& other : stations_)
    if (other.axis == station.axis && std::abs(other.at - station.at) <= slack_) {
      if (other.view == station.view && rank(other, station.point) > rank(other, other.point))
        other.point = station.point;
      return;
    }
  if (!is_known(station.axis, station.at)) stations_.push_back(station);
}

Vec3 Stations::base_of(const NamedProjection& view, int axis) const {
  const projection::Projection& projection = view.projection;
  const Station station{&view, axis, 0, {}};
  const double way = is_horizontal(station) ? projection.u[axis] : projection.v[axis];
  const double at = way > 0 ? subject_.extents[axis].from : subject_.extents[axis].to;
  double nearest = HUGE_VAL;
  for (const Vec3& p : subject_.world.points) nearest = std::min(nearest, std::abs(p[axis] - at));
  const Vec3* best = nullptr;
  for (const Vec3& p : subject_.world.points)
    if (std::abs(p[axis] - at) <= nearest + slack_ && (best == nullptr || rank(station, p) > rank(station, *best)))
      best = &p;
  Vec3 base = best != nullptr ? *best : subject_.world.box.min;
  base[axis] = at;
  return base;
}

std::vector<scene::DimensionDescription> Stations::dimensions(const std::string& where, int decimals) const {
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<char> done(stations_.size(), 0);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (done[i] != 0) continue;
    std::vector<Station> row;
    for (std::size_t j = i; j < stations_.size(); ++j)
      if (stations_[j].view == stations_[i].view && stations_[j].axis == stations_[i].axis &&
          stations_[j].in_row == stations_[i].in_row) {
        row.push_back(stations_[j]);
        done[j] = 1;
      }
    const Vec3 base = base_of(*row.front().view, row.front().axis);
    const auto farther = [&](const Station& a, const Station& b) {
      return std::abs(a.at - base[a.axis]) < std::abs(b.at - base[b.axis]);
    };
    std::sort(row.begin(), row.end(), farther);
    const bool equal = are_a_row(row, slack_);
    for (const Station& station : row) {
      dimensions.push_back(distance(station, base, station.point, where));
      if (equal) break;
    }
    if (!equal) continue;
    const double pitch = std::abs(row[1].at - row[0].at);
    dimensions.push_back(distance(row.front(), row.front().point, row.back().point, where));
    dimensions.back().text = {std::to_string(row.size() - 1) + "× " + format_fixed(pitch, decimals) + " (=<>)", where};
  }
  return dimensions;
}

}  // namespace epura::sheet
