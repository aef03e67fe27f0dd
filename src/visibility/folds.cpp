// SPDX-License-Identifier: Apache-2.0
#include "visibility/folds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "visibility/spans.hpp"

namespace epura::visibility {

namespace {

// Distance of the tested line from the contour, as a fraction of the width of its facets.
constexpr double beside = 1.0 / 64;
constexpr double least_cells = 4;
// At its ends, a fold is too narrow to lie beside the tested line: this fraction of the contour is not drawn either.
constexpr double narrow_end = 0.25;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

bool is_visible_somewhere(const HiddenSpans& hidden, std::size_t edge) {
  bool visible = false;
  hidden.visit_parts(edge, [&](double, double, bool is_visible) { visible = visible || is_visible; });
  return visible;
}

/// Lines next to contours, on the side on which their facets are not.
class Beside {
 public:
  /// Adds the ends of lines to `view`.
  Beside(const scene::World& world, view::ProjectedScene& view) : world_(world), view_(view) {}

  /// Returns nothing for contours without a length or facets on the page.
  [[nodiscard]] std::optional<edges::FeatureEdge> line_at(const edges::FeatureEdge& contour) {
    const view::PageVertex from = view_.vertices[contour.vertex[0]], to = view_.vertices[contour.vertex[1]];
    const Vec2 along(to.x - from.x, to.y - from.y);
    const double length = glm::length(along);
    if (!(length > 0)) return std::nullopt;
    double side = 0, nearest = from.depth, farthest = from.depth;
    for (const view::PageVertex& corner : corners_at(contour)) {
      const double away = cross(along, Vec2(corner.x - from.x, corner.y - from.y)) / length;
      if (std::abs(away) > std::abs(side)) side = away;
      nearest = std::max(nearest, corner.depth);
      farthest = std::min(farthest, corner.depth);
    }
    if (side == 0) return std::nullopt;
    const double away = std::max(beside * std::abs(side), least_cells * view_.cell) * (side > 0 ? -1 : 1);
    const Vec2 shift = away / length * Vec2(-along.y, along.x);
    const double behind = nearest - farthest + 4 * view_.contact.touching;
    edges::FeatureEdge line = contour;
    for (int& vertex : line.vertex) vertex = moved(vertex, shift, behind);
    return line;
  }

 private:
  [[nodiscard]] std::vector<view::PageVertex> corners_at(const edges::FeatureEdge& contour) const {
    const mesh::Mesh& mesh = *world_.models[contour.model].mesh;
    std::vector<view::PageVertex> corners;
    for (const int t : mesh.triangles_of(mesh.edges[static_cast<std::size_t>(contour.mesh_edge)]))
      for (const int v : mesh.triangle(t)) corners.push_back(view_.vertices[world_.first_vertex[contour.model] + v]);
    return corners;
  }

  int moved(int vertex, const Vec2& shift, double behind) {
    view::Mapped place = view_.clipper.vertices[static_cast<std::size_t>(vertex)];
    place.x += place.w * shift.x;
    place.y += place.w * shift.y;
    place.z -= place.w * behind;
    return view::add_mapped_point(view_, place);
  }

