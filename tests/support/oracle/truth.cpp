// SPDX-License-Identifier: Apache-2.0
#include "oracle/truth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <unordered_map>

#include "base/parallel.hpp"
#include "oracle/span_sets.hpp"
#include "search/bounds_tree.hpp"
#include "verify/polygon.hpp"

namespace epura {

namespace {

// As fractions of the drawing: the guaranteed precision of positions on the page (docs/numerics.md) ...
constexpr double sideways = 1e-9;
// ... and the distance from an edge, in doubles, beyond which objects are not examined.
constexpr double surely_beside = 1e-8;
constexpr std::size_t batch = 256, grain = 256;
// The visible region begins at this fraction of the scene's distance in front of the viewer.
constexpr double nearest_seen = 0x1p-44;

/// Depth grows towards the viewer. Origin and unit (about that of the view) are rounded, but the same for all points.
struct ExactPoint {
  verify::Exact x, y, depth;
};

// Twice the signed area of a, b, c.
verify::Exact cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

verify::Triple<verify::Exact> along_projectors(const verify::Triple<verify::Exact>& axis,
                                               const verify::Triple<verify::Exact>& n,
                                               const verify::Triple<verify::Exact>& direction) {
  return verify::along<verify::Exact>(axis, verify::Exact(-verify::dot(axis, direction) / verify::dot(n, direction)),
                                      n);
}

/// The page in rational numbers: corners of triangles and edges mapped to it without rounding.
class ExactPage {
 public:
  ExactPage(const verify::VerifyInput& input, const view::ProjectedScene& view);

  /// A point in front of the viewer.
  [[nodiscard]] ExactPoint place(const verify::Triple<verify::Exact>& point) const;
  /// The part of a triangle in front of the viewer and between the depth limits: its corners in order, possibly none.
  [[nodiscard]] std::vector<ExactPoint> place(const std::array<Vec3, 3>& corners) const;

 private:
  [[nodiscard]] verify::Polygon<verify::Exact> clipped(const std::array<Vec3, 3>& corners) const;

  verify::Viewing viewing_;
  verify::Triple<verify::Exact> point_, n_, u_, v_;
  std::optional<verify::Triple<verify::Exact>> centre_;
  verify::Exact page_, depth_, nearest_;
};

ExactPage::ExactPage(const verify::VerifyInput& input, const view::ProjectedScene& view)
    : viewing_(verify::viewing_of(input)),
      point_(verify::triple<verify::Exact>(input.projection.point)),
      n_(verify::triple<verify::Exact>(input.projection.n)),
      u_(verify::triple<verify::Exact>(input.projection.u)),
      v_(verify::triple<verify::Exact>(input.projection.v)) {
  const projection::Projection& p = input.projection;
  const view::ViewMap& map = view.map;
  if (p.central) {
    const double w0 = 1 / (map.depth_to_one * map.depth_of_n);
    centre_ = verify::triple<verify::Exact>(p.projector);
    page_ = p.scale * glm::dot(p.n, p.projector * map.normalisation - p.point * map.normalisation);
    depth_ = map.depth_of_n * w0 * w0 / map.normalisation;
    nearest_ = nearest_seen * w0 / map.normalisation;
  } else {
    u_ = along_projectors(u_, n_, verify::triple<verify::Exact>(p.projector));
    v_ = along_projectors(v_, n_, verify::triple<verify::Exact>(p.projector));
    page_ = p.scale * map.normalisation;
    depth_ = map.depth_of_n * map.normalisation;
  }
}

ExactPoint ExactPage::place(const verify::Triple<verify::Exact>& point) const {
  const verify::Triple<verify::Exact> l = point - (centre_ ? *centre_ : point_);
  const verify::Exact n = verify::dot(n_, l);
  if (!centre_) return {page_ * verify::dot(u_, l), page_ * verify::dot(v_, l), depth_ * n};
  const verify::Exact ahead = std::max(verify::Exact(-n), nearest_);  // ends that were clipped there are rounded
  return {page_ * verify::dot(u_, l) / ahead, page_ * verify::dot(v_, l) / ahead, depth_ / ahead};
}

std::vector<ExactPoint> ExactPage::place(const std::array<Vec3, 3>& corners) const {
  const verify::Polygon<verify::Exact> polygon = clipped(corners);
  std::vector<ExactPoint> places;
  for (std::size_t i = 0; i < polygon.count; ++i) places.push_back(place(polygon.corner[i]));
  return places;
}

verify::Polygon<verify::Exact> ExactPage::clipped(const std::array<Vec3, 3>& corners) const {
  verify::Polygon<verify::Exact> polygon;
  for (const Vec3& corner : corners) polygon.add(verify::triple<verify::Exact>(corner));
  using Point = verify::Triple<verify::Exact>;
  if (centre_)
    polygon =
        verify::clip(polygon, [&](const Point& p) { return verify::Exact(verify::dot(n_, *centre_ - p) - nearest_); });
  if (viewing_.front)
    polygon = verify::clip(polygon, [&](const Point& p) {
      return verify::Exact(verify::Exact(*viewing_.front) - verify::dot(n_, p - point_));
    });
  if (viewing_.back)
    polygon = verify::clip(polygon, [&](const Point& p) {
      return verify::Exact(verify::dot(n_, p - point_) - verify::Exact(*viewing_.back));
    });
  return polygon;
}

struct Range {
  verify::Exact from = 0, to = 1;

