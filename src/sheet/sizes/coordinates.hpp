// SPDX-License-Identifier: Apache-2.0
// Positions of features along the axes of the world, and the dimensions that fix them from one end of the models.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/automatic.hpp"
#include "sizes/datums.hpp"

namespace epura::sheet {

/// A place along an axis of the world that a view dimensions.
struct Coordinate {
  const NamedProjection* view;
  int axis;
  double at;
  Vec3 point;                       ///< where its extension line begins, as the view shows it
  int group = -1;                   ///< of equal holes, which may be equally spaced: its first size; -1 for steps
  Vec3 opposite{point};             ///< where it begins if the dimension line is above or on the left
  std::optional<double> from{};     ///< place that it is measured from, beside it, instead of the end of the models
  std::optional<double> partner{};  ///< of one side of a groove or rib: the place of the other one
};

/// Returns the axis of the world, 0 to 2, to which a unit vector is parallel; -1 if there is none.
int world_axis(const Vec3& direction);

/// The largest number of parallel dimensions of one direction in a view: more stand too far from what they measure.
inline constexpr std::size_t max_parallel = 8;

/// Collects coordinates, each once.
class Coordinates {
 public:
  /// Along each axis, all views measure from what is chosen, or else from the usual end of the models; a chosen place
  /// that is no end has its own distance from that.
  Coordinates(const DimensionSubject& subject, const ChosenDatums& chosen, std::span<const RoundEnd> ends,
              std::span<const NamedProjection* const> views);

  /// Notes that a place follows from other dimensions.
  void know(int axis, double at);
  [[nodiscard]] bool is_known(int axis, double at) const;
  /// Adds a place unless it is known, or an aligned section does not show it at its true distance. Of points at the
  /// same place in one view, those nearest to the dimension line count.
  void add(const Coordinate& coordinate);

  /// Notes that another dimension measures from one place to another: of two that were added, the farther one from
  /// where they are measured from follows.
  void join(int axis, double from, double to);

  /// The dimension of one from where it is measured; nothing if it is there.
  [[nodiscard]] std::optional<scene::DimensionDescription> distance_to(const Coordinate& coordinate,
                                                                       const std::string& where) const;
  /// Dimensions of all coordinates in the arrangement that is wanted; without one, parallel, and with a common origin
  /// where these would be more than `max_parallel`. Parallel ones give grooves and ribs a place and a width.
  [[nodiscard]] std::vector<scene::DimensionDescription> dimensions(const scene::DimensionDescription& wanted,
                                                                    const Notation& notation) const;

 private:
  [[nodiscard]] bool is_datum(const Coordinate& coordinate) const;
  [[nodiscard]] Coordinate base_of(const Coordinate& coordinate) const;
  [[nodiscard]] bool are_about_line(const Coordinate& one, const Coordinate& other) const;
  [[nodiscard]] std::optional<Coordinate> first_side(const Coordinate& coordinate) const;
  [[nodiscard]] std::vector<scene::DimensionDescription> arranged(std::span<const Coordinate> coordinates,
                                                                  DimensionArrangement arrangement,
                                                                  const std::string& where) const;
  [[nodiscard]] std::vector<scene::DimensionDescription> without_crowds(
      std::vector<scene::DimensionDescription> dimensions, const std::vector<std::size_t>& coordinates_of,
      const std::string& where) const;
  void add_row(std::vector<Coordinate> row, const std::string& where, const Notation& notation,
               std::vector<scene::DimensionDescription>& dimensions) const;

  const DimensionSubject& subject_;
  std::array<Datum, 3> datums_, ends_;  // the usual ones, if others are chosen
  std::vector<Vec3> points_;
  double slack_;
  std::array<std::vector<double>, 3> known_;
  std::vector<Coordinate> coordinates_;
};

}  // namespace epura::sheet
