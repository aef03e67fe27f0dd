// SPDX-License-Identifier: Apache-2.0
#include "sheet/centre_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/portable_math.hpp"
#include "sheet/dash.hpp"

namespace epura::sheet {

namespace {

constexpr double beyond = 3;             // mm
constexpr double least_diameter = 1;     // mm
constexpr double shortest_piece = 1;     // mm, of what other lines leave
constexpr double same_place = 0.02;      // mm
constexpr double same_direction = 1e-4;  // radians
constexpr double edge_on = 1e-4;         // of the radius

/// How the view sees a circle; mm of paper.
struct SeenCircle {
  Vec2 centre;
  Vec2 u, v;  ///< images of two perpendicular radii
  Vec2 axis;  ///< image of the unit normal

  [[nodiscard]] double radius() const { return std::max(glm::length(u), glm::length(v)); }
  [[nodiscard]] bool is_round() const {
    const double slack = 1e-4 * glm::dot(u, u);
    return std::abs(glm::dot(u, u) - glm::dot(v, v)) <= slack && std::abs(glm::dot(u, v)) <= slack;
  }
  /// How far it reaches from its centre in a direction.
  [[nodiscard]] double reach(const Vec2& direction) const {
    return std::hypot(glm::dot(u, direction), glm::dot(v, direction));
  }
};

SeenCircle see(const Mat4& world_to_page, const mesh::MeshCircle& circle) {
  const auto place = [&](const Vec3& p, double w) {
    const Vec4 image = world_to_page * Vec4(p, w);
    return Vec2(image.x, image.y) / world_to_page[3][3];
  };
  const Vec3 u = glm::normalize(glm::cross(circle.axis, std::abs(circle.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  return {place(circle.centre, 1), place(circle.radius * u, 0), place(circle.radius * glm::cross(circle.axis, u), 0),
          place(circle.radius * circle.axis, 0)};
}

/// A piece of the line through offset * normal along the direction of `angle`, the normal being 90 degrees further.
struct Piece {
  double angle, offset;
  double from, to;
  bool centred = true;  ///< its middle is to have ink

  [[nodiscard]] Vec2 direction() const { return {portable_cos(angle), portable_sin(angle)}; }
  [[nodiscard]] Vec2 at(double s) const {
    const Vec2 d = direction();
    return s * d + offset * Vec2(-d.y, d.x);
  }
};

// Angles from 0 to pi, those a little below pi as if below 0; rounded, so that lines in one direction share it.
double angle_of_line(const Vec2& direction) {
  double angle = portable_atan2(direction.y, direction.x);
  if (angle < -same_direction) angle += std::numbers::pi;
  if (angle > std::numbers::pi - same_direction) angle -= std::numbers::pi;
  return std::round(angle * 1e9) / 1e9;
}

double offset_of(double angle, const Vec2& p) { return portable_cos(angle) * p.y - portable_sin(angle) * p.x; }
double place_along(double angle, const Vec2& p) { return portable_cos(angle) * p.x + portable_sin(angle) * p.y; }

// A number for each value; values that are `apart` or nearer have the same.
std::vector<int> classes_of(const std::vector<double>& values, double apart) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::pair(values[a], a) < std::pair(values[b], b); });
  std::vector<int> classes(values.size());
  int number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && values[order[i]] - values[order[i - 1]] > apart) ++number;
    classes[order[i]] = number;
  }
  return classes;
}

// Indices of things in groups: those near each other in both values.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<double>& a, double a_apart,
                                                const std::vector<double>& b, double b_apart) {
  const std::vector<int> first = classes_of(a, a_apart), second = classes_of(b, b_apart);
  std::map<std::pair<int, int>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < a.size(); ++i) groups[{first[i], second[i]}].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [key, group] : groups) result.push_back(std::move(group));
  return result;
}

template <class Value>
std::vector<double> values_of(const auto& things, const Value& value) {
  std::vector<double> values;
  for (const auto& thing : things) values.push_back(value(thing));
  return values;
}

