// SPDX-License-Identifier: Apache-2.0
// What the surfaces of a part say about its edges: whether they fold there, and whether their contour is near.
//
// Declared and recognised faces are taken for what they claim, but nothing that the drawing derives from them: angles
// along borders and normals are found anew, in closed form where the surface has one, otherwise from the facets. Where
// a program has recognised the faces, the facets must confirm a fold between two round ones.
#pragma once

#include <array>
#include <vector>

#include "base/groups.hpp"
#include "edges/find_edges.hpp"
#include "verify/line_marks.hpp"
#include "world/world.hpp"

namespace epura::verify {

/// Why a line may be drawn at an edge.
enum class Ground {
  none,
  contour,  ///< the surface turns away from the viewer there
  edge      ///< the surface folds or ends there
};

class PartEyes {
 public:
  /// The world and the projection must outlive it.
  PartEyes(const world::World& world, const projection::Projection& projection, const edges::EdgeOptions& options);

  /// Whether the faces of the part that a triangle belongs to are known.
  [[nodiscard]] bool knows(int triangle) const { return face_of(triangle) >= 0; }

  /// For two triangles that meet in an edge of the mesh, of faces that are known. `visible`: whether a contour has to
  /// be one that its own surface does not hide.
  [[nodiscard]] Ground ground_at(const MetEdge& met, const std::array<int, 2>& triangles, bool visible) const;

 private:
  struct Model {
    const mesh::Mesh* mesh = nullptr;  ///< null: no faces are known
    const surfaces::PartFaces* part = nullptr;
    Mat3 to_file{1};
    Groups<int> at_vertex;    ///< triangles
    std::vector<char> sharp;  ///< by border

    [[nodiscard]] Vec3 point(int vertex) const {
      const auto& [x, y, z] = mesh->points[static_cast<std::size_t>(vertex)];
      return {x, y, z};
    }
  };

  [[nodiscard]] int face_of(int triangle) const;
  [[nodiscard]] Vec3 normal_of(const Model& model, int triangle) const;
  [[nodiscard]] Vec3 normal_at(const Model& model, int vertex, int face) const;
  [[nodiscard]] bool is_sharp(const Model& model, const surfaces::PartBorder& border) const;
  [[nodiscard]] bool folds_at(const Model& model, const mesh::MeshEdge& edge) const;
  [[nodiscard]] bool is_fold_of_facets(const Model& model, const mesh::MeshEdge& edge) const;
  [[nodiscard]] double turn_beside(const Model& model, const mesh::MeshEdge& edge, int triangle) const;
  [[nodiscard]] bool has_contour(int model, const MetEdge& met, int face, bool visible) const;

  const world::World& world_;
  const projection::Projection& projection_;
  edges::EdgeOptions options_;
  std::vector<Model> models_;
};

}  // namespace epura::verify
