// SPDX-License-Identifier: Apache-2.0
// Large scenes in closed form, so that a run can be repeated anywhere without a model file.
#pragma once

#include <string_view>
#include <vector>

#include "scene.hpp"

namespace epura::bench {

struct Generator {
  std::string_view name;
  std::string_view summary;  ///< description of the scene and of its size N
  Scene (*make)(int size);
};

/// Scenes as people draw them.
std::vector<Generator> usual_scenes();

/// Scenes that slow a careless method down: much hides much, or little hides a lot.
std::vector<Generator> hard_scenes();

std::vector<Generator> all_scenes();

/// Adds a sphere of about `triangles` triangles, 100 in radius, around the origin.
void add_sphere(Scene& scene, int triangles);

}  // namespace epura::bench
