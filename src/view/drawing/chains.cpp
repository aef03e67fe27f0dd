// SPDX-License-Identifier: Apache-2.0
#include "drawing/chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/drawing.hpp"
#include "drawing/limits.hpp"
#include "search/lines_at.hpp"

namespace epura::drawing {

namespace {

const Vec2& place(const std::vector<Segment>& segments, End end) {
  const Segment& s = segments[line_of(end)];
  return end % 2 == 0 ? s.from : s.to;
}

std::vector<End> continuations_of(const std::vector<Segment>& segments, const Gaps& gaps, const Progress& progress) {
  const auto place_of = [&](End end) { return place(segments, end); };
  const auto look_of = [&](End end) {
    const Segment& s = segments[line_of(end)];
    const double style = 2 * static_cast<double>(edges::look_of(s.kind)) + (s.visible ? 1 : 0);
    return std::array{style, static_cast<double>(s.model), static_cast<double>(s.body)};
  };
  const auto kind_of = [&](End end) { return segments[line_of(end)].kind; };
  std::vector<End> continuation = drawing::find_continuations(
      LineEnds{static_cast<int>(segments.size()), place_of, look_of, kind_of}, gaps, progress);
  for (End end = 0; end < static_cast<End>(continuation.size()); ++end)
    check(continuation[end] == no_end || continuation[continuation[end]] == end, "ends of lines are joined in pairs");
  return continuation;
}

// Leaves out corners at which the line runs straight on. The offsets of the corners left out since the last one kept
// are added up; otherwise a long fine arc would be cut short little by little.
void straighten(std::vector<Vec2>& points, bool closed, double tolerance) {
  const std::size_t n = points.size();
  const Vec2 first = points.front();
  std::size_t kept = 0;  // points that are kept overwrite those before them
  double offsets = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = !closed && (i == 0 || i == n - 1);
    const Vec2 before = kept > 0 ? points[kept - 1] : points[(i + n - 1) % n];
    const Vec2 chord = (i + 1 < n ? points[i + 1] : first) - before;
    const Vec2 step = points[i] - before;
    const double length = glm::length(chord);
    if (length > 0) offsets += std::abs(cross(chord, step)) / length;
    const bool straight =
        length > 0 && offsets <= tolerance && glm::dot(step, chord) >= 0 && glm::dot(step, chord) <= length * length;
    if (!end && straight) continue;
    points[kept++] = points[i];
    offsets = 0;
  }
  check(closed || kept >= std::min<std::size_t>(n, 2), "an open line keeps its ends");
  if (kept >= 2) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(kept), points.end());
  } else {
    points.front() = first;
  }
}

// Where ends meet only nearly, the step between them has no direction of its own: it would look like a corner.
void leave_out_steps(std::vector<Vec2>& points, bool closed, double touching) {
  std::vector<Vec2> kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool is_end = !closed && i + 1 == points.size(), is_step = glm::distance(points[i], kept.back()) <= touching;
    if (is_end && is_step && kept.size() > 1) kept.pop_back();
    if (is_end || !is_step) kept.push_back(points[i]);
  }
  if (closed && kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= touching) kept.pop_back();
  if (kept.size() >= (closed ? 3 : 2)) points = std::move(kept);
}

// Where two segments that nearly meet are joined: at the end that comes first across the page, whichever way the chain
// is followed.
const Vec2& joint(const Vec2& one, const Vec2& other) {
  return order_on_page(other) < order_on_page(one) ? other : one;
}

// Follows continuations from the end `start` of a segment, towards the other end of the segment.
Chain follow(const std::vector<Segment>& segments, const std::vector<End>& continuation, End start,
             std::vector<bool>& used) {
  const Segment& first = segments[line_of(start)];
  Chain chain{{place(segments, start)}, false, first.visible, first.kind, {}};
  for (End at = start; at != no_end && !used[line_of(at)]; at = continuation[other(at)]) {
    used[line_of(at)] = true;
    chain.points.back() = joint(chain.points.back(), place(segments, at));
    chain.segments.push_back(line_of(at));
    chain.kind = std::min(chain.kind, segments[line_of(at)].kind);
    chain.points.push_back(place(segments, other(at)));
  }
  return chain;
}