std::vector<Piece> crosses(const std::vector<SeenCircle>& circles) {
  std::vector<SeenCircle> round;
  std::copy_if(circles.begin(), circles.end(), std::back_inserter(round), [](const auto& c) { return c.is_round(); });
  std::vector<Piece> pieces;
  const auto x = values_of(round, [](const auto& c) { return c.centre.x; });
  const auto y = values_of(round, [](const auto& c) { return c.centre.y; });
  for (const auto& group : groups_of(x, same_place, y, same_place)) {
    double radius = 0;
    for (const std::size_t i : group) radius = std::max(radius, round[i].radius());
    for (const double angle : {0.0, angle_of_line({0, 1})}) {
      const Vec2 centre = round[group.front()].centre;
      const double middle = place_along(angle, centre), half = radius + beyond;
      pieces.push_back({angle, offset_of(angle, centre), middle - half, middle + half});
    }
  }
  return pieces;
}

std::vector<Piece> axes(const std::vector<SeenCircle>& circles) {
  std::vector<SeenCircle> slanted;
  std::copy_if(circles.begin(), circles.end(), std::back_inserter(slanted),
               [](const auto& c) { return glm::length(c.axis) > edge_on * c.radius(); });
  const auto angles = values_of(slanted, [](const auto& c) { return angle_of_line(c.axis); });
  const auto offsets = values_of(slanted, [](const auto& c) { return offset_of(angle_of_line(c.axis), c.centre); });
  std::vector<Piece> pieces;
  for (const auto& group : groups_of(angles, same_direction, offsets, same_place)) {
    const double angle = angles[group.front()];
    Piece piece{angle, offsets[group.front()], HUGE_VAL, -HUGE_VAL};
    double first = HUGE_VAL, last = -HUGE_VAL;  // centres
    bool alone = false;                         // one of them is enough
    for (const std::size_t i : group) {
      const SeenCircle& circle = slanted[i];
      const double middle = place_along(angle, circle.centre), reach = circle.reach(piece.direction());
      piece.from = std::min(piece.from, middle - reach - beyond);
      piece.to = std::max(piece.to, middle + reach + beyond);
      first = std::min(first, middle);
      last = std::max(last, middle);
      alone = alone || reach <= edge_on * circle.radius();
    }
    if (alone || last - first > same_place) pieces.push_back(piece);
  }
  return pieces;
}

// Overlapping pieces of one line are one piece.
std::vector<Piece> merged(const std::vector<Piece>& pieces) {
  const auto angles = values_of(pieces, [](const Piece& p) { return p.angle; });
  const auto offsets = values_of(pieces, [](const Piece& p) { return p.offset; });
  std::vector<Piece> result;
  for (const auto& group : groups_of(angles, same_direction, offsets, same_place)) {
    std::vector<Piece> line;
    for (const std::size_t i : group) line.push_back(pieces[i]);
    std::sort(line.begin(), line.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
    const std::size_t begin = result.size();
    for (const Piece& piece : line) {
      if (result.size() == begin || piece.from > result.back().to) {
        result.push_back(piece);
        continue;
      }
      Piece& last = result.back();
      const bool same_middle = std::abs(last.from + last.to - piece.from - piece.to) <= 2 * same_place;
      last.centred = last.centred && same_middle;
      last.to = std::max(last.to, piece.to);
    }
  }
  return result;
}

/// What lines of other layers take from pieces.
class Covers {
 public:
  Covers(const std::vector<Piece>& pieces, double apart) : pieces_(pieces), apart_(apart), taken_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i) by_line_.insert({pieces[i].angle, pieces[i].offset, i});
    for (const Piece& piece : pieces) angles_.insert(piece.angle);
  }

  void add(const Vec2& from, const Vec2& to) {
    for (const double angle : angles_) {
      const double a = offset_of(angle, from), b = offset_of(angle, to);
      if (std::abs(a - b) > apart_) continue;
      const double s = place_along(angle, from), t = place_along(angle, to);
      for (auto i = by_line_.lower_bound({angle, std::max(a, b) - apart_, 0});
           i != by_line_.end() && std::get<0>(*i) == angle && std::get<1>(*i) <= std::min(a, b) + apart_; ++i)
        taken_[std::get<2>(*i)].push_back({std::min(s, t), std::max(s, t)});
    }
  }

  /// What is left.
  [[nodiscard]] std::vector<Piece> rest() const {
    std::vector<Piece> left;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      std::vector<std::array<double, 2>> taken = taken_[i];
      std::sort(taken.begin(), taken.end());
      taken.push_back({HUGE_VAL, HUGE_VAL});
      Piece piece = pieces_[i];
      for (const auto& [low, high] : taken) {
        Piece part = piece;
        part.to = std::min(pieces_[i].to, low);
        part.centred = part.from == pieces_[i].from && part.to == pieces_[i].to && piece.centred;
        if (part.to - part.from >= shortest_piece) left.push_back(part);
        piece.from = std::max(piece.from, high);
      }
    }
    return left;
  }

 private:
  const std::vector<Piece>& pieces_;
  double apart_;
  std::vector<std::vector<std::array<double, 2>>> taken_;
  std::set<std::tuple<double, double, std::size_t>> by_line_;
  std::set<double> angles_;
};

