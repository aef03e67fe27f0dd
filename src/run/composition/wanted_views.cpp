// SPDX-License-Identifier: Apache-2.0
#include "composition/wanted_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "composition/seen_marks.hpp"
#include "features/assembly_features.hpp"
#include "features/tolerances.hpp"
#include "scene/choices.hpp"
#include "scene/view_names.hpp"
#include "sizes/pictorial.hpp"
#include "sizes/twins.hpp"
#include "sizes/view_choice.hpp"

namespace epura::pipeline {

namespace {

TrialView trial_view(std::string name, const Vec3& right, const Vec3& up) {
  TrialView view{std::move(name), {}};
  view.seen.u = right;
  view.seen.v = up;
  view.seen.n = view.seen.projector = glm::cross(right, up);
  return view;
}

std::string words_of(const Vec3& direction) {
  constexpr int digits = 6;
  std::string words = "auxiliary:direction=";
  for (int i = 0; i < 3; ++i)
    words +=
        (i > 0 ? "," : "") + format_rounded(std::abs(direction[i]) <= features::same_point ? 0 : direction[i], digits);
  return words;
}

}  // namespace

bool shows_an_axis(const projection::Projection& seen) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(seen.n[axis]) <= max_tilt) return true;
  return false;
}

std::vector<TrialView> views_to_try(std::span<const Vec3> directions) {
  std::vector<TrialView> views{trial_view("front", {1, 0, 0}, {0, 0, 1}),   trial_view("top", {1, 0, 0}, {0, 1, 0}),
                               trial_view("left", {0, -1, 0}, {0, 0, 1}),   trial_view("right", {0, 1, 0}, {0, 0, 1}),
                               trial_view("bottom", {1, 0, 0}, {0, -1, 0}), trial_view("back", {-1, 0, 0}, {0, 0, 1})};
  const std::size_t most = 2 * views.size();
  for (const Vec3& direction : directions)
    for (const double sign : {1.0, -1.0}) {
      const Vec3 n = sign * direction;
      const auto is_it = [&n](const TrialView& view) { return glm::dot(view.seen.n, n) >= 1 - max_tilt * max_tilt; };
      if (views.size() >= most || std::any_of(views.begin(), views.end(), is_it)) continue;
      const Vec3 up = std::abs(n.z) < 1 - max_tilt ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
      const Vec3 right = glm::normalize(glm::cross(up, n));
      TrialView view = trial_view(words_of(n), right, glm::cross(n, right));
      if (shows_an_axis(view.seen)) views.push_back(std::move(view));
    }
  return views;
}

std::vector<ShowingView> few_views(std::vector<ShowingView> views) {
  const auto fewer = [](const auto& a, const auto& b) { return a.shows.size() < b.shows.size(); };
  std::vector<ShowingView> chosen;
  while (!views.empty()) {
    const auto most = std::max_element(views.begin(), views.end(), fewer);
    if (most->shows.empty()) break;
    chosen.push_back(std::move(*most));
    views.erase(most);
    std::vector<std::size_t> shown = chosen.back().shows;
    std::sort(shown.begin(), shown.end());
    for (ShowingView& view : views)
      std::erase_if(view.shows, [&](std::size_t i) { return std::binary_search(shown.begin(), shown.end(), i); });
  }
  return chosen;
}

namespace {

// Circles of which one must be seen where a note about them stands.
std::vector<scene::FeatureCircle> circles_of(const scene::DimensionDescription& note,
                                             const features::PartFeatures& features) {
  std::vector<scene::FeatureCircle> circles = sheet::rims_of(note, features);
  circles.push_back(*note.circle);
  std::ranges::copy(sheet::equal_circles(note, {}, features), std::back_inserter(circles));
  return circles;
}

}  // namespace

std::vector<std::string> views_for_hidden(const world::World& world, const SheetOfViews& sheet,
                                          std::span<const view::ProjectedScene> seen,
                                          std::span<const Annotations> annotations, const Progress& progress) {
  std::vector<std::string> wanted;
  std::optional<features::PartFeatures> features;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const projection::Projection& here = seen[i].projection;
    const scene::ViewDescription& view = sheet.descriptions[i];
    if (!projection::is_orthographic(here) || view.section.given() || view.detail.given()) continue;
    const auto tries = views_to_try(std::array{-here.n});
    const auto trial = std::ranges::find_if(
        tries, [&here](const TrialView& one) { return glm::dot(one.seen.n, here.n) <= max_tilt * max_tilt - 1; });
    if (trial == tries.end()) continue;
    std::vector<std::vector<scene::FeatureCircle>> notes;
    for (const scene::DimensionDescription& note : std::span(annotations[i].dimensions).first(annotations[i].found))
      if (note.circle && !note.is_label && std::abs(glm::dot(note.circle->axis, here.n)) >= 1 - max_tilt * max_tilt) {
        if (!features) features = features::features_to_dimension(world, progress);
        notes.push_back(circles_of(note, *features));
      }
    const auto erase = [&notes, &world](const std::string& name, const projection::Projection& of, bool seen_ones) {
      if (notes.empty()) return;
      const FaceView faces(name, of, world);
      std::erase_if(notes, [&](const auto& circles) {
        return seen_ones == std::ranges::any_of(circles, [&](const auto& one) {
                 return sheet::shows_part(one, [&faces](const Vec3& point) { return faces.shows(point); });
               });
      });
    };
    erase(*view.name, here, true);
    erase(trial->projection, trial->seen, false);
    if (!notes.empty()) wanted.push_back(trial->projection);
  }
  return wanted;
}

std::size_t add_views(scene::SceneDescription& scene, int sheet, std::span<const std::string> projections) {
  const auto is_usual = [sheet](const scene::ViewDescription& view) {
    return view.is_automatic && view.sheet.value_or(1) == sheet + 1;
  };
  const auto found = std::ranges::find_if(scene.views, is_usual);
  if (found == scene.views.end()) return 0;
  const scene::ViewDescription usual = *found;
  std::size_t added = 0;
  for (const std::string& projection : projections) {
    const scene::ProjectionRequest request = scene::parse_request(projection);
    const auto has_it = [&](const scene::ViewDescription& view) {
      return view.sheet.value_or(1) == sheet + 1 && view.projection.given() && !view.section.given() &&
             view.projection->name == request.name && view.projection->assignments == request.assignments;
    };
    if (std::any_of(scene.views.begin(), scene.views.end(), has_it)) continue;
    scene::ViewDescription& view = scene.views.emplace_back(usual);
    view.projection = {request, "--views auto"};
    view.name = {};
    ++added;
  }
  scene::name_views(scene.views);
  return added;
}

}  // namespace epura::pipeline
