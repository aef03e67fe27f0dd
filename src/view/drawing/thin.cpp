// SPDX-License-Identifier: Apache-2.0
#include "drawing/thin.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

namespace {

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
