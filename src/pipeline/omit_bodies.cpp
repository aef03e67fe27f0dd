// SPDX-License-Identifier: Apache-2.0
#include "pipeline/omit_bodies.hpp"

#include <cstddef>
#include <memory>
#include <utility>

#include "mesh/edge_table.hpp"

namespace epura::pipeline {

namespace {

// `mesh` without its edges and triangles, with the triangles `kept`. Where bodies touch, one that stays has those of
// the other one.
mesh::Mesh with_triangles(mesh::Mesh& mesh, const std::vector<int>& kept, const std::vector<bool>& omitted) {
  mesh::Mesh part;
  auto contact = mesh.contacts.begin();
  for (const int t : kept) {
    for (const int corner : mesh.triangle(t)) part.corners.push_back(corner);
    while (contact != mesh.contacts.end() && contact->triangle < t) ++contact;
    const bool is_contact = contact != mesh.contacts.end() && contact->triangle == t;
    const int body = mesh.body[t];
    if (is_contact && !omitted[static_cast<std::size_t>(body)] && !omitted[static_cast<std::size_t>(contact->body)])
      part.contacts.push_back({static_cast<int>(part.body.size()), contact->body});
    part.polygon.push_back(mesh.polygon[t]);
    part.body.push_back(is_contact && omitted[static_cast<std::size_t>(body)] ? contact->body : body);
  }
  part.points = std::move(mesh.points);
  part.report = std::move(mesh.report);
  mesh::make_edges(part, mesh::wires_of(mesh));
  return part;
}

}  // namespace

void omit_bodies(importer::ReadModel& model, const std::vector<bool>& omitted) {
  mesh::Mesh whole = std::move(model.mesh);
  std::vector<char> stays(static_cast<std::size_t>(whole.triangle_count()), 0);
  for (int t = 0; t < whole.triangle_count(); ++t)
    stays[static_cast<std::size_t>(t)] = omitted[static_cast<std::size_t>(whole.body[t])] ? 0 : 1;
  for (const auto& [t, body] : whole.contacts)
    if (!omitted[static_cast<std::size_t>(body)]) stays[static_cast<std::size_t>(t)] = 1;
  std::vector<int> kept;
  for (int t = 0; t < whole.triangle_count(); ++t)
    if (stays[static_cast<std::size_t>(t)] != 0) kept.push_back(t);
  model.mesh = with_triangles(whole, kept, omitted);
  if (model.part == nullptr) return;
  auto part = std::make_shared<features::PartFaces>(*model.part);
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
