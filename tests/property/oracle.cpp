// SPDX-License-Identifier: Apache-2.0
#include "oracle.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace epura::test {
namespace {

using Number = mpq_class;
using Spans = std::vector<std::array<double, 2>>;

struct ExactPoint {
  Number x, y, z;
};

ExactPoint map_exactly(const Mat4& m, const Vec3& p) {
  std::array<Number, 4> h;
  for (int row = 0; row < 4; ++row)
    h[row] = Number(m[0][row]) * Number(p.x) + Number(m[1][row]) * Number(p.y) + Number(m[2][row]) * Number(p.z) +
             Number(m[3][row]);
  return {h[0] / h[3], h[1] / h[3], h[2] / h[3]};
}

Number cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance(const ExactPoint& a, const ExactPoint& b) {
  const Number dx = a.x - b.x, dy = a.y - b.y;
  return std::hypot(dx.get_d(), dy.get_d());
}

// Where a linear function with the given values at t = 0 and t = 1 is positive, cut from [from, to].
void keep_positive(const Number& at0, const Number& at1, Number& from, Number& to) {
  if (at0 <= 0 && at1 <= 0) {
    to = from;
    return;
  }
  if (at0 > 0 && at1 > 0) return;
  const Number root = at0 / (at0 - at1);
  if (at0 <= 0)
    from = std::max(from, root);
  else
    to = std::min(to, root);
}

struct Margins {
  double plane;    // how far inside the triangle on the page
  double contact;  // how far in front, times the steepness of the triangle
};

// The part of the edge that one triangle hides with these margins.
std::optional<std::array<double, 2>> hidden_part(const std::array<ExactPoint, 3>& triangle, const ExactPoint& p,
                                                 const ExactPoint& q, const Margins& margins) {
  const Number area = cross(triangle[0], triangle[1], triangle[2]);
  if (area == 0) return std::nullopt;
  const int sign = area > 0 ? 1 : -1;
  Number from = 0, to = 1;
  Number depth_p = 0, depth_q = 0;
  double gradient_x = 0, gradient_y = 0;
  for (int i = 0; i < 3; ++i) {
    const ExactPoint& a = triangle[i];
    const ExactPoint& b = triangle[(i + 1) % 3];
    const ExactPoint& opposite = triangle[(i + 2) % 3];
    const Number at_p = cross(a, b, p), at_q = cross(a, b, q);
    const Number margin(margins.plane * distance(a, b));
    keep_positive(at_p * sign - margin, at_q * sign - margin, from, to);
    // Barycentric: the plane's depth over p and q.
    depth_p += at_p / area * opposite.z;
    depth_q += at_q / area * opposite.z;
    gradient_x += Number((a.y - b.y) / area * opposite.z).get_d();
    gradient_y += Number((b.x - a.x) / area * opposite.z).get_d();
  }
  const Number front(margins.contact * (1 + std::hypot(gradient_x, gradient_y)));
  keep_positive(depth_p - p.z - front, depth_q - q.z - front, from, to);
  if (from >= to) return std::nullopt;
  return std::array{from.get_d(), to.get_d()};
}

// The part of the edge that runs along a triangle seen edge-on, within a margin: whether it counts as covered is a
// matter of definition, since the triangle's own sides are drawn at the same place.
std::optional<std::array<double, 2>> along_part(const std::array<ExactPoint, 3>& triangle, const ExactPoint& p,
                                                const ExactPoint& q, double margin) {
  int i = 0;
  for (int k = 1; k < 3; ++k)
    if (distance(triangle[k], triangle[(k + 1) % 3]) > distance(triangle[i], triangle[(i + 1) % 3])) i = k;
  const ExactPoint& a = triangle[i];
  const ExactPoint& b = triangle[(i + 1) % 3];
  const double length = distance(a, b);
  if (abs(cross(a, b, triangle[(i + 2) % 3])) > Number(margin * length)) return std::nullopt;
  Number from = 0, to = 1;
  const Number wide(2 * margin * length);
  for (const int sign : {1, -1}) keep_positive(cross(a, b, p) * sign + wide, cross(a, b, q) * sign + wide, from, to);
  const auto along = [&](const ExactPoint& c) { return Number((b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y)); };
  const Number whole = along(b);
  keep_positive(along(p) + wide, along(q) + wide, from, to);
  keep_positive(whole - along(p) + wide, whole - along(q) + wide, from, to);
  if (from >= to) return std::nullopt;
  return std::array{from.get_d(), to.get_d()};
}

Spans unite(Spans spans) {
  std::sort(spans.begin(), spans.end());
  Spans united;
  for (const auto& span : spans) {
    if (!united.empty() && span[0] <= united.back()[1])
      united.back()[1] = std::max(united.back()[1], span[1]);
    else
      united.push_back(span);
  }
  return united;
}

// What of `a` is not in `b`.
Spans without(const Spans& a, const Spans& b) {
  Spans rest;
  for (const auto& span : a) {
    double from = span[0];
    for (const auto& cut : b) {
      if (cut[1] <= from || cut[0] >= span[1]) continue;
      if (cut[0] > from) rest.push_back({from, cut[0]});
      from = std::max(from, cut[1]);
    }
    if (from < span[1]) rest.push_back({from, span[1]});
  }
  return rest;
}

double length_of(const Spans& spans) {
  double sum = 0;
  for (const auto& span : spans) sum += span[1] - span[0];
  return sum;
}

// Plainly beside the edge on the page: decided in doubles, far beyond their rounding.
bool is_beside(const std::array<ExactPoint, 3>& triangle, const ExactPoint& p, const ExactPoint& q, double margin) {
  const auto apart = [&](auto coordinate) {
    const double a = coordinate(triangle[0]), b = coordinate(triangle[1]), c = coordinate(triangle[2]);
    const double d = coordinate(p), e = coordinate(q);
    return std::max({a, b, c}) < std::min(d, e) - margin || std::min({a, b, c}) > std::max(d, e) + margin;
  };
  return apart([](const ExactPoint& point) { return point.x.get_d(); }) ||
         apart([](const ExactPoint& point) { return point.y.get_d(); });
}

bool is_own(const Result& r, const FeatureEdge& edge, int triangle) {
  if (edge.crossing >= 0) {
    const auto& pair = r.drawn.crossings[edge.crossing].triangles;
    return triangle == pair[0] || triangle == pair[1];
  }
  const auto& ends = r.world.models[edge.model].mesh->edges[edge.mesh_edge].vertex;
  const int first = r.world.first_vertex[edge.model];
  int common = 0;
  for (const int v : r.world.triangles[triangle]) common += v == first + ends[0] || v == first + ends[1] ? 1 : 0;
  return common == 2;
}

void count_wrong(Verdict& verdict, const Spans& wrong, double length, const char* what, std::size_t edge) {
  for (const auto& span : wrong) {
    const double size = (span[1] - span[0]) * length;
    verdict.wrong += size;
    if (size <= verdict.longest_wrong) continue;
    verdict.longest_wrong = size;
    std::ostringstream words;
    words << what << ' ' << edge << " from " << span[0] << " to " << span[1];
    verdict.worst = words.str();
  }
}

}  // namespace

