// SPDX-License-Identifier: Apache-2.0
#include "explain/subject.hpp"

#include <algorithm>
#include <cstddef>

#include "base/utf8.hpp"

namespace epura::explain {

FaceName face_of(const world::World& world, int triangle) {
  const int model = world.model_of_triangle(triangle);
  return {world.number_in_scene(model), world.models[model].mesh->polygon[triangle - world.first_triangle[model]]};
}

std::vector<FaceName> faces_at(const ExplainInput& drawn_view, const Subject& subject) {
  const world::World& world = drawn_view.world;
  std::vector<FaceName> faces;
  if (subject.mesh_edge < 0) {
    const int crossing = drawn_view.drawn.edges[subject.drawn].crossing;
    for (const int triangle : drawn_view.drawn.crossings[crossing].triangles) faces.push_back(face_of(world, triangle));
    return faces;
  }
  const mesh::Mesh& mesh = *world.models[subject.model].mesh;
  for (const int triangle : mesh.triangles_of(mesh.edges[subject.mesh_edge]))
    faces.push_back({world.number_in_scene(subject.model), mesh.polygon[triangle]});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::string name_of(const FaceName& face) {
  return std::to_string(face[0]) + ":" + (face[1] < 0 ? "cut" : std::to_string(face[1]));
}

std::string name_of(const ExplainInput& drawn_view, const Subject& subject) {
  if (subject.mesh_edge < 0) {
    const std::vector<FaceName> faces = faces_at(drawn_view, subject);
    return name_of(faces[0]) + "x" + name_of(faces[1]);
  }
  const mesh::Mesh& mesh = *drawn_view.world.models[subject.model].mesh;
  const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[subject.mesh_edge]);
  if (!origin.in_file) {
    const std::vector<FaceName> faces = faces_at(drawn_view, subject);
    return name_of(faces.empty() ? FaceName{drawn_view.world.number_in_scene(subject.model), -1} : faces.front());
  }
  const auto [a, b] = origin.vertex;
  return std::to_string(drawn_view.world.number_in_scene(subject.model)) + ":" + std::to_string(a) + "-" +
         std::to_string(b);
}

std::string names_of(const std::vector<FaceName>& faces) {
  if (faces.empty()) return "faces that are left out";
  std::string text = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < faces.size(); ++i)
    text += (i == 0 ? "" : i + 1 == faces.size() ? " and " : ", ") + name_of(faces[i]);
  return text;
}

std::string owner_of(const world::World& world, const FaceName& face) {
  const mesh::Mesh& mesh = *world.models[face[0]].mesh;
  const auto triangle = std::find(mesh.polygon.begin(), mesh.polygon.end(), face[1]) - mesh.polygon.begin();
  const std::string file = one_line(mesh.report.name);
  if (mesh.report.body_names.empty() || triangle == static_cast<std::ptrdiff_t>(mesh.polygon.size())) return file;
  const std::string& body = mesh.report.body_names[mesh.body[triangle]];
  return body.empty() ? file : "'" + one_line(body) + "' in " + file;
}

std::string owner_of(const ExplainInput& drawn_view, const Subject& subject) {
  const std::vector<FaceName> faces = faces_at(drawn_view, subject);
  return faces.empty() ? drawn_view.world.models[subject.model].mesh->report.name
                       : owner_of(drawn_view.world, faces.front());
}

std::array<Vec3, 2> ends_of(const ExplainInput& drawn_view, const Subject& subject) {
  const world::World& world = drawn_view.world;
  if (subject.mesh_edge < 0) return drawn_view.drawn.crossings[drawn_view.drawn.edges[subject.drawn].crossing].ends;
  const mesh::Mesh& mesh = *world.models[subject.model].mesh;
  const auto [a, b] = mesh.origin_of(mesh.edges[subject.mesh_edge]).vertex;
  const int first = world.first_vertex[subject.model];
  return {world.points[first + a], world.points[first + b]};
}

Subject drawn_subject(const ExplainInput& drawn_view, std::size_t e) {
  const edges::FeatureEdge& edge = drawn_view.drawn.edges[e];
  return {edge.model, edge.mesh_edge, static_cast<int>(e)};
}

std::vector<Span> spans_of(const visibility::HiddenSpans& hidden, std::size_t e) {
  std::vector<Span> spans;
  hidden.visit_parts(e, [&](double from, double to, bool visible) { spans.push_back({from, to, visible}); });
  return spans;
}

}  // namespace epura::explain
