// SPDX-License-Identifier: Apache-2.0
#include "annotations/seen_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/error.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double on_axis_line = 0.02;  // mm

std::vector<std::array<int, 4>> visible_edges(const drawing::ViewDrawing& drawing) {
  std::vector<std::array<int, 4>> edges;
  for (std::size_t i = 0; i < drawing.segments.size(); ++i)
    if (const drawing::Segment& s = drawing.segments[i]; s.visible && s.edge[0] >= 0)
      edges.push_back({s.model, std::min(s.edge[0], s.edge[1]), std::max(s.edge[0], s.edge[1]), static_cast<int>(i)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

SeenFeatures::SeenFeatures(const drawing::ViewDrawing& drawing, const BodyStyles& styles)
    : drawing_(drawing), styles_(styles) {
  const bool some_without_hidden = styles.any([](const BodyStyle& style) { return style.hidden == HiddenLines::none; });
  if (some_without_hidden) edges_ = visible_edges(drawing);
  for (const drawing::Segment& s : drawing.segments)
    if (s.body >= 0 && s.edge[0] >= 0)
      for (const int vertex : s.edge) bodies_.push_back({s.model, vertex, s.body});
  std::sort(bodies_.begin(), bodies_.end());
}

// Calls visit(segment) for visible lines between vertices of a feature, while it returns true.
template <class Visit>
void SeenFeatures::visit_edges(const features::CentredRound& feature, const Visit& visit) const {
  const std::vector<int>& vertices = feature.vertices;
  for (const int low : vertices) {
    auto edge = std::lower_bound(edges_.begin(), edges_.end(), Edge{feature.model, low, 0, 0});
    for (; edge != edges_.end() && (*edge)[0] == feature.model && (*edge)[1] == low; ++edge)
      if (std::binary_search(vertices.begin(), vertices.end(), (*edge)[2]) &&
          !visit(in_whole_view(drawing_.segments[(*edge)[3]])))
        return;
  }
}

drawing::Segment SeenFeatures::in_whole_view(drawing::Segment segment) const {
  if (!drawing_.shown.breaks.any()) return segment;
  segment.from = drawing_.shown.breaks.restored(segment.from);
  segment.to = drawing_.shown.breaks.restored(segment.to);
  return segment;
}

// The named body that has lines at its vertices.
int SeenFeatures::body_of(const features::CentredRound& feature) const {
  for (const int vertex : feature.vertices) {
    const auto found = std::lower_bound(bodies_.begin(), bodies_.end(), std::array{feature.model, vertex, 0});
    if (found != bodies_.end() && (*found)[0] == feature.model && (*found)[1] == vertex) return (*found)[2];
  }
  return -1;
}

bool SeenFeatures::has_hidden_lines(const features::CentredRound& feature) const {
  return styles_(feature.model, body_of(feature)).hidden != HiddenLines::none;
}

bool SeenFeatures::shows(const features::CentredRound& feature) const {
  if (has_hidden_lines(feature)) return true;
  // The rims of a hole seen from the side are part of the outline, and do not show the hole.
  if (feature.enclosed && largest_of(see(drawing_, feature)).is_edge_on()) return false;
  bool found = false;
  visit_edges(feature, [&](const drawing::Segment&) { return !(found = true); });
  return found;
}

bool SeenFeatures::is_inside(const features::CentredRound& feature) const {
  return feature.enclosed && !has_hidden_lines(feature) && largest_of(see(drawing_, feature)).is_slanted();
}

bool SeenFeatures::is_in_parts(const features::CentredRound& feature) const {
  return !feature.enclosed && !feature.cut && feature.rings.size() > 1 && !has_hidden_lines(feature) &&
         largest_of(see(drawing_, feature)).is_slanted();
}

std::vector<SeenRim> SeenFeatures::rims(const features::CentredRound& feature) const {
  const std::vector<SeenCircle> rings = see(drawing_, feature);
  std::vector<SeenRim> seen(rings.size());
  visit_edges(feature, [&](const drawing::Segment& s) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (!rings[i].has(s.from) || !rings[i].has(s.to)) continue;
      seen[i].turn += std::abs(rings[i].angle_between(s.from, s.to)) / (2 * std::numbers::pi);
      seen[i].points.insert(seen[i].points.end(), {s.from, s.to});
    }
    return true;
  });
  return seen;
}

void SeenFeatures::add_beside(const features::CentredRound& feature, const PageAxis& axis,
                              std::array<visibility::Spans, 2>& sides) const {
  check(std::abs(glm::length(axis.along) - 1) < 1e-9, "the direction of an axis is a unit vector");
  const auto offset = [&](const Vec2& p) {
    return axis.along.x * (p.y - axis.at.y) - axis.along.y * (p.x - axis.at.x);
  };
  visit_edges(feature, [&](const drawing::Segment& s) {
    const double from = glm::dot(s.from, axis.along), to = glm::dot(s.to, axis.along);
    const std::array<double, 2> span{std::min(from, to) - axis.beyond, std::max(from, to) + axis.beyond};
    if (std::min(offset(s.from), offset(s.to)) <= on_axis_line) visibility::add_span(sides[0], span);
    if (std::max(offset(s.from), offset(s.to)) >= -on_axis_line) visibility::add_span(sides[1], span);
    return true;
  });
}

}  // namespace epura::sheet
