// SPDX-License-Identifier: Apache-2.0
// How long the lines of a view will take, estimated before they are begun: by the time that reading its triangles took,
// which tells how fast the machine is, too.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "views/draw_view.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Finding, hiding and drawing the lines of a view take so many times what reading its triangles took, or less.
inline constexpr double lines_per_reading = 2.5;

/// The sheet and the files use the time that views leave: as much as a part of a view.
inline constexpr double views_for_the_rest = 0.25;

/// Returns seconds; `read` is how many reading took. Of copies, only the first was read.
inline double seconds_for_lines(const world::World& world, double read) {
  std::map<const mesh::Mesh*, double> triangles;
  for (const world::Placed& placed : world.models) triangles[placed.mesh.get()] = placed.mesh->triangle_count();
  double all = 0;
  for (const auto& [mesh, count] : triangles) all += count;
  return lines_per_reading * read * static_cast<double>(world.triangles.size()) / std::max(all, 1.0);
}

/// The same for many views, with what comes before and after them.
inline double seconds_for_views(const world::World& world, double read, std::size_t views) {
  return seconds_for_lines(world, read) * (static_cast<double>(views) + 2 * views_for_the_rest);
}

/// Seconds since the run began; 0 without a time limit.
inline double seconds_now(const Progress& progress) {
  return progress.with_part_of_the_time(0).time_limit().value_or(0);
}

/// The last time, if models were read again.
inline double seconds_of_reading(const Stopwatch& watch) {
  double seconds = 0;
  for (const auto& [stage, took] : watch.laps())
    if (stage == "read") seconds = took;
  return seconds;
}

}  // namespace epura::pipeline
