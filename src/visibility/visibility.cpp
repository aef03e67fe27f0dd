#include "visibility/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "visibility/occluders.hpp"
#include "visibility/spans.hpp"

namespace epura {

namespace {

constexpr double contact_cells = 4;
constexpr double contact_part = 0x1p-29;
constexpr double joined_part = 0x1p-44;

double size_of(const World& world, const View& view) {
  const Vec3 size = world.box.size() * view.map.shrink;
  return std::max({size.x, size.y, size.z});
}

struct Hider {
  const World& world;
  const View& view;
  const Contact& contact;
  const OccluderGrid& occluders;
  const DrawnEdges& drawn;

  // In every cell along the edge, what lies behind its cover is hidden; otherwise candidates are tried from the nearest
  // on, until the stretch is hidden or the rest lies behind it. What a triangle hides is computed for the whole edge,
  // so the union does not depend on cells or order.
  [[nodiscard]] Spans hidden_spans(const DrawnEdge& edge) const {
    const Sightline line{edge.vertex[0], edge.vertex[1]};
    std::array<int, 64> tried;  // lately, by the last bits of their numbers
    tried.fill(-1);
    Spans spans;
    occluders.along(line, [&](const Stretch& stretch) {
      if (covers(spans, stretch.from, stretch.to)) return;
      const auto [farthest, nearest] = occluders.depths(line, stretch.from, stretch.to);
      if (nearest < stretch.cover) return add_span(spans, {stretch.from, stretch.to});
      const double reach = occluders.distance(farthest);
      for (const Candidate& candidate : stretch.candidates) {
        if (candidate.distance() > reach) return;
        const int number = candidate.triangle();
        if (std::exchange(tried[number % tried.size()], number) == number) continue;
        const ViewTriangle& triangle = view.triangles[number];
        if (is_own(world, drawn, edge, triangle.source)) continue;
        const auto part = hidden_part(view, line, triangle, contact);
        if (!part) continue;
        add_span(spans, *part);
        if (covers(spans, stretch.from, stretch.to)) return;
      }
    });
    absorb_slivers(spans, least_span(view, line));
    return spans;
  }
};

constexpr std::size_t chunk = 256;

}  // namespace

Contact contact_of(const World& world, const View& view, std::optional<double> given) {
  const double unit = view.map.unit;
  const double joined = joined_part * view.extent;
  if (given) return {std::max(*given * view.map.shrink * unit, joined), joined};
  return {std::max(contact_cells * view.cell, world.rounding * view.map.shrink * unit), joined};
}

double contact_in_space(const World& world, const View& view, std::optional<double> given) {
  if (given) return *given * view.map.shrink;
  return std::max(contact_part * size_of(world, view), world.rounding * view.map.shrink);
}

bool is_own(const World& world, const DrawnEdges& drawn, const DrawnEdge& edge, int triangle) {
  if (edge.crossing >= 0) {
    const auto& pair = drawn.crossings[edge.crossing].triangles;
    return triangle == pair[0] || triangle == pair[1];
  }
  const Mesh& mesh = *world.models[edge.model].mesh;
  const auto own = mesh.triangles_of(mesh.edges[edge.mesh_edge]);
  return std::find(own.begin(), own.end(), triangle - world.first_triangle[edge.model]) != own.end();
}

HiddenSpans find_hidden(const World& world, const View& view, const DrawnEdges& drawn, const Contact& contact) {
  const OccluderGrid occluders(view, drawn.edges, contact);
  const Hider hider{world, view, contact, occluders, drawn};
  const std::size_t count = drawn.edges.size();
  HiddenSpans hidden{std::vector<std::size_t>(count + 1, 0), {}};
  std::vector<Spans> found((count + chunk - 1) / chunk);
  parallel_for(found.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      for (std::size_t e = part * chunk; e < std::min((part + 1) * chunk, count); ++e) {
        const Spans spans = hider.hidden_spans(drawn.edges[e]);
        hidden.first[e + 1] = spans.size();
        found[part].insert(found[part].end(), spans.begin(), spans.end());
      }
  });
  for (std::size_t e = 0; e < count; ++e) hidden.first[e + 1] += hidden.first[e];
  for (const Spans& spans : found) hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
  return hidden;
}

HiddenSpans nothing_hidden(const DrawnEdges& drawn) {
  return {std::vector<std::size_t>(drawn.edges.size() + 1, 0), {}};
}

}  // namespace epura
