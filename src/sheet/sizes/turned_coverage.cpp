// SPDX-License-Identifier: Apache-2.0
#include "sizes/turned_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/feature_places.hpp"
#include "sizes/hole_angles.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::same_size;

// Whether a length along a slope begins or ends at a place.
bool measures(const AnchoredDimension& dimension, const Vec3& along, const Vec3& place, double slack) {
  if (dimension.type != DimensionType::aligned) return false;
  check(dimension.points.size() == 2, "an aligned dimension has two ends");
  const Vec3 span = dimension.points[1] - dimension.points[0];
  if (!(glm::length(span) > 0) || !are_parallel(glm::normalize(span), along)) return false;
  const auto at = [&](const Vec3& p) { return glm::dot(p, along); };
  // A row "3× 20 (=60)" has places between its ends.
  const int parts = dimension.text.find('=') == std::string::npos ? 1 : repeats_of(dimension.text);
  for (int i = 0; i <= parts; ++i)
    if (std::abs(at(dimension.points[0] + (double(i) / parts) * span) - at(place)) <= slack) return true;
  return false;
}

class TurnedFinder {
 public:
  TurnedFinder(std::span<const DimensionsInView> views, const DimensionSubject& subject, const FeatureTable& table,
               const SizesOnSheet& on_sheet, const Notation& notation)
      : views_(views),
        features_(subject.features),
        table_(table),
        on_sheet_(on_sheet),
        notation_(notation),
        part_(on_sheet.held.empty() ? std::nullopt : world::place_part(subject.world.models.front())),
        slack_(same_size * glm::length(subject.world.box.size())) {
    check(on_sheet.held.empty() || (part_ && part_->faces.size() == on_sheet.held.size()), "each face is held or not");
  }

  TurnedCoverage find() {
    found_.holes.assign(features_.holes.size(), true);
    for (const RadialPattern& pattern : table_.radial) {
      add_angles(directions_of(pattern, table_.own_directions(pattern.axis)));
      if (!pattern.is_slanted || has_slant(pattern)) continue;
      for (const features::HoleFeature* hole : pattern.holes) found_.holes[number_of(hole)] = false;
      found_.missing.push_back(name_of(*pattern.holes.front()) + ": angle to the axis");
    }
    for (std::size_t i = 0; i < features_.pitch_circles.size(); ++i)
      add_angles(directions_of(features_, static_cast<int>(i), table_.own_directions(features_.pitch_circles[i].axis)));
    for (std::size_t i = 0; i < features_.holes.size(); ++i)
      if (const features::HoleFeature& hole = features_.holes[i];
          !table_.is_radial(hole) && !has_place(hole.mouth, hole.axis)) {
        found_.holes[i] = false;
        found_.missing.push_back(name_of(hole) + ": position along its slope");
      }
    for (const features::SlotFeature& slot : features_.slots)
      if (!has_place(slot.centres[0], slot.axis) || !has_place(slot.centres[1], slot.axis))
        found_.missing.push_back("slot R" + length_text(slot.radius, notation_) + ": position along its slope");
    add_own_places();
    check(found_.holes.size() == features_.holes.size(), "each hole is given or missing");
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::size_t number_of(const features::HoleFeature* hole) const {
    return static_cast<std::size_t>(hole - features_.holes.data());
  }
  [[nodiscard]] std::string name_of(const features::HoleFeature& hole) const {
    return "hole ⌀" + length_text(hole.diameter, notation_);
  }

  // Of evenly spaced ones, any may have the angle; those in a table have coordinates.
  void add_angles(const HoleDirections& around) {
    const auto is_given = [&](std::size_t number) {
      return any_dimension(views_, [&](const AnchoredDimension& one) { return gives_direction(one, around, number); });
    };
    bool any = false;
    for (std::size_t i = 0; around.are_even() && i < around.directions.size(); ++i) any = any || is_given(i);
    for (const std::size_t i : around.needed())
      if (!any && !is_given(i) && !is_labelled(around.holes[i]->mouth, on_sheet_)) {
        found_.holes[number_of(around.holes[i])] = false;
        found_.missing.push_back(name_of(*around.holes[i]) + ": angle");
      }
  }

  // Holes in a table have coordinates, and those on a pitch circle its place.
  void add_own_places() {
    const std::vector<PlacedAxis> axes = placed_axes(features_, table_, notation_);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!table_.is_turned(axes[i].axis) || has_own_place(axes[i].centre)) continue;
      const features::HoleFeature* hole = i < features_.holes.size() ? &features_.holes[i] : nullptr;
      if (hole != nullptr && (hole->pitch_circle >= 0 || is_labelled(hole->mouth, on_sheet_))) continue;
      if (hole != nullptr) found_.holes[i] = false;
      found_.missing.push_back(axes[i].name + ": position along the axes of the turned part");
    }
  }

  [[nodiscard]] bool has_own_place(const Vec3& place) const {
    const auto is_along = [&](std::size_t side) {
      const Vec3& along = table_.turned->directions[side];
      const auto& ends = table_.turned->ends[side];
      const double at = glm::dot(place, along), from = glm::dot(ends[0]->corners.front(), along),
                   to = glm::dot(ends[1]->corners.front(), along);
      return std::min(std::abs(at - from), std::abs(at - to)) <= slack_ ||
             any_dimension(views_, [&](const AnchoredDimension& one) { return measures(one, along, place, slack_); });
    };
    return is_along(0) && is_along(1);
  }

  // At any hole of a pattern.
  [[nodiscard]] bool has_slant(const RadialPattern& pattern) const {
    return any_dimension(views_, [&](const AnchoredDimension& one) {
      if (one.type != DimensionType::angular || glm::distance(one.points[0], pattern.centre) > slack_) return false;
      const auto has_leg = [&](const Vec3& along) {
        return std::any_of(one.points.begin() + 1, one.points.end(),
                           [&](const Vec3& end) { return are_parallel(glm::normalize(end - one.points[0]), along); });
      };
      return has_leg(pattern.axis) && std::any_of(pattern.holes.begin(), pattern.holes.end(),
                                                  [&](const auto* hole) { return has_leg(hole->axis); });
    });
  }

  [[nodiscard]] bool has_place(const Vec3& place, const Vec3& axis) const {
    if (features::axis_along(axis) >= 0 || is_held(place, axis)) return true;
    const std::optional<Vec3> along = slanted_across(axis);
    return along && any_dimension(views_, [&](const AnchoredDimension& dimension) {
             return measures(dimension, *along, place, slack_);
           });
  }

  // Whether dimensions hold all round faces about an axis.
  [[nodiscard]] bool is_held(const Vec3& place, const Vec3& axis) const {
    bool any = false, all = true;
    for (std::size_t face = 0; face < on_sheet_.held.size(); ++face) {
      const surfaces::PartSurface& one = part_->faces[face].surface;
      if (!surfaces::has_axis(one.kind) || !are_parallel(one.axis, axis) ||
          features::distance_from_line(place, one.origin, one.axis) > slack_)
        continue;
      any = true;
      all = all && on_sheet_.held[face] != 0;
    }
    return any && all;
  }

  std::span<const DimensionsInView> views_;
  const features::PartFeatures& features_;
  const FeatureTable& table_;
  const SizesOnSheet& on_sheet_;
  const Notation& notation_;
  std::optional<world::PlacedPart> part_;
  double slack_;
  TurnedCoverage found_;
};

}  // namespace

TurnedCoverage cover_turned(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                            const FeatureTable& table, const SizesOnSheet& on_sheet, const Notation& notation) {
  return TurnedFinder(views, subject, table, on_sheet, notation).find();
}

}  // namespace epura::sheet
