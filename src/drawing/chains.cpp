// SPDX-License-Identifier: Apache-2.0
#include "drawing/chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "base/same_key.hpp"

namespace epura::drawing {

namespace {

// One end of a segment: 2 * segment + (0 at `from`, 1 at `to`).
using End = int;
constexpr End none = -1;

int segment_of(End end) { return end / 2; }
End other(End end) { return end ^ 1; }

const Vec2& place(const std::vector<Segment>& segments, End end) {
  const Segment& s = segments[segment_of(end)];
  return end % 2 == 0 ? s.from : s.to;
}

// Direction in which the segment leaves this end.
Vec2 leaving(const std::vector<Segment>& segments, End end) {
  return glm::normalize(place(segments, other(end)) - place(segments, end));
}

// Ends that meet in one point: the two that run on most straightly first, as long as there are two.
void pair_up(const std::vector<Segment>& segments, std::span<const End> ends, std::vector<End>& partner) {
  constexpr std::size_t most_at_a_point = 64;  // beyond that, straightness is not worth a quadratic search
  if (ends.size() > most_at_a_point) return;
  const auto join = [&](End a, End b) {
    partner[a] = b;
    partner[b] = a;
  };
  if (ends.size() == 2) return join(ends[0], ends[1]);
  std::vector<std::pair<End, Vec2>> left;
  for (const End end : ends) left.emplace_back(end, leaving(segments, end));
  while (left.size() >= 2) {
    std::tuple<double, End, End> best{HUGE_VAL, none, none};
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t j = i + 1; j < left.size(); ++j)
        best = std::min(best, std::tuple(glm::dot(left[i].second, left[j].second), left[i].first, left[j].first));
    const auto [straightness, a, b] = best;
    join(a, b);
    std::erase_if(left, [a = a, b = b](const auto& l) { return l.first == a || l.first == b; });
  }
}

std::vector<End> find_partners(const std::vector<Segment>& segments, const Progress& progress) {
  std::vector<End> partner(segments.size() * 2, none);
  const auto look_and_place = [&](End e) {
    const Segment& s = segments[segment_of(e)];
    const Vec2& p = place(segments, e);
    return std::array{s.visible ? 1.0 : 0.0, static_cast<double>(s.kind), static_cast<double>(s.model), p.x, p.y};
  };
  visit_same_keys(static_cast<int>(partner.size()), look_and_place, progress,
                  [&](std::span<const End> ends) { pair_up(segments, ends, partner); });
  return partner;
}

// Leaves out corners at which the line runs straight on. The offsets of those left out since the last corner add up, or
// a long fine arc would be cut short bit by bit.
void straighten(std::vector<Vec2>& points, bool closed, double tolerance) {
  const std::size_t n = points.size();
  const Vec2 first = points.front();
  std::size_t kept = 0;  // they take the places of those before them
  double offsets = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = !closed && (i == 0 || i == n - 1);
    const Vec2 before = kept > 0 ? points[kept - 1] : points[(i + n - 1) % n];
    const Vec2 chord = (i + 1 < n ? points[i + 1] : first) - before;
    const Vec2 step = points[i] - before;
    const double length = glm::length(chord);
    if (length > 0) offsets += std::abs(chord.x * step.y - chord.y * step.x) / length;
    const bool straight =
        length > 0 && offsets <= tolerance && glm::dot(step, chord) >= 0 && glm::dot(step, chord) <= length * length;
    if (!end && straight) continue;
    points[kept++] = points[i];
    offsets = 0;
  }
  if (kept >= 2) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(kept), points.end());
  } else {
    points.front() = first;
  }
}

// Follows partners from the end `start`, whose segment is walked towards its other end.
Chain follow(const std::vector<Segment>& segments, const std::vector<End>& partner, End start,
             std::vector<bool>& used) {
  const Segment& first = segments[segment_of(start)];
  Chain chain{{place(segments, start)}, false, first.visible, first.kind, {}};
  for (End at = start; at != none && !used[segment_of(at)]; at = partner[other(at)]) {
    used[segment_of(at)] = true;
    chain.segments.push_back(segment_of(at));
    chain.points.push_back(place(segments, other(at)));
  }
  return chain;
}

}  // namespace

std::vector<Chain> chain_segments(const std::vector<Segment>& segments, double tolerance, const Progress& progress) {
  const std::vector<End> partner = find_partners(segments, progress);
  std::vector<bool> used(segments.size(), false);
  std::vector<Chain> chains;
  Pace pace(progress, segments.size());
  std::size_t left = segments.size();
  const auto add = [&](End start, bool closed) {
    Chain chain = follow(segments, partner, start, used);
    pace.left(left -= chain.segments.size());
    chain.closed = closed && chain.segments.size() > 2;
    if (chain.closed) chain.points.pop_back();
    straighten(chain.points, chain.closed, tolerance);
    chains.push_back(std::move(chain));
  };
  for (End end = 0; end < static_cast<End>(partner.size()); ++end)
    if (partner[end] == none && !used[segment_of(end)]) add(end, false);
  // What is left runs in rings.
  for (End end = 0; end < static_cast<End>(partner.size()); end += 2)
    if (!used[segment_of(end)]) add(end, true);
  return chains;
}

}  // namespace epura::drawing
