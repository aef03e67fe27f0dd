// SPDX-License-Identifier: Apache-2.0
#include "drawing/closed_line.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/portable_math.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

using Rings = std::vector<std::vector<Vec2>>;
using SidePart = std::array<Vec2, 2>;

bool crosses_height(const Vec2& a, const Vec2& b, double y) { return (a.y > y) != (b.y > y); }

// Whether the ray to the right of a point crosses a side.
bool is_left_of(const Vec2& p, const Vec2& a, const Vec2& b) {
  return crosses_height(a, b, p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x;
}

template <class Visit>
void visit_sides(const Rings& rings, const Visit& visit) {
  for (const std::vector<Vec2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
}

// Adds the parts of a side between the places where it changes between inside and outside.
void add_pieces(std::vector<SidePart>& pieces, const SidePart& side, const std::vector<Vec2>& places, bool& inside) {
  Vec2 before = side[0];
  const auto add = [&](const Vec2& next) {
    if (inside && before != next) pieces.push_back({before, next});
    before = next;
  };
  for (const Vec2& place : places) {
    add(place);
    inside = !inside;
  }
  add(side[1]);
}

// Joins pieces to rings. Nothing if an end is left over.
std::optional<Rings> rings_of(const std::vector<SidePart>& pieces) {
  const auto less = [](const Vec2& a, const Vec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
  std::map<Vec2, std::vector<std::size_t>, decltype(less)> at(less);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Vec2& end : pieces[i]) at[end].push_back(i);
  check(at.size() <= 2 * pieces.size(), "a piece has two ends");
  std::vector<bool> used(pieces.size());
  Rings rings;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (used[first]) continue;
    used[first] = true;
    std::vector<Vec2> ring{pieces[first][0]};
    for (Vec2 end = pieces[first][1]; end != ring.front();) {
      ring.push_back(end);
      const std::vector<std::size_t>& here = at.at(end);
      const auto next = std::find_if(here.begin(), here.end(), [&](std::size_t piece) { return !used[piece]; });
      if (next == here.end()) return std::nullopt;
      used[*next] = true;
      end = pieces[*next][0] == end ? pieces[*next][1] : pieces[*next][0];
    }
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return rings;
}

// The boundary of the common area of a line and an area: the parts of either boundary inside the other. Nothing if a
// corner of one lies on a side of the other, up to rounding.
std::optional<Rings> common_area(const ClosedLine& line, const Rings& rings) {
  std::vector<SidePart> pieces;
  std::vector<std::vector<std::pair<double, Vec2>>> on_line(line.corners().size());
  for (const std::vector<Vec2>& ring : rings) {
    if (ring.empty()) continue;
    const bool begins_inside = line.contains(ring[0]);
    bool inside = begins_inside;
    bool is_doubtful = false;
    visit_sides({ring}, [&](const Vec2& from, const Vec2& to) {
      is_doubtful = is_doubtful || line.touches(from, to);
      std::vector<Vec2> places;
      for (const ClosedLine::Crossing& crossing : line.crossings(from, to)) {
        places.push_back(crossing.at);
        check(crossing.s >= 0 && crossing.s <= 1, "a side is crossed between its ends");
        on_line[static_cast<std::size_t>(crossing.side)].emplace_back(crossing.s, crossing.at);
      }
      add_pieces(pieces, {from, to}, places, inside);
    });
    if (is_doubtful || inside != begins_inside) return std::nullopt;
  }
  bool begins_inside = false;
  visit_sides(rings, [&](const Vec2& a, const Vec2& b) {
    if (is_left_of(line.corners()[0], a, b)) begins_inside = !begins_inside;
  });
  bool inside = begins_inside;
  for (std::size_t i = 0; i < on_line.size(); ++i) {
    std::stable_sort(on_line[i].begin(), on_line[i].end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vec2> places;
    for (const auto& [s, place] : on_line[i]) places.push_back(place);
    add_pieces(pieces, {line.corners()[i], line.corners()[i + 1 < on_line.size() ? i + 1 : 0]}, places, inside);
  }
  if (inside != begins_inside) return std::nullopt;
  return rings_of(pieces);
}

bool is_on(const Vec2& p, const Vec2& a, const Vec2& b) { return distance_to_segment(p, a, b) <= rounding_mm; }

// The part of a line in a triangle; nothing if it only touches it.
std::optional<std::array<double, 2>> part_in(const std::array<Vec2, 3>& triangle, const Vec2& from, const Vec2& to) {
  const double orientation = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0 ? -1 : 1;
  std::array<double, 2> part{0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = triangle[i], along = triangle[(i + 1) % 3] - a;
    const double f = orientation * cross(along, from - a), t = orientation * cross(along, to - a);
    if (f <= 0 && t <= 0) return std::nullopt;
    if (f < 0) part[0] = std::max(part[0], f / (f - t));
    if (t < 0) part[1] = std::min(part[1], f / (f - t));
  }
  return part[0] < part[1] ? std::optional(part) : std::nullopt;
}

// The union of intervals between 0 and 1. Rounding separates neighbouring triangles by less than `on_line_part`.
std::vector<std::array<double, 2>> joined(std::vector<std::array<double, 2>> parts) {
  std::sort(parts.begin(), parts.end());
  std::vector<std::array<double, 2>> all;
  for (const std::array<double, 2>& part : parts) {
    if (all.empty() || part[0] > all.back()[1] + on_line_part)
      all.push_back({part[0] <= on_line_part ? 0 : part[0], part[1]});
    all.back()[1] = std::max(all.back()[1], part[1] >= 1 - on_line_part ? 1 : part[1]);
  }
  return all;
}

// What remains of disjoint intervals without others, all ascending.
std::vector<std::array<double, 2>> difference(const std::vector<std::array<double, 2>>& all,
                                              const std::vector<std::array<double, 2>>& without) {
  std::vector<std::array<double, 2>> rest;
  for (auto [from, to] : all) {
    for (const std::array<double, 2>& gap : without) {
      if (gap[1] <= from || gap[0] >= to) continue;
      if (gap[0] > from) rest.push_back({from, gap[0]});
      from = gap[1];
    }
    if (from < to) rest.push_back({from, to});
  }
  return rest;
}

}  // namespace

ClosedLine::ClosedLine(std::vector<Vec2> corners) : corners_(std::move(corners)) {
  check(corners_.size() >= 3, "a closed line has three corners");
  min_ = max_ = corners_[0];
  for (const Vec2& p : corners_) {
    min_ = glm::min(min_, p);
    max_ = glm::max(max_, p);
  }
  check(max_.x > min_.x && max_.y > min_.y, "a closed line encloses an area");
  rows_.resize(corners_.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto [a, b] = side(i);
    for (std::size_t r = row(std::min(a.y, b.y)); r <= row(std::max(a.y, b.y)); ++r)
      rows_[r].push_back(static_cast<int>(i));
  }
}

std::size_t ClosedLine::row(double y) const {
  const double at = (y - min_.y) / (max_.y - min_.y) * static_cast<double>(rows_.size());
  if (!(at > 0)) return 0;
  return at < static_cast<double>(rows_.size()) ? static_cast<std::size_t>(at) : rows_.size() - 1;
}

template <class Visit>
void ClosedLine::visit_between(double low, double high, const Visit& visit) const {
  if (high < min_.y || low > max_.y) return;
  const std::size_t first = row(low), last = row(high);
  if (first == last) {
    for (const int i : rows_[first]) visit(i);
    return;
  }
  std::vector<int> sides;
  for (std::size_t r = first; r <= last; ++r) sides.insert(sides.end(), rows_[r].begin(), rows_[r].end());
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  for (const int i : sides) visit(i);
}

bool ClosedLine::contains(const Vec2& p) const {
  bool inside = false;
  visit_between(p.y, p.y, [&](int i) {
    const auto [a, b] = side(static_cast<std::size_t>(i));
    if (is_left_of(p, a, b)) inside = !inside;
  });
  return inside;
}

std::vector<ClosedLine::Crossing> ClosedLine::crossings(const Vec2& from, const Vec2& to) const {
  std::vector<Crossing> found;
  if (std::max(from.x, to.x) < min_.x || std::min(from.x, to.x) > max_.x) return found;
  const Vec2 along = to - from;
  visit_between(std::min(from.y, to.y), std::max(from.y, to.y), [&](int i) {
    const auto [a, b] = side(static_cast<std::size_t>(i));
    const double at_a = cross(along, a - from), at_b = cross(along, b - from);
    const double at_from = cross(b - a, from - a), at_to = cross(b - a, to - a);
    if ((at_a > 0) == (at_b > 0) || (at_from > 0) == (at_to > 0)) return;
    const double t = at_from / (at_from - at_to);
    check(t >= 0 && t <= 1, "a line crosses another between its ends");
    found.push_back({t, i, at_a / (at_a - at_b), from + t * along});
  });
  std::stable_sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
  return found;
}

bool ClosedLine::touches(const Vec2& from, const Vec2& to) const {
  const Vec2 low = glm::min(from, to) - rounding_mm, high = glm::max(from, to) + rounding_mm;
  if (high.x < min_.x || low.x > max_.x) return false;
  bool found = false;
  visit_between(low.y, high.y, [&](int i) {
    const auto [a, b] = side(static_cast<std::size_t>(i));
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x) return;
    found = found || is_on(a, from, to) || is_on(from, a, b) || is_on(to, a, b);
  });
  return found;
}

std::vector<std::array<double, 2>> ClosedLine::parts(const Vec2& from, const Vec2& to, bool inside) const {
  std::vector<std::array<double, 2>> found;
  std::vector<double> places{0};
  for (const Crossing& crossing : crossings(from, to)) places.push_back(crossing.t);
  places.push_back(1);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double middle = (places[i] + places[i + 1]) / 2;
    if (places[i] == places[i + 1] || contains(from + middle * (to - from)) != inside) continue;
    if (!found.empty() && found.back()[1] == places[i])
      found.back()[1] = places[i + 1];
    else
      found.push_back({places[i], places[i + 1]});
  }
  for (const auto& [begin, end] : found) check(begin >= 0 && begin < end && end <= 1, "a part lies on its line");
  return found;
}

