// SPDX-License-Identifier: Apache-2.0
#include "sizes/dimension_names.hpp"

#include "base/error.hpp"
#include "sizes/stated_values.hpp"

namespace epura::sheet {

std::string DimensionNames::text_at(const DimensionPlace& place) const {
  const auto [view, number] = place;
  check(view < views_.size() && number < views_[view].dimensions.size(), "a dimension is one of those in a view");
  return "'" + text_of(views_[view].dimensions[number], views_[view], notation_) + "'";
}

std::string DimensionNames::name_of(const DimensionPlace& place) const { return list_of({&place, 1}); }

std::string DimensionNames::list_of(std::span<const DimensionPlace> places,
                                    std::optional<std::size_t> known_view) const {
  std::string names;
  for (std::size_t i = 0; i < places.size(); ++i) {
    names += (i == 0 ? "" : i + 1 < places.size() ? ", " : " and ") + text_at(places[i]);
    if (places[i][0] != known_view) names += " in view '" + views_[places[i][0]].view + "'";
  }
  return names;
}

}  // namespace epura::sheet
