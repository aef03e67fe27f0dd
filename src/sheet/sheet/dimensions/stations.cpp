// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/stations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

constexpr double off_axis = 1e-6;
constexpr double same_station = 1e-5;  // relative to the size of the models

bool is_horizontal(const Station& station) { return std::abs(station.view->projection.u[station.axis]) > 0.5; }

bool is_kept(const Station& station) { return station.view->aligned() || keeps(*station.view, station.point); }

// Prefers points below, or on the right.
double rank(const Station& station, const Vec3& point) {
  const projection::Projection& projection = station.view->projection;
  return is_horizontal(station) ? -glm::dot(point, projection.v) : glm::dot(point, projection.u);
}

scene::DimensionDescription distance_along(const Station& from, const Station& to, const std::string& where) {
  scene::DimensionDescription dimension;
  dimension.where = where;
  dimension.view = {from.view->name, where};
  dimension.type = {DimensionType::linear, where};
  dimension.direction = {is_horizontal(from) ? DimensionDirection::horizontal : DimensionDirection::vertical, where};
  dimension.anchors = {from.point, to.point};
  dimension.opposite = {from.opposite, to.opposite};
  return dimension;
}

// Whether three or more stations are equally spaced.
bool are_a_row(std::span<const Station> stations, double slack) {
  if (stations.size() < 3) return false;
  const double pitch = (stations.back().at - stations.front().at) / static_cast<double>(stations.size() - 1);
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (stations[i].group < 0 ||
        std::abs(stations[i].at - stations.front().at - pitch * static_cast<double>(i)) > slack)
      return false;
  return true;
}

// The ends whose radius a view can give.
std::vector<RoundEnd> seen_ends(std::span<const RoundEnd> ends, std::span<const NamedProjection* const> views) {
  std::vector<RoundEnd> seen;
  std::copy_if(ends.begin(), ends.end(), std::back_inserter(seen), [&](const RoundEnd& end) {
    return std::any_of(views.begin(), views.end(), [&](const NamedProjection* view) {
      return !view->aligned() && features::are_parallel(view->projection.n, end.axis);
    });
  });
  return seen;
}

Datum datum_along(int axis, const features::Extent& extent, std::span<const RoundEnd> ends,
                  std::span<const NamedProjection* const> views) {
  bool low = true;
  for (const NamedProjection* view : views)
    if (const Vec3& u = view->projection.u, &v = view->projection.v; world_axis(u) == axis || world_axis(v) == axis) {
      low = (world_axis(u) == axis ? u : v)[axis] > 0;
      break;
    }
  const RoundEnd* end = end_along(ends, axis, low ? 0 : 1, extent);
  if (end != nullptr && end->bulges(axis, low ? 0 : 1)) return {end->centre[axis], end->centre};
  return {low ? extent.from : extent.to, std::nullopt};
}

}  // namespace

int world_axis(const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(std::abs(direction[axis]) - 1) <= off_axis * off_axis + 1e-9) return axis;
  return -1;
}

bool is_plain(const projection::Projection& projection) {
  return !projection.central &&
         glm::length(glm::cross(projection.projector, projection.n)) <= 1e-9 * glm::length(projection.projector);
}

Stations::Stations(const DimensionSubject& subject, std::span<const RoundEnd> ends,
                   std::span<const NamedProjection* const> views)
    : subject_(subject),
      points_(features::points_of_faces(subject.world)),
      slack_(same_station * glm::length(subject.world.box.size())) {
  const std::vector<RoundEnd> seen = seen_ends(ends, views);
  for (int axis = 0; axis < 3; ++axis) {
    const features::Extent& extent = subject.extents[axis];
    datums_[axis] = datum_along(axis, extent, seen, views);
    known_[axis] = {extent.from, extent.to, datums_[axis].at};
    // The middle of a shaft needs no dimension, even where a flat is.
    if (extent.form == features::ExtentForm::length) continue;
    for (int other = 0; other < 3; ++other)
      if (std::abs(extent.axis[other]) <= off_axis) known_[other].push_back(extent.centre[other]);
  }
}

void Stations::know(int axis, double at) { known_[axis].push_back(at); }

