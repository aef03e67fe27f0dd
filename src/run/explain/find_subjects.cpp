// SPDX-License-Identifier: Apache-2.0
#include "explain/find_subjects.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"

namespace epura::explain {

namespace {

const std::string option = "--why";
constexpr std::size_t max_candidates = 8;
constexpr std::size_t nearest_edges = 3;

// Parses two non-negative integers with a separator between them.
std::optional<std::array<int, 2>> parse_pair(std::string_view text, char separator) {
  const auto parts = split(text, separator);
  if (parts.size() != 2) return std::nullopt;
  std::array<int, 2> pair{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = parse_integer(parts[i]);
    if (!number || *number < 0 || *number > INT_MAX) return std::nullopt;
    pair[i] = static_cast<int>(*number);
  }
  return pair;
}

std::optional<EdgeQuestion> parse(std::string_view text) {
  if (text.starts_with("@")) {
    const auto place = parse_numbers(text.substr(1));
    if (!place || place->size() != 2 || !std::isfinite((*place)[0]) || !std::isfinite((*place)[1])) return std::nullopt;
    return ByPlace{{(*place)[0], (*place)[1]}};
  }
  if (const auto parts = split(text, 'x'); parts.size() == 2) {
    const auto first = parse_pair(parts[0], ':');
    const auto second = parse_pair(parts[1], ':');
    if (!first || !second) return std::nullopt;
    return ByFaces{{*first, *second}};
  }
  const auto parts = split(text, ':');
  const auto vertices = parse_pair(parts.back(), '-');
  const auto model = parse_integer(parts.size() == 2 ? parts[0] : "0");
  if (!vertices || !model || *model < 0 || *model > INT_MAX || parts.size() > 2) return std::nullopt;
  return ByVertices{static_cast<int>(*model),
                    {std::min((*vertices)[0], (*vertices)[1]), std::max((*vertices)[0], (*vertices)[1])}};
}

// Returns the number of a drawn edge, or -1. Drawn edges are in the order of models and their edges.
int drawn_number(const edges::FeatureEdges& drawn, int model, int mesh_edge) {
  const auto found = std::find_if(drawn.edges.begin(), drawn.edges.end(), [&](const edges::FeatureEdge& edge) {
    return edge.model == model && edge.mesh_edge == mesh_edge;
  });
  return found == drawn.edges.end() ? -1 : static_cast<int>(found - drawn.edges.begin());
}

// Returns "edges at VERTEX: 0-1 0-2 ...".
std::string edges_at(const mesh::Mesh& mesh, int vertex) {
  std::string text = "edges at " + std::to_string(vertex) + ":";
  std::size_t count = 0;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    if (edge.vertex[0] != vertex && edge.vertex[1] != vertex) continue;
    const mesh::EdgeOrigin origin = mesh.origin_of(edge);
    if (!origin.in_file) continue;
    const auto [a, b] = origin.vertex;
    if (++count <= max_candidates) text += " " + std::to_string(a) + "-" + std::to_string(b);
  }
  if (count == 0) return text + " none";
  return count > max_candidates ? text + " and " + std::to_string(count - max_candidates) + " more" : text;
}

const mesh::Mesh& checked_model(const world::World& world, int model) {
  const auto is_whole = [](const world::Placed& placed) { return placed.copy_of < 0; };
  const auto count = static_cast<int>(std::count_if(world.models.begin(), world.models.end(), is_whole));
  if (model >= count)
    throw Error(ErrorKind::input, option, "there is no model " + std::to_string(model),
                count == 1 ? "the only model is 0" : "models are numbered from 0 to " + std::to_string(count - 1));
  return *world.models[model].mesh;
}

std::vector<Subject> find(const ExplainInput& drawn_view, const ByVertices& wanted) {
  const mesh::Mesh& mesh = checked_model(drawn_view.world, wanted.model);
  for (const int vertex : wanted.vertex)
    if (vertex >= mesh.report.vertices)
      throw Error(ErrorKind::input, option, mesh.report.name + " has no vertex " + std::to_string(vertex),
                  "its vertices are numbered from 0 to " + std::to_string(mesh.report.vertices - 1));
  // An aligned section may show an edge in several planes, and cuts and contours divide edges.
  std::vector<Subject> subjects;
  for (int model = 0; model < static_cast<int>(drawn_view.world.models.size()); ++model) {
    if (drawn_view.world.number_in_scene(model) != wanted.model) continue;
    const mesh::Mesh& shown = *drawn_view.world.models[static_cast<std::size_t>(model)].mesh;
    for (std::size_t e = 0; e < shown.edges.size(); ++e) {
      const mesh::EdgeOrigin origin = shown.origin_of(shown.edges[e]);
      if (!origin.in_file || origin.vertex != wanted.vertex) continue;
      const int number = static_cast<int>(e);
      subjects.push_back({model, number, drawn_number(drawn_view.drawn, model, number)});
    }
  }
  if (subjects.empty())
    throw Error(ErrorKind::input, option,
                "no edge of " + mesh.report.name + " connects vertices " + std::to_string(wanted.vertex[0]) + " and " +
                    std::to_string(wanted.vertex[1]),
                edges_at(mesh, wanted.vertex[0]) + "; " + edges_at(mesh, wanted.vertex[1]));
  return subjects;
}

std::vector<Subject> find(const ExplainInput& drawn_view, const ByFaces& wanted) {
  for (const FaceName& face : wanted.faces) checked_model(drawn_view.world, face[0]);
  std::vector<Subject> subjects;
  for (std::size_t e = 0; e < drawn_view.drawn.edges.size(); ++e) {
    const Subject subject = drawn_subject(drawn_view, e);
    if (subject.mesh_edge >= 0) continue;
    const std::vector<FaceName> faces = faces_at(drawn_view, subject);
    if (std::is_permutation(faces.begin(), faces.end(), wanted.faces.begin())) subjects.push_back(subject);
  }
  if (subjects.empty())
    throw Error(
        ErrorKind::input, option,
        "no intersection line of faces " + name_of(wanted.faces[0]) + " and " + name_of(wanted.faces[1]) + " is drawn",
        "'--dump edges' lists those that are");
  return subjects;
}

std::vector<Subject> find(const ExplainInput& drawn_view, const ByPlace& wanted) {
  const std::vector<edges::FeatureEdge>& edges = drawn_view.drawn.edges;
  std::vector<std::pair<double, std::size_t>> near;
  const Vec2 place = drawn_view.drawing.shown.breaks.restored(wanted.place);
  for (std::size_t e = 0; e < edges.size(); ++e)
    near.emplace_back(
        distance_to_segment(place, drawing::position_on_paper(drawn_view.view, drawn_view.paper, edges[e], 0),
                            drawing::position_on_paper(drawn_view.view, drawn_view.paper, edges[e], 1)),
        e);
  if (near.empty()) throw Error(ErrorKind::input, option, "nothing is drawn");
  const std::size_t count = std::min(nearest_edges, near.size());
  std::partial_sort(near.begin(), near.begin() + count, near.end());
  std::vector<Subject> subjects;
  for (std::size_t i = 0; i < count; ++i) {
    subjects.push_back(drawn_subject(drawn_view, near[i].second));
    subjects.back().away = near[i].first;
  }
  return subjects;
}

}  // namespace

EdgeQuestion parse_edge_question(std::string_view text) {
  if (const auto question = parse(text)) return *question;
  throw Error(ErrorKind::input, option, "'" + std::string(text) + "' does not name an edge",
              "[MODEL:]VERTEX-VERTEX as in JSON, MODEL:FACExMODEL:FACE or @X,Y in mm on the sheet");
}

std::vector<Subject> find_subjects(const ExplainInput& drawn_view, const EdgeQuestion& question) {
  return std::visit([&](const auto& wanted) { return find(drawn_view, wanted); }, question);
}

}  // namespace epura::explain