std::vector<std::vector<Vec2>> ClosedLine::area(const std::vector<std::vector<Vec2>>& rings) const {
  if (auto common = common_area(*this, rings)) return std::move(*common);
  for (int attempt = 1; attempt <= 8; ++attempt) {
    const Vec2 shift = aside_mm * attempt * Vec2(portable_cos(attempt), portable_sin(attempt));
    std::vector<Vec2> moved = corners_;
    for (Vec2& p : moved) p += shift;
    if (auto common = common_area(ClosedLine(std::move(moved)), rings)) return std::move(*common);
  }
  check(false, "some small displacement separates the corners of two areas");
  return {};
}

// For each side, the parts in triangles.
std::vector<ClosedLine::Intervals> ClosedLine::covered_parts(Triangles triangles) const {
  std::vector<Intervals> covered(corners_.size());
  for (const std::array<Vec2, 3>& t : triangles) {
    const Vec2 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
    if (high.x < min_.x || low.x > max_.x || !(std::abs(cross(t[1] - t[0], t[2] - t[0])) > 0)) continue;
    visit_between(low.y, high.y, [&](int i) {
      const auto [a, b] = side(static_cast<std::size_t>(i));
      if (const auto part = part_in(t, a, b)) covered[static_cast<std::size_t>(i)].push_back(*part);
    });
  }
  for (Intervals& parts : covered) parts = joined(std::move(parts));
  return covered;
}

