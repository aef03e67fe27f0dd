// SPDX-License-Identifier: Apache-2.0
#include "scene/view_sections.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"
#include "scene/arrow_views.hpp"
#include "scene/view_names.hpp"

namespace epura::scene {

namespace {

/// One side of a plane perpendicular to an axis.
struct Side {
  int axis;
  double at, sign;

  [[nodiscard]] Vec3 direction() const {
    Vec3 direction(0);
    direction[axis] = sign;
    return direction;
  }
};

// That of the viewer, who is to the right, before and above where the view itself does not say otherwise.
double nearer_side(int axis, std::string_view projection) {
  if (axis == 1) return projection == "back" ? 1 : -1;
  return projection == (axis == 0 ? "left" : "bottom") ? -1 : 1;
}

// "y@20", "+y@20" or "-y@20".
std::optional<Side> parse_side(std::string_view text, std::string_view projection) {
  const bool has_sign = text.starts_with('+') || text.starts_with('-');
  const std::string_view rest = text.substr(has_sign ? 1 : 0);
  const std::size_t axis = std::string_view("xyz").find(rest.empty() ? ' ' : rest.front());
  if (axis == std::string_view::npos || rest.substr(1, 1) != "@") return std::nullopt;
  const auto at = parse_number(rest.substr(2));
  if (!at || !is_usable(*at)) return std::nullopt;
  const int number = static_cast<int>(axis);
  return Side{number, *at, !has_sign ? nearer_side(number, projection) : text.front() == '-' ? -1.0 : 1.0};
}

SectionDescription parse_plane(std::string_view text, std::string_view projection, const std::string& where) {
  std::vector<Side> sides;
  bool is_sound = true;
  for (const std::string_view part : split(text, '/')) {
    const auto side = parse_side(part, projection);
    is_sound = is_sound && side;
    if (side) sides.push_back(*side);
  }
  if (!is_sound || sides.size() > 2 || (sides.size() == 2 && sides[0].axis == sides[1].axis))
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is neither a plane nor the name of a section",
                "write an axis and a place on it, y@20; -y@20 removes what is below; y@20/x@5 is a half section");
  SectionDescription section;
  section.normal = sides[0].direction();
  section.point[sides[0].axis] = sides[0].at;
  if (sides.size() == 1) return section;
  Vec3 corner = section.point;
  corner[sides[1].axis] = sides[1].at;
  section.path = {std::vector<Vec3>{corner + sides[1].direction(), corner, corner + section.normal}, where};
  return section;
}

}  // namespace

void take_view_sections(SceneDescription& scene) {
  std::set<std::string> letters = letters_of(scene);
  for (ViewDescription& view : scene.views) {
    if (!view.projection.given()) continue;
    const std::string& where = view.projection.where;
    for (const auto& [key, word] : view.projection.value->assignments) {
      if (key != "section") continue;
      if (view.section.given()) throw Error(ErrorKind::input, where, "has two sections", "omit one of them");
      view.section = {word, where};
      if (std::any_of(scene.sections.begin(), scene.sections.end(),
                      [&name = word](const SectionDescription& section) { return section.name.value == name; }))
        continue;
      SectionDescription section = parse_plane(word, view.projection->name, where);
      section.name = {next_letter(letters), where};
      view.section = section.name;
      scene.sections.push_back(std::move(section));
    }
    std::erase_if(view.projection.value->assignments,
                  [](const auto& assignment) { return assignment.first == "section"; });
  }
}

namespace {

// Points of an outline. Each of its sides splits all models: memory grows with the square.
constexpr std::size_t max_corners = 1000;

void expect_line(const BrokenOutDescription& one) {
  if (!finite(*one.point)) refuse_input(one.point.where, "the point has a number that is not finite", "");
  if (one.radius.given() == one.outline.given())
    refuse_input(
        one.point.where,
        std::string("a broken-out section has ") + (one.radius.given() ? "both a radius and an outline" : "no line"),
        "give the radius of the freehand line around the point, or an outline of three points or more");
  if (!one.outline.given()) return;
  if (one.outline->size() < 3)
    refuse_input(one.outline.where, "the outline has fewer than three points", "give points around the area to be cut");
  if (one.outline->size() > max_corners)
    refuse_input(one.outline.where,
                 "the outline has " + std::to_string(one.outline->size()) + " points, allowed are " +
                     std::to_string(max_corners),
                 "give every second point, or fewer");
  for (const Vec3& p : *one.outline)
    if (!finite(p)) refuse_input(one.outline.where, "the outline has a number that is not finite", "");
}

const ViewDescription& view_of(const BrokenOutDescription& one, const std::vector<ViewDescription>& views) {
  const ViewDescription& view = whole_view(one.view, one.point.where, views);
  if (view.section.given())
    refuse_input(one.view.given() ? one.view.where : one.point.where,
                 "view '" + *view.name + "' shows section " + *view.section + ", and is cut already",
                 "name a view of the whole");
  return view;
}

}  // namespace

void complete_broken_outs(SceneDescription& scene) {
  for (BrokenOutDescription& one : scene.broken_outs) {
    expect_line(one);
    one.view = {*view_of(one, scene.views).name, one.view.given() ? one.view.where : one.point.where};
  }
}

}  // namespace epura::scene
