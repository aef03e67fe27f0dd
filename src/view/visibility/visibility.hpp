// SPDX-License-Identifier: Apache-2.0
// Splits every drawn edge into visible and hidden spans.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "edges/find_edges.hpp"
#include "visibility/hiding_rule.hpp"

namespace epura::visibility {

/// A part of an edge.
struct FacetsSpan {
  int edge;
  double from, to;
};

/// Hidden parts of edge e: spans[first[e]] to spans[first[e + 1]], as page parameters from its first vertex (0) to its
/// second (1), ascending and disjoint. What is not hidden is visible.
struct HiddenSpans {
  std::vector<std::size_t> first;
  std::vector<std::array<double, 2>> spans;
  std::vector<int> undecided;     ///< edges not examined before time was up, ascending
  std::vector<int> by_surface{};  ///< edges that facets alone do not hide as far as this, ascending (folds.hpp)
  /// What only facets hide that lie behind it as their surface does (edges::ClearContour): visible nevertheless;
  /// ascending.
  std::vector<FacetsSpan> by_facets{};
  /// What is no line of the surface (folds.hpp): hidden, and not even drawn as such; ascending.
  std::vector<FacetsSpan> folds{};

  /// What facets alone hide of an edge, though their surface does not.
  [[nodiscard]] std::span<const FacetsSpan> hidden_by_facets(std::size_t e) const { return spans_of(by_facets, e); }
  [[nodiscard]] std::span<const FacetsSpan> folds_of(std::size_t e) const { return spans_of(folds, e); }

  /// Calls `visit(from, to, visible)` for the parts of edge e from its first vertex to its second.
  template <class Visit>
  void visit_parts(std::size_t e, Visit visit) const {
    const auto part = [&](double from, double to, bool visible) {
      if (from < to) visit(from, to, visible);
    };
    double at = 0;
    for (std::size_t i = first[e]; i < first[e + 1]; ++i) {
      part(at, spans[i][0], true);
      part(spans[i][0], spans[i][1], false);
      at = spans[i][1];
    }
    part(at, 1, true);
  }

 private:
  [[nodiscard]] static std::span<const FacetsSpan> spans_of(const std::vector<FacetsSpan>& spans, std::size_t e) {
    const auto edge = static_cast<int>(e);
    const auto begin = std::ranges::lower_bound(spans, edge, {}, &FacetsSpan::edge);
    return {begin, std::ranges::upper_bound(begin, spans.end(), edge, {}, &FacetsSpan::edge)};
  }
};

/// A view whose hidden lines have been found: the input of its drawing.
struct ResolvedView {
  const world::World& world;
  const view::ProjectedScene& view;
  const edges::FeatureEdges& drawn;
  const HiddenSpans& hidden;
};

/// The triangles that never hide an edge: those that meet in it, and facets of its face that lie behind it as the
/// surface does (edges::ClearContour).
class OwnTriangles {
 public:
  OwnTriangles() = default;  ///< none
  OwnTriangles(const world::World& world, const edges::FeatureEdges& drawn, const edges::FeatureEdge& edge);

  /// Whether one of them is this triangle of the world.
  [[nodiscard]] bool contain(int triangle) const {
    return std::find(numbers_.begin(), numbers_.end(), triangle - first_) != numbers_.end() ||
           (clear_ != nullptr && is_behind_contour(triangle - first_));
  }

  /// Whether there are others than those that meet in the edge.
  [[nodiscard]] bool include_clear_facets() const { return clear_ != nullptr; }
  /// Without these others.
  [[nodiscard]] OwnTriangles meeting() const {
    OwnTriangles own = *this;
    own.clear_ = nullptr;
    return own;
  }

 private:
  [[nodiscard]] bool is_behind_contour(int triangle) const;

  std::span<const int> numbers_;
  int first_ = 0;  ///< added to the numbers
  const edges::ClearContour* clear_ = nullptr;
  const world::Placed* placed_ = nullptr;
};

/// Whether a triangle of the model never hides a contour, since its surface lies behind it.
bool is_clear(const world::Placed& placed, const edges::ClearContour& contour, int triangle);

/// Tests every edge against every triangle that meets it on the page. The result does not depend on the number of
/// threads. Under a time limit, the longest edges come first, and those for which there is no time left stay undecided;
/// OutOfTime is thrown if there is no time for a single one.
HiddenSpans find_hidden(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                        Progress progress = {});

/// Computes the same, to the last bit, without a search for possible occluders: every triangle is tested. For the
/// longest few edges, where the search itself takes too long.
HiddenSpans find_hidden_directly(const world::World& world, const view::ProjectedScene& view,
                                 const edges::FeatureEdges& drawn, Progress progress = {});

/// Removes the undecided edges from both, so that everything drawn is right.
void keep_decided(edges::FeatureEdges& drawn, HiddenSpans& hidden);

/// Returns all edges but the `count` longest ones on the page, ascending.
std::vector<int> all_but_longest(const view::ProjectedScene& view, const std::vector<edges::FeatureEdge>& edges,
                                 std::size_t count);

/// For a wireframe.
HiddenSpans nothing_hidden(const edges::FeatureEdges& drawn);

}  // namespace epura::visibility