bool Stations::is_known(int axis, double at) const {
  return std::any_of(known_[axis].begin(), known_[axis].end(),
                     [&](double known) { return std::abs(known - at) <= slack_; });
}

void Stations::add(const Station& station) {
  check(station.view != nullptr && station.axis >= 0 && station.axis < 3, "a station is along an axis, in a view");
  if (!keeps_positions(*station.view, station.axis)) return;
  for (Station& other : stations_)
    if (other.axis == station.axis && std::abs(other.at - station.at) <= slack_) {
      if (other.view != station.view) return;
      // What a section has removed is the worse place to measure to.
      const bool was_kept = is_kept(other), kept = is_kept(station);
      if (was_kept && !kept) return;
      if (kept && !was_kept) {
        other.point = station.point;
        other.opposite = station.opposite;
        return;
      }
      if (rank(other, station.point) > rank(other, other.point)) other.point = station.point;
      if (rank(other, station.opposite) < rank(other, other.opposite)) other.opposite = station.opposite;
      return;
    }
  if (!is_known(station.axis, station.at)) stations_.push_back(station);
}

// Positions on a round part are measured from its axis.
Station Stations::base_of(const Station& station) const {
  const features::Extent& extent = subject_.extents[station.axis];
  if (station.from) {
    Station base = station;
    base.at = base.point[base.axis] = base.opposite[base.axis] = *station.from;
    return base;
  }
  const bool from_axis = extent.form != features::ExtentForm::length && station.group >= 0;
  const Datum datum = from_axis ? Datum{(extent.from + extent.to) / 2, extent.centre} : datums_[station.axis];
  Station base = station;
  base.at = datum.at;
  if (datum.centre) {
    base.point = base.opposite = shown_point(*base.view, *datum.centre).value_or(*datum.centre);
    return base;
  }
  double nearest = HUGE_VAL;
  for (const Vec3& p : points_) nearest = std::min(nearest, std::abs(p[base.axis] - base.at));
  std::optional<Vec3> low, high;
  const auto take = [&](const Vec3& p) {
    if (std::abs(p[base.axis] - base.at) > nearest + slack_) return;
    if (!low || rank(base, p) > rank(base, *low)) low = p;
    if (!high || rank(base, p) < rank(base, *high)) high = p;
  };
  for (const Vec3& p : points_)
    if (const auto shown = shown_point(*base.view, p)) take(*shown);
  // An aligned section may have left out the end of the models, of which others show the place.
  if (!low)
    for (const Vec3& p : points_) take(p);
  check(low && high, "a base has a place where it is measured from");
  base.point = *low;
  base.opposite = *high;
  base.point[base.axis] = base.opposite[base.axis] = base.at;
  return base;
}

void Stations::add_row(std::vector<Station> row, const std::string& where, const Notation& notation,
                       std::vector<scene::DimensionDescription>& dimensions) const {
  const features::Extent& extent = subject_.extents[row.front().axis];
  // Both sides of a keyway, for example: their distance.
  if (extent.form != features::ExtentForm::length && row.front().group < 0)
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t j = i + 1; j < row.size(); ++j)
        if (std::abs(row[i].at + row[j].at - extent.from - extent.to) <= slack_) {
          dimensions.push_back(distance_along(row[i], row[j], where));
          row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
          row.erase(row.begin() + static_cast<std::ptrdiff_t>(i--));
          break;
        }
  std::erase_if(row, [&](const Station& station) {
    if (station.from) dimensions.push_back(distance_along(base_of(station), station, where));
    return station.from.has_value();
  });
  if (row.empty()) return;
  const Station base = base_of(row.front());
  std::sort(row.begin(), row.end(), [&](const Station& a, const Station& b) {
    return std::pair(std::abs(a.at - base.at), a.at) < std::pair(std::abs(b.at - base.at), b.at);
  });
  const bool equal = are_a_row(row, slack_);
  for (const Station& station : row) {
    dimensions.push_back(distance_along(base, station, where));
    if (equal) break;
  }
  if (!equal) return;
  check(row.size() >= 2, "a row of equal steps has two places");
  const double pitch = std::abs(row[1].at - row[0].at);
  dimensions.push_back(distance_along(row.front(), row.back(), where));
  dimensions.back().text = {std::to_string(row.size() - 1) + "× " + length_text(pitch, notation) + " (=<>)", where};
}

