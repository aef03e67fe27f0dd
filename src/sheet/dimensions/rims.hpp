// SPDX-License-Identifier: Apache-2.0
// Circles of the models where they stand in the world.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "sheet/dimensions/anchors.hpp"

namespace epura::sheet {

/// Looks for the circles of a model when they are first asked for, and keeps them.
class Rims {
 public:
  explicit Rims(const scene::World& world) : world_(world) {}

  /// Those through a vertex, or of any model through a point of the world. Throws Error{input} that names `where` and
  /// the nearest circle when there are none.
  std::vector<WorldCircle> through(const scene::Anchor& anchor, const Vec3& place, const std::string& where);

 private:
  struct Rim {
    std::vector<int> vertices;
    WorldCircle circle;
  };
  const std::vector<Rim>& of_model(int model);

  const scene::World& world_;
  std::map<int, std::vector<Rim>> rims_;
};

}  // namespace epura::sheet
