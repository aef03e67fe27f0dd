// SPDX-License-Identifier: Apache-2.0
// Views that a sheet lacks: those that show what has to be seen in its true form, as few as do.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "composition/annotations.hpp"
#include "projection/projection.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// A view that a sheet might have, without its place on the page.
struct TrialView {
  std::string projection;  ///< as in --projection
  projection::Projection seen;
};

/// The six along the axes of the world, then along `directions` and against them: each once, and none that is
/// pictorial. Of skew ones, the first few: each costs a look at all that is not shown.
std::vector<TrialView> views_to_try(std::span<const Vec3> directions);

/// Whether an axis of the world lies in the plane of a view, as it does in all that are not pictorial.
bool shows_an_axis(const projection::Projection& seen);

/// A view, and the numbers of what it shows.
struct ShowingView {
  std::string projection;
  std::vector<std::size_t> shows;
};

/// Those that together show whatever any of them shows: in turn the one that shows most of the rest, the first of equal
/// ones, each with that. At most ln(n) times as many as would do (Johnson 1974).
std::vector<ShowingView> few_views(std::vector<ShowingView> views);

/// The views from behind in which something is seen of what automatic notes measure, that each view in which they stand
/// hides, as of bores that open below.
std::vector<std::string> views_for_hidden(const world::World& world, const SheetOfViews& sheet,
                                          std::span<const view::ProjectedScene> seen,
                                          std::span<const Annotations> annotations, const Progress& progress);

/// Adds views with names of their own to a sheet of a scene, as its automatic ones, but none that it has. Returns how
/// many.
std::size_t add_views(scene::SceneDescription& scene, int sheet, std::span<const std::string> projections);

}  // namespace epura::pipeline