  const scene::World& world_;
  view::ProjectedScene& view_;
};

/// The face of the part at a triangle of a model.
int face_at(const scene::World& world, int model, int triangle) {
  return world.models[model].part->face_of_triangle[static_cast<std::size_t>(triangle)];
}

/// Faces of parts, as model and face, sorted.
using Faces = std::vector<std::array<int, 2>>;

Faces faces_with(const scene::World& world, const edges::FeatureEdges& drawn, const std::vector<std::size_t>& numbers) {
  Faces faces;
  for (const std::size_t e : numbers) {
    const edges::FeatureEdge& edge = drawn.edges[e];
    const mesh::Mesh& mesh = *world.models[edge.model].mesh;
    const auto triangles = mesh.triangles_of(mesh.edges[static_cast<std::size_t>(edge.mesh_edge)]);
    faces.push_back({edge.model, face_at(world, edge.model, triangles.front())});
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// The view without all other faces.
view::ProjectedScene view_of(const scene::World& world, const view::ProjectedScene& view, const Faces& faces) {
  view::ProjectedScene some = view;
  const auto is_other = [&](const view::ViewTriangle& triangle) {
    const int model = world.model_of_triangle(triangle.source);
    if (world.models[model].part == nullptr) return true;
    const int face = face_at(world, model, triangle.source - world.first_triangle[model]);
    return !std::binary_search(faces.begin(), faces.end(), std::array{model, face});
  };
  const auto end = std::remove_if(some.triangles.begin(), some.triangles.end(), is_other);
  some.triangles.resize(static_cast<std::size_t>(end - some.triangles.begin()));
  return some;
}

/// Closes gaps between spans, and at both ends, up to this length.
void close_gaps(Spans& spans, double most) {
  Spans closed;
  for (const auto& [from, to] : spans) {
    const double before = closed.empty() ? 0 : closed.back()[1];
    add_span(closed, {from - before <= most ? before : from, to});
  }
  if (!closed.empty() && 1 - closed.back()[1] <= most) closed.back()[1] = 1;
  spans = std::move(closed);
}

/// Adds spans to those of the edges with these numbers, which ascend, and closes gaps between them up to `most_gap`.
HiddenSpans with_spans(const HiddenSpans& hidden, const std::vector<std::size_t>& numbers, const HiddenSpans& more,
                       double most_gap) {
  HiddenSpans all{{0}, {}, hidden.undecided};
  all.first.reserve(hidden.first.size());
  all.spans.reserve(hidden.spans.size() + more.spans.size());
  std::size_t next = 0;
  for (std::size_t e = 0; e + 1 < hidden.first.size(); ++e) {
    Spans spans(hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[e]),
                hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[e + 1]));
    if (next < numbers.size() && numbers[next] == e) {
      for (std::size_t i = more.first[next]; i < more.first[next + 1]; ++i) add_span(spans, more.spans[i]);
      if (more.first[next] < more.first[next + 1]) close_gaps(spans, most_gap);
      ++next;
    }
    all.spans.insert(all.spans.end(), spans.begin(), spans.end());
    all.first.push_back(all.spans.size());
  }
  return all;
}

void hide_beyond_cusps(const edges::FeatureEdges& drawn, HiddenSpans& hidden) {
  std::vector<std::size_t> numbers;
  HiddenSpans parts{{0}, {}, {}};
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    if (drawn.edges[e].hollow == 0) continue;
    numbers.push_back(e);
    parts.spans.push_back(drawn.edges[e].hollow_part());
    parts.first.push_back(parts.spans.size());
  }
  if (!numbers.empty()) hidden = with_spans(hidden, numbers, parts, 0);
}

}  // namespace

void hide_folds(const scene::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                HiddenSpans& hidden, const Progress& progress) {
  hide_beyond_cusps(drawn, hidden);
  std::vector<std::size_t> folds;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (drawn.edges[e].by_chance && is_visible_somewhere(hidden, e)) folds.push_back(e);
  if (folds.empty()) return;
  view::ProjectedScene faces = view_of(world, view, faces_with(world, drawn, folds));
  Beside next_to(world, faces);
  std::vector<std::size_t> numbers;
  edges::FeatureEdges lines;
  lines.beside_slivers = drawn.beside_slivers;
  for (const std::size_t e : folds)
    if (const auto line = next_to.line_at(drawn.edges[e])) {
      numbers.push_back(e);
      lines.edges.push_back(*line);
    }
  const HiddenSpans behind = find_hidden(world, faces, lines, progress);
  if (!behind.undecided.empty()) throw OutOfTime{"hiding lines"};
  hidden = with_spans(hidden, numbers, behind, narrow_end);
}

}  // namespace epura::visibility
