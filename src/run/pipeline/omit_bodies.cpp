// SPDX-License-Identifier: Apache-2.0
#include "pipeline/omit_bodies.hpp"

#include <cstddef>
#include <memory>
#include <utility>

#include "mesh/edge_table.hpp"

namespace epura::pipeline {

namespace {

// `mesh` without its edges and triangles, with the triangles `kept`.
mesh::Mesh with_triangles(mesh::Mesh& mesh, const std::vector<int>& kept) {
  mesh::Mesh part;
  for (const int t : kept) {
    for (const int corner : mesh.triangle(t)) part.corners.push_back(corner);
    part.polygon.push_back(mesh.polygon[t]);
    part.body.push_back(mesh.body[t]);
  }
  part.points = std::move(mesh.points);
  part.report = std::move(mesh.report);
  mesh::make_edges(part, mesh::wires_of(mesh));
  return part;
}

}  // namespace

void omit_bodies(importer::ReadModel& model, const std::vector<bool>& omitted) {
  mesh::Mesh whole = std::move(model.mesh);
  std::vector<int> kept;
  for (int t = 0; t < whole.triangle_count(); ++t)
    if (!omitted[static_cast<std::size_t>(whole.body[t])]) kept.push_back(t);
  model.mesh = with_triangles(whole, kept);
  if (model.part == nullptr) return;
  auto part = std::make_shared<surfaces::PartFaces>(*model.part);
  part->face_of_triangle.clear();
  part->border_of_edge.clear();
  for (const int t : kept) part->face_of_triangle.push_back(model.part->face_of_triangle[t]);
  for (const mesh::MeshEdge& edge : model.mesh.edges) {
    const auto number = whole.edge_between(edge.vertex) - whole.edges.data();
    part->border_of_edge.push_back(model.part->border_of_edge[static_cast<std::size_t>(number)]);
  }
  model.part = std::move(part);
}

}  // namespace epura::pipeline
