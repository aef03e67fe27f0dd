// SPDX-License-Identifier: Apache-2.0
#include "study/methods/sampled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "oracle/span_sets.hpp"
#include "study/methods/point_rule.hpp"
#include "visibility/occluders.hpp"

namespace epura::study {

namespace {

constexpr std::size_t chunk = 64;
constexpr double max_points = 1e9;

/// Tests the points of one edge.
class Lookup {
 public:
  Lookup(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
         const visibility::OccluderGrid& occluders, const edges::FeatureEdge& edge)
      : view_(view),
        occluders_(occluders),
        own_(world, drawn, edge),
        line_{edge.vertex[0], edge.vertex[1]},
        rule_(view, line_) {
    occluders.along(line_, [&](const visibility::CellSegment& stretch) { stretches_.push_back(stretch); });
    std::sort(stretches_.begin(), stretches_.end(),
              [](const visibility::CellSegment& a, const visibility::CellSegment& b) { return a.from < b.from; });
  }

  [[nodiscard]] bool is_hidden(double s) const {
    for (const int end : {line_.p, line_.q})
      for (const int triangle : occluders_.copies_around(end))
        if (is_hidden_by(triangle, s)) return true;
    const visibility::CellSegment& stretch = stretch_at(s);
    const double depth = occluders_.depths(line_, s, s)[0];
    if (depth < stretch.cover) return true;
    if (stretch.tree != nullptr) return is_hidden_in(*stretch.tree, s);
    const double reach = occluders_.distance(depth);
    for (const visibility::Candidate& candidate : stretch.candidates) {
      if (candidate.distance() > reach) return false;
      if (is_hidden_by(candidate.triangle(), s)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_hidden_by(int number, double s) const {
    const view::ViewTriangle& triangle = view_.triangles[number];
    return rule_.hides(triangle, s) && !own_.contain(triangle.source);
  }

  [[nodiscard]] bool is_hidden_by(const visibility::Pile& pile, double s) const {
    const auto hides = [&](int triangle) { return is_hidden_by(triangle, s); };
    return std::any_of(pile.triangles().begin(), pile.triangles().end(), hides);
  }

  [[nodiscard]] bool is_hidden_in(const visibility::CandidateTree& tree, double s) const {
    const Vec3 point = occluders_.point(line_, s);
    bool hidden = false;
    tree.visit_joined(view_, line_, [&](int triangle) { hidden = hidden || is_hidden_by(triangle, s); });
    if (hidden) return true;
    tree.visit(tree.before(view_, line_, {point, point}), [&](const auto& thing) {
      hidden = is_hidden_by(thing, s);
      return !hidden;
    });
    return hidden;
  }

  // Segments overlap by rounding, and every position is in one.
  [[nodiscard]] const visibility::CellSegment& stretch_at(double s) const {
    auto stretch =
        std::upper_bound(stretches_.begin(), stretches_.end(), s,
                         [](double place, const visibility::CellSegment& other) { return place < other.from; });
    if (stretch != stretches_.begin()) --stretch;
    for (auto earlier = stretch; earlier->to < s && earlier != stretches_.begin();)
      if ((--earlier)->to >= s) return *earlier;
    return *stretch;
  }

  const view::ProjectedScene& view_;
  const visibility::OccluderGrid& occluders_;
  visibility::OwnTriangles own_;
  visibility::PageEdge line_;
  PointRule rule_;
  std::vector<visibility::CellSegment> stretches_;
};

// The position of the change between two positions with different results.
double place_of_change(const Lookup& lookup, double from, double to, bool hidden_from, int halvings) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (from + to);
    if (middle <= from || middle >= to) break;
    (lookup.is_hidden(middle) == hidden_from ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

visibility::Spans hidden_spans(const Lookup& lookup, double points, int halvings) {
  visibility::Spans spans;
  double begin = 0, last = 0;
  bool hidden = false;
  for (double i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points;
    const bool now = lookup.is_hidden(s);
    if (i > 0 && now != hidden) {
      const double change = place_of_change(lookup, last, s, hidden, halvings);
      if (hidden) spans.push_back({begin, change});
      begin = change;
    }
    hidden = now;
    last = s;
  }
  if (hidden) spans.push_back({begin, 1});
  return spans;
}

double length_of(const view::ProjectedScene& view, const edges::FeatureEdge& edge) {
  const view::PageVertex& p = view.vertices[edge.vertex[0]];
  const view::PageVertex& q = view.vertices[edge.vertex[1]];
  return std::hypot(q.x - p.x, q.y - p.y);
}

void require_few_points(const view::ProjectedScene& view, const edges::FeatureEdges& drawn, double density) {
  double points = 0;
  for (const edges::FeatureEdge& edge : drawn.edges) points += length_of(view, edge) * density;
  if (points > max_points)
    throw Error(
        ErrorKind::input, "--visibility sampled",
        "asks for " + format_rounded(points, 2) + " points, at most " + format_rounded(max_points, 2) + " are possible",
        "give a smaller density");
}

}  // namespace

visibility::HiddenSpans find_hidden_by_samples(const world::World& world, const view::ProjectedScene& view,
                                               const edges::FeatureEdges& drawn, const Sampling& sampling,
                                               Progress progress) {
  require_few_points(view, drawn, sampling.density);
  progress.begin("hiding lines", drawn.edges.size());
  const visibility::OccluderGrid occluders(world, view, drawn.edges);
  std::vector<visibility::Spans> found(drawn.edges.size());
  parallel_for(drawn.edges.size(), chunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const Lookup lookup(world, view, drawn, occluders, drawn.edges[e]);
      const double points = std::max(1.0, std::ceil(length_of(view, drawn.edges[e]) * sampling.density));
      found[e] = hidden_spans(lookup, points, sampling.halvings);
    }
    progress.advance(last - first);
  });
  return gather(found);
}

}  // namespace epura::study
