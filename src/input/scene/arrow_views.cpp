// SPDX-License-Identifier: Apache-2.0
#include "scene/arrow_views.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

void expect_parent(const ViewDescription& view, const std::vector<ViewDescription>& views) {
  const auto parent =
      std::find_if(views.begin(), views.end(), [&](const ViewDescription& other) { return *other.name == *view.of; });
  if (parent == views.end()) {
    std::vector<std::string> names;
    for (const ViewDescription& other : views)
      if (!other.of.given() && !other.detail.given()) names.push_back(*other.name);
    refuse_input(view.of.where, "there is no view '" + *view.of + "'", did_you_mean(*view.of, names));
  }
  if (parent->of.given() || parent->detail.given())
    refuse_input(view.of.where,
                 "view '" + *view.of + "' itself " + (parent->of.given() ? "has a parent" : "shows a detail"),
                 "name a view that has its own projection");
}

}  // namespace

std::set<std::string> letters_of(const SceneDescription& scene) {
  std::set<std::string> taken;
  for (const SectionDescription& section : scene.sections) taken.insert(*section.name);
  for (const DetailDescription& detail : scene.details) taken.insert(*detail.name);
  for (const ViewDescription& view : scene.views)
    if (view.label.given()) taken.insert(*view.label);
  return taken;
}

// ISO 128-3 recommends to leave out I, O and Q.
std::string next_letter(std::set<std::string>& taken) {
  for (const char letter : std::string("ABCDEFGHJKLMNPRSTUVWXYZ"))
    if (taken.insert(std::string(1, letter)).second) return std::string(1, letter);
  for (int number = 1;; ++number)
    if (taken.insert("A" + std::to_string(number)).second) return "A" + std::to_string(number);
}

void complete_directions(SceneDescription& scene) {
  for (ViewDescription& view : scene.views) {
    if (!view.of.given() && !view.from.given()) continue;
    if (!view.of.given()) refuse_input(view.from.where, "'from' needs the view beside which this one is", "add 'of'");
    if (!view.from.given())
      refuse_input(view.of.where, "'of' needs the direction from which this view is seen",
                   "add 'from', such as [1, 0, 1]");
    if (view.projection.given() || view.detail.given())
      refuse_input(view.from.where, "a view with a direction has no projection and no detail", "omit one of them");
    const Vec3& d = *view.from;
    view.projection = {
        ProjectionRequest{"auxiliary",
                          {{"direction", format_number(d.x) + "," + format_number(d.y) + "," + format_number(d.z)}}},
        view.from.where};
  }
}

void complete_letters(SceneDescription& scene) {
  std::set<std::string> taken = letters_of(scene);
  for (ViewDescription& view : scene.views) {
    if (!view.of.given()) continue;
    expect_parent(view, scene.views);
    // That of a section has the letters of its plane.
    if (!view.label.given() && !view.section.given()) view.label = {next_letter(taken), view.of.where};
  }
}

}  // namespace epura::scene
