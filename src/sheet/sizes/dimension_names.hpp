// SPDX-License-Identifier: Apache-2.0
// How findings name dimensions: by what they say, and by the view where they stand.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "sheet/notation.hpp"
#include "sizes/dimensions_in_view.hpp"

namespace epura::sheet {

/// The number of a view, and of a dimension there.
using DimensionPlace = std::array<std::size_t, 2>;

class DimensionNames {
 public:
  /// It refers to what it is given.
  DimensionNames(std::span<const DimensionsInView> views, const Notation& notation)
      : views_(views), notation_(notation) {}

  /// "'52' in view 'top'"
  [[nodiscard]] std::string name_of(const DimensionPlace& place) const;
  /// "'15', '25' in view 'top' and '40'": the view is told where it is not the one that is known.
  [[nodiscard]] std::string list_of(std::span<const DimensionPlace> places,
                                    std::optional<std::size_t> known_view = std::nullopt) const;

 private:
  [[nodiscard]] std::string text_at(const DimensionPlace& place) const;

  std::span<const DimensionsInView> views_;
  const Notation& notation_;
};

}  // namespace epura::sheet
