// SPDX-License-Identifier: Apache-2.0
#include "drawing/drawn_lines.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

bool is_on(const std::array<Vec2, 2>& line, const PageCurve& curve) {
  return std::max(curve.distance(line[0]), curve.distance(line[1])) <= on_line_mm;
}

// Whether a line is the one that ends at `end` on facets, or an arc of which that is a part, or the other end of a line
// that closes there, within `near`.
bool is_own(const DrawnLine& one, const DrawnLine& line, const Vec2& end, double near) {
  if (one.chain != line.chain) return false;
  const double distance = std::min(glm::distance(one.facets[0], end), glm::distance(one.facets[1], end));
  return distance <= near || (one.curve >= 0 && one.curve == line.curve);
}

// Hidden parts of an arc, and what goes on from it at a vertex, are nearly the same curve: they do not tell where it
// ends.
bool are_both_round(const DrawnLine& line, const DrawnLine& one) {
  return !line.drawn.is_straight() && !one.drawn.is_straight();
}

void take_nearer(std::optional<Vec2>& nearest, const std::optional<Vec2>& place, const Vec2& end) {
  if (place && (!nearest || glm::distance(*place, end) < glm::distance(*nearest, end))) nearest = place;
}

std::vector<search::LinesAt::Line> facets_of(const std::vector<DrawnLine>& all) {
  std::vector<search::LinesAt::Line> lines;
  lines.reserve(all.size());
  for (const DrawnLine& line : all) lines.push_back(line.facets);
  return lines;
}

}  // namespace

std::vector<DrawnLine> drawn_lines(const std::vector<Chain>& chains, const std::vector<std::vector<Vec2>>& facets) {
  std::vector<DrawnLine> all;
  for (std::size_t number = 0; number < chains.size(); ++number) {
    const Chain& chain = chains[number];
    const std::size_t count = chain.points.size(), first = all.size();
    check(facets[number].size() == count, "each point of a line has its place on facets");
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const std::array line{facets[number][i], facets[number][next]};
      const PageCurve drawn(chain.points[i], chain.points[next]);
      all.push_back({line, drawn, !is_on(line, drawn), chain.visible, static_cast<int>(number)});
    }
    for (std::size_t c = 0; c < chain.curves.size(); ++c) {
      const CurvePart& curve = chain.curves[c];
      check(curve.first >= 0 && curve.last - curve.first <= static_cast<int>(count), "an arc is a part of its line");
      for (int i = curve.first; i < curve.last; ++i) {
        DrawnLine& one = all[first + static_cast<std::size_t>(i) % count];
        one.drawn = PageCurve(curve);
        one.is_moved = true;
        one.curve = static_cast<int>(c);
      }
    }
  }
  return all;
}

DrawnLines::DrawnLines(std::vector<DrawnLine> all, double near, double touching)
    : all_(std::move(all)), near_(near), touching_(touching), at_(facets_of(all_), near) {}

bool DrawnLines::is_at(const DrawnLine& one, const Vec2& place) const {
  return distance_to_segment(place, one.facets[0], one.facets[1]) <= near_;
}

template <class Visit>
void DrawnLines::visit_others_at(const Vec2& end, const DrawnLine& line, const Visit& visit) const {
  for (const int i : at_(end))
    if (!is_own(all_[i], line, end, near_) && is_at(all_[i], end)) visit(i);
}

// Where a line crosses the line with a number near the end that facets have, or what goes on from that in its chain, or
// else its end.
std::optional<Vec2> DrawnLines::meeting(const DrawnLine& line, std::size_t number, const Vec2& end) const {
  const DrawnLine& one = all_[number];
  // The longer facet is off by more: it decides how far an end may move.
  const double most =
      std::max(glm::distance(one.facets[0], one.facets[1]), glm::distance(line.facets[0], line.facets[1]));
  const double off = line.drawn.distance(end) + one.drawn.distance(end);
  const auto is_near = [&](const Vec2& place) { return glm::distance(place, end) <= std::min(most, max_slant * off); };
  std::optional<Vec2> beyond;
  for (const std::size_t i : {number, number - 1, number + 1}) {
    if (i >= all_.size() || all_[i].chain != one.chain || is_own(all_[i], line, end, near_)) continue;
    const auto place = crossing_near(line.drawn, all_[i].drawn, end);
    if (!place || !is_near(*place)) continue;
    if (all_[i].drawn.is_in_part(*place)) return place;
    if (i == number) beyond = all_[i].drawn.end_near(*place);
  }
  return beyond && is_near(*beyond) ? beyond : std::nullopt;
}

std::optional<Vec2> DrawnLines::end_in_edge(const DrawnLine& line, const Vec2& end) const {
  std::optional<Vec2> nearest;
  bool found = false;
  for (const bool moved : {true, false}) {
    // What is drawn elsewhere is not where facets have it, even if the line only touches it.
    if (nearest || found || (!moved && !line.is_moved)) break;
    visit_others_at(end, line, [&](std::size_t i) {
      const DrawnLine& one = all_[i];
      if (!one.visible || one.is_moved != moved) return;
      found = true;
      take_nearer(nearest, meeting(line, i, end), end);
    });
  }
  return nearest;
}

std::optional<Vec2> DrawnLines::end_at_vertex(const DrawnLine& line, const Vec2& end, const Vec2& drawn_end) const {
  std::optional<Vec2> nearest;
  bool is_joined = false;
  visit_others_at(end, line, [&](std::size_t i) {
    is_joined = is_joined || all_[i].drawn.distance(drawn_end) <= touching_;
    if (all_[i].is_moved && !are_both_round(line, all_[i])) take_nearer(nearest, meeting(line, i, end), end);
  });
  return is_joined ? std::nullopt : nearest;
}

}  // namespace epura::drawing
