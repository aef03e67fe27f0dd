// SPDX-License-Identifier: Apache-2.0
#include "edges/slivers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "edges/limits.hpp"
#include "view/page_height.hpp"

namespace epura::edges {

namespace {

double length_of(const EdgeSurroundings& around, const std::array<int, 2>& side) {
  return glm::length(around.point(side[1]) - around.point(side[0]));
}

// A strict order of sides.
auto rank(const EdgeSurroundings& around, const std::array<int, 2>& side) {
  return std::tuple(length_of(around, side), side);
}

// Zero on the side, and increasing away from it.
double detour(const EdgeSurroundings& around, const std::array<int, 2>& side, const Vec3& place) {
  const Vec3 a = around.point(side[0]), b = around.point(side[1]);
  return glm::length(place - a) + glm::length(b - place) - glm::length(b - a);
}

// The side of the triangle, other than `entry`, on which `place` lies.
std::array<int, 2> side_at(const EdgeSurroundings& around, const std::array<int, 3>& corners,
                           const std::array<int, 2>& entry, const Vec3& place) {
  std::array<int, 2> best{};
  double min = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const std::array<int, 2> side = side_of(corners[i], corners[(i + 1) % 3]);
    if (side == entry) continue;
    const double way = detour(around, side, place);
    if (way < min) {
      min = way;
      best = side;
    }
  }
  return best;
}

Vec3 middle_of(const EdgeSurroundings& around, const std::array<int, 2>& edge) {
  return (around.point(edge[0]) + around.point(edge[1])) * 0.5;
}

// The other triangle at a side, if there is exactly one.
std::optional<int> other_side(const EdgeSurroundings& around, const std::array<int, 2>& side, int triangle) {
  const mesh::MeshEdge* edge = find_edge(around, side);
  if (edge == nullptr || edge->count != 2) return std::nullopt;
  const auto both = around.mesh().triangles_of(*edge);
  return both[0] == triangle ? both[1] : both[0];
}

// The exit from a triangle that was entered through `entry`: the side on which `place` lies.
Exit exit_at(const EdgeSurroundings& around, const std::array<int, 2>& entry, int triangle, const Vec3& place) {
  const std::array<int, 2> side = side_at(around, around.corners(triangle), entry, place);
  check(side != entry, "a triangle is left through another side");
  return {side, other_side(around, side, triangle)};
}

// Whether both ends of the edge lie on the side, with a tolerance of `slack`.
bool spans(const EdgeSurroundings& around, const std::array<int, 2>& side, const std::array<int, 2>& edge,
           double slack) {
  return std::all_of(edge.begin(), edge.end(), [&](int v) {
    return distance_to_segment(around.point(v), around.point(side[0]), around.point(side[1])) <= slack;
  });
}

double longest_side(const EdgeSurroundings& around, const std::array<int, 3>& corners) {
  const auto& [a, b, c] = corners;
  return std::max({length_of(around, {a, b}), length_of(around, {b, c}), length_of(around, {c, a})});
}

double nearest_w(const view::ProjectedScene& view, const std::array<int, 3>& corners) {
  return std::min(
      {view.clipper.vertices[corners[0]].w, view.clipper.vertices[corners[1]].w, view.clipper.vertices[corners[2]].w});
}

}  // namespace

SliverRule::SliverRule(const EdgeSurroundings& around, const view::ProjectedScene& view)
    : around_(around),
      view_(&view),
      lowest_(std::max(product_rounding, around.world.rounding * view.map.normalisation)),
      on_page_(lowest_on_page * view::page_resolution(around.world, view)) {}

bool SliverRule::holds_for(int triangle) const {
  if (around_.facing_of(triangle) != 0) return false;
  const std::array<int, 3> corners = around_.corners(triangle);
  const double height = height_of(around_, triangle);
  if (height <= lowest_) return true;
  const double w = view_->projection.central ? nearest_w(*view_, corners) : 1;
  return height * view_->map.unit <= edge_on * on_page_ * w && height <= slender * longest_side(around_, corners) &&
         view::height_on_page(*view_, corners) <= on_page_ && !is_of_a_step(triangle);
}

bool SliverRule::is_of_a_step(int triangle) const {
  const double known = known_height * lowest_;
  if (height_of(around_, triangle) <= known) return false;
  const std::array<int, 3> corners = around_.corners(triangle);
  for (int i = 0; i < 3; ++i) {
    const std::array<int, 2> side = side_of(corners[i], corners[(i + 1) % 3]);
    if (length_of(around_, side) <= known) continue;
    const std::optional<int> other = other_side(around_, side, triangle);
    if (other && height_of(around_, *other) > known && fold_angle(around_, side, triangle, *other) >= step_angle)
      return true;
  }
  return false;
}

Slivers::Slivers(const EdgeSurroundings& around, const view::ProjectedScene& view, const Progress& progress)
    : around_(around), is_sliver_(around.mesh().polygon.size()) {
  const SliverRule rule(around, view);
  parallel_for(is_sliver_.size(), grain::light, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) is_sliver_[t] = rule.holds_for(static_cast<int>(t)) ? 1 : 0;
  });
}

Beyond Slivers::across(const std::array<int, 2>& edge, int triangle, std::vector<int>* passed) const {
  const Vec3 middle = middle_of(around_, edge);
  std::array<int, 2> entry = edge;
  double reach = 0;
  for (int step = 0; step < longest_row && contain(triangle); ++step) {
    if (passed != nullptr) passed->push_back(triangle);
    reach += 2 * height_of(around_, triangle);
    const Exit exit = exit_at(around_, entry, triangle, middle);
    if (rank(around_, exit.side) < rank(around_, edge) && (step == 0 || spans(around_, exit.side, edge, reach)))
      return {std::nullopt, true};
    if (!exit.next) return {};
    triangle = *exit.next;
    entry = exit.side;
  }
  return {triangle, false};
}

Exit Slivers::way_out(const std::array<int, 2>& edge, int triangle) const {
  return exit_at(around_, edge, triangle, middle_of(around_, edge));
}

}  // namespace epura::edges
