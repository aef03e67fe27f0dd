// SPDX-License-Identifier: Apache-2.0
#include "sizes/coordinates.hpp"

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
constexpr double same_coordinate = 1e-5;  // relative to the size of the models

bool is_horizontal(const Coordinate& coordinate) {
  return std::abs(coordinate.view->projection.u[coordinate.axis]) > 0.5;
}

bool is_kept(const Coordinate& coordinate) {
  return coordinate.view->aligned() || keeps(*coordinate.view, coordinate.point);
}

// Prefers points below, or on the right.
double rank(const Coordinate& coordinate, const Vec3& point) {
  const projection::Projection& projection = coordinate.view->projection;
  return is_horizontal(coordinate) ? -glm::dot(point, projection.v) : glm::dot(point, projection.u);
}

scene::DimensionDescription distance_along(const Coordinate& from, const Coordinate& to, const std::string& where) {
  scene::DimensionDescription dimension;
  dimension.where = where;
  dimension.view = {from.view->name, where};
  dimension.type = {DimensionType::linear, where};
  dimension.direction = {is_horizontal(from) ? DimensionDirection::horizontal : DimensionDirection::vertical, where};
  dimension.anchors = {from.point, to.point};
  dimension.opposite = {from.opposite, to.opposite};
  return dimension;
}

// Whether three or more coordinates are equally spaced.
bool are_a_row(std::span<const Coordinate> coordinates, double slack) {
  if (coordinates.size() < 3) return false;
  const double pitch = (coordinates.back().at - coordinates.front().at) / static_cast<double>(coordinates.size() - 1);
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    if (coordinates[i].group < 0 ||
        std::abs(coordinates[i].at - coordinates.front().at - pitch * static_cast<double>(i)) > slack)
      return false;
  return true;
}

}  // namespace

int world_axis(const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(std::abs(direction[axis]) - 1) <= off_axis * off_axis + 1e-9) return axis;
  return -1;
}

Coordinates::Coordinates(const DimensionSubject& subject, const ChosenDatums& chosen, std::span<const RoundEnd> ends,
                         std::span<const NamedProjection* const> views)
    : subject_(subject),
      datums_(usual_datums(subject, ends, views)),
      ends_(datums_),
      points_(features::points_of_faces(subject.world)),
      slack_(same_coordinate * glm::length(subject.world.box.size())) {
  for (int axis = 0; axis < 3; ++axis) {
    const features::Extent& extent = subject.extents[axis];
    known_[axis] = {extent.from, extent.to, ends_[axis].at};
    if (const auto& datum = chosen[static_cast<std::size_t>(axis)]) datums_[axis] = *datum;
    // The middle of a shaft needs no dimension, even where a flat is.
    if (extent.form == features::ExtentForm::length) continue;
    for (int other = 0; other < 3; ++other)
      if (std::abs(extent.axis[other]) <= off_axis) known_[other].push_back(extent.centre[other]);
  }
}

void Coordinates::know(int axis, double at) { known_[axis].push_back(at); }

bool Coordinates::is_known(int axis, double at) const {
  return std::any_of(known_[axis].begin(), known_[axis].end(),
                     [&](double known) { return std::abs(known - at) <= slack_; });
}

void Coordinates::add(const Coordinate& found) {
  check(found.view != nullptr && found.axis >= 0 && found.axis < 3, "a coordinate is along an axis, in a view");
  // Corners of a face of a mesh are off its plane, by so little that those of two steps may change places.
  Coordinate coordinate = found;
  const auto put = [this](Coordinate& one) {
    for (Vec3* point : {&one.point, &one.opposite})
      if (std::abs((*point)[one.axis] - one.at) > slack_) (*point)[one.axis] = one.at;
  };
  put(coordinate);
  if (!keeps_positions(*coordinate.view, coordinate.axis)) return;
  for (Coordinate& other : coordinates_)
    if (other.axis == coordinate.axis && std::abs(other.at - coordinate.at) <= slack_) {
      if (other.view != coordinate.view) return;
      // What a section has removed is the worse place to measure to.
      const bool was_kept = is_kept(other), kept = is_kept(coordinate);
      if (was_kept && !kept) return;
      if (kept && !was_kept) {
        other.point = coordinate.point;
        other.opposite = coordinate.opposite;
        return put(other);
      }
      if (rank(other, coordinate.point) > rank(other, other.point)) other.point = coordinate.point;
      if (rank(other, coordinate.opposite) < rank(other, other.opposite)) other.opposite = coordinate.opposite;
      return put(other);
    }
  if (!is_known(coordinate.axis, coordinate.at)) coordinates_.push_back(coordinate);
}