double length_of(const Chain& chain) {
  double length = chain.closed ? glm::distance(chain.points.back(), chain.points.front()) : 0;
  for (std::size_t i = 1; i < chain.points.size(); ++i) length += glm::distance(chain.points[i - 1], chain.points[i]);
  return length;
}

// The largest distance between the ends of segments that continue each other.
double widest_gap(const ViewDrawing& drawing) {
  double widest = 0;
  for (const Chain& chain : drawing.chains)
    for (std::size_t i = 1; i < chain.segments.size(); ++i) {
      const Segment &one = drawing.segments[chain.segments[i - 1]], &next = drawing.segments[chain.segments[i]];
      widest = std::max(widest, std::min({glm::distance(one.to, next.from), glm::distance(one.to, next.to),
                                          glm::distance(one.from, next.from), glm::distance(one.from, next.to)}));
    }
  return widest;
}

// Finds the lines that end or pass at a place.
class LinesThere {
 public:
  LinesThere(const ViewDrawing& drawing, double reach)
      : lines_(lines_of(drawing.segments)), at_(lines_, reach), chain_of_(lines_.size(), -1), reach_(reach) {
    for (std::size_t c = 0; c < drawing.chains.size(); ++c)
      for (const int segment : drawing.chains[c].segments) chain_of_[segment] = static_cast<int>(c);
  }

  /// Whether only lines of this chain do.
  [[nodiscard]] bool are_of(int chain, const Vec2& place) const {
    return std::ranges::all_of(at_(place), [&](int line) {
      return chain_of_[line] == chain || distance_to_segment(place, lines_[line][0], lines_[line][1]) > reach_;
    });
  }

 private:
  static std::vector<search::LinesAt::Line> lines_of(const std::vector<Segment>& segments) {
    std::vector<search::LinesAt::Line> lines;
    lines.reserve(segments.size());
    for (const Segment& segment : segments) lines.push_back({segment.from, segment.to});
    return lines;
  }

  std::vector<search::LinesAt::Line> lines_;
  search::LinesAt at_;
  std::vector<int> chain_of_;  ///< by segment
  double reach_;
};

std::vector<char> longest(const std::vector<Chain>& chains, std::size_t count) {
  std::vector<double> length;
  for (const Chain& chain : chains) length.push_back(distances_along(chain.points, chain.closed, chain.curves).back());
  std::vector<std::size_t> order(chains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return length[a] > length[b]; });
  std::vector<char> keep(chains.size(), 0);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) keep[order[i]] = 1;
  return keep;
}

// Returns the new numbers of the segments that are kept.
std::vector<int> keep_segments(ViewDrawing& drawing, const std::vector<char>& keep) {
  std::vector<int> number(keep.size(), -1);
  std::vector<Segment> segments;
  std::vector<CrossingSegment> crossings;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i] == 0) continue;
    number[i] = static_cast<int>(segments.size());
    Segment& segment = segments.emplace_back(drawing.segments[i]);
    if (segment.crossing < 0) continue;
    crossings.push_back(drawing.crossings[static_cast<std::size_t>(segment.crossing)]);
    segment.crossing = static_cast<int>(crossings.size()) - 1;
  }
  drawing.segments = std::move(segments);
  drawing.crossings = std::move(crossings);
  return number;
}

}  // namespace

