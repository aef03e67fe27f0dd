// SPDX-License-Identifier: Apache-2.0
#include "sizes/twins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::same_size;
using scene::DimensionDescription;

/// The corner of an angle, and the directions of its legs; unit vectors.
struct Angle {
  Vec3 corner;
  std::array<Vec3, 2> legs;
};

/// What a dimension measures: a circle, an angle, or from one place to another along a direction.
struct Measure {
  std::optional<WorldCircle> circle{};
  Vec3 along{0};
  double from = 0, to = 0;
  bool across = false;  ///< whether a diameter and a length across its circle may be one
  std::optional<Angle> angle{};
};

std::optional<Vec3> direction_in_views(const DimensionDescription& description, const AnchoredDimension& dimension,
                                       std::span<const NamedProjection> views) {
  for (const NamedProjection& view : views)
    if (description.view.value_or("") == view.name) return direction_of(dimension, view);
  return std::nullopt;
}

std::optional<Measure> measure_of(const DimensionDescription& description, const AnchoredDimension& dimension,
                                  std::span<const NamedProjection> views) {
  if (dimension.is_label || dimension.arrangement) return std::nullopt;
  if (dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius)
    return Measure{dimension.circles.front(), Vec3(0), 0, 0, dimension.type == DimensionType::diameter};
  if (dimension.type == DimensionType::arc) return std::nullopt;
  if (dimension.type == DimensionType::angular) {
    const Vec3& corner = dimension.points[0];
    const auto leg = [&](std::size_t end) { return glm::normalize(dimension.points[end] - corner); };
    return Measure{.angle = Angle{corner, {leg(1), leg(2)}}};
  }
  const std::optional<Vec3> along = direction_in_views(description, dimension, views);
  if (!along) return std::nullopt;
  const bool across = dimension.type != DimensionType::overall || dimension.form == features::ExtentForm::diameter;
  return Measure{{}, *along, glm::dot(dimension.points[0], *along), glm::dot(dimension.points[1], *along), across};
}

std::vector<std::optional<Measure>> measures_of(const std::vector<DimensionDescription>& descriptions,
                                                const world::World& world, std::span<const NamedProjection> views) {
  const std::vector<AnchoredDimension> anchored = find_anchors(world, descriptions);
  std::vector<std::optional<Measure>> measures;
  for (std::size_t i = 0; i < anchored.size(); ++i) measures.push_back(measure_of(descriptions[i], anchored[i], views));
  return measures;
}

bool are_one_circle(const WorldCircle& a, const WorldCircle& b) {
  const double slack = 10 * same_size * a.radius;
  return std::abs(a.radius - b.radius) <= slack && are_parallel(a.axis, b.axis) &&
         features::distance_from_line(b.centre, a.centre, a.axis) <= slack;
}

WorldCircle circle_of(const features::HoleFeature& hole) {
  return {hole.mouth, hole.axis, hole.called() / 2, {}, true};
}

// The hole of which a circle is; null if it is of none.
const features::HoleFeature* hole_at(const WorldCircle& circle, const features::PartFeatures& features) {
  const auto hole = std::ranges::find_if(
      features.holes, [&circle](const features::HoleFeature& one) { return are_one_circle(circle_of(one), circle); });
  return hole == features.holes.end() ? nullptr : &*hole;
}

// Whether two circles are those of holes that one note describes.
bool are_of_equal_holes(const WorldCircle& a, const WorldCircle& b, const features::PartFeatures& features) {
  const features::HoleFeature *one = hole_at(a, features), *other = hole_at(b, features);
  return one != nullptr && other != nullptr && features::are_equal(*one, *other);
}

// The place in a hole where another place is in an equal hole: axonometric views show bores below their recesses.
Vec3 place_in(const features::HoleFeature& hole, const features::HoleFeature& equal, const Vec3& place) {
  return hole.mouth + glm::dot(place - equal.mouth, equal.axis) * hole.axis;
}

bool is_across(const Measure& length, const WorldCircle& circle) {
  const double slack = 10 * same_size * circle.radius, middle = glm::dot(circle.centre, length.along);
  return std::abs(glm::dot(circle.axis, length.along)) <= features::parallel &&
         std::abs(std::abs(length.to - length.from) - 2 * circle.radius) <= slack &&
         std::abs((length.from + length.to) / 2 - middle) <= slack;
}

bool are_one(const Measure& a, const Measure& b, const features::PartFeatures& features, double slack) {
  if (a.angle || b.angle) return false;  // see follows_from
  if (a.circle && b.circle)
    return are_one_circle(*a.circle, *b.circle) || are_of_equal_holes(*a.circle, *b.circle, features);
  if (a.circle) return a.across && b.across && is_across(b, *a.circle);
  if (b.circle) return a.across && b.across && is_across(a, *b.circle);
  if (!are_parallel(a.along, b.along)) return false;
  const double way = glm::dot(a.along, b.along) < 0 ? -1 : 1;
  const auto near = [&](double x, double y) { return std::abs(x - way * y) <= slack; };
  return (near(a.from, b.from) && near(a.to, b.to)) || (near(a.from, b.to) && near(a.to, b.from));
}

