// SPDX-License-Identifier: Apache-2.0
#include "scene/broken_outs.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& reason, const std::string& hint) {
  throw Error(ErrorKind::input, where, reason, hint);
}

void expect_line(const BrokenOutDescription& one) {
  if (!finite(*one.point)) refuse(one.point.where, "the point has a number that is not finite", "");
  if (one.radius.given() == one.outline.given())
    refuse(one.point.where,
           std::string("a broken-out section has ") + (one.radius.given() ? "both a radius and an outline" : "no line"),
           "give the radius of the freehand line around the point, or an outline of three points or more");
  if (!one.outline.given()) return;
  if (one.outline->size() < 3)
    refuse(one.outline.where, "the outline has fewer than three points", "give points around the area to be cut");
  for (const Vec3& p : *one.outline)
    if (!finite(p)) refuse(one.outline.where, "the outline has a number that is not finite", "");
}

const ViewDescription& view_of(const BrokenOutDescription& one, const std::vector<ViewDescription>& views) {
  const auto is_it = [&](const ViewDescription& view) {
    return one.view.given() ? *view.name == *one.view : !view.detail.given();
  };
  const auto found = std::find_if(views.begin(), views.end(), is_it);
  const std::string& where = one.view.given() ? one.view.where : one.point.where;
  if (found == views.end()) {
    std::vector<std::string> names;
    for (const ViewDescription& view : views)
      if (!view.detail.given()) names.push_back(*view.name);
    refuse(where, "there is no view '" + *one.view + "'", did_you_mean(*one.view, names));
  }
  if (found->detail.given())
    refuse(where, "view '" + *found->name + "' shows a detail",
           "name the view that it enlarges; the detail shows its broken-out sections, too");
  if (found->section.given())
    refuse(where, "view '" + *found->name + "' shows section " + *found->section + ", and is cut already",
           "name a view of the whole");
  return *found;
}

}  // namespace

void complete_broken_outs(SceneDescription& scene) {
  for (BrokenOutDescription& one : scene.broken_outs) {
    expect_line(one);
    one.view = {*view_of(one, scene.views).name, one.view.given() ? one.view.where : one.point.where};
  }
}

}  // namespace epura::scene
