// SPDX-License-Identifier: Apache-2.0
// What lines of a view show of recognised parts: edges of their meshes, borders, faces.
#pragma once

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "world/placed_part.hpp"

namespace epura::drawing {

/// The recognised parts of a view's world, placed once for all that asks. Refers to the world.
class PartEdges {
 public:
  explicit PartEdges(const world::World& world);

  [[nodiscard]] const world::Placed& placed(int model) const { return world_->models[static_cast<std::size_t>(model)]; }
  /// Nothing if no faces of the model are recognised.
  [[nodiscard]] const std::optional<world::PlacedPart>& part(int model) const {
    return parts_[static_cast<std::size_t>(model)];
  }

  /// The border of the part on which a line lies; -1 if it lies on none.
  [[nodiscard]] int border_of(const Segment& segment) const;
  /// The recognised face, placed in the world, inside which an edge of the file lies; null if it lies in none.
  [[nodiscard]] const surfaces::PartFace* face_around(const Segment& segment) const;
  /// The same for a face of the file, given by model and number; null if it belongs to none.
  [[nodiscard]] const surfaces::PartFace* face_of(const std::array<int, 2>& in_file) const;
  /// The point in the world of an edge of the file at a parameter, 0 to 1.
  [[nodiscard]] Vec3 place_on(const Segment& segment, double t) const;

 private:
  [[nodiscard]] const mesh::MeshEdge* edge_of(const Segment& segment) const;

  const world::World* world_;
  std::vector<std::optional<world::PlacedPart>> parts_{};
  std::vector<std::vector<int>> face_of_polygon_{};  ///< by model
};

}  // namespace epura::drawing
