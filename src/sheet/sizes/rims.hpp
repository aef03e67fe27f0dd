// SPDX-License-Identifier: Apache-2.0
// Circles of the models in world coordinates.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "sizes/anchors.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

/// Finds the circles of a model on first use, and keeps them.
class Rims {
 public:
  explicit Rims(const world::World& world) : world_(world) {}

  /// Circles through a vertex, or of any model through a point of the world; they have the centre and radius of a
  /// recognised shaft or bore that ends there. For a vertex that is not on a rim, the circle of the shaft or bore on
  /// which it lies. Throws Error{input} that names `where` and the nearest circle if there are none.
  std::vector<WorldCircle> through(const scene::Anchor& anchor, const Vec3& place, const std::string& where);

 private:
  struct Rim {
    std::vector<int> vertices;
    WorldCircle circle;
  };
  struct Model {
    std::vector<Rim> rims;
    std::optional<world::PlacedPart> part;
  };
  Model& of_model(int model);
  std::vector<WorldCircle> of_faces(const std::array<int, 2>& vertex);

  const world::World& world_;
  std::map<int, Model> models_;
};

}  // namespace epura::sheet
