// SPDX-License-Identifier: Apache-2.0
// What automatic dimensions are chosen from, and what is chosen so far.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sheet/dimensions/automatic.hpp"
#include "sheet/dimensions/stations.hpp"
#include "sheet/dimensions/view_choice.hpp"
#include "sheet/notation.hpp"

namespace epura::sheet {

struct Planning {
  const scene::DimensionDescription& wanted;
  ViewChoice views;
  const DimensionSubject& subject;
  Notation notation;
  Box box;  ///< of the faces of the models
  Stations stations;
  int groups = 0;  ///< of equal features, so far
  std::vector<scene::DimensionDescription> dimensions{};

  Planning(const scene::DimensionDescription& of, std::span<const NamedProjection> projections,
           const DimensionSubject& parts, const Notation& written);

  /// Adds a dimension without its places; "<>" is the usual text.
  scene::DimensionDescription& add(DimensionType type, const NamedProjection& view, const std::string& text);
  [[nodiscard]] std::string length(double value) const { return length_text(value, notation); }
};

/// How many notes, horizontal or vertical dimensions a view has at most; and slopes that all views dimension.
inline constexpr std::size_t most_of_a_kind = 40;

/// The one in the upper right, where leaders find room beside the lower and left baselines.
template <class Feature>
const Feature* uppermost(const std::vector<const Feature*>& group, const NamedProjection& view,
                         const std::function<Vec3(const Feature&)>& centre) {
  const auto height = [&](const Feature* one) {
    const std::optional<Vec3> shown = shown_point(view, centre(*one));
    return shown && keeps(view, centre(*one)) ? glm::dot(*shown, view.projection.u + view.projection.v) : -HUGE_VAL;
  };
  return *std::max_element(group.begin(), group.end(),
                           [&](const Feature* a, const Feature* b) { return height(a) < height(b); });
}

/// Whether a point is on a line, for something of this size.
bool are_coaxial(const Vec3& point, const Vec3& axis, const Vec3& other, double size);

/// Whether an overall dimension is the diameter of a cylinder.
bool is_overall(const DimensionSubject& subject, const design::DesignCylinder& cylinder);

}  // namespace epura::sheet
