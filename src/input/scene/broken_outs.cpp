// SPDX-License-Identifier: Apache-2.0
#include "scene/broken_outs.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/view_names.hpp"

namespace epura::scene {

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
