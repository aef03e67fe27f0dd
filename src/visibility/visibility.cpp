#include "visibility/visibility.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "visibility/occluders.hpp"

namespace epura {

namespace {

using Spans = std::vector<std::array<double, 2>>;

constexpr double contact_cells = 4;
constexpr double contact_part = 0x1p-29;
constexpr double joined_part = 0x1p-44;
// Pieces of a line shorter than this part of the drawing are rounding, not geometry.
constexpr double least_piece = 1e-7;

double size_of(const World& world, const View& view) {
  const Vec3 size = world.box.size() * view.map.shrink;
  return std::max({size.x, size.y, size.z});
}

// An edge's own triangles never hide it.
bool is_own(const World& world, const DrawnEdges& drawn, const DrawnEdge& edge, int triangle) {
  if (edge.crossing >= 0) {
    const auto& pair = drawn.crossings[edge.crossing].triangles;
    return triangle == pair[0] || triangle == pair[1];
  }
  const Mesh& mesh = *world.models[edge.model].mesh;
  const auto own = mesh.triangles_of(mesh.edges[edge.mesh_edge]);
  return std::find(own.begin(), own.end(), triangle - world.first_triangle[edge.model]) != own.end();
}

// Sorted and joined where they touch or overlap.
void unite(Spans& spans) {
  std::sort(spans.begin(), spans.end());
  std::size_t last = 0;
  for (std::size_t i = 1; i < spans.size(); ++i) {
    if (spans[i][0] <= spans[last][1])
      spans[last][1] = std::max(spans[last][1], spans[i][1]);
    else
      spans[++last] = spans[i];
  }
  if (!spans.empty()) spans.resize(last + 1);
}

// Visible slivers between or before hidden spans become hidden, then hidden slivers visible.
void absorb_slivers(Spans& spans, double least) {
  if (spans.empty()) return;
  if (least >= 1) {
    double hidden = 0;
    for (const auto& span : spans) hidden += span[1] - span[0];
    spans = hidden > 0.5 ? Spans{{0.0, 1.0}} : Spans{};
    return;
  }
  Spans joined;
  for (const auto& span : spans) {
    if (!joined.empty() && span[0] - joined.back()[1] < least)
      joined.back()[1] = span[1];
    else
      joined.push_back(span);
  }
  std::erase_if(joined, [&](const auto& span) { return span[1] - span[0] < least; });
  if (!joined.empty()) {
    if (joined.front()[0] < least) joined.front()[0] = 0;
    if (1 - joined.back()[1] < least) joined.back()[1] = 1;
  }
  spans = joined;
}

struct Hider {
  const World& world;
  const View& view;
  const Contact& contact;
  const OccluderGrid& occluders;
  const DrawnEdges& drawn;

  // `candidates` is scratch space.
  [[nodiscard]] Spans hidden_spans(const DrawnEdge& edge, std::vector<int>& candidates) const {
    const auto& [p, q] = edge.vertex;
    const PageVertex& a = view.vertices[p];
    const PageVertex& b = view.vertices[q];
    const Sightline line{p, q, std::min(a.depth, b.depth)};
    Spans spans;
    occluders.near(view, line, candidates);
    for (const int number : candidates) {
      const Occluder& occluder = occluders.occluders()[number];
      if (is_own(world, drawn, edge, occluder.source)) continue;
      if (const auto part = hidden_part(view, line, occluder, contact)) spans.push_back(*part);
    }
    unite(spans);
    absorb_slivers(spans, least_piece * view.extent / std::hypot(b.x - a.x, b.y - a.y));
    return spans;
  }
};

}  // namespace

Contact contact_of(const World& world, const View& view, std::optional<double> given) {
  const double unit = view.map.unit;
  const double joined = joined_part * view.extent;
  if (given) return {std::max(*given * view.map.shrink * unit, joined), joined};
  return {std::max(contact_cells * view.cell, world.precision * size_of(world, view) * unit), joined};
}

double contact_in_space(const World& world, const View& view, std::optional<double> given) {
  if (given) return *given * view.map.shrink;
  return std::max(contact_part, world.precision) * size_of(world, view);
}

HiddenSpans find_hidden(const World& world, const View& view, const DrawnEdges& drawn, const Contact& contact) {
  const OccluderGrid occluders(view);
  const Hider hider{world, view, contact, occluders, drawn};
  std::vector<Spans> by_edge(drawn.edges.size());
  parallel_for(drawn.edges.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<int> candidates;
    for (std::size_t e = begin; e < end; ++e) by_edge[e] = hider.hidden_spans(drawn.edges[e], candidates);
  });

  HiddenSpans hidden;
  hidden.first.push_back(0);
  for (const Spans& spans : by_edge) {
    hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
    hidden.first.push_back(hidden.spans.size());
  }
  return hidden;
}

HiddenSpans nothing_hidden(const DrawnEdges& drawn) {
  return {std::vector<std::size_t>(drawn.edges.size() + 1, 0), {}};
}

}  // namespace epura
