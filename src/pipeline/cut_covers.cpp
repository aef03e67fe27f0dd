// SPDX-License-Identifier: Apache-2.0
#include "pipeline/cut_covers.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "drawing/cut_covers.hpp"
#include "drawing/cut_faces.hpp"
#include "scene/body_styles.hpp"
#include "visibility/spans.hpp"

namespace epura::pipeline {

namespace {

using Body = std::array<int, 2>;  // a model, and a body of it

// Of an outline of a cut, or of a line of a thread; nothing for other lines, which are behind the plane.
std::optional<Body> body_in_plane(const world::World& world, const edges::FeatureEdges& drawn,
                                  const edges::FeatureEdge& edge) {
  const auto model = static_cast<std::size_t>(edge.model);
  const mesh::Mesh& mesh = *world.models[model].mesh;
  if (edge.kind == EdgeKind::thread || edge.kind == EdgeKind::thread_end) {
    const int triangle = drawn.crossings[static_cast<std::size_t>(edge.crossing)].triangles[0];
    return Body{edge.model, mesh.body[static_cast<std::size_t>(triangle - world.first_triangle[model])]};
  }
  if (edge.mesh_edge < 0) return std::nullopt;
  const mesh::MeshEdge& line = mesh.edges[static_cast<std::size_t>(edge.mesh_edge)];
  if (line.cut != mesh::CutEdge::outline || line.count == 0) return std::nullopt;
  return Body{edge.model, mesh.body[static_cast<std::size_t>(mesh.triangles_of(line).front())]};
}

std::string name_of(const CutSection& section, const Body& body) {
  const mesh::Mesh& mesh = *section.cut.world.models[static_cast<std::size_t>(body[0])].mesh;
  const std::string& name = scene::name_of_body(mesh, body[1]);
  return "'" + (name.empty() ? mesh.report.name + ": body " + std::to_string(body[1]) : name) + "'";
}

}  // namespace

std::vector<OverlappingBodies> hide_in_overlaps(const CutSection& section, view::ProjectedScene& view,
                                                const view::PaperMap& paper, const edges::FeatureEdges& drawn,
                                                visibility::HiddenSpans& hidden) {
  if (view.projection.central || section.cut.faces.size() < 2) return {};
  const std::vector<drawing::CutFace> faces =
      drawing::cut_faces_on_paper(section.cut.faces, section.surface.plane, view, paper);
  std::vector<OverlappingBodies> overlaps;
  const std::vector<drawing::CoveredFace> covered = drawing::covered_faces(faces);
  const auto body_of = [&](std::size_t face) { return Body{faces[face].model, faces[face].body}; };
  for (const drawing::CoveredFace& pair : covered) overlaps.push_back({body_of(pair.covered), body_of(pair.covering)});
  if (overlaps.empty()) return overlaps;
  visibility::HiddenSpans all = std::move(hidden);
  hidden.first = {0};
  hidden.spans.clear();
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    const edges::FeatureEdge& edge = drawn.edges[e];
    visibility::Spans spans(all.spans.begin() + static_cast<std::ptrdiff_t>(all.first[e]),
                            all.spans.begin() + static_cast<std::ptrdiff_t>(all.first[e + 1]));
    const auto body = body_in_plane(section.cut.world, drawn, edge);
    for (const drawing::CoveredFace& pair : covered) {
      if (!body || *body != body_of(pair.covered)) continue;
      const auto end = [&](std::size_t i) { return paper(view.vertices[static_cast<std::size_t>(edge.vertex[i])]); };
      for (const auto& part : drawing::parts_inside(faces[pair.covering], end(0), end(1)))
        visibility::add_span(spans, part);
    }
    hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
    hidden.first.push_back(hidden.spans.size());
  }
  hidden.undecided = std::move(all.undecided);
  hidden.by_surface = std::move(all.by_surface);
  hidden.by_facets = std::move(all.by_facets);
  check(hidden.first.size() == drawn.edges.size() + 1, "every edge has its hidden parts");
  return overlaps;
}

void warn_about(const Messages& messages, const CutSection& section, std::span<const OverlappingBodies> overlaps) {
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, overlaps.size()); ++i)
    messages.warn("in section " + section.surface.plane.name + ", " + name_of(section, overlaps[i][0]) + " and " +
                  name_of(section, overlaps[i][1]) + " overlap: the second one is drawn over the first");
  if (overlaps.size() > most)
    messages.warn("... and " + std::to_string(overlaps.size() - most) + " more pairs of bodies");
}

}  // namespace epura::pipeline