// Whether one of the sides that automatic angles give follows from a given one: each of its legs is a side at this
// angle to what they are measured from, or is this. An angle of one side alone is at that side.
bool follows_from(const Angle& automatic, bool is_alone, const Angle& given, double slack) {
  const auto& [from, side] = automatic.legs;
  const Vec3 normal = glm::cross(from, side);
  if (!are_parallel(glm::normalize(normal), glm::normalize(glm::cross(given.legs[0], given.legs[1])))) return false;
  const double cosine = std::abs(glm::dot(from, side));
  int sides = 0;
  for (const Vec3& leg : given.legs) {
    const bool is_side = std::abs(std::abs(glm::dot(leg, from)) - cosine) <= features::parallel;
    if (!is_side && !are_parallel(leg, from)) return false;
    if (is_side) ++sides;
  }
  return sides > 0 && (!is_alone || features::distance_from_line(given.corner, automatic.corner, side) <= slack);
}

// Takes those sides out of the number for which an automatic angle stands. Whether none is left.
bool leave_angle_to_others(DimensionDescription& automatic, const Angle& angle,
                           std::span<DimensionDescription* const> given,
                           const std::vector<std::optional<Measure>>& measures, double slack) {
  const int all = repeats_of(automatic.text.value_or(""));
  int left = all;
  for (std::size_t j = 0; j < given.size(); ++j)
    if (measures[j] && measures[j]->angle && given[j]->text.value_or("").rfind('(', 0) != 0 &&
        follows_from(angle, all == 1, *measures[j]->angle, slack))
      left -= repeats_of(given[j]->text.value_or(""));
  if (left == all || left <= 0) return left <= 0;
  const std::string text = automatic.text.value_or("");
  automatic.text.value =
      times(static_cast<std::size_t>(left)) + text.substr(times(static_cast<std::size_t>(all)).size());
  return false;
}

// A text in brackets is auxiliary (ISO 129-1). A length across a circle has no text of the circle: number, depth.
bool is_replacement(const DimensionDescription& given, const DimensionDescription& automatic, bool same_kind) {
  if (!given.text.given()) return same_kind || !automatic.text.given();
  return given.text->rfind('(', 0) != 0 && repeats_of(*given.text) == repeats_of(automatic.text.value_or(""));
}

/// Dimensions with what they measure.
struct MeasuredGiven {
  std::span<DimensionDescription* const> given;
  const std::vector<std::optional<Measure>>& measures;
};

// Leaves the features of which others say the size out of a note for several.
void leave_to_others(DimensionDescription& automatic, int count, const MeasuredGiven& of,
                     const features::PartFeatures& features) {
  const std::string text = automatic.text.value_or("");
  const int all = repeats_of(text);
  if (count == 0 || all <= count || !automatic.circle) return;
  const scene::FeatureCircle circle = *automatic.circle;
  const WorldCircle own{circle.centre, circle.axis, circle.radius, {}, true};
  const auto is_given = [&](const WorldCircle& one) {
    return std::any_of(of.given.begin(), of.given.end(), [&](const DimensionDescription* given) {
      return !given->requirement.empty() && given->circle &&
             are_one_circle({given->circle->centre, given->circle->axis, given->circle->radius, {}, true}, one);
    });
  };
  const features::HoleFeature* at = is_given(own) ? hole_at(own, features) : nullptr;
  const auto other = std::ranges::find_if(features.holes, [&](const features::HoleFeature& hole) {
    return at != nullptr && features::are_equal(*at, hole) && !is_given(circle_of(hole));
  });
  if (other != features.holes.end()) automatic.circle->centre = place_in(*other, *at, circle.centre);
  automatic.text.value = times(static_cast<std::size_t>(all - count)) + text.substr(times(std::size_t(all)).size());
}

// Requirements of a file say themselves for how many features they hold: they replace a dimension of features for all
// of which they are, and say the rest of what it says behind them, as its depth.
bool is_required(DimensionDescription& automatic, const Measure& measure, const MeasuredGiven& of,
                 const features::PartFeatures& features, double slack) {
  std::vector<DimensionDescription*> same;
  int count = 0;
  for (std::size_t j = 0; j < of.given.size(); ++j) {
    if (of.given[j]->requirement.empty() || !of.measures[j] || !are_one(measure, *of.measures[j], features, slack))
      continue;
    count += repeats_of(of.given[j]->text.value_or(""));
    if (of.measures[j]->circle.has_value() == measure.circle.has_value()) same.push_back(of.given[j]);
  }
  const std::string text = automatic.text.value_or("<>");
  if (count < repeats_of(text)) leave_to_others(automatic, count, of, features);
  if (count < repeats_of(text)) return false;
  const std::size_t sign = text.find("<>");
  for (DimensionDescription* one : same)
    if (sign != std::string::npos) one->text.value.value() += text.substr(sign + 2);
  return true;
}

