// SPDX-License-Identifier: Apache-2.0
// Tries groups of views on a sheet at decreasing scales.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sheet/arrangement.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/view_table.hpp"

namespace epura::sheet {

/// Where to arrange, and how strictly.
struct ArrangerRoom {
  Rectangle area;
  std::vector<Rectangle> taken;  ///< the title block and the clearance around it
  double gap;                    ///< between views
  double clearance = 0;          ///< beyond the area
  bool aligns = true;            ///< views beside others are aligned with them
  bool watch_given = true;       ///< views with a given position must be in the area, without overlaps
};

class Arranger {
 public:
  Arranger(std::span<const ViewToPlace> views, ProjectionAngle angle, ArrangerRoom room);

  /// Upper bound for the scale; infinite if all views have their own scale.
  [[nodiscard]] double largest_scale() const;

  /// Whether views are aligned beside others.
  [[nodiscard]] bool has_aligned() const { return !beside_.empty(); }

  /// All views at a scale, pictorial ones at no less than `share` of it; nothing if they do not fit.
  [[nodiscard]] std::optional<std::vector<ViewSpot>> arranged(double scale, double share) const;

  /// The same views, with each group in the middle of the room that the others leave.
  [[nodiscard]] std::vector<ViewSpot> balanced(std::vector<ViewSpot> spots) const;

  /// Positions for views that do not fit: they do not overlap, but are not confined to the area.
  [[nodiscard]] std::vector<ViewSpot> overflowing(double scale) const;

 private:
  using Tables = std::vector<ViewTable>;
  using Spots = std::vector<ViewSpot>;
  enum class Labels { given, all };

  void sort_out();
  [[nodiscard]] Vec2 room_after(const ViewToPlace& view) const;
  [[nodiscard]] ViewCell principal_cell(std::size_t view) const;
  [[nodiscard]] ViewCell free_cell(std::size_t view, int column, int row, Labels labels) const;
  [[nodiscard]] Tables grids(const std::vector<std::size_t>& views, Labels labels) const;
  [[nodiscard]] ViewSpot given_spot(std::size_t view, double scale) const;
  [[nodiscard]] std::optional<ViewSpot> beside_spot(std::size_t view, const Spots& spots, double scale,
                                                    std::span<const Rectangle> taken) const;
  bool add_beside(Spots& spots, double scale, std::span<const Rectangle> taken) const;
  [[nodiscard]] bool is_free(const Spots& spots, std::span<const Rectangle> taken) const;
  [[nodiscard]] std::optional<Spots> principal_spots(double scale, std::span<const Rectangle> taken) const;
  [[nodiscard]] std::optional<Spots> grid_spots(const Tables& tables, double scale,
                                                std::span<const Rectangle> taken) const;
  [[nodiscard]] std::optional<Spots> pictorial_spots(double scale, double share,
                                                     std::span<const Rectangle> taken) const;
  [[nodiscard]] std::array<double, 2> play(const Spots& spots, const std::vector<std::size_t>& group, int axis) const;

  std::span<const ViewToPlace> views_;
  ProjectionAngle angle_;
  ArrangerRoom room_;
  std::vector<std::size_t> given_, principal_, beside_, other_, pictorial_;  // view numbers
  Tables cross_;                                                             // of the principal views, if there are any
  Tables others_, pictorials_, labelled_pictorials_;                         // by number of columns
};

}  // namespace epura::sheet
