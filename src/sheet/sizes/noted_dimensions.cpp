// SPDX-License-Identifier: Apache-2.0
#include "sizes/noted_dimensions.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/hole_judge.hpp"
#include "sizes/hole_walls.hpp"
#include "sizes/note_text.hpp"
#include "sizes/noted_circles.hpp"

namespace epura::sheet {

namespace {

std::optional<DimensionType> type_of(const NotedText& text) {
  const NotedElement* size = text.size();
  if (size == nullptr) return text.gives_thread() ? std::optional(DimensionType::diameter) : std::nullopt;
  const bool is_radius = size->sign == NotedSign::radius || size->sign == NotedSign::sphere_radius;
  if (is_radius) return DimensionType::radius;
  const bool is_diameter = size->sign == NotedSign::diameter || size->sign == NotedSign::sphere;
  return is_diameter ? std::optional(DimensionType::diameter) : std::nullopt;
}

AnchoredDimension dimension_of(const std::string& text, DimensionType type, WorldCircle circle) {
  return {.where = "note '" + text + "'",
          .type = type,
          .direction = {},
          .points = {circle.centre},
          .circles = {std::move(circle)},
          .offset = {},
          .text = text};
}

// "6× ⌀9 ON ⌀60": of the circle on which they are.
std::optional<AnchoredDimension> dimension_of_circle(const std::string& text, const WorldCircle& hole,
                                                     const HoleWalls& walls, const Notation& notation) {
  const NotedText read = read_text(text, notation);
  const auto noted =
      std::ranges::find_if(read.elements, [](const NotedElement& one) { return one.role == NotedRole::circle; });
  if (noted == read.elements.end() || read.count < 2) return std::nullopt;
  std::vector<WorldCircle> equal;
  for (const HoleChain& one : walls.chains_of(hole.radius))
    equal.push_back({one.centre, one.axis, hole.radius, {}, true});
  const auto circles = circles_of_holes(hole, equal, noted->least, 2 * walls.slack() + noted->slack);
  const auto found = std::ranges::find_if(
      circles, [&](const CircleOfHoles& one) { return one.angles.size() >= static_cast<std::size_t>(read.count); });
  if (found == circles.end()) return std::nullopt;
  check(found->circle.radius > 0, "what is round has a radius");
  return dimension_of("⌀" + length_text(noted->least, notation), DimensionType::diameter, found->circle);
}

// Of all that are as it says.
std::optional<AnchoredDimension> dimension_of_all(const std::string& note, const HoleWalls& walls,
                                                  const Notation& notation) {
  const NotedText text = read_text(note, notation);
  const auto type = type_of(text);
  const bool is_of_fillets = text.kind == NotedKind::fillets;
  if (text.size() == nullptr || !type || (!is_of_fillets && text.kind != NotedKind::holes)) return std::nullopt;
  const double factor = *type == DimensionType::diameter ? 2 : 1;
  std::vector<NotedRound> meant = walls.rounds();
  std::erase_if(meant, [&](const NotedRound& one) {
    return one.is_fillet() != is_of_fillets || (!is_of_fillets && !one.inwards) ||
           !text.size()->allows(factor * one.circle.radius, factor * walls.slack());
  });
  if (meant.empty()) return std::nullopt;
  check(meant.front().circle.radius > 0, "what is round has a radius");
  const std::string sign = *type == DimensionType::diameter ? "⌀" : "R";
  std::string own = times(meant.size()) + sign + length_text(text.size()->least, notation);
  if (std::ranges::any_of(text.elements, [](const auto& one) { return one.role == NotedRole::through; }))
    own += " THRU";
  return dimension_of(own, *type, meant.front().circle);
}

}  // namespace

std::vector<DimensionsInView> with_noted_sizes(std::span<const DimensionsInView> views,
                                               std::span<const std::string> general, const world::World& world,
                                               const Notation& notation) {
  std::vector<DimensionsInView> all(views.begin(), views.end());
  const bool any = !general.empty() || std::ranges::any_of(all, [](const DimensionsInView& view) {
    return !view.notes.empty() ||
           std::ranges::any_of(view.dimensions, [](const auto& one) { return !one.text.empty(); });
  });
  if (!any || all.empty()) return all;
  const HoleWalls walls(world);
  for (DimensionsInView& view : all) {
    for (const LeaderNote& note : view.notes) {
      const NotedText text = read_text(note.text, notation);
      const auto type = type_of(text);
      const auto circle = type ? walls.circle_of(note) : std::optional<WorldCircle>();
      if (!circle) continue;
      const WorldCircle meant = circle_meant(text, *circle, walls);
      const double factor = *type == DimensionType::diameter ? 2 : 1;
      if (text.size() == nullptr || text.size()->allows(factor * meant.radius, factor * walls.slack()))
        view.dimensions.push_back(dimension_of(note.text, *type, meant));
    }
    for (std::size_t i = 0; i < view.dimensions.size(); ++i) {
      const AnchoredDimension& one = view.dimensions[i];
      if (one.type != DimensionType::diameter || one.circles.empty() || one.text.empty()) continue;
      if (auto circle = dimension_of_circle(one.text, one.circles.front(), walls, notation))
        view.dimensions.push_back(std::move(*circle));
    }
  }
  for (const std::string& note : general)
    if (auto dimension = dimension_of_all(note, walls, notation))
      all.front().dimensions.push_back(std::move(*dimension));
  check(all.size() == views.size(), "each view stays one");
  return all;
}

}  // namespace epura::sheet
