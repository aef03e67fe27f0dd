// SPDX-License-Identifier: Apache-2.0
// The faces of the part that a mesh stands for, and the edges between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "features/part_surface.hpp"
#include "mesh/mesh.hpp"

namespace epura::features {

/// Triangles that are one face of the part. Lengths and places are the file's.
struct PartFace {
  PartSurface surface;
  double residual = 0;      ///< largest distance of a vertex from the surface; 0 for free forms
  double sagitta = 0;       ///< mean height of the surface over the middles of facets: what tessellation leaves out
  double area = 0;          ///< of its triangles
  double from = 0, to = 0;  ///< of cylinders, cones and tori: heights of its ends along the axis, from the origin
  double sweep = 0;         ///< of the same: degrees around the axis; 360 for whole turns
  int triangles = 0;
  int body = 0;          ///< of its first triangle
  bool inwards = false;  ///< the material is outside: a bore, a fillet in a corner
};

enum class BorderKind : std::uint8_t { sharp, tangent, open };

/// Mesh edges between two faces from corner to corner, or once round.
struct PartBorder {
  std::array<int, 2> faces;  ///< lower first; {-1, f} where one face ends, {f, f} for an edge that fades out inside one
  BorderKind kind;
  double angle;            ///< between the faces, degrees: nine tenths of the border's length are not above it
  std::vector<int> edges;  ///< of the mesh, in order along it
  bool closed;
};

struct PartFaces {
  std::vector<PartFace> faces;        ///< largest triangles first; none where nothing was recognised
  std::vector<int> face_of_triangle;  ///< -1 where nothing was recognised
  std::vector<PartBorder> borders;
  std::vector<int> border_of_edge;  ///< of the mesh; -1 inside a face
  double tolerance = 0;             ///< distance up to which vertices were taken to lie on surfaces
  double recognised = 0;            ///< share of the area that lies on planes, cylinders, cones, spheres and tori

  /// The border that an edge of the mesh belongs to; null inside a face.
  [[nodiscard]] const PartBorder* border_at(std::ptrdiff_t edge) const {
    const int border = border_of_edge[static_cast<std::size_t>(edge)];
    return border < 0 ? nullptr : &borders[static_cast<std::size_t>(border)];
  }
};

struct RecogniseOptions {
  double tangent_angle = 5;  ///< degrees up to which faces that meet all along a border are tangent there
};

/// Finds the faces of a tessellated part. A scan or an artist's mesh, where no surface fits, gives no faces. Neither
/// the order of the faces in the file nor the unit matters.
/// Throws OutOfTime.
PartFaces recognise_faces(const mesh::Mesh& mesh, const RecogniseOptions& options = {}, const Progress& progress = {});

/// Whether some edge is folded by more than `least` degrees, and by less than certainly an edge of the part is. Where
/// none is, folds alone tell edges of the part that are sharper than that.
bool has_shallow_folds(const mesh::Mesh& mesh, double least);

}  // namespace epura::features
