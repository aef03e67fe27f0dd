// SPDX-License-Identifier: Apache-2.0
#include "world/placed_part.hpp"

#include <cstddef>

namespace epura::world {

namespace {

surfaces::PartFace placed_face(surfaces::PartFace face, const Mat4& to_world, double scale) {
  face.surface = surfaces::moved(face.surface, to_world, scale);
  face.residual *= scale;
  face.sagitta *= scale;
  face.area *= scale * scale;
  face.from *= scale;
  face.to *= scale;
  return face;
}

}  // namespace

std::vector<int> faces_of_polygons(const Placed& placed) {
  const std::vector<int>& polygons = placed.mesh->whole().polygon;
  std::vector<int> face_of_polygon;
  for (std::size_t t = 0; t < polygons.size(); ++t) {
    const auto polygon = static_cast<std::size_t>(polygons[t]);
    if (polygon >= face_of_polygon.size()) face_of_polygon.resize(polygon + 1, -1);
    face_of_polygon[polygon] = placed.part->face_of_triangle[t];
  }
  return face_of_polygon;
}

std::vector<int> faces_of_triangles(const Placed& placed) {
  const mesh::Mesh& mesh = *placed.mesh;
  if (mesh.uncut == nullptr) return placed.part->face_of_triangle;
  const std::vector<int> face_of_polygon = faces_of_polygons(placed);
  std::vector<int> faces;
  // Polygons created by the cut belong to no face, and follow those of the file.
  for (const int polygon : mesh.polygon)
    faces.push_back(polygon < static_cast<int>(face_of_polygon.size()) ? face_of_polygon[polygon] : -1);
  return faces;
}

std::optional<PlacedPart> place_part(const Placed& placed) {
  if (placed.part == nullptr) return std::nullopt;
  const std::optional<double> scale = similarity_scale(placed.to_world);
  if (!scale) return std::nullopt;
  PlacedPart part{{}, faces_of_triangles(placed), placed.part->tolerance * *scale};
  for (const surfaces::PartFace& face : placed.part->faces)
    part.faces.push_back(placed_face(face, placed.to_world, *scale));
  return part;
}

}  // namespace epura::world