// Half circles at both ends of a slot.
std::array<scene::FeatureCircle, 2> ends_of(const features::SlotFeature& slot) {
  std::array<scene::FeatureCircle, 2> ends;
  for (std::size_t end = 0; end < 2; ++end) {
    const Vec3 &centre = slot.centres[end], along = glm::normalize(centre - slot.centres[1 - end]);
    const Vec3 out = glm::cross(slot.axis, along);
    ends[end] = {centre,
                 slot.axis,
                 slot.radius,
                 {centre - slot.radius * out, centre + slot.radius * along, centre + slot.radius * out}};
  }
  return ends;
}

}  // namespace

std::vector<scene::FeatureCircle> equal_circles(const DimensionDescription& automatic,
                                                std::span<const DimensionDescription> given,
                                                const features::PartFeatures& features) {
  std::vector<scene::FeatureCircle> equal;
  if (!automatic.circle || automatic.is_label || repeats_of(automatic.text.value_or("")) < 2) return equal;
  const scene::FeatureCircle& own = *automatic.circle;
  const auto circle_at = [](const scene::FeatureCircle& one) {
    return WorldCircle{one.centre, one.axis, one.radius, one.arc, one.arc.empty()};
  };
  const auto add = [&](scene::FeatureCircle one) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const DimensionDescription& other) {
      return other.circle && are_one_circle(circle_at(*other.circle), circle_at(one));
    });
    if (!is_given && are_parallel(own.axis, one.axis) && features::are_same(own.radius, one.radius) &&
        !are_one_circle(circle_at(own), circle_at(one)))
      equal.push_back(std::move(one));
  };
  if (*automatic.type == DimensionType::diameter) {
    const features::HoleFeature* at = hole_at(circle_at(own), features);
    for (const features::HoleFeature& hole : features.holes)
      if (at != nullptr && glm::dot(own.axis, hole.axis) > 0 && features::are_equal(*at, hole))
        add({place_in(hole, *at, own.centre), hole.axis, hole.called() / 2, {}});
    return equal;
  }
  const auto is_own = [&](const scene::FeatureCircle& end) { return are_one_circle(circle_at(own), circle_at(end)); };
  bool is_slot = false;  // otherwise a fillet
  for (const features::SlotFeature& slot : features.slots) {
    const auto ends = ends_of(slot);
    is_slot = is_slot || std::any_of(ends.begin(), ends.end(), is_own);
  }
  if (is_slot)
    for (const features::SlotFeature& slot : features.slots)
      for (const scene::FeatureCircle& end : ends_of(slot)) add(end);
  else
    for (const features::ArcFeature& arc : features.arcs) add({arc.centre, arc.axis, arc.radius, arc.points});
  check(equal.size() <= features.arcs.size() + 2 * features.slots.size(), "equal features are those of the part");
  return equal;
}

Vec3 direction_of(const AnchoredDimension& dimension, const NamedProjection& view) {
  if (dimension.type == DimensionType::overall) return Mat3(1)[axis_of(*dimension.direction)];
  if (dimension.type == DimensionType::aligned) return glm::normalize(dimension.points[1] - dimension.points[0]);
  return *dimension.direction == DimensionDirection::horizontal ? view.projection.u : view.projection.v;
}

void replace_twins(std::vector<DimensionDescription>& automatic, std::span<DimensionDescription* const> given,
                   const world::World& world, const features::PartFeatures& features,
                   std::span<const NamedProjection> views) {
  if (automatic.empty() || given.empty()) return;
  std::vector<DimensionDescription> copies;
  for (const DimensionDescription* one : given) copies.push_back(*one);
  const auto of_given = measures_of(copies, world, views), of_automatic = measures_of(automatic, world, views);
  check(of_given.size() == given.size() && of_automatic.size() == automatic.size(), "each dimension has a measure");
  const double slack = same_size * glm::length(world.box.size());
  std::vector<char> replaced(automatic.size(), 0);
  for (std::size_t i = 0; i < automatic.size(); ++i) {
    if (of_automatic[i] && of_automatic[i]->angle)
      replaced[i] = leave_angle_to_others(automatic[i], *of_automatic[i]->angle, given, of_given, slack) ? 1 : 0;
    if (of_automatic[i] && is_required(automatic[i], *of_automatic[i], {given, of_given}, features, slack))
      replaced[i] = 1;
    for (std::size_t j = 0; j < given.size() && replaced[i] == 0; ++j) {
      if (!of_automatic[i] || !of_given[j] || !given[j]->requirement.empty() ||
          !are_one(*of_automatic[i], *of_given[j], features, slack))
        continue;
      const bool same_kind = of_automatic[i]->circle.has_value() == of_given[j]->circle.has_value();
      if (!is_replacement(*given[j], automatic[i], same_kind)) continue;
      // A size with a tolerance is not auxiliary.
      const bool is_auxiliary = automatic[i].text.value_or("").rfind('(', 0) == 0 && given[j]->tolerance.given();
      if (!given[j]->text.given() && automatic[i].text.given() && same_kind && !is_auxiliary)
        given[j]->text = automatic[i].text;
      replaced[i] = 1;
    }
  }
  std::size_t number = 0;
  std::erase_if(automatic, [&](const DimensionDescription&) { return replaced[number++] != 0; });
}

}  // namespace epura::sheet
