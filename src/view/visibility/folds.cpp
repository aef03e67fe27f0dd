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

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/limits.hpp"
#include "visibility/spans.hpp"

namespace epura::visibility {

namespace {

/// The facets of one model.
class FacetsOfModel {
 public:
  FacetsOfModel(const world::World& world, const view::ProjectedScene& view, int model)
      : view_(view),
        placed_(world.models[model]),
        mesh_(*placed_.mesh),
        face_of_triangle_(placed_.part->face_of_triangle),
        projector_(glm::inverse(placed_.to_world) * Vec4(view.projection.projector, view.projection.central ? 1 : 0)),
        first_(world.first_triangle[model]),
        at_vertex_(mesh_.points.size(), [&](const auto& visit) {
          for (std::size_t i = 0; i < mesh_.corners.size(); ++i)
            visit(static_cast<std::size_t>(mesh_.corners[i]), static_cast<int>(i / 3));
        }) {}

  /// Returns how a contour inside a face lies.
  [[nodiscard]] edges::ClearContour clear(const edges::FeatureEdge& contour) const {
    const auto& [a, b] = mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)].vertex;
    const Vec3 from = (mesh_.point(a) + mesh_.point(b)) / 2.0;
    const Vec3 towards = glm::normalize(view_.projection.central ? projector_ - from : projector_);
    return {contour.model, contour.mesh_edge, face_of_triangle_[own(contour).front()], from, towards, contour.clear};
  }

  /// Whether facets near a contour hide a part of it, though their surface lies behind it.
  [[nodiscard]] bool any_hides(const edges::FeatureEdge& contour) const {
    const edges::ClearContour clear_contour = clear(contour);
    const PageEdge line{contour.vertex[0], contour.vertex[1]};
    const std::span<const int> own_triangles = own(contour);
    return std::ranges::any_of(around(contour, clear_contour.face), [&](int t) {
      if (std::ranges::find(own_triangles, t) != own_triangles.end() || !is_clear(placed_, clear_contour, t))
        return false;
      const auto& all = view_.triangles;
      const auto begin = std::ranges::lower_bound(all, first_ + t, {}, &view::ViewTriangle::source);
      const auto end = std::ranges::upper_bound(begin, all.end(), first_ + t, {}, &view::ViewTriangle::source);
      return std::any_of(begin, end,
                         [&](const view::ViewTriangle& piece) { return hidden_part(view_, line, piece).has_value(); });
    });
  }

 private:
  // The facets of a face that are near a contour, ascending.
  [[nodiscard]] std::vector<int> around(const edges::FeatureEdge& contour, int face) const {
    const std::array<int, 2>& ends = mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)].vertex;
    std::vector<int> corners(ends.begin(), ends.end()), triangles;
    for (int ring = 0; ring < rings; ++ring) {
      triangles.clear();
      for (const int corner : corners)
        for (const int t : at_vertex_[static_cast<std::size_t>(corner)])
          if (face_of_triangle_[t] == face) triangles.push_back(t);
      sort_once(triangles);
      for (const int t : triangles)
        for (const int corner : mesh_.triangle(t)) corners.push_back(corner);
      sort_once(corners);
    }
    return triangles;
  }

  static void sort_once(std::vector<int>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  [[nodiscard]] std::span<const int> own(const edges::FeatureEdge& contour) const {
    return mesh_.triangles_of(mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)]);
  }

  const view::ProjectedScene& view_;
  const world::Placed& placed_;
  const mesh::Mesh& mesh_;
  const std::vector<int>& face_of_triangle_;
  Vec3 projector_;  ///< the centre of projection, or a direction towards the viewer
  int first_;       ///< of its triangles in the world
  Groups<int> at_vertex_;
};

bool is_visible_somewhere(const HiddenSpans& hidden, std::size_t edge) {
  bool visible = false;
  hidden.visit_parts(edge, [&](double, double, bool is_visible) { visible = visible || is_visible; });
  return visible;
}

/// Lines to be tested in place of contours.
class TestedLines {
 public:
  /// Adds the ends of lines to `view`.
  TestedLines(const world::World& world, view::ProjectedScene& view) : world_(world), view_(view) {}

  /// Returns a contour where it is drawn, in front of its facets.
  [[nodiscard]] edges::FeatureEdge drawn(const edges::FeatureEdge& contour) {
    double nearest = -HUGE_VAL, farthest = HUGE_VAL;
    for (const view::PageVertex& corner : corners_at(contour)) {
      nearest = std::max(nearest, corner.depth);
      farthest = std::min(farthest, corner.depth);
    }
    edges::FeatureEdge line = contour;
    for (std::size_t end = 0; end < 2; ++end)
      line.vertex[end] = moved(contour.drawn_vertex(end), {0, 0}, farthest - nearest - 4 * view_.contact.touching);
    return line;
  }

