// SPDX-License-Identifier: Apache-2.0
#include "visibility/visibility.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "visibility/in_sight.hpp"
#include "visibility/limits.hpp"
#include "visibility/occluders.hpp"
#include "visibility/occlusion_query.hpp"
#include "visibility/spans.hpp"

namespace epura::visibility {

namespace {

struct Occlusion {
  const world::World& world;
  const view::ProjectedScene& view;
  const edges::FeatureEdges& drawn;
  const OccluderGrid& occluders;
  const std::optional<OccluderGrid>& uncovered;  ///< for edges whose own triangles may cover cells

  [[nodiscard]] Spans hidden_spans(const edges::FeatureEdge& edge) const {
    const OwnTriangles own(world, drawn, edge);
    return hidden_in(own.include_clear_facets() ? *uncovered : occluders, edge, own);
  }

  // With facets that lie behind the edge as their surface does.
  [[nodiscard]] Spans hidden_by_facets(const edges::FeatureEdge& edge) const {
    return hidden_in(occluders, edge, OwnTriangles(world, drawn, edge).meeting());
  }

 private:
  [[nodiscard]] Spans hidden_in(const OccluderGrid& grid, const edges::FeatureEdge& edge,
                                const OwnTriangles& own) const {
    const PageEdge line{edge.vertex[0], edge.vertex[1]};
    OcclusionQuery hider(view, grid, line, own);
    grid.along(line, [&](const CellSegment& stretch) { hider.hide(stretch); });
    return std::move(hider).spans();
  }
};

constexpr std::size_t edges_at_once = 256;

// The order in which edges are decided. It matters only if time may run out.
std::vector<int> work_order(const view::ProjectedScene& view, const std::vector<edges::FeatureEdge>& edges,
                            Progress progress) {
  if (progress.is_limited()) return longest_first(view, edges);
  std::vector<int> order(edges.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// Puts the spans, which were found in the order of work, into the order of the edges. `hidden.first[e + 1]` holds the
// number of spans of edge e.
void put_in_order(const std::vector<Spans>& found, const std::vector<int>& order, HiddenSpans& hidden) {
  std::partial_sum(hidden.first.begin(), hidden.first.end(), hidden.first.begin());
  hidden.spans.resize(hidden.first.back());
  for (std::size_t part = 0; part < found.size(); ++part) {
    auto from = found[part].begin();
    for (std::size_t i = part * edges_at_once; i < std::min((part + 1) * edges_at_once, order.size()); ++i) {
      const auto e = static_cast<std::size_t>(order[i]);
      const auto end = from + static_cast<std::ptrdiff_t>(hidden.first[e + 1] - hidden.first[e]);
      check(end <= found[part].end(), "every span is of one edge");
      std::copy(from, end, hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[e]));
      from = end;
    }
    check(from == found[part].end(), "every span is of one edge");
  }
}

/// Tells for all threads whether a stage may go on: for the first part of its time, and longer if it will end in time.
class Speed {
 public:
  Speed(const Progress& progress, std::size_t work)
      : progress_(progress),
        first_(progress.with_part_of_the_time(first_part_of_the_time)),
        begun_(now()),
        work_(static_cast<double>(work)) {}

  void advance() { done_.fetch_add(1, std::memory_order_relaxed); }
  /// False for all threads once it is for one.
  [[nodiscard]] bool has_time() {
    if (!is_over_ && first_.is_out_of_time() && (progress_.is_out_of_time() || !will_end())) is_over_ = true;
    return !is_over_;
  }

 private:
  [[nodiscard]] double now() const { return progress_.with_part_of_the_time(0).time_limit().value_or(0); }
  [[nodiscard]] bool will_end() const {
    const double at = now(), done = static_cast<double>(done_.load(std::memory_order_relaxed));
    return done > 0 && at + (at - begun_) * (work_ - done) / done <= progress_.time_limit().value_or(at);
  }

  const Progress& progress_;
  Progress first_;
  double begun_, work_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> is_over_ = false;
};

// Decides edges by `spans_of(edge)`; with a time limit, the longest first while time remains.
template <class SpansOf>
HiddenSpans decide(const view::ProjectedScene& view, const edges::FeatureEdges& drawn, const SpansOf& spans_of,
                   const Progress& progress) {
  const std::size_t count = drawn.edges.size();
  progress.begin("hiding lines", count);
  const std::vector<int> order = work_order(view, drawn.edges, progress);
  HiddenSpans hidden = nothing_hidden(drawn);
  std::vector<Spans> found((count + edges_at_once - 1) / edges_at_once);
  std::vector<char> decided(count, 0);
  std::atomic<std::size_t> next = 0;
  Speed speed(progress, count);
  parallel_for(found.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t turn = first; turn < last; ++turn) {
      const std::size_t part = next++;  // in order, whichever edges_at_once a thread was given
      const std::size_t end = std::min((part + 1) * edges_at_once, count);
      for (std::size_t i = part * edges_at_once; i < end && speed.has_time(); ++i) {
        const Spans spans = spans_of(drawn.edges[order[i]]);
        hidden.first[order[i] + 1] = spans.size();
        found[part].insert(found[part].end(), spans.begin(), spans.end());
        decided[order[i]] = 1;
        speed.advance();
      }
      progress.advance(end - part * edges_at_once);
    }
  });
  check(next == found.size(), "every part of the edges is taken once");
  put_in_order(found, order, hidden);
  for (std::size_t e = 0; e < count; ++e)
    if (decided[e] == 0) hidden.undecided.push_back(static_cast<int>(e));
  if (count > 0 && hidden.undecided.size() == count) throw OutOfTime{"hiding lines"};
  return hidden;
}

// The parts of an edge that any triangle hides, by testing all of them.
Spans hidden_by_all(const view::ProjectedScene& view, const PageEdge& line, const OwnTriangles& own) {
  Spans spans;
  for (const view::ViewTriangle& triangle : view.triangles) {
    const auto& [a, b, c] = triangle.vertex;
    // A triangle seen edge-on hides nothing.
    if (view::cross(view.grid[a], view.grid[b], view.grid[c]) == 0 || own.contain(triangle.source)) continue;
    if (const auto part = hidden_part(view, line, triangle)) add_span(spans, *part);
    if (covers(spans, 0, 1)) break;
  }
  absorb_slivers(spans, min_span(view, line));
  return spans;
}

// Finds the entry of an edge in a list in order of model and mesh edge.
template <class Entry>
const Entry* find_entry(const std::vector<Entry>& list, const edges::FeatureEdge& edge) {
  const auto key = [](const Entry& entry) { return std::pair(entry.model, entry.mesh_edge); };
  const auto found = std::ranges::lower_bound(list, std::pair(edge.model, edge.mesh_edge), {}, key);
  return found != list.end() && key(*found) == std::pair(edge.model, edge.mesh_edge) ? &*found : nullptr;
}

}  // namespace

