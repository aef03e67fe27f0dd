// SPDX-License-Identifier: Apache-2.0
// What automatic dimensions are chosen from, and what is chosen for some of the features.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/automatic.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/feature_table.hpp"
#include "sizes/view_choice.hpp"

namespace epura::sheet {

struct Planning {
  const scene::DimensionDescription& wanted;
  ViewChoice views;
  const DimensionSubject& subject;
  Notation notation;
  Box box;  ///< of the faces of the models
  FeatureTable table;
  ChosenDatums datums;

  Planning(const scene::DimensionDescription& of, std::span<const NamedProjection> projections,
           const DimensionSubject& parts, const Notation& written);

  /// A dimension without its places; "<>" is the usual text.
  [[nodiscard]] scene::DimensionDescription dimension(DimensionType type, const NamedProjection& view,
                                                      const std::string& text) const;
  /// The same of a circle.
  [[nodiscard]] scene::DimensionDescription dimension(DimensionType type, const NamedProjection& view,
                                                      const std::string& text, scene::FeatureCircle circle) const;
  [[nodiscard]] std::string length(double value) const { return length_text(value, notation); }
  /// The number of a group of equal features, for coordinates: that of the size of its first one.
  template <class Feature>
  [[nodiscard]] int group_of(SizeKind kind, const std::vector<Feature>& features, const Feature* first) const {
    return static_cast<int>(table.first(kind)) + static_cast<int>(first - features.data());
  }
  [[nodiscard]] const features::Extent& extent(int axis) const {
    return subject.extents[static_cast<std::size_t>(axis)];
  }
};

/// A place along an axis of the world that follows from dimensions.
struct KnownPlace {
  int axis;
  double at;
};

/// A place along a slope: that of a feature which begins on a face.
struct SlantedPlace {
  const NamedProjection* view;
  const features::PlaneFeature* face;
  Vec3 along, centre;
  int group;  ///< as of coordinates
};

/// What is planned for some features.
struct Planned {
  std::vector<scene::DimensionDescription> dimensions{};
  std::vector<std::variant<Coordinate, KnownPlace, SlantedPlace>> places{};  ///< one after the other
  std::vector<HoleTable> tables{};
  Omitted omitted{};

  void append(Planned other);
};

/// How many notes, horizontal or vertical dimensions a view has at most; and slopes that all views dimension.
inline constexpr std::size_t max_of_a_kind = 40;

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

/// A view that shows one of several equal features from the side; null if there is none. `inside`: as in
/// ViewChoice::beside.
template <class Feature>
const NamedProjection* view_beside(const ViewChoice& views, const std::vector<const Feature*>& group,
                                   const std::function<Vec3(const Feature&)>& centre, bool inside) {
  const NamedProjection* view = nullptr;
  for (std::size_t i = 0; i < group.size() && view == nullptr; ++i)
    view = views.beside(group[i]->axis, centre(*group[i]), inside);
  return view;
}

/// Whether an overall dimension is the diameter of a cylinder.
bool is_overall(const DimensionSubject& subject, const features::CylinderFeature& cylinder);

}  // namespace epura::sheet
