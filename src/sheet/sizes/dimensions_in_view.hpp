// SPDX-License-Identifier: Apache-2.0
// The dimensions of a view, in the world.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "projection/projection.hpp"
#include "sizes/anchors.hpp"

namespace epura::sheet {

/// A note whose leader ends in a view.
struct LeaderNote {
  std::string text;                  ///< its lines, one behind the other
  std::optional<Vec3> at{};          ///< where the leader ends; nothing if that is a place on the page
  std::optional<WorldCircle> rim{};  ///< of a hole that is named as its end
};

struct DimensionsInView {
  std::string view;
  projection::Projection projection;
  std::vector<AnchoredDimension> dimensions;  ///< in the world, where an aligned section turns nothing
  std::optional<Vec3> turned_about{};  ///< of an aligned section: the direction in which lengths stay as they are
  bool has_centre_lines = true;
  bool shows_inside = true;  ///< a section, or with hidden lines
  std::vector<LeaderNote> notes{};
  std::map<std::string, std::string> sizes_in_tables{};  ///< of holes, by label: "A1", "⌀8 ↧20"
};

/// Whether is_wanted(dimension) holds for one in any view.
template <class IsWanted>
bool any_dimension(std::span<const DimensionsInView> views, const IsWanted& is_wanted) {
  return std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
    return std::any_of(view.dimensions.begin(), view.dimensions.end(), is_wanted);
  });
}

}  // namespace epura::sheet