// One row for all stations of a view along one axis that are measured from the same place.
std::vector<scene::DimensionDescription> Stations::arranged(std::span<const Station> stations,
                                                            DimensionArrangement arrangement,
                                                            const std::string& where) const {
  struct Row {
    Station base;
    std::vector<Station> stations;
  };
  std::vector<Row> rows;
  for (const Station& station : stations) {
    const Station base = base_of(station);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& one) {
      return one.base.view == base.view && one.base.axis == base.axis && std::abs(one.base.at - base.at) <= slack_;
    });
    if (row == rows.end())
      rows.push_back({base, {station}});
    else
      row->stations.push_back(station);
  }
  std::vector<scene::DimensionDescription> dimensions;
  for (Row& row : rows) {
    std::stable_sort(row.stations.begin(), row.stations.end(), [&](const Station& a, const Station& b) {
      return std::abs(a.at - row.base.at) < std::abs(b.at - row.base.at);
    });
    scene::DimensionDescription dimension = distance_along(row.base, row.stations.front(), where);
    for (std::size_t i = 1; i < row.stations.size(); ++i) {
      dimension.anchors.emplace_back(row.stations[i].point);
      dimension.opposite.push_back(row.stations[i].opposite);
    }
    check(dimension.opposite.size() == dimension.anchors.size(), "each place of a row has one on the other side");
    if (row.stations.size() > 1) dimension.arrangement = {arrangement, where};
    dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

std::vector<scene::DimensionDescription> Stations::dimensions(const scene::DimensionDescription& wanted,
                                                              const Notation& notation) const {
  const std::string& where = wanted.where;
  if (wanted.arrangement.given()) return arranged(stations_, *wanted.arrangement, wanted.arrangement.where);
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<std::size_t> stations_of;  // each dimension: its first station
  std::vector<char> done(stations_.size(), 0);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (done[i] != 0) continue;
    std::vector<Station> row;
    for (std::size_t j = i; j < stations_.size(); ++j)
      if (done[j] == 0 && stations_[j].view == stations_[i].view && stations_[j].axis == stations_[i].axis &&
          stations_[j].group == stations_[i].group) {
        row.push_back(stations_[j]);
        done[j] = 1;
      }
    add_row(std::move(row), where, notation, dimensions);
    check(stations_of.size() < dimensions.size(), "every station is in a dimension");
    stations_of.resize(dimensions.size(), i);
  }
  return without_crowds(std::move(dimensions), stations_of, where);
}

// Replaces parallel dimensions of one direction in a view by a row with a common origin if they are too many.
std::vector<scene::DimensionDescription> Stations::without_crowds(std::vector<scene::DimensionDescription> dimensions,
                                                                  const std::vector<std::size_t>& stations_of,
                                                                  const std::string& where) const {
  std::vector<scene::DimensionDescription> kept, rows;
  std::vector<char> in_row(dimensions.size(), 0);
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const Station& first = stations_[stations_of[i]];
    const auto is_beside = [&](const Station& station) {
      return station.view == first.view && station.axis == first.axis;
    };
    if (in_row[i] == 0) {
      std::vector<std::size_t> beside;
      for (std::size_t j = i; j < dimensions.size(); ++j)
        if (is_beside(stations_[stations_of[j]])) beside.push_back(j);
      if (beside.size() > max_parallel) {
        std::vector<Station> crowd;
        std::copy_if(stations_.begin(), stations_.end(), std::back_inserter(crowd), is_beside);
        for (scene::DimensionDescription& row : arranged(crowd, DimensionArrangement::ordinate, where))
          rows.push_back(std::move(row));
        for (const std::size_t j : beside) in_row[j] = 1;
      }
    }
    if (in_row[i] == 0) kept.push_back(std::move(dimensions[i]));
  }
  check(kept.size() + static_cast<std::size_t>(std::count(in_row.begin(), in_row.end(), 1)) == dimensions.size(),
        "a dimension is kept or in a row");
  std::move(rows.begin(), rows.end(), std::back_inserter(kept));
  return kept;
}

}  // namespace epura::sheet
