#include "visibility/hiding_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace epura {

namespace {

// Where the edge p, q crosses a side of a triangle.
struct Crossing {
  double t;      // on the edge
  double depth;  // of the side there
  bool rounded;  // t is only as good as the grid
};

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

Vec2 place(const PageVertex& v) { return {v.x, v.y}; }

// The crossing with the side a, b. On the grid it is decided (0 before the edge's start, 2 behind its end, 1 between),
// in double coordinates it is placed: both agree but for lines that are parallel within the grid.
Crossing cross_side(const View& view, const Sightline& edge, int a, int b) {
  const int u = std::min(a, b);
  const int v = std::max(a, b);
  const GridPoint& gp = view.grid[edge.p];
  const GridPoint& gq = view.grid[edge.q];
  const GridPoint& gu = view.grid[u];
  const GridPoint& gv = view.grid[v];
  const std::int64_t dx = std::int64_t{gq.x} - gp.x, dy = std::int64_t{gq.y} - gp.y;
  const std::int64_t gx = std::int64_t{gv.x} - gu.x, gy = std::int64_t{gv.y} - gu.y;
  const std::int64_t ox = std::int64_t{gu.x} - gp.x, oy = std::int64_t{gu.y} - gp.y;
  std::int64_t denominator = dx * gy - dy * gx;
  std::int64_t numerator = ox * gy - oy * gx;
  if (denominator < 0) {
    denominator = -denominator;
    numerator = -numerator;
  }
  const double on_grid = static_cast<double>(numerator) / static_cast<double>(denominator);

  const PageVertex& pu = view.vertices[u];
  const PageVertex& pv = view.vertices[v];
  const Vec2 along = place(view.vertices[edge.q]) - place(view.vertices[edge.p]);
  const Vec2 side = place(pv) - place(pu);
  const Vec2 offset = place(pu) - place(view.vertices[edge.p]);
  const double product = cross(along, side);
  double t = cross(offset, side) / product;
  double s = cross(offset, along) / product;

  // Both ends of both lines were moved by at most a cell.
  const double reach = static_cast<double>(std::abs(gx) + std::abs(gy)) / static_cast<double>(denominator);
  const bool rounded = !(std::abs(t - on_grid) <= 4 * reach) || !(s >= 0 && s <= 1);
  if (rounded) {
    t = on_grid;
    const std::int64_t from = ox * dy - oy * dx;
    s = std::clamp(std::abs(static_cast<double>(from)) / static_cast<double>(denominator), 0.0, 1.0);
  }
  if (numerator <= 0)
    t = std::min(t, 0.0);
  else if (numerator >= denominator)
    t = std::max(t, 1.0);
  else
    t = std::clamp(t, 0.0, 1.0);
  return {t, pu.depth + s * (pv.depth - pu.depth), rounded};
}

// The part of [from, to] where a difference that runs linearly exceeds the tolerance.
std::optional<std::array<double, 2>> exceeding(double from, double to, double at_from, double at_to, double tolerance) {
  const double over_from = at_from - tolerance;
  const double over_to = at_to - tolerance;
  if (!(over_from > 0) && !(over_to > 0)) return std::nullopt;
  if (over_from > 0 && over_to > 0) return std::array{from, to};
  const double root = std::clamp(from + (to - from) * (over_from / (over_from - over_to)), from, to);
  return over_from > 0 ? std::array{from, root} : std::array{root, to};
}

}  // namespace

std::optional<std::array<double, 2>> hidden_part(const View& view, const Sightline& edge, const Occluder& triangle,
                                                 const Contact& contact) {
  std::array<bool, 3> left{};
  for (int i = 0; i < 3; ++i)
    left[i] = epura::cross(view.grid[edge.p], view.grid[edge.q], view.grid[triangle.vertex[i]]) >= 0;
  if (left[0] == left[1] && left[1] == left[2]) return std::nullopt;

  std::array<Crossing, 2> in_out{};
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (left[i] != left[j]) in_out[count++] = cross_side(view, edge, triangle.vertex[i], triangle.vertex[j]);
  }
  if (in_out[0].t > in_out[1].t) std::swap(in_out[0], in_out[1]);
  const auto& [in, out] = in_out;
  const double from = std::max(in.t, 0.0);
  const double to = std::min(out.t, 1.0);
  if (!(from < to)) return std::nullopt;

  const auto& own = triangle.vertex;
  const bool holds_p = std::find(own.begin(), own.end(), edge.p) != own.end();
  const bool holds_q = std::find(own.begin(), own.end(), edge.q) != own.end();
  const PageVertex& p = view.vertices[edge.p];
  const PageVertex& q = view.vertices[edge.q];
  const auto in_front = [&](double t) {
    const double of_triangle = in.depth + (out.depth - in.depth) * ((t - in.t) / (out.t - in.t));
    return of_triangle - (p.depth + t * (q.depth - p.depth));
  };
  if (!holds_p && !holds_q)
    return exceeding(from, to, in_front(from), in_front(to), contact.touching * triangle.steepness);

  // At a common corner the difference is zero by definition; the other end decides for the whole.
  const double rounding = in.rounded || out.rounded ? contact.touching : contact.joined;
  const bool hides = in_front(holds_p ? to : from) > rounding * triangle.steepness;
  return hides ? std::optional(std::array{from, to}) : std::nullopt;
}

}  // namespace epura