void Coordinates::join(int axis, double from, double to) {
  const auto find = [&](double place) {
    return std::find_if(coordinates_.begin(), coordinates_.end(),
                        [&](const Coordinate& one) { return one.axis == axis && std::abs(one.at - place) <= slack_; });
  };
  if (find(from) == coordinates_.end() || find(to) == coordinates_.end() || std::abs(from - to) <= slack_) return;
  const double end = datums_[static_cast<std::size_t>(axis)].at;
  coordinates_.erase(find(std::abs(from - end) > std::abs(to - end) ? from : to));
}

// Whether it is where others are measured from, amid the models.
bool Coordinates::is_datum(const Coordinate& coordinate) const {
  const auto axis = static_cast<std::size_t>(coordinate.axis);
  return std::abs(coordinate.at - datums_[axis].at) <= slack_ && std::abs(datums_[axis].at - ends_[axis].at) > slack_;
}

// Positions on a round part are measured from its axis.
Coordinate Coordinates::base_of(const Coordinate& coordinate) const {
  const features::Extent& extent = subject_.extents[coordinate.axis];
  if (coordinate.from) {
    Coordinate base = coordinate;
    base.at = base.point[base.axis] = base.opposite[base.axis] = *coordinate.from;
    return base;
  }
  const bool is_chosen = std::abs(datums_[coordinate.axis].at - ends_[coordinate.axis].at) > slack_;
  const bool from_axis = !is_chosen && extent.form != features::ExtentForm::length && coordinate.group >= 0;
  const Datum datum = from_axis              ? Datum{(extent.from + extent.to) / 2, extent.centre}
                      : is_datum(coordinate) ? ends_[coordinate.axis]
                                             : datums_[coordinate.axis];
  Coordinate base = coordinate;
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

std::optional<scene::DimensionDescription> Coordinates::distance_to(const Coordinate& coordinate,
                                                                    const std::string& where) const {
  const Coordinate base = base_of(coordinate);
  if (std::abs(coordinate.at - base.at) <= slack_) return std::nullopt;
  return distance_along(base, coordinate, where);
}

// The side of its groove or rib at which the width begins, if it has a place of its own: the one in line with the axis
// of a feature, or else the nearer one to the end of the models.
std::optional<Coordinate> Coordinates::first_side(const Coordinate& coordinate) const {
  if (!coordinate.partner) return std::nullopt;
  const double end = datums_[coordinate.axis].at;
  const auto side = std::find_if(coordinates_.begin(), coordinates_.end(), [&](const Coordinate& other) {
    return other.axis == coordinate.axis && std::abs(other.at - *coordinate.partner) <= slack_;
  });
  const bool is_at_feature = side != coordinates_.end() && side->group >= 0;
  if (!is_at_feature && std::abs(*coordinate.partner - end) >= std::abs(coordinate.at - end) - slack_)
    return std::nullopt;
  if (side != coordinates_.end() && side->view == coordinate.view) return *side;
  if (side == coordinates_.end() && !is_known(coordinate.axis, *coordinate.partner)) return std::nullopt;
  Coordinate beside = coordinate;
  beside.at = beside.point[beside.axis] = beside.opposite[beside.axis] = *coordinate.partner;
  return beside;
}

// Whether two places along one axis have the axis of a round part, or the line of centres of an arm, in the middle.
bool Coordinates::are_about_line(const Coordinate& one, const Coordinate& other) const {
  const features::Extent& extent = subject_.extents[one.axis];
  return (extent.form != features::ExtentForm::length &&
          std::abs(one.at + other.at - extent.from - extent.to) <= slack_) ||
         std::ranges::any_of(subject_.features.arms, [&](const features::ArmFeature& arm) {
           return arm.has_sides(one.axis, one.at, other.at);
         });
}

void Coordinates::add_row(std::vector<Coordinate> row, const std::string& where, const Notation& notation,
                          std::vector<scene::DimensionDescription>& dimensions) const {
  // Both sides of a keyway or arm, for example: their distance.
  if (row.front().group < 0)
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t j = i + 1; j < row.size(); ++j)
        if (are_about_line(row[i], row[j])) {
          dimensions.push_back(distance_along(row[i], row[j], where));
          row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
          row.erase(row.begin() + static_cast<std::ptrdiff_t>(i--));
          break;
        }
  std::erase_if(row, [&](const Coordinate& coordinate) {
    const bool is_own = coordinate.from.has_value() || is_datum(coordinate);
    const std::optional<Coordinate> base = is_own ? base_of(coordinate) : first_side(coordinate);
    if (base) dimensions.push_back(distance_along(*base, coordinate, where));
    return base.has_value();
  });
  if (row.empty()) return;
  const Coordinate base = base_of(row.front());
  std::sort(row.begin(), row.end(), [&](const Coordinate& a, const Coordinate& b) {
    return std::pair(std::abs(a.at - base.at), a.at) < std::pair(std::abs(b.at - base.at), b.at);
  });
  const bool equal = are_a_row(row, slack_);
  for (const Coordinate& coordinate : row) {
    dimensions.push_back(distance_along(base, coordinate, where));
    if (equal) break;
  }
  if (!equal) return;
  check(row.size() >= 2, "a row of equal steps has two places");
  const double pitch = std::abs(row[1].at - row[0].at);
  dimensions.push_back(distance_along(row.front(), row.back(), where));
  dimensions.back().text = {std::to_string(row.size() - 1) + "× " + length_text(pitch, notation) + " (=<>)", where};
}