std::vector<std::vector<Vec2>> ClosedLine::covered(Triangles by, Triangles not_by) const {
  const std::vector<Intervals> all = covered_parts(by), without = covered_parts(not_by);
  std::vector<std::vector<Vec2>> lines;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto [a, b] = side(i);
    for (const auto& [from, to] : difference(all[i], without[i])) {
      check(from < to, "a covered part of a side goes forwards");
      const Vec2 begin = from == 0 ? a : a + from * (b - a), end = to == 1 ? b : a + to * (b - a);
      if (lines.empty() || lines.back().back() != begin) lines.push_back({begin});
      lines.back().push_back(end);
    }
  }
  if (lines.size() > 1 && lines.back().back() == lines.front().front()) {
    lines.back().insert(lines.back().end(), lines.front().begin() + 1, lines.front().end());
    lines.front() = std::move(lines.back());
    lines.pop_back();
  }
  return lines;
}

bool overlap(const ClosedLine& a, const ClosedLine& b) {
  if (a.contains(b.corners()[0]) || b.contains(a.corners()[0])) return true;
  for (std::size_t i = 0; i < b.corners().size(); ++i)
    if (!a.crossings(b.corners()[i], b.corners()[i + 1 < b.corners().size() ? i + 1 : 0]).empty()) return true;
  return false;
}

}  // namespace epura::drawing