  // Restricts the range to where a function that is linear between its values at 0 and 1 is not negative.
  void keep(const verify::Exact& at_0, const verify::Exact& at_1) {
    if (at_0 < 0 && at_1 < 0) to = from;
    if (at_0 >= 0 && at_1 >= 0) return;
    if (at_0 == at_1) return;
    const verify::Exact root = at_0 / (at_0 - at_1);
    if (at_0 < 0)
      from = std::max(from, root);
    else
      to = std::min(to, root);
  }
};

double distance(const ExactPoint& a, const ExactPoint& b) {
  return std::hypot(verify::Exact(b.x - a.x).get_d(), verify::Exact(b.y - a.y).get_d());
}

/// A convex polygon on the page with its depth: z + slope . (p - corner).
struct Face {
  std::vector<ExactPoint> corner;
  std::vector<bool> border;  ///< of the side from corner i
  int turn = 0;              ///< 1: counterclockwise; 0: a line
  verify::Exact slope_x, slope_y;

  [[nodiscard]] verify::Exact depth(const ExactPoint& p) const {
    return corner[0].depth + slope_x * (p.x - corner[0].x) + slope_y * (p.y - corner[0].y);
  }
  [[nodiscard]] double steepness() const { return 1 + std::hypot(slope_x.get_d(), slope_y.get_d()); }
};

Face face_from(std::vector<ExactPoint> corners) {
  Face face{std::move(corners), {}, 0, 0, 0};
  const auto& c = face.corner;
  verify::Exact largest = 0;
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const verify::Exact area = cross(c[0], c[i], c[i + 1]);
    if (abs(area) <= abs(largest)) continue;
    largest = area;
    const verify::Exact bz = c[i].depth - c[0].depth, cz = c[i + 1].depth - c[0].depth;
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

// The part of the line that a face hides. The face's borders are moved inwards by `inwards`, and the face must be in
// front of the line by at least `ahead` times its steepness.
std::optional<std::array<double, 2>> hidden_part(const Face& face, const Line& line, double inwards, double ahead) {
  Range range;
  for (std::size_t i = 0; i < face.corner.size(); ++i) {
    const ExactPoint& a = face.corner[i];
    const ExactPoint& b = face.corner[(i + 1) % face.corner.size()];
    const verify::Exact margin(face.border[i] || inwards < 0 ? inwards * distance(a, b) : 0);
    range.keep(cross(a, b, line.p) * face.turn - margin, cross(a, b, line.q) * face.turn - margin);
  }
  const verify::Exact margin(ahead * face.steepness());
  range.keep(face.depth(line.p) - line.p.depth - margin, face.depth(line.q) - line.q.depth - margin);
  if (range.from >= range.to) return std::nullopt;
  return std::array{range.from.get_d(), range.to.get_d()};
}

// The part of the line along a face that is seen edge-on, within `margin`: whether that covers it is a matter of
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
  const verify::Exact wide(2 * margin * length);
  for (const int sign : {1, -1}) range.keep(cross(a, b, line.p) * sign + wide, cross(a, b, line.q) * sign + wide);
  const auto along = [&](const ExactPoint& c) {
    return verify::Exact((b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y));
  };
  const verify::Exact whole = along(b);
  range.keep(along(line.p) + wide, along(line.q) + wide);
  range.keep(whole - along(line.p) + wide, whole - along(line.q) + wide);
  if (range.from >= range.to) return std::nullopt;
  return std::array{range.from.get_d(), range.to.get_d()};
}

/// Positions of the world's triangles in doubles: finds those that may be in front of an edge.
class TrianglePlaces {
 public:
  TrianglePlaces(const world::World& world, const ExactPage& page) : corners_(world.triangles.size()) {
    const auto place = [&](std::size_t t) {
      const auto& [a, b, c] = world.triangles[t];
      return page.place({world.points[a], world.points[b], world.points[c]});
    };
    for (std::size_t t = 0; t < corners_.size(); ++t)
      if (const auto corners = place(t); !corners.empty()) {
        origin_ = corners.front();
        break;
      }
    parallel_for(corners_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        for (const ExactPoint& p : place(t)) corners_[t].push_back(in_doubles(p));
    });
    tree_ = {corners_.size(), [&](std::size_t t) { return bounds_of(corners_[t], 0); }};
  }