std::vector<Piece> uncovered(const std::vector<Piece>& pieces, std::span<const Layer> drawn, double apart,
                             const Progress& progress) {
  Covers covers(pieces, apart);
  for (const Layer& layer : drawn) {
    for (const Stroke& stroke : layer.strokes) {
      progress.expect_time();
      const std::size_t lines = stroke.points.size() - (stroke.closed || stroke.points.empty() ? 0 : 1);
      for (std::size_t i = 0; i < lines; ++i)
        covers.add(stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]);
    }
  }
  return covers.rest();
}

using Edge = std::array<int, 3>;  // model, vertices

std::vector<Edge> visible_edges(const drawing::ViewDrawing& drawing) {
  std::vector<Edge> edges;
  for (const drawing::Segment& s : drawing.segments)
    if (s.visible && s.edge[0] >= 0)
      edges.push_back({s.model, std::min(s.edge[0], s.edge[1]), std::max(s.edge[0], s.edge[1])});
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool is_visible(const scene::PlacedCircle& placed, const std::vector<Edge>& edges) {
  const std::vector<int>& v = placed.circle.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto [low, high] = std::minmax(v[i], v[(i + 1) % v.size()]);
    if (std::binary_search(edges.begin(), edges.end(), Edge{placed.model, low, high})) return true;
  }
  return false;
}

std::vector<SeenCircle> seen_circles(const CentredView& view) {
  const bool some_without_hidden = std::any_of(view.styles.begin(), view.styles.end(), [](const ModelStyle& style) {
    return style.hidden == HiddenLines::none;
  });
  const std::vector<Edge> edges = some_without_hidden ? visible_edges(view.drawing) : std::vector<Edge>();
  std::vector<SeenCircle> seen;
  for (const scene::PlacedCircle& placed : view.circles) {
    const bool hides = view.styles[static_cast<std::size_t>(placed.model)].hidden == HiddenLines::none;
    if (hides && !is_visible(placed, edges)) continue;
    const SeenCircle circle = see(view.drawing.world_to_page, placed.circle);
    if (2 * circle.radius() >= least_diameter) seen.push_back(circle);
  }
  return seen;
}

}  // namespace

Layer centre_lines(const CentredView& view, const LineWidths& widths, std::span<const Layer> drawn,
                   const Progress& progress) {
  const double width = widths.narrow;
  Layer layer = empty_layer(view.drawing.name, scene::SheetLine::centre, widths);
  if (view.drawing.projection.central) return layer;
  const std::vector<SeenCircle> seen = seen_circles(view);
  std::vector<Piece> pieces = axes(seen);
  for (const Piece& piece : crosses(seen)) pieces.push_back(piece);
  pieces = merged(pieces);
  for (const Piece& piece : uncovered(pieces, drawn, width / 2, progress)) {
    const double length = piece.to - piece.from;
    const Dashes dashes = piece.centred ? fit_centred(length, width, scene::long_dash_dot)
                                        : fit_open(length, width, scene::long_dash_dot);
    layer.strokes.push_back({{piece.at(piece.from), piece.at(piece.to)}, false, dashes});
  }
  return layer;
}

}  // namespace epura::sheet
