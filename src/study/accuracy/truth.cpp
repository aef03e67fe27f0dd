// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/truth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <unordered_map>

#include "base/parallel.hpp"
#include "explain/hiders.hpp"
#include "study/accuracy/exact_page.hpp"
#include "study/accuracy/span_sets.hpp"

namespace epura {

namespace {

// Parts of the drawing: to this every place on the page is guaranteed (docs/numerics.md) ...
constexpr double sideways = 1e-9;
// ... and what the view's own doubles place farther beside an edge than this is not looked at.
constexpr double surely_beside = 1e-8;
constexpr std::size_t batch = 256;

struct Range {
  Exact from = 0, to = 1;

  // Leaves the part where a function that is linear between its values at 0 and 1 is not negative.
  void keep(const Exact& at_0, const Exact& at_1) {
    if (at_0 < 0 && at_1 < 0) to = from;
    if (at_0 >= 0 && at_1 >= 0) return;
    if (at_0 == at_1) return;
    const Exact root = at_0 / (at_0 - at_1);
    if (at_0 < 0)
      from = std::max(from, root);
    else
      to = std::min(to, root);
  }
};

double distance(const ExactPoint& a, const ExactPoint& b) {
  return std::hypot(Exact(b.x - a.x).get_d(), Exact(b.y - a.y).get_d());
}

/// A convex polygon of the page with its depth: z + slope . (p - corner).
struct Face {
  std::vector<ExactPoint> corner;
  std::vector<bool> border;  ///< of the side from corner i on
  int turn = 0;              ///< 1: counterclockwise; 0: a line
  Exact slope_x, slope_y;

  [[nodiscard]] Exact depth(const ExactPoint& p) const {
    return corner[0].depth + slope_x * (p.x - corner[0].x) + slope_y * (p.y - corner[0].y);
  }
  [[nodiscard]] double steepness() const { return 1 + std::hypot(slope_x.get_d(), slope_y.get_d()); }
};

Face face_from(std::vector<ExactPoint> corners) {
  Face face{std::move(corners), {}, 0, 0, 0};
  const auto& c = face.corner;
  Exact largest = 0;
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const Exact area = cross(c[0], c[i], c[i + 1]);
    if (abs(area) <= abs(largest)) continue;
    largest = area;
    const Exact bz = c[i].depth - c[0].depth, cz = c[i + 1].depth - c[0].depth;
    face.slope_x = (bz * (c[i + 1].y - c[0].y) - cz * (c[i].y - c[0].y)) / area;
    face.slope_y = (cz * (c[i].x - c[0].x) - bz * (c[i + 1].x - c[0].x)) / area;
  }
  face.turn = sgn(largest);
  face.border.assign(c.size(), true);
  return face;
}

struct Line {
  ExactPoint p, q;
};

// The part of the line that a face hides. Its borders move inwards by `inwards`, and it lies at least `ahead` times its
// steepness before the line.
std::optional<std::array<double, 2>> hidden_part(const Face& face, const Line& line, double inwards, double ahead) {
  Range range;
  for (std::size_t i = 0; i < face.corner.size(); ++i) {
    const ExactPoint& a = face.corner[i];
    const ExactPoint& b = face.corner[(i + 1) % face.corner.size()];
    const Exact margin(face.border[i] || inwards < 0 ? inwards * distance(a, b) : 0);
    range.keep(cross(a, b, line.p) * face.turn - margin, cross(a, b, line.q) * face.turn - margin);
  }
  const Exact margin(ahead * face.steepness());
  range.keep(face.depth(line.p) - line.p.depth - margin, face.depth(line.q) - line.q.depth - margin);
  if (range.from >= range.to) return std::nullopt;
  return std::array{range.from.get_d(), range.to.get_d()};
}

// Where the line runs along a face that is a line itself, within `margin`: whether that covers it is a matter of
// definition.
std::optional<std::array<double, 2>> part_along(const Face& face, const Line& line, double margin) {
  std::size_t longest = 0;
  const auto end = [&](std::size_t i) -> const ExactPoint& { return face.corner[(i + 1) % face.corner.size()]; };
  for (std::size_t i = 1; i < face.corner.size(); ++i)
    if (distance(face.corner[i], end(i)) > distance(face.corner[longest], end(longest))) longest = i;
  const ExactPoint& a = face.corner[longest];
  const ExactPoint& b = end(longest);
  const double length = distance(a, b);
  for (const ExactPoint& c : face.corner)
    if (std::abs(cross(a, b, c).get_d()) > margin * length) return std::nullopt;
  Range range;
  const Exact wide(2 * margin * length);
  for (const int sign : {1, -1}) range.keep(cross(a, b, line.p) * sign + wide, cross(a, b, line.q) * sign + wide);
  const auto along = [&](const ExactPoint& c) { return Exact((b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y)); };
  const Exact whole = along(b);
  range.keep(along(line.p) + wide, along(line.q) + wide);
  range.keep(whole - along(line.p) + wide, whole - along(line.q) + wide);
  if (range.from >= range.to) return std::nullopt;
  return std::array{range.from.get_d(), range.to.get_d()};
}

std::uint64_t side_key(int a, int b) {
  const auto [first, second] = std::minmax(a, b);
  return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 | static_cast<std::uint32_t>(second);
}

class Judge {
 public:
  Judge(const VerifyInput& claim, const ProjectedScene& view)
      : claim_(claim), view_(view), page_(claim, view), boxes_(view) {
    const auto& triangles = claim.world.triangles;
    sides_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        sides_.emplace(side_key(triangles[t][i], triangles[t][(i + 1) % 3]), static_cast<int>(t));
  }

