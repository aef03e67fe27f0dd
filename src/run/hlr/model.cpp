// SPDX-License-Identifier: Apache-2.0
#include "hlr/model.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// An edge or a wire of a shape.
struct Line {
  int end;                                          ///< in the vertices of all, which follow one another
  int spline = -1;                                  ///< in Model::splines; -1: none
  const std::vector<double>* parameters = nullptr;  ///< of its vertices on it
};

void add_edges(std::vector<SourceEdge>& edges, const Occurrence& at, const std::vector<int>& vertices,
               const std::vector<Line>& lines) {
  std::size_t begin = 0;
  for (std::uint32_t number = 0; number < lines.size(); ++number) {
    const Line& line = lines[number];
    const auto end = static_cast<std::size_t>(line.end);
    for (std::size_t i = begin; i + 1 < end; ++i) {
      SourceEdge piece{{vertices[i], vertices[i + 1]}, at.node, at.shape, number, line.spline, {}};
      if (line.parameters != nullptr) std::copy_n(line.parameters->begin() + (i - begin), 2, piece.parameters.begin());
      if (piece.vertex[1] < piece.vertex[0]) {
        std::swap(piece.vertex[0], piece.vertex[1]);
        std::swap(piece.parameters[0], piece.parameters[1]);
      }
      edges.push_back(piece);
    }
    begin = end;
  }
}

// Adds edges and splines of all shapes at their places. Of one piece with several edges, as where bodies touch, the
// first one counts.
void add_edges(Model& model, const importer::Document& document, const importer::Assembled& assembled,
               const mesh::Mesh& mesh) {
  const std::vector<int> vertex = mesh::same_places(mesh.points);
  std::vector<std::size_t> placed(document.shapes.size(), 0);
  int first_point = 0;
  for (const Occurrence& at : occurrences_of(document)) {
    const importer::Shape& shape = document.shapes[at.shape];
    const Mat4& place = assembled.places[at.shape][placed[at.shape]++];
    std::vector<Line> edges, wires;
    for (const surfaces::DeclaredEdge& edge : shape.edges) edges.push_back({edge.end});
    for (const int end : shape.wire_ends) wires.push_back({end});
    for (const importer::EdgeSpline& curve : shape.splines) {
      Line& line = (curve.is_wire ? wires : edges)[static_cast<std::size_t>(curve.number)];
      line.spline = static_cast<int>(model.splines.size());
      line.parameters = &curve.parameters;
      model.splines.push_back(curve.spline);
      for (Vec4& pole : model.splines.back().poles) pole = place * pole;
    }
    const auto in_mesh = [&](std::vector<int> vertices) {
      for (int& v : vertices) v = vertex[static_cast<std::size_t>(first_point + v)];
      return vertices;
    };
    add_edges(model.edges, at, in_mesh(shape.edge_vertices), edges);
    add_edges(model.edges, at, in_mesh(shape.wire_vertices), wires);
    first_point += static_cast<int>(shape.points.size());
  }
  std::ranges::stable_sort(model.edges, {}, &SourceEdge::vertex);
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
  Model model{{}, faces_of(document), {}};
  add_edges(model, document, assembled, *mesh);
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