OwnTriangles::OwnTriangles(const world::World& world, const edges::FeatureEdges& drawn,
                           const edges::FeatureEdge& edge) {
  if (edge.crossing >= 0) {
    check(edge.crossing < static_cast<int>(drawn.crossings.size()), "an intersection line has its crossing");
    numbers_ = drawn.crossings[edge.crossing].triangles;
    return;
  }
  const world::Placed& placed = world.models[edge.model];
  const mesh::Mesh& mesh = *placed.mesh;
  const auto* met = find_entry(drawn.beside_slivers, edge);
  numbers_ = met != nullptr ? std::span(met->triangles) : mesh.triangles_of(mesh.edges[edge.mesh_edge]);
  first_ = world.first_triangle[edge.model];
  clear_ = find_entry(drawn.clear_contours, edge);
  if (clear_ != nullptr) placed_ = &placed;
}

bool OwnTriangles::is_behind_contour(int triangle) const {
  return triangle >= 0 && triangle < static_cast<int>(placed_->part->face_of_triangle.size()) &&
         is_clear(*placed_, *clear_, triangle);
}

bool is_clear(const world::Placed& placed, const edges::ClearContour& contour, int triangle) {
  if (placed.part->face_of_triangle[static_cast<std::size_t>(triangle)] != contour.face) return false;
  const auto [a, b, c] = placed.mesh->triangle(triangle);
  const Vec3 middle = (placed.mesh->point(a) + placed.mesh->point(b) + placed.mesh->point(c)) / 3.0;
  return glm::dot(middle - contour.from, contour.towards) < contour.clear;
}

namespace {

// The numbers of edges of which facets may lie behind them as their surface does.
std::vector<int> clear_edges(const world::World& world, const edges::FeatureEdges& drawn) {
  std::vector<int> numbers;
  for (std::size_t e = 0; !drawn.clear_contours.empty() && e < drawn.edges.size(); ++e)
    if (OwnTriangles(world, drawn, drawn.edges[e]).include_clear_facets()) numbers.push_back(static_cast<int>(e));
  return numbers;
}

// Adds what facets hide of some edges beyond what is hidden anyway. Where time runs out, facets decide nothing.
template <class SpansOf>
void add_hidden_by_facets(const std::vector<int>& numbers, const SpansOf& with_facets, HiddenSpans& hidden,
                          const Progress& progress) {
  std::vector<Spans> found(numbers.size());
  parallel_for(numbers.size(), grain::heavy, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.is_out_of_time(); ++i) found[i] = with_facets(numbers[i]);
  });
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (const std::array<double, 2>& part : found[i])
      hidden.visit_parts(static_cast<std::size_t>(numbers[i]), [&](double start, double end, bool visible) {
        const double from = std::max(part[0], start), to = std::min(part[1], end);
        if (visible && from < to) hidden.by_facets.push_back({numbers[i], from, to});
      });
  check(std::ranges::is_sorted(hidden.by_facets, {}, &FacetsSpan::edge), "what facets hide is in the order of edges");
}

}  // namespace