  [[nodiscard]] EdgeTruth truth_of(int e, std::atomic<std::size_t>& pairs) const {
    const FeatureEdge& edge = claim_.drawn.edges[e];
    const std::array<Vec3, 2> ends = claim_.ends_of(edge);
    const Line line{page_.position(position_on<Exact>(ends, edge.t[0])),
                    page_.position(position_on<Exact>(ends, edge.t[1]))};
    const double extent = view_.extent;
    EdgeTruth truth{e, {}, {}};
    for (const int triangle : near(edge)) {
      ++pairs;
      Face face = face_from(page_.position(corners_of(triangle)));
      if (face.corner.empty()) continue;
      if (const auto part = part_along(face, line, sideways * extent)) add_span(truth.perhaps, *part);
      const auto perhaps = face.turn == 0 ? std::nullopt : hidden_part(face, line, -sideways * extent, 0);
      if (!perhaps) continue;
      add_span(truth.perhaps, *perhaps);
      find_borders(edge, triangle, face);
      const auto surely = hidden_part(face, line, sideways * extent, 2 * view_.contact.touching);
      if (surely) add_span(truth.surely, *surely);
    }
    for (const auto& span : truth.surely) add_span(truth.perhaps, span);
    return truth;
  }

 private:
  // Triangles of the world that are none of the edge's own and may lie before it.
  [[nodiscard]] std::vector<int> near(const FeatureEdge& edge) const {
    const PageVertex& p = view_.vertices[edge.vertex[0]];
    const PageVertex& q = view_.vertices[edge.vertex[1]];
    const Vec2 margin(surely_beside * view_.extent);
    const Window box{glm::min(Vec2(p.x, p.y), Vec2(q.x, q.y)) - margin,
                     glm::max(Vec2(p.x, p.y), Vec2(q.x, q.y)) + margin};
    std::vector<int> found;
    boxes_.meeting(box, [&](int t) {
      const ViewTriangle& triangle = view_.triangles[t];
      if (may_hide(triangle, p, q) && !claim_.contains(edge, triangle.source)) found.push_back(triangle.source);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  [[nodiscard]] bool may_hide(const ViewTriangle& triangle, const PageVertex& p, const PageVertex& q) const {
    const Vec2 along(q.x - p.x, q.y - p.y);
    const double beside = surely_beside * view_.extent * glm::length(along);
    const double behind = std::min(p.depth, q.depth);
    const double slack = surely_beside * (view_.extent + std::abs(behind));
    int left = 0, right = 0, back = 0;
    for (const int v : triangle.vertex) {
      const PageVertex& c = view_.vertices[v];
      const double turn = along.x * (c.y - p.y) - along.y * (c.x - p.x);
      left += turn > beside ? 1 : 0;
      right += turn < -beside ? 1 : 0;
      back += c.depth < behind - slack ? 1 : 0;
    }
    return left < 3 && right < 3 && back < 3;
  }

  [[nodiscard]] std::array<Vec3, 3> corners_of(int triangle) const {
    const auto& [a, b, c] = claim_.world.triangles[triangle];
    return {claim_.world.points[a], claim_.world.points[b], claim_.world.points[c]};
  }

  void find_borders(const FeatureEdge& edge, int triangle, Face& face) const {
    if (face.corner.size() != 3) return;
    for (std::size_t i = 0; i < 3; ++i) face.border[i] = is_border(edge, triangle, i, face);
  }

  // Whether no other triangle goes on behind a side.
  [[nodiscard]] bool is_border(const FeatureEdge& edge, int triangle, std::size_t side, const Face& face) const {
    const auto& corner = claim_.world.triangles[triangle];
    const int a = corner[side], b = corner[(side + 1) % 3];
    const auto [begin, end] = sides_.equal_range(side_key(a, b));
    return std::none_of(begin, end, [&](const auto& found) {
      const int other = found.second;
      if (other == triangle || claim_.contains(edge, other)) return false;
      const auto& c = claim_.world.triangles[other];
      const auto apex = std::find_if(c.begin(), c.end(), [&](int v) { return v != a && v != b; });
      if (apex == c.end()) return false;
      const Face beyond = face_from(page_.position(corners_of(other)));
      if (beyond.corner.size() != 3) return false;
      return sgn(cross(face.corner[side], face.corner[(side + 1) % 3],
                       page_.position(triple<Exact>(claim_.world.points[*apex])))) *
                 face.turn <
             0;
    });
  }

  const VerifyInput& claim_;
  const ProjectedScene& view_;
  ExactPage page_;
  TriangleBoxes boxes_;
  std::unordered_multimap<std::uint64_t, int> sides_;
};

// Fisher and Yates with a generator that is the same everywhere.
std::vector<int> random_order(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(1);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

}  // namespace

std::vector<EdgeTruth> find_truth(const VerifyInput& claim, const ProjectedScene& view, const TruthEffort& effort) {
  const Judge judge(claim, view);
  const std::vector<int> order = random_order(claim.drawn.edges.size());
  std::vector<EdgeTruth> truths;
  std::atomic<std::size_t> pairs = 0;
  while (truths.size() < order.size() && static_cast<double>(pairs) < effort.pairs) {
    const std::size_t begin = truths.size();
    truths.resize(std::min(begin + batch, order.size()));
    parallel_for(truths.size() - begin, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i) truths[i] = judge.truth_of(order[i], pairs);
    });
  }
  std::sort(truths.begin(), truths.end(), [](const EdgeTruth& a, const EdgeTruth& b) { return a.edge < b.edge; });
  return truths;
}

Spans nearest_right(const Spans& shown, const EdgeTruth& truth) {
  return united(common(shown, truth.perhaps), truth.surely);
}

}  // namespace epura