  /// Ascending. Positions within `slack` count as the same.
  [[nodiscard]] std::vector<int> before(const Line& line, double slack) const {
    const std::vector<Vec3> ends{in_doubles(line.p), in_doubles(line.q)};
    std::vector<int> found;
    tree_.visit(bounds_of(ends, slack), [&](std::size_t t) {
      if (may_hide(corners_[t], ends[0], ends[1], slack)) found.push_back(static_cast<int>(t));
      return true;
    });
    return found;
  }

 private:
  [[nodiscard]] Vec3 in_doubles(const ExactPoint& p) const {
    return {verify::Exact(p.x - origin_.x).get_d(), verify::Exact(p.y - origin_.y).get_d(),
            verify::Exact(p.depth - origin_.depth).get_d()};
  }

  static search::Bounds<2> bounds_of(const std::vector<Vec3>& points, double slack) {
    search::Bounds<2> bounds{{{HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}}};
    for (const Vec3& p : points)
      for (int i = 0; i < 2; ++i)
        bounds[i] = {std::min(bounds[i][0], p[i] - slack), std::max(bounds[i][1], p[i] + slack)};
    return bounds;
  }

  static bool may_hide(const std::vector<Vec3>& corners, const Vec3& p, const Vec3& q, double slack) {
    const Vec2 along(q - p);
    const double beside = slack * glm::length(along);
    const double behind = std::min(p.z, q.z);
    const double deeper = slack + surely_beside * std::abs(behind);
    std::size_t left = 0, right = 0, back = 0;
    for (const Vec3& c : corners) {
      const double turn = along.x * (c.y - p.y) - along.y * (c.x - p.x);
      left += turn > beside ? 1 : 0;
      right += turn < -beside ? 1 : 0;
      back += c.z < behind - deeper ? 1 : 0;
    }
    return left < corners.size() && right < corners.size() && back < corners.size();
  }

  ExactPoint origin_;                       ///< of the doubles: a point of the drawing, to preserve their precision
  std::vector<std::vector<Vec3>> corners_;  ///< by triangle: x, y and depth of its visible part
  search::BoundsTree<2> tree_;
};

std::uint64_t side_key(int a, int b) {
  const auto [first, second] = std::minmax(a, b);
  return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 | static_cast<std::uint32_t>(second);
}

class Judge {
 public:
  Judge(const verify::VerifyInput& input, const view::ProjectedScene& view)
      : input_(input), view_(view), page_(input, view), places_(input.world, page_) {
    const auto& triangles = input.world.triangles;
    sides_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        sides_.emplace(side_key(triangles[t][i], triangles[t][(i + 1) % 3]), static_cast<int>(t));
  }

