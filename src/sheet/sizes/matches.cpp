// SPDX-License-Identifier: Apache-2.0
#include "sizes/matches.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "sizes/anchors.hpp"
#include "sizes/tolerance.hpp"
#include "sizes/twins.hpp"

namespace epura::sheet {

namespace {

using scene::DimensionDescription;

constexpr std::string_view value_sign = "<>";

// As whoever types it may write it.
std::string plain(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> same{
      {{"Ø", "⌀"}, {"ø", "⌀"}, {"x", "×"}, {",", "."}}};
  for (const auto& [old, with] : same) text = replaced(std::move(text), old, with);
  return text;
}

double angle_of(const AnchoredDimension& dimension) {
  const Vec3 one = glm::normalize(dimension.points[1] - dimension.points[0]);
  const Vec3 other = glm::normalize(dimension.points[2] - dimension.points[0]);
  return portable_atan2(glm::length(glm::cross(one, other)), glm::dot(one, other)) * 180 / std::numbers::pi;
}

// What a dimension measures, in the world; of a row, from its origin to a place.
std::optional<MeasuredValue> value_of(const AnchoredDimension& dimension, std::size_t place,
                                      const NamedProjection& view, const Notation& notation) {
  using features::ExtentForm;
  switch (dimension.type) {
    case DimensionType::diameter:
      return MeasuredValue{2 * dimension.circles.front().radius, notation.diameter};
    case DimensionType::radius:
      return MeasuredValue{dimension.circles.front().radius, "R"};
    case DimensionType::angular:
      return MeasuredValue{angle_of(dimension), "", true};
    case DimensionType::overall: {
      const int axis = axis_of(*dimension.direction);
      return MeasuredValue{dimension.points[1][axis] - dimension.points[0][axis],
                           dimension.form == ExtentForm::length     ? ""
                           : dimension.form == ExtentForm::diameter ? notation.diameter
                                                                    : "S" + notation.diameter};
    }
    case DimensionType::linear:
    case DimensionType::aligned:
      return MeasuredValue{
          std::abs(glm::dot(dimension.points[place] - dimension.points[0], direction_of(dimension, view)))};
    default:
      return std::nullopt;
  }
}

/// What stands on the sheet without a wish.
struct WrittenSize {
  std::string whole, value;
};

std::optional<WrittenSize> written(const DimensionDescription& description, const AnchoredDimension& dimension,
                                   std::size_t place, const NamedProjection& view, const Notation& notation) {
  if (dimension.is_label) return std::nullopt;
  const std::optional<MeasuredValue> measured = value_of(dimension, place, view, notation);
  if (!measured) return std::nullopt;
  const std::string value = text_of(*measured, std::nullopt, notation).line();
  return WrittenSize{description.text.given() ? replaced(*description.text, value_sign, value) : value, value};
}

bool is_elsewhere(const DimensionDescription& wish, const DimensionDescription& dimension) {
  const auto differs = [](const auto& wanted, const auto& other) {
    return wanted.given() && wanted.value != other.value;
  };
  return differs(wish.view, dimension.view) || differs(wish.type, dimension.type) ||
         differs(wish.direction, dimension.direction);
}

bool fits(const DimensionDescription& wish, const WrittenSize& size) {
  const std::string pattern = plain(*wish.match);
  const auto is_it = [&pattern](const std::string& text) {
    return ::fnmatch(pattern.c_str(), plain(text).c_str(), 0) == 0;
  };
  return is_it(size.whole) || is_it(size.value);
}

void apply(const DimensionDescription& wish, DimensionDescription& dimension) {
  const bool is_auxiliary = dimension.text.value_or("").starts_with('(');
  if (is_auxiliary && wish.tolerance.given()) dimension.text = {};
  if (wish.text.given())
    dimension.text = {replaced(*wish.text, value_sign, dimension.text.value_or(std::string(value_sign))),
                      wish.text.where};
  if (wish.tolerance.given()) dimension.tolerance = wish.tolerance;
  if (wish.limits.given()) dimension.limits = wish.limits;
  if (wish.offset.given()) dimension.offset = wish.offset;
  if (wish.name.given()) dimension.name = wish.name;
  dimension.where = wish.where;
}

// Only what is measured from the origin of a row can stand apart from it.
bool can_stand_apart(const DimensionDescription& dimension) {
  return dimension.arrangement.value_or(DimensionArrangement::baseline) != DimensionArrangement::chain;
}

DimensionDescription apart(const DimensionDescription& row, std::size_t place) {
  DimensionDescription one = row;
  one.arrangement = {};
  one.anchors = {row.anchors[0], row.anchors[place]};
  if (!row.opposite.empty()) one.opposite = {row.opposite[0], row.opposite[place]};
  return one;
}

void leave_out(DimensionDescription& row, std::size_t place) {
  row.anchors.erase(row.anchors.begin() + static_cast<std::ptrdiff_t>(place));
  if (!row.opposite.empty()) row.opposite.erase(row.opposite.begin() + static_cast<std::ptrdiff_t>(place));
  if (row.anchors.size() == 2) row.arrangement = {};
}

/// The wishes of a scene and how sizes are written.
struct Wishes {
  std::span<const DimensionDescription> list;
  const Notation& notation;

  // Whether a dimension, or all places of a row, are taken.
  bool take(DimensionDescription& dimension, const AnchoredDimension& anchored, const NamedProjection& view,
            Matches& matches) const {
    if (dimension.arrangement.given() && !can_stand_apart(dimension)) return false;
    const std::size_t first = 1, end = dimension.arrangement.given() ? anchored.points.size() : 2;
    bool is_taken = false;
    for (std::size_t place = end; place-- > first;) {
      const std::optional<WrittenSize> size = written(dimension, anchored, place, view, notation);
      if (!size) continue;
      matches.sizes.push_back(size->whole);
      DimensionDescription one = end > 2 ? apart(dimension, place) : dimension;
      bool is_met = false;
      for (const DimensionDescription& wish : list) {
        if (!fits(wish, *size)) continue;
        if (is_elsewhere(wish, dimension)) {
          matches.others.push_back({wish.where, view.name});
          continue;
        }
        apply(wish, one);
        matches.met.push_back(wish.where);
        is_met = true;
      }
      if (!is_met) continue;
      matches.matched.push_back(std::move(one));
      if (end > 2) leave_out(dimension, place);
      is_taken = dimension.anchors.size() < 2 || end == 2;
    }
    return is_taken;
  }
};

}  // namespace

Matches take_matches(std::vector<DimensionDescription>& automatic, std::span<const DimensionDescription> wishes,
                     const world::World& world, std::span<const NamedProjection> views, Notation notation) {
  Matches matches;
  if (wishes.empty() || automatic.empty()) return matches;
  notation.sign = DecimalSign::point;
  notation.diameter = "⌀";
  const std::vector<AnchoredDimension> anchored = find_anchors(world, automatic);
  check(anchored.size() == automatic.size(), "each dimension has its anchors");
  std::vector<DimensionDescription> rest;
  for (std::size_t i = 0; i < automatic.size(); ++i) {
    const auto view = std::find_if(views.begin(), views.end(), [&](const NamedProjection& one) {
      return one.name == automatic[i].view.value_or("");
    });
    if (view == views.end() || !Wishes{wishes, notation}.take(automatic[i], anchored[i], *view, matches))
      rest.push_back(std::move(automatic[i]));
  }
  automatic = std::move(rest);
  return matches;
}

}  // namespace epura::sheet
