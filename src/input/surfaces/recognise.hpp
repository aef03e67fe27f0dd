// SPDX-License-Identifier: Apache-2.0
// The faces of the part that a mesh represents, and the edges between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "surfaces/part_surface.hpp"

namespace epura::surfaces {

/// Triangles that are one face of the part. Lengths and positions are in units of the file.
struct PartFace {
  PartSurface surface;
  double residual = 0;      ///< largest distance of a vertex from the surface; 0 for free forms
  double sagitta = 0;       ///< mean distance of the surface from the middles of facets, which the tessellation leaves
                            ///< out
  double area = 0;          ///< sum over its triangles
  double from = 0, to = 0;  ///< of cylinders, cones and tori: extent along the axis, from the origin
  double sweep = 0;         ///< of the same: degrees around the axis; 360 for full turns
  int triangles = 0;
  int body = 0;          ///< of its first triangle
  bool inwards = false;  ///< the material is outside, as around a bore or a fillet in a corner
};

enum class BorderKind : std::uint8_t { sharp, tangent, open };

/// Mesh edges between two faces, from corner to corner or around a closed loop.
struct PartBorder {
  std::array<int, 2> faces;  ///< lower first; {-1, f} where a single face ends, {f, f} for an edge that fades out
                             ///< inside a face
  BorderKind kind;
  double angle;            ///< between the faces, degrees; not exceeded over nine tenths of the border's length
  std::vector<int> edges;  ///< of the mesh, in order along it
  bool closed;
};

struct PartFaces {
  std::vector<PartFace> faces;        ///< by size of the largest triangles; empty if nothing was recognised
  std::vector<int> face_of_triangle;  ///< -1 if nothing was recognised
  std::vector<PartBorder> borders;
  std::vector<int> border_of_edge;  ///< of the mesh; -1 inside a face
  double tolerance = 0;             ///< greatest distance at which vertices were considered to lie on surfaces
  double recognised = 0;            ///< fraction of the area that lies on planes, cylinders, cones, spheres and tori
  bool declared = false;            ///< by the file

  /// Returns the border that an edge of the mesh belongs to; null inside a face.
  [[nodiscard]] const PartBorder* border_at(std::ptrdiff_t edge) const {
    const int border = border_of_edge[static_cast<std::size_t>(edge)];
    return border < 0 ? nullptr : &borders[static_cast<std::size_t>(border)];
  }
};

struct RecogniseOptions {
  double tangent_angle = 5;  ///< degrees up to which faces that meet along a whole border are tangent there
};

/// Finds the faces of a tessellated part. A scan or an artist's mesh, on which no surfaces fit, yields no faces.
/// Neither the order of faces in the file nor the unit matters. Throws OutOfTime.
PartFaces recognise_faces(const mesh::Mesh& mesh, const RecogniseOptions& options = {}, const Progress& progress = {});

/// Whether some edge is folded by more than `least` degrees, but by less than what makes it an edge of the part beyond
/// doubt. If there is none, folds alone identify the edges of the part that are sharper than `least`.
bool has_shallow_folds(const mesh::Mesh& mesh, double least);

}  // namespace epura::surfaces
