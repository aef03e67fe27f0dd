// SPDX-License-Identifier: Apache-2.0
#include "hlr/model.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "importer/assemble.hpp"
#include "mesh/read.hpp"
#include "mesh/weld.hpp"
#include "surfaces/recognise.hpp"
#include "world/expect_usable.hpp"

namespace epura::hlr {

namespace {

constexpr const char* name = "model";

/// A shape and the node that places it, in the order in which shapes are assembled.
struct Occurrence {
  std::uint32_t node, shape;
};

std::vector<Occurrence> occurrences_of(const importer::Document& document) {
  std::vector<Occurrence> found;
  if (document.nodes.empty())
    for (std::uint32_t shape = 0; shape < document.shapes.size(); ++shape) found.push_back({shape, shape});
  for (std::uint32_t node = 0; node < document.nodes.size(); ++node)
    if (const int shape = document.nodes[node].shape; shape >= 0)
      found.push_back({node, static_cast<std::uint32_t>(shape)});
  return found;
}

void add_edges(std::vector<SourceEdge>& edges, const Occurrence& at, std::span<const int> vertices,
               const std::vector<int>& ends) {
  int begin = 0;
  for (std::uint32_t number = 0; number < ends.size(); ++number) {
    for (int i = begin; i + 1 < ends[number]; ++i) {
      const auto [low, high] =
          std::minmax(vertices[static_cast<std::size_t>(i)], vertices[static_cast<std::size_t>(i) + 1]);
      edges.push_back({{low, high}, at.node, at.shape, number});
    }
    begin = ends[number];
  }
}

// Of one piece with several edges, as where bodies touch, the first one counts.
std::vector<SourceEdge> edges_of(const importer::Document& document, const mesh::Mesh& mesh) {
  const std::vector<int> vertex = mesh::same_places(mesh.points);
  std::vector<SourceEdge> edges;
  int first_point = 0;
  for (const Occurrence& at : occurrences_of(document)) {
    const importer::Shape& shape = document.shapes[at.shape];
    const auto placed = [&](std::vector<int> vertices) {
      for (int& v : vertices) v = vertex[static_cast<std::size_t>(first_point + v)];
      return vertices;
    };
    std::vector<int> ends;
    for (const surfaces::DeclaredEdge& edge : shape.edges) ends.push_back(edge.end);
    add_edges(edges, at, placed(shape.edge_vertices), ends);
    add_edges(edges, at, placed(shape.wire_vertices), shape.wire_ends);
    first_point += static_cast<int>(shape.points.size());
  }
  std::ranges::stable_sort(edges, {}, &SourceEdge::vertex);
  return edges;
}

std::vector<epura_hlr_face> faces_of(const importer::Document& document) {
  const auto number = [](int n) { return n < 0 ? EPURA_NONE : static_cast<std::uint32_t>(n); };
  std::vector<epura_hlr_face> faces;
  for (const Occurrence& at : occurrences_of(document)) {
    const importer::Shape& shape = document.shapes[at.shape];
    for (std::size_t i = 0; i < shape.polygon_ends.size(); ++i)
      faces.push_back({at.node, at.shape, number(shape.face_of_polygon[i]), number(shape.body_of_polygon[i])});
  }
  return faces;
}

}  // namespace

Model make_model(const importer::Document& document, bool is_mesh) {
  importer::Assembled assembled = importer::assemble(document, "memory");
  auto mesh = std::make_shared<mesh::Mesh>(mesh::make_mesh(std::move(assembled.soup), name, {}, assembled.step));
  std::shared_ptr<const surfaces::PartFaces> part;
  if (!is_mesh) {
    auto faces = std::make_shared<surfaces::PartFaces>(
        assembled.part.faces.empty()
            ? surfaces::recognise_faces(*mesh)
            : surfaces::part_of(*mesh, assembled.part, surfaces::RecogniseOptions().tangent_angle));
    if (!faces->faces.empty()) part = std::move(faces);
  }
  Model model{{}, faces_of(document), edges_of(document, *mesh)};
  model.world = world::make_world({{.mesh = std::move(mesh), .part = std::move(part)}});
  world::expect_usable(model.world);
  return model;
}

const SourceEdge* edge_at(const Model& model, const std::array<int, 2>& vertices) {
  const auto found = std::ranges::lower_bound(model.edges, vertices, {}, &SourceEdge::vertex);
  return found == model.edges.end() || found->vertex != vertices ? nullptr : &*found;
}

std::array<epura_hlr_face, 2> faces_at(const Model& model, const std::array<int, 2>& vertices, const SourceEdge* edge) {
  std::array faces{no_face, no_face};
  const mesh::Mesh& mesh = *model.world.models.front().mesh;
  const mesh::MeshEdge* found = mesh.edge_between(vertices);
  std::size_t count = 0;
  if (found != nullptr)
    for (const int t : mesh.triangles_of(*found)) {
      const epura_hlr_face& face =
          model.face_of_polygon[static_cast<std::size_t>(mesh.polygon[static_cast<std::size_t>(t)])];
      if (count == 0 || (count == 1 && key_of(face) != key_of(faces[0]))) faces[count++] = face;
    }
  if (edge == nullptr) return faces;
  if (count == 0) return {epura_hlr_face{edge->node, edge->shape, EPURA_NONE, EPURA_NONE}, no_face};
  if (faces[0].node != edge->node && faces[1].node == edge->node) std::swap(faces[0], faces[1]);
  return faces;
}

}  // namespace epura::hlr