  /// Returns a line next to a contour, on the side on which its facets are not, behind them; nothing for contours
  /// without a length or facets on the page.
  [[nodiscard]] std::optional<edges::FeatureEdge> beside(const edges::FeatureEdge& contour) {
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
    const double away = std::max(off_contour * std::abs(side), min_cells * view_.cell) * (side > 0 ? -1 : 1);
    const Vec2 shift = away / length * Vec2(-along.y, along.x);
    const double facets = contour.by_chance ? 1 : beyond_cusp;
    const double behind = facets * (nearest - farthest) + 4 * view_.contact.touching;
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

  const world::World& world_;
  view::ProjectedScene& view_;
};

/// The face of the part at a triangle of a model.
int face_at(const world::World& world, int model, int triangle) {
  return world.models[model].part->face_of_triangle[static_cast<std::size_t>(triangle)];
}

/// Faces of parts, as model and face, sorted.
using Faces = std::vector<std::array<int, 2>>;

Faces faces_with(const world::World& world, const edges::FeatureEdges& drawn, const std::vector<std::size_t>& numbers) {
  Faces faces;
  for (const std::size_t e : numbers) {
    const edges::FeatureEdge& edge = drawn.edges[e];
    const mesh::Mesh& mesh = *world.models[edge.model].mesh;
    for (const int t : mesh.triangles_of(mesh.edges[static_cast<std::size_t>(edge.mesh_edge)]))
      faces.push_back({edge.model, face_at(world, edge.model, t)});
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// The view without all other faces.
view::ProjectedScene view_of(const world::World& world, const view::ProjectedScene& view, const Faces& faces) {
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

/// The part of a contour that is no line of its surface.
std::array<double, 2> doubtful_part(const edges::FeatureEdge& edge) {
  return edge.by_chance ? std::array{0.0, 1.0} : edge.hollow_part();
}

/// Returns what lies in a part. Gaps between spans, and at both ends of the part, are closed up to a length.
Spans within(std::span<const std::array<double, 2>> spans, const std::array<double, 2>& part, double max_gap) {
  Spans some;
  for (const auto& [from, to] : spans) {
    if (to <= part[0] || from >= part[1]) continue;
    const double before = some.empty() ? part[0] : some.back()[1];
    add_span(some, {from - before <= max_gap ? before : from, std::min(to, part[1])});
  }
  if (!some.empty() && part[1] - some.back()[1] <= max_gap) some.back()[1] = part[1];
  return some;
}

/// Lines tested in place of some edges: the numbers of those edges ascend.
struct Tests {
  std::vector<std::size_t> numbers;
  edges::FeatureEdges lines;

  void add(std::size_t number, const edges::FeatureEdge& line) {
    numbers.push_back(number);
    lines.edges.push_back(line);
  }
};

/// Adds to the hidden spans of each tested edge what `hides` returns for it and its line.
template <class Hides>
HiddenSpans with_spans(const HiddenSpans& hidden, const Tests& tests, const HiddenSpans& found, const Hides& hides) {
  HiddenSpans all{{0}, {}, hidden.undecided, hidden.by_surface, hidden.by_facets, hidden.folds};
  all.first.reserve(hidden.first.size());
  all.spans.reserve(hidden.spans.size() + found.spans.size());
  std::size_t next = 0;
  for (std::size_t e = 0; e + 1 < hidden.first.size(); ++e) {
    Spans spans(hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[e]),
                hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[e + 1]));
    if (next < tests.numbers.size() && tests.numbers[next] == e) {
      const Spans more =
          hides(e, std::span(found.spans).subspan(found.first[next], found.first[next + 1] - found.first[next]));
      for (const auto& span : more) add_span(spans, span);
      if (!more.empty()) all.by_surface.push_back(static_cast<int>(e));
      ++next;
    }
    all.spans.insert(all.spans.end(), spans.begin(), spans.end());
    all.first.push_back(all.spans.size());
  }
  check(next == tests.numbers.size(), "every edge that was tested gets its spans");
  std::sort(all.by_surface.begin(), all.by_surface.end());
  all.by_surface.erase(std::unique(all.by_surface.begin(), all.by_surface.end()), all.by_surface.end());
  return all;
}

HiddenSpans found_hidden(const world::World& world, const view::ProjectedScene& faces, const Tests& tests,
                         const Progress& progress) {
  HiddenSpans found = find_hidden(world, faces, tests.lines, progress);
  if (!found.undecided.empty()) throw OutOfTime{"hiding lines"};
  return found;
}

/// Whether a contour is drawn on a torus, not on the mesh.
bool is_drawn_on_torus(const world::World& world, const edges::FeatureEdge& edge) {
  if (!edge.is_moved()) return false;
  const world::Placed& placed = world.models[edge.model];
  const auto triangles = placed.mesh->triangles_of(placed.mesh->edges[static_cast<std::size_t>(edge.mesh_edge)]);
  return std::all_of(triangles.begin(), triangles.end(), [&](int t) {
    const int face = placed.part->face_of_triangle[static_cast<std::size_t>(t)];
    return placed.part->faces[static_cast<std::size_t>(face)].surface.kind == surfaces::SurfaceKind::torus;
  });
}

/// The visible edges that fulfil a condition.
template <class Wanted>
std::vector<std::size_t> visible_edges(const edges::FeatureEdges& drawn, const HiddenSpans& hidden,
                                       const Wanted& wanted) {
  std::vector<std::size_t> found;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (wanted(drawn.edges[e]) && is_visible_somewhere(hidden, e)) found.push_back(e);
  return found;
}

// Of a mesh, all vertices of a contour near a cusp may be drawn beyond the place where another contour passes before
// it.
void hide_behind_own_face(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                          HiddenSpans& hidden, const Progress& progress) {
  const std::vector<std::size_t> contours =
      visible_edges(drawn, hidden, [&](const edges::FeatureEdge& edge) { return is_drawn_on_torus(world, edge); });
  if (contours.empty()) return;
  view::ProjectedScene faces = view_of(world, view, faces_with(world, drawn, contours));
  TestedLines lines(world, faces);
  Tests tests;
  tests.lines.beside_slivers = drawn.beside_slivers;
  tests.lines.clear_contours = drawn.clear_contours;
  for (const std::size_t e : contours) tests.add(e, lines.drawn(drawn.edges[e]));
  const auto all = [](std::size_t, std::span<const std::array<double, 2>> spans) {
    return Spans(spans.begin(), spans.end());
  };
  hidden = with_spans(hidden, tests, found_hidden(world, faces, tests, progress), all);
}

}  // namespace

void find_clear_contours(const world::World& world, const view::ProjectedScene& view, edges::FeatureEdges& drawn,
                         const Progress& progress) {
  drawn.clear_contours.clear();
  for (auto from = drawn.edges.begin(); from != drawn.edges.end();) {
    const int model = from->model;
    std::vector<const edges::FeatureEdge*> contours;
    for (; from != drawn.edges.end() && from->model == model; ++from)
      if (from->clear > 0) contours.push_back(&*from);
    if (contours.empty()) continue;
    const FacetsOfModel facets(world, view, model);
    std::vector<char> hidden(contours.size(), 0);
    parallel_for(contours.size(), grain::heavy, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) hidden[i] = facets.any_hides(*contours[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < contours.size(); ++i)
      if (hidden[i] != 0) drawn.clear_contours.push_back(facets.clear(*contours[i]));
  }
}

void hide_folds(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                HiddenSpans& hidden, const Progress& progress) {
  hide_behind_own_face(world, view, drawn, hidden, progress);
  check(hidden.folds.empty(), "folds are found once");
  std::vector<std::size_t> all;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (drawn.edges[e].by_chance || drawn.edges[e].hollow != 0) all.push_back(e);
  if (all.empty()) return;
  // A facet at the border of a face may lie over the next one, whose border is hidden there.
  view::ProjectedScene faces = view_of(world, view, faces_with(world, drawn, all));
  TestedLines lines(world, faces);
  Tests tests;
  tests.lines.beside_slivers = drawn.beside_slivers;
  for (const std::size_t e : all)
    if (const auto line = lines.beside(drawn.edges[e])) tests.add(e, *line);
  std::vector<FacetsSpan> folds;
  const auto doubtful = [&](std::size_t e, std::span<const std::array<double, 2>> spans) {
    Spans parts = within(spans, doubtful_part(drawn.edges[e]), narrow_end);
    if (drawn.edges[e].by_chance)
      for (const auto& [from, to] : parts) folds.push_back({static_cast<int>(e), from, to});
    return parts;
  };
  hidden = with_spans(hidden, tests, found_hidden(world, faces, tests, progress), doubtful);
  hidden.folds = std::move(folds);
}

}  // namespace epura::visibility