Verdict judge(const Result& r) {
  std::vector<ExactPoint> points;
  for (const Vec3& p : r.world.points) points.push_back(map_exactly(r.drawing.world_to_page, p));
  const double extent = r.view.extent;
  const double contact = r.view.contact.touching;
  const Margins eroded{1e-9 * extent, 2 * contact};
  const Margins dilated{-1e-9 * extent, 0};

  Verdict verdict;
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e) {
    const FeatureEdge& edge = r.drawn.edges[e];
    ExactPoint p, q;
    if (edge.crossing >= 0) {
      p = map_exactly(r.drawing.world_to_page, r.drawn.crossings[edge.crossing].ends[0]);
      q = map_exactly(r.drawing.world_to_page, r.drawn.crossings[edge.crossing].ends[1]);
    } else {
      p = points[edge.vertex[0]];
      q = points[edge.vertex[1]];
    }
    Spans surely, perhaps;
    for (std::size_t t = 0; t < r.world.triangles.size(); ++t) {
      if (is_own(r, edge, static_cast<int>(t))) continue;
      const auto& c = r.world.triangles[t];
      const std::array<ExactPoint, 3> triangle{points[c[0]], points[c[1]], points[c[2]]};
      if (is_beside(triangle, p, q, 1e-6 * extent)) continue;
      if (const auto part = hidden_part(triangle, p, q, eroded)) surely.push_back(*part);
      if (const auto part = hidden_part(triangle, p, q, dilated)) perhaps.push_back(*part);
      if (const auto part = along_part(triangle, p, q, 1e-9 * extent)) perhaps.push_back(*part);
    }
    surely = unite(surely);
    perhaps = unite(perhaps);
    const Spans shown(r.hidden.spans.begin() + r.hidden.first[e], r.hidden.spans.begin() + r.hidden.first[e + 1]);
    const double length = distance(p, q) / extent;
    count_wrong(verdict, without(surely, shown), length, "hidden but shown visible, edge", e);
    count_wrong(verdict, without(shown, perhaps), length, "visible but shown hidden, edge", e);
    verdict.undecided += length_of(without(perhaps, surely)) * length;
    verdict.judged += length;
  }
  return verdict;
}

PointTruth truth_of_point(const std::array<PageVertex, 3>& triangle, const std::array<PageVertex, 2>& edge, double s) {
  const auto exact = [](const PageVertex& v) { return ExactPoint{Number(v.x), Number(v.y), Number(v.depth)}; };
  const ExactPoint p = exact(edge[0]), q = exact(edge[1]);
  const Number part(s);
  const ExactPoint point{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), p.z + part * (q.z - p.z)};
  const std::array<ExactPoint, 3> corners{exact(triangle[0]), exact(triangle[1]), exact(triangle[2])};
  const Number area = cross(corners[0], corners[1], corners[2]);
  double inside = HUGE_VAL;
  Number ahead = -point.z, slope_x = 0, slope_y = 0;
  for (int i = 0; i < 3; ++i) {
    const ExactPoint& a = corners[i];
    const ExactPoint& b = corners[(i + 1) % 3];
    const Number& opposite = corners[(i + 2) % 3].z;
    const Number turn = cross(a, b, point);
    inside = std::min(inside, turn.get_d() * sgn(area) / distance(a, b));
    ahead += turn / area * opposite;
    slope_x += (a.y - b.y) / area * opposite;
    slope_y += (b.x - a.x) / area * opposite;
  }
  return {inside, ahead.get_d(), 1 + std::hypot(slope_x.get_d(), slope_y.get_d())};
}

}  // namespace epura::test
