// SPDX-License-Identifier: Apache-2.0
#include "scene/details.hpp"

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/part_options.hpp"

namespace epura::scene {

namespace {

const std::string& where_of(const DetailDescription& detail) {
  return detail.view.given() ? detail.view.where : detail.name.where;
}

void expect_shape(const DetailDescription& detail) {
  if (detail.radius.given() == detail.size.given())
    refuse_input(
        detail.name.where,
        "detail '" + *detail.name + "' has " + (detail.size.given() ? "both a radius and a size" : "no radius"),
        "give the radius of a circle, or the size of a rectangle, [width, height]");
}

const ViewDescription& parent_of(const DetailDescription& detail, const SceneDescription& scene) {
  const auto is_it = [&](const ViewDescription& view) {
    return detail.view.given() ? *view.name == *detail.view : !view.detail.given();
  };
  const auto found = std::find_if(scene.views.begin(), scene.views.end(), is_it);
  if (found == scene.views.end()) {
    std::vector<std::string> names;
    for (const ViewDescription& view : scene.views)
      if (!view.detail.given()) names.push_back(*view.name);
    if (!detail.view.given())
      refuse_input(where_of(detail), "detail '" + *detail.name + "' has no view to enlarge",
                   "add a [[view]] of the whole");
    refuse_input(where_of(detail), "there is no view '" + *detail.view + "'", did_you_mean(*detail.view, names));
  }
  if (found->detail.given())
    refuse_input(where_of(detail), "view '" + *found->name + "' itself shows a detail", "name the view of the whole");
  return *found;
}

void expect_detail_view(const ViewDescription& view) {
  if (view.projection.given())
    refuse_input(view.projection.where, "a view of a detail has the projection of the view that it enlarges",
                 "omit 'projection', or 'detail'");
  if (view.section.given())
    refuse_input(view.section.where, "a view of a detail shows the section that the enlarged view shows",
                 "omit it; to enlarge a section, name its view in the [[detail]]");
  if (!view.scale.given() || !view.scale->fixed)
    refuse_input(view.scale.given() ? view.scale.where : view.detail.where,
                 "the view of detail '" + *view.detail + "' lacks a scale",
                 "write one larger than its parent's, such as 5:1");
}

// What the view does not say itself of its lines is as in its parent, which alone shows constructions.
void inherit_from(const ViewDescription& parent, ViewDescription& view) {
  const Options<ViewDescription> options = line_options();
  ViewDescription lines;
  overrule(lines, parent, options);
  lines.construction = {};
  lines.centre_of_gravity = {};
  overrule(lines, view, options);
  overrule(view, lines, options);
  view.projection = parent.projection;
  view.section = parent.section;
  if (!view.sheet.given()) view.sheet = parent.sheet;
}

}  // namespace

Vec2 half_size(const DetailDescription& detail) {
  return detail.radius.given() ? Vec2(*detail.radius) : *detail.size / 2.0;
}

void expect_projections(const SceneDescription& scene) {
  for (const ViewDescription& view : scene.views)
    if (!view.projection.given() && !view.detail.given())
      refuse_input(view.projection.where, "[[view]] lacks 'projection'",
                   "`NAME[:key=value...]`, or `{name = NAME, key = value}`");
}

const DetailDescription* find_detail(const SceneDescription& scene, const std::string& name) {
  const auto found = std::find_if(scene.details.begin(), scene.details.end(),
                                  [&name](const DetailDescription& detail) { return *detail.name == name; });
  return found == scene.details.end() ? nullptr : &*found;
}

void complete_details(SceneDescription& scene) {
  for (const DetailDescription& detail : scene.details) expect_shape(detail);
  std::vector<std::string> names;
  for (const DetailDescription& detail : scene.details) names.push_back(*detail.name);
  for (ViewDescription& view : scene.views) {
    if (!view.detail.given()) continue;
    const DetailDescription* detail = find_detail(scene, *view.detail);
    if (detail == nullptr)
      refuse_input(view.detail.where, "there is no detail '" + *view.detail + "'",
                   names.empty() ? "there is no [[detail]]" : did_you_mean(*view.detail, names));
    expect_detail_view(view);
    inherit_from(parent_of(*detail, scene), view);
  }
  const auto is_shown = [&](const DetailDescription& detail) {
    return std::any_of(scene.views.begin(), scene.views.end(),
                       [&](const ViewDescription& view) { return view.detail.value == *detail.name; });
  };
  for (DetailDescription& detail : scene.details)
    if (is_shown(detail)) detail.view = {*parent_of(detail, scene).name, where_of(detail)};
}

DetailRequest parse_detail(std::string_view text, const std::string& where) {
  const auto parts = split(text, ':');
  const auto centre = parts.size() >= 3 ? parse_vector(parts[0]) : std::nullopt;
  const auto radius = parts.size() >= 3 ? parse_number(parts[1]) : std::nullopt;
  if (!centre || !radius || !(*radius > 0) || !is_usable(*radius))
    refuse_input(where, "'" + std::string(text) + "' is not a detail",
                 "write its centre, its radius and its scale, X,Y,Z:RADIUS:SCALE, such as 40,0,10:6:5:1");
  const std::size_t before = parts[0].size() + parts[1].size() + 2;
  const ScaleChoice scale = parse_scale(text.substr(before), where);
  if (!scale.fixed) refuse_input(where, "the scale of a detail cannot be automatic", "write one such as 5:1");
  return {*centre, *radius, scale};
}

}  // namespace epura::scene