std::vector<Chain> chain_segments(const std::vector<Segment>& segments, double tolerance, const Gaps& gaps,
                                  const Progress& progress) {
  const double widest = std::max(gaps.touching, gaps.unseen);
  const std::vector<End> continuation = continuations_of(segments, gaps, progress);
  std::vector<bool> used(segments.size(), false);
  std::vector<Chain> chains;
  Pace pace(progress, segments.size());
  std::size_t left = segments.size();
  const auto add = [&](End start, bool closed) {
    Chain chain = follow(segments, continuation, start, used);
    pace.left(left -= chain.segments.size());
    chain.closed = closed && chain.segments.size() > 2;
    check(chain.points.size() == chain.segments.size() + 1, "a chain has a line between any two of its points");
    if (chain.closed) {
      check(glm::distance(chain.points.front(), chain.points.back()) <= 4 * widest + 0x1p-28, "a closed chain closes");
      chain.points.front() = joint(chain.points.front(), chain.points.back());
      chain.points.pop_back();
    }
    // Both look at one point after the other, so they begin at the end that comes first across the page.
    const bool is_backwards = !chain.closed && order_on_page(chain.points.back()) < order_on_page(chain.points.front());
    if (is_backwards) std::ranges::reverse(chain.points);
    leave_out_steps(chain.points, chain.closed, gaps.touching);
    straighten(chain.points, chain.closed, tolerance);
    if (is_backwards) std::ranges::reverse(chain.points);
    chains.push_back(std::move(chain));
  };
  for (End end = 0; end < static_cast<End>(continuation.size()); ++end)
    if (continuation[end] == no_end && !used[line_of(end)]) add(end, false);
  // The remaining segments form rings.
  for (End end = 0; end < static_cast<End>(continuation.size()); end += 2)
    if (!used[line_of(end)]) add(end, true);
  check(left == 0, "every line is in one chain");
  return chains;
}

void chain_lines(ViewDrawing& drawing, const Progress& progress) {
  drawing.chains =
      chain_segments(drawing.segments, on_line_mm, {drawing.distances.coincident, drawing.distances.unseen}, progress);
  if (!(drawing.distances.unseen > drawing.distances.coincident)) return;
  // Ink that crosses a gap has other ink within the gap.
  const double gap = widest_gap(drawing);
  if (gap > 4 * drawing.distances.coincident)
    drawing.distances.joined_within = std::max(drawing.distances.joined_within, gap);
}

bool drop_short_creases(ViewDrawing& drawing, double least) {
  const auto is_short = [&](const Chain& chain) {
    return chain.kind == EdgeKind::crease && !chain.closed && length_of(chain) < least;
  };
  if (std::none_of(drawing.chains.begin(), drawing.chains.end(), is_short)) return false;
  const LinesThere lines(drawing, std::max({drawing.distances.coincident, drawing.distances.unseen, on_line_mm}));
  std::vector<char> dropped(drawing.segments.size(), 0);
  for (std::size_t c = 0; c < drawing.chains.size(); ++c) {
    const Chain& chain = drawing.chains[c];
    const auto fades = [&](int segment, const Vec2& end) {
      const Segment& s = drawing.segments[segment];
      const double t = glm::distance(s.from, end) < glm::distance(s.to, end) ? s.t[0] : s.t[1];
      return (t == 0 || t == 1) && lines.are_of(static_cast<int>(c), end);
    };
    if (!is_short(chain) || !fades(chain.segments.front(), chain.points.front())) continue;
    if (!fades(chain.segments.back(), chain.points.back())) continue;
    for (const int i : chain.segments) dropped[i] = 1;
  }
  const auto* first = drawing.segments.data();
  const auto count = std::erase_if(drawing.segments, [&](const Segment& s) { return dropped[&s - first] != 0; });
  check(std::count(dropped.begin(), dropped.end(), 1) == static_cast<std::ptrdiff_t>(count),
        "short creases are left out, and nothing else");
  return true;
}

std::size_t keep_longest_chains(ViewDrawing& drawing, std::size_t count) {
  const std::vector<char> keep = longest(drawing.chains, count);
  const std::size_t before = drawing.segments.size();
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i] != 0) chains.push_back(std::move(drawing.chains[i]));
  drawing.chains = std::move(chains);
  std::vector<char> keep_segment(before, 0);
  for (const Chain& chain : drawing.chains)
    for (const int segment : chain.segments) keep_segment[static_cast<std::size_t>(segment)] = 1;
  const std::vector<int> number = keep_segments(drawing, keep_segment);
  for (Chain& chain : drawing.chains)
    for (int& segment : chain.segments) {
      segment = number[static_cast<std::size_t>(segment)];
      check(segment >= 0, "lines of chains that are kept are kept");
    }
  return before - drawing.segments.size();
}

}  // namespace epura::drawing