// One row for all coordinates of a view along one axis that are measured from the same place.
std::vector<scene::DimensionDescription> Coordinates::arranged(std::span<const Coordinate> coordinates,
                                                               DimensionArrangement arrangement,
                                                               const std::string& where) const {
  struct Row {
    Coordinate base;
    std::vector<Coordinate> coordinates;
  };
  std::vector<Row> rows;
  for (const Coordinate& coordinate : coordinates) {
    const Coordinate base = base_of(coordinate);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& one) {
      return one.base.view == base.view && one.base.axis == base.axis && std::abs(one.base.at - base.at) <= slack_;
    });
    if (row == rows.end())
      rows.push_back({base, {coordinate}});
    else
      row->coordinates.push_back(coordinate);
  }
  std::vector<scene::DimensionDescription> dimensions;
  for (Row& row : rows) {
    std::stable_sort(row.coordinates.begin(), row.coordinates.end(), [&](const Coordinate& a, const Coordinate& b) {
      return std::abs(a.at - row.base.at) < std::abs(b.at - row.base.at);
    });
    scene::DimensionDescription dimension = distance_along(row.base, row.coordinates.front(), where);
    for (std::size_t i = 1; i < row.coordinates.size(); ++i) {
      dimension.anchors.emplace_back(row.coordinates[i].point);
      dimension.opposite.push_back(row.coordinates[i].opposite);
    }
    check(dimension.opposite.size() == dimension.anchors.size(), "each place of a row has one on the other side");
    if (row.coordinates.size() > 1) dimension.arrangement = {arrangement, where};
    dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

std::vector<scene::DimensionDescription> Coordinates::dimensions(const scene::DimensionDescription& wanted,
                                                                 const Notation& notation) const {
  const std::string& where = wanted.where;
  if (wanted.arrangement.given()) return arranged(coordinates_, *wanted.arrangement, wanted.arrangement.where);
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<std::size_t> coordinates_of;  // each dimension: its first coordinate
  std::vector<char> done(coordinates_.size(), 0);
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    if (done[i] != 0) continue;
    std::vector<Coordinate> row;
    for (std::size_t j = i; j < coordinates_.size(); ++j)
      if (done[j] == 0 && coordinates_[j].view == coordinates_[i].view &&
          coordinates_[j].axis == coordinates_[i].axis && coordinates_[j].group == coordinates_[i].group) {
        row.push_back(coordinates_[j]);
        done[j] = 1;
      }
    add_row(std::move(row), where, notation, dimensions);
    check(coordinates_of.size() < dimensions.size(), "every coordinate is in a dimension");
    coordinates_of.resize(dimensions.size(), i);
  }
  return without_crowds(std::move(dimensions), coordinates_of, where);
}

// Replaces parallel dimensions of one direction in a view by a row with a common origin if they are too many.
std::vector<scene::DimensionDescription> Coordinates::without_crowds(
    std::vector<scene::DimensionDescription> dimensions, const std::vector<std::size_t>& coordinates_of,
    const std::string& where) const {
  std::vector<scene::DimensionDescription> kept, rows;
  std::vector<char> in_row(dimensions.size(), 0);
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const Coordinate& first = coordinates_[coordinates_of[i]];
    const auto is_beside = [&](const Coordinate& coordinate) {
      return coordinate.view == first.view && coordinate.axis == first.axis;
    };
    if (in_row[i] == 0) {
      std::vector<std::size_t> beside;
      for (std::size_t j = i; j < dimensions.size(); ++j)
        if (is_beside(coordinates_[coordinates_of[j]])) beside.push_back(j);
      if (beside.size() > max_parallel) {
        std::vector<Coordinate> crowd;
        std::copy_if(coordinates_.begin(), coordinates_.end(), std::back_inserter(crowd), is_beside);
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
