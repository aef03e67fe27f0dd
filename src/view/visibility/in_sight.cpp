// SPDX-License-Identifier: Apache-2.0
#include "visibility/in_sight.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/visibility.hpp"

namespace epura::visibility {

std::vector<int> longest_first(const view::ProjectedScene& view, const std::vector<edges::FeatureEdge>& edges) {
  std::vector<int> order(edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> length(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const view::PageVertex& p = view.vertices[edges[e].vertex[0]];
    const view::PageVertex& q = view.vertices[edges[e].vertex[1]];
    length[e] = std::hypot(q.x - p.x, q.y - p.y);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return length[a] > length[b]; });
  return order;
}

namespace {

// All numbers below `count` but those.
std::vector<int> all_but(std::span<const int> numbers, std::size_t count) {
  std::vector<char> is_left(count, 1);
  for (const int e : numbers) is_left[static_cast<std::size_t>(e)] = 0;
  std::vector<int> left;
  for (std::size_t e = 0; e < count; ++e)
    if (is_left[e] != 0) left.push_back(static_cast<int>(e));
  check(left.size() + numbers.size() == count, "all edges but some are left");
  return left;
}

/// Edges by the positions of their middles on the page, from the left.
class Middles {
 public:
  Middles(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
          std::span<const int> asked)
      : view_(view), order_(asked.size()), hidden_(asked.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto middle = [&](std::size_t i) {
      const auto& [p, q] = drawn.edges[static_cast<std::size_t>(asked[i])].vertex;
      return (view.vertices[p].at() + view.vertices[q].at()) * 0.5;
    };
    std::ranges::sort(order_, {}, [&](std::size_t i) { return std::pair(middle(i).x, i); });
    for (const std::size_t i : order_) {
      const edges::FeatureEdge& edge = drawn.edges[static_cast<std::size_t>(asked[i])];
      x_.push_back(middle(i).x);
      y_.push_back(middle(i).y);
      lines_.push_back({edge.vertex[0], edge.vertex[1]});
      own_.emplace_back(world, drawn, edge);
    }
  }

  /// May be called from any thread.
  void hide_behind(const view::ViewTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertex;
    const auto& [p, q, r] = std::tie(view_.vertices[a], view_.vertices[b], view_.vertices[c]);
    const auto [left, right] = std::minmax({p.x, q.x, r.x});
    const auto begin = std::ranges::lower_bound(x_, left);
    if (begin == x_.end() || *begin > right || view::cross(view_.grid[a], view_.grid[b], view_.grid[c]) == 0) return;
    const auto [low, high] = std::minmax({p.y, q.y, r.y});
    for (auto i = static_cast<std::size_t>(begin - x_.begin()); i < x_.size() && x_[i] <= right; ++i) {
      if (y_[i] < low || y_[i] > high || hidden_[i] != 0 || own_[i].contain(triangle.source)) continue;
      const auto part = hidden_part(view_, lines_[i], triangle);
      if (part && (*part)[0] <= 0.5 && (*part)[1] >= 0.5) hidden_[i] = 1;
    }
  }

  /// Of each edge that was asked for.
  [[nodiscard]] std::vector<char> hidden() const {
    std::vector<char> all(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) all[order_[i]] = hidden_[i];
    return all;
  }

 private:
  const view::ProjectedScene& view_;
  std::vector<std::size_t> order_;
  std::vector<double> x_, y_;
  std::vector<PageEdge> lines_;
  std::vector<OwnTriangles> own_;
  std::vector<std::atomic<char>> hidden_;
};

std::vector<char> have_hidden_middles(const world::World& world, const view::ProjectedScene& view,
                                      const edges::FeatureEdges& drawn, std::span<const int> asked) {
  Middles middles(world, view, drawn, asked);
  parallel_for(view.triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) middles.hide_behind(view.triangles[t]);
  });
  return middles.hidden();
}

}  // namespace

std::vector<int> all_but_longest_in_sight(const world::World& world, const view::ProjectedScene& view,
                                          const edges::FeatureEdges& drawn, std::size_t count, Progress progress) {
  constexpr std::size_t at_once = 4096;  // edges whose middles are tested together
  const std::vector<int> order = longest_first(view, drawn.edges);
  std::vector<int> chosen;
  for (std::size_t begin = 0; begin < order.size() && chosen.size() < count; begin += at_once) {
    if (begin > 0 && progress.is_out_of_time()) break;
    const std::span<const int> asked = std::span(order).subspan(begin, std::min(at_once, order.size() - begin));
    const std::vector<char> hidden = have_hidden_middles(world, view, drawn, asked);
    for (std::size_t i = 0; i < asked.size() && chosen.size() < count; ++i)
      if (hidden[i] == 0) chosen.push_back(asked[i]);
  }
  if (chosen.empty())
    chosen.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size())));
  return all_but(chosen, drawn.edges.size());
}

}  // namespace epura::visibility