  [[nodiscard]] EdgeTruth truth_of(int e, std::atomic<std::size_t>& pairs) const {
    const edges::FeatureEdge& edge = input_.drawn.edges[e];
    const std::array<Vec3, 2> ends = input_.ends_of(edge);
    const Line line{page_.place(verify::position_on<verify::Exact>(ends, edge.t[0])),
                    page_.place(verify::position_on<verify::Exact>(ends, edge.t[1]))};
    const double extent = view_.extent;
    EdgeTruth truth{e, {}, {}};
    for (const int triangle : near(edge, line)) {
      ++pairs;
      Face face = face_from(page_.place(corners_of(triangle)));
      if (face.corner.empty()) continue;
      if (const auto part = part_along(face, line, sideways * extent)) visibility::add_span(truth.perhaps, *part);
      const auto perhaps = face.turn == 0 ? std::nullopt : hidden_part(face, line, -sideways * extent, 0);
      if (!perhaps) continue;
      visibility::add_span(truth.perhaps, *perhaps);
      find_borders(edge, triangle, face);
      const auto surely = hidden_part(face, line, sideways * extent, 2 * view_.contact.touching);
      if (surely) visibility::add_span(truth.surely, *surely);
    }
    for (const auto& span : truth.surely) visibility::add_span(truth.perhaps, span);
    return truth;
  }

 private:
  // Triangles of the world that are not the edge's own and may be in front of it.
  [[nodiscard]] std::vector<int> near(const edges::FeatureEdge& edge, const Line& line) const {
    std::vector<int> found = places_.before(line, surely_beside * view_.extent);
    std::erase_if(found, [&](int triangle) { return input_.contains(edge, triangle); });
    return found;
  }

  [[nodiscard]] std::array<Vec3, 3> corners_of(int triangle) const {
    const auto& [a, b, c] = input_.world.triangles[triangle];
    return {input_.world.points[a], input_.world.points[b], input_.world.points[c]};
  }

  void find_borders(const edges::FeatureEdge& edge, int triangle, Face& face) const {
    if (face.corner.size() != 3) return;
    for (std::size_t i = 0; i < 3; ++i) face.border[i] = is_border(edge, triangle, i, face);
  }

  // Whether no other triangle continues beyond a side.
  [[nodiscard]] bool is_border(const edges::FeatureEdge& edge, int triangle, std::size_t side, const Face& face) const {
    const auto& corner = input_.world.triangles[triangle];
    const int a = corner[side], b = corner[(side + 1) % 3];
    const auto [begin, end] = sides_.equal_range(side_key(a, b));
    return std::none_of(begin, end, [&](const auto& found) {
      const int other = found.second;
      if (other == triangle || input_.contains(edge, other)) return false;
      const auto& c = input_.world.triangles[other];
      const auto apex = std::find_if(c.begin(), c.end(), [&](int v) { return v != a && v != b; });
      if (apex == c.end()) return false;
      const Face beyond = face_from(page_.place(corners_of(other)));
      if (beyond.corner.size() != 3) return false;
      return sgn(cross(face.corner[side], face.corner[(side + 1) % 3],
                       page_.place(verify::triple<verify::Exact>(input_.world.points[*apex])))) *
                 face.turn <
             0;
    });
  }

  const verify::VerifyInput& input_;
  const view::ProjectedScene& view_;
  ExactPage page_;
  TrianglePlaces places_;
  std::unordered_multimap<std::uint64_t, int> sides_;
};

// Fisher-Yates shuffle with a generator that is the same everywhere.
std::vector<int> random_order(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(1);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

}  // namespace

std::vector<EdgeTruth> find_truth(const verify::VerifyInput& input, const view::ProjectedScene& view,
                                  const TruthEffort& effort) {
  const Judge judge(input, view);
  const std::vector<int> order = random_order(input.drawn.edges.size());
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

PointTruth truth_of_point(const std::array<view::PageVertex, 3>& triangle, const std::array<view::PageVertex, 2>& edge,
                          double s) {
  const auto exact = [](const view::PageVertex& v) {
    return ExactPoint{verify::Exact(v.x), verify::Exact(v.y), verify::Exact(v.depth)};
  };
  const ExactPoint p = exact(edge[0]), q = exact(edge[1]);
  const verify::Exact part(s);
  const ExactPoint point{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), p.depth + part * (q.depth - p.depth)};
  const Face face = face_from({exact(triangle[0]), exact(triangle[1]), exact(triangle[2])});
  double inside = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactPoint& a = face.corner[i];
    const ExactPoint& b = face.corner[(i + 1) % 3];
    inside = std::min(inside, cross(a, b, point).get_d() * face.turn / distance(a, b));
  }
  return {inside, verify::Exact(face.depth(point) - point.depth).get_d(), face.steepness()};
}

visibility::Spans nearest_right(const visibility::Spans& shown, const EdgeTruth& truth) {
  return united(common(shown, truth.perhaps), truth.surely);
}

}  // namespace epura