HiddenSpans find_hidden(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                        Progress progress) {
  progress.begin("finding occluders");
  const Progress search = progress.with_part_of_the_time(first_part_of_the_time);
  const OccluderGrid occluders(world, view, drawn.edges, Covers::any, search);
  const std::vector<int> numbers = clear_edges(world, drawn);
  std::vector<edges::FeatureEdge> clear;
  for (const int e : numbers) clear.push_back(drawn.edges[e]);
  std::optional<OccluderGrid> uncovered;
  if (!clear.empty()) uncovered.emplace(world, view, clear, Covers::none, search);
  const Occlusion hider{world, view, drawn, occluders, uncovered};
  HiddenSpans hidden = decide(
      view, drawn, [&](const edges::FeatureEdge& edge) { return hider.hidden_spans(edge); }, progress);
  add_hidden_by_facets(
      numbers, [&](int e) { return hider.hidden_by_facets(drawn.edges[e]); }, hidden, progress);
  return hidden;
}

HiddenSpans find_hidden_directly(const world::World& world, const view::ProjectedScene& view,
                                 const edges::FeatureEdges& drawn, Progress progress) {
  const auto spans_of = [&](const edges::FeatureEdge& edge) {
    return hidden_by_all(view, {edge.vertex[0], edge.vertex[1]}, OwnTriangles(world, drawn, edge));
  };
  HiddenSpans hidden = decide(view, drawn, spans_of, progress);
  const auto with_facets = [&](int e) {
    const edges::FeatureEdge& edge = drawn.edges[e];
    return hidden_by_all(view, {edge.vertex[0], edge.vertex[1]}, OwnTriangles(world, drawn, edge).meeting());
  };
  add_hidden_by_facets(clear_edges(world, drawn), with_facets, hidden, progress);
  return hidden;
}

void keep_decided(edges::FeatureEdges& drawn, HiddenSpans& hidden) {
  if (hidden.undecided.empty()) return;
  std::size_t kept = 0, spans = 0;
  auto next = hidden.undecided.begin();
  std::vector<int> by_surface;
  std::vector<FacetsSpan> by_facets, folds;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    if (next != hidden.undecided.end() && static_cast<std::size_t>(*next) == e) {
      ++next;
      continue;
    }
    if (std::binary_search(hidden.by_surface.begin(), hidden.by_surface.end(), static_cast<int>(e)))
      by_surface.push_back(static_cast<int>(kept));
    for (const FacetsSpan& span : hidden.hidden_by_facets(e))
      by_facets.push_back({static_cast<int>(kept), span.from, span.to});
    for (const FacetsSpan& span : hidden.folds_of(e)) folds.push_back({static_cast<int>(kept), span.from, span.to});
    drawn.edges[kept] = drawn.edges[e];
    for (std::size_t i = hidden.first[e]; i < hidden.first[e + 1]; ++i) hidden.spans[spans++] = hidden.spans[i];
    hidden.first[++kept] = spans;
  }
  check(kept + hidden.undecided.size() == drawn.edges.size(), "every edge is decided or not");
  drawn.edges.resize(kept);
  hidden.first.resize(kept + 1);
  hidden.spans.resize(spans);
  hidden.undecided.clear();
  hidden.by_surface = std::move(by_surface);
  hidden.by_facets = std::move(by_facets);
  hidden.folds = std::move(folds);
}

std::vector<int> all_but_longest(const view::ProjectedScene& view, const std::vector<edges::FeatureEdge>& edges,
                                 std::size_t count) {
  std::vector<int> order = longest_first(view, edges);
  order.erase(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size())));
  std::sort(order.begin(), order.end());
  check(order.size() == edges.size() - std::min(count, edges.size()), "all edges but some are left");
  return order;
}

HiddenSpans nothing_hidden(const edges::FeatureEdges& drawn) {
  return {std::vector<std::size_t>(drawn.edges.size() + 1, 0), {}, {}};
}

}  // namespace epura::visibility
