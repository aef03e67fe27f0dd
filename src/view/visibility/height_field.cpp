// SPDX-License-Identifier: Apache-2.0
#include "visibility/height_field.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/error.hpp"

namespace epura::visibility {

namespace {

// Number of pairs of borders that are examined before the test gives up: some hundredths of a second.
constexpr std::size_t max_border_pairs = 1 << 24;

/// A side with only one triangle, which lies to its left on the page.
struct Border {
  int from, to;  ///< vertices of the view
};

class Sheet {
 public:
  Sheet(const world::World& world, const view::ProjectedScene& view) : world_(world), view_(view) {}

  [[nodiscard]] bool is_one() const {
    if (is_closed() || !world_.wires.empty()) return false;
    const auto borders = find_borders();
    return borders && have_one_outline(*borders) && keep_apart(*borders);
  }

 private:
  [[nodiscard]] std::int64_t area(int a, int b, int c) const {
    return view::cross(view_.grid[a], view_.grid[b], view_.grid[c]);
  }

  // Decided by counting: if no edge has more than two triangles, the surface is closed exactly when there are no more
  // edges than that allows.
  [[nodiscard]] bool is_closed() const {
    std::size_t edges = 0;
    for (const world::Placed& model : world_.models) edges += model.mesh->edges.size();
    return 2 * edges <= 3 * world_.triangles.size();
  }

  [[nodiscard]] int corner_beside(int triangle, int u, int v) const {
    for (const int corner : world_.triangles[triangle])
      if (corner != u && corner != v) return corner;
    return u;
  }

  // Returns nothing if the surface is folded on the page.
  [[nodiscard]] std::optional<std::vector<Border>> find_borders() const {
    std::vector<Border> borders;
    for (int model = 0; model < static_cast<int>(world_.models.size()); ++model)
      for (const mesh::MeshEdge& edge : world_.models[model].mesh->edges) {
        const auto triangles = world_.models[model].mesh->triangles_of(edge);
        const int u = world_.first_vertex[model] + edge.vertex[0];
        const int v = world_.first_vertex[model] + edge.vertex[1];
        check(u < v, "an edge leads from its lower vertex to the higher one");
        const auto side_of = [&](int t) { return area(u, v, corner_beside(world_.first_triangle[model] + t, u, v)); };
        const std::int64_t side = side_of(triangles[0]);
        if (side == 0 || triangles.size() > 2) return std::nullopt;
        if (triangles.size() == 1) {
          borders.push_back(side > 0 ? Border{u, v} : Border{v, u});
        } else {
          const std::int64_t other = side_of(triangles[1]);
          if (other == 0 || (side > 0) == (other > 0)) return std::nullopt;
        }
      }
    if (borders.empty()) return std::nullopt;
    return borders;
  }

  // Whether two borders have a common place other than the end of one at which the other begins.
  [[nodiscard]] bool meet(const Border& a, const Border& b) const {
    const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
    const int a_from = sign(area(b.from, b.to, a.from)), a_to = sign(area(b.from, b.to, a.to));
    const int b_from = sign(area(a.from, a.to, b.from)), b_to = sign(area(a.from, a.to, b.to));
    if (a.to == b.from || b.to == a.from) return a_from == 0 && a_to == 0 && folds_back(a, b);
    return a_from * a_to <= 0 && b_from * b_to <= 0;
  }

  // For borders on one line.
  [[nodiscard]] bool folds_back(const Border& a, const Border& b) const {
    const auto direction = [&](const Border& border) {
      const view::GridPoint& p = view_.grid[border.from];
      const view::GridPoint& q = view_.grid[border.to];
      return std::array{std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y};
    };
    const auto one = direction(a), two = direction(b);
    return one[0] * two[0] + one[1] * two[1] < 0;
  }

  // Sweeps over their boxes from left to right.
  [[nodiscard]] bool keep_apart(std::vector<Border> borders) const {
    const auto span = [&](const Border& b, std::int32_t view::GridPoint::*axis) {
      return std::minmax(view_.grid[b.from].*axis, view_.grid[b.to].*axis);
    };
    std::sort(borders.begin(), borders.end(), [&](const Border& a, const Border& b) {
      return std::pair(span(a, &view::GridPoint::x).first, a.from) <
             std::pair(span(b, &view::GridPoint::x).first, b.from);
    });
    std::vector<Border> open;
    std::size_t pairs = 0;
    for (const Border& border : borders) {
      const auto x = span(border, &view::GridPoint::x), y = span(border, &view::GridPoint::y);
      std::erase_if(open, [&](const Border& other) { return span(other, &view::GridPoint::x).second < x.first; });
      check(open.empty() || span(open.back(), &view::GridPoint::x).first <= x.first,
            "borders are met from left to right");
      pairs += open.size();
      if (pairs > max_border_pairs) return false;
      for (const Border& other : open) {
        const auto other_y = span(other, &view::GridPoint::y);
        if (other_y.first <= y.second && y.first <= other_y.second && meet(border, other)) return false;
      }
      open.push_back(border);
    }
    return true;
  }

  // Follows the borders. Exactly one starts at each corner and one ends there: with more, the line would not be simple.
  [[nodiscard]] bool have_one_outline(const std::vector<Border>& borders) const {
    std::unordered_map<int, int> next;
    for (const Border& border : borders)
      if (!next.emplace(border.from, border.to).second) return false;
    int outlines = 0;
    for (const Border& border : borders) {
      std::vector<int> line;
      for (auto at = next.find(border.from); at != next.end(); at = next.find(line.back())) {
        line.push_back(at->second);
        next.erase(at);
      }
      if (line.empty()) continue;
      if (line.back() != border.from) return false;
      outlines += runs_left(line) ? 1 : 0;
    }
    check(next.empty(), "every border is on one line");
    return outlines == 1;
  }

  // Whether a simple closed line has its inside on its left. This is the sign of its area, summed in two halves since
  // 64 bits may not hold it.
  [[nodiscard]] bool runs_left(const std::vector<int>& line) const {
    std::int64_t high = 0, low = 0;
    for (std::size_t i = 2; i < line.size(); ++i) {
      const std::int64_t part = area(line[0], line[i - 1], line[i]);
      high += part >> 32;
      low += part & 0xffffffff;
    }
    high += low >> 32;
    return high > 0 || (high == 0 && (low & 0xffffffff) != 0);
  }

  const world::World& world_;
  const view::ProjectedScene& view_;
};

}  // namespace

bool is_height_field(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn) {
  if (!view.triangle_planes.empty() || !view.edge_planes.empty() || !drawn.crossings.empty()) return false;
  return Sheet(world, view).is_one();
}

}  // namespace epura::visibility
