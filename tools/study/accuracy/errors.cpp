// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/span_sets.hpp"
#include "study/accuracy/ink_distance.hpp"

namespace epura::study {

namespace {

visibility::Spans longer_than(visibility::Spans spans, double min) {
  std::erase_if(spans, [&](const auto& span) { return span[1] - span[0] <= min; });
  return spans;
}

long long strangers(const visibility::Spans& spans, const visibility::Spans& others) {
  return std::count_if(spans.begin(), spans.end(), [&](const auto& span) { return common({span}, others).empty(); });
}

// Counts spans of `inner` that lie inside one of `outer` without reaching its ends.
long long inside(const visibility::Spans& inner, const visibility::Spans& outer) {
  return std::count_if(inner.begin(), inner.end(), [&](const auto& span) {
    return std::any_of(outer.begin(), outer.end(),
                       [&](const auto& other) { return other[0] < span[0] && span[1] < other[1]; });
  });
}

// The one span that overlaps this one; nothing if there is none, or several.
std::optional<std::array<double, 2>> partner(const std::array<double, 2>& span, const visibility::Spans& others) {
  const auto meets = [&](const auto& other) { return std::max(span[0], other[0]) < std::min(span[1], other[1]); };
  if (std::count_if(others.begin(), others.end(), meets) != 1) return std::nullopt;
  return *std::find_if(others.begin(), others.end(), meets);
}

double farthest_end(const visibility::Spans& visible, const visibility::Spans& shown) {
  double farthest = 0;
  for (const auto& span : visible) {
    const auto other = partner(span, shown);
    if (!other || !partner(*other, visible)) continue;
    farthest = std::max({farthest, std::abs((*other)[0] - span[0]), std::abs((*other)[1] - span[1])});
  }
  return farthest;
}

void add_ink(std::vector<InkLine>& ink, const JudgedEdge& edge, const visibility::Spans& spans) {
  for (const auto& [from, to] : spans)
    ink.push_back({edge.from + from * (edge.to - edge.from), edge.from + to * (edge.to - edge.from)});
}

// Common ink has no distance: only the ink of one of them is examined.
double ink_distance(const std::vector<JudgedEdge>& edges) {
  std::vector<InkLine> ink_shown, ink_right, only_shown, only_right;
  for (const JudgedEdge& edge : edges) {
    const visibility::Spans shown = complement(edge.shown), right = complement(edge.right);
    add_ink(ink_shown, edge, shown);
    add_ink(ink_right, edge, right);
    add_ink(only_shown, edge, without(shown, right));
    add_ink(only_right, edge, without(right, shown));
  }
  return std::max(farthest_from_ink(only_shown, ink_right), farthest_from_ink(only_right, ink_shown));
}

void add_edge(Errors& errors, const JudgedEdge& edge, double min_length) {
  const double length = glm::distance(edge.from, edge.to);
  const visibility::Spans wrong = united(without(edge.shown, edge.right), without(edge.right, edge.shown));
  for (const auto& [from, to] : wrong) {
    errors.longest = std::max(errors.longest, (to - from) * length);
    errors.sum += (to - from) * length;
  }
  const visibility::Spans shown = complement(edge.shown), right = complement(edge.right);
  errors.end_point = std::max(errors.end_point, farthest_end(right, shown) * length);
  const double min = min_length / length;
  errors.missed += strangers(longer_than(right, min), shown);
  errors.phantom += strangers(longer_than(shown, min), right);
  errors.cracks += inside(longer_than(edge.shown, min), right);
  errors.edges += longer_than(wrong, min).empty() ? 0 : 1;
}

}  // namespace

Errors measure_errors(const std::vector<JudgedEdge>& edges, double min) {
  Errors errors;
  errors.judged = static_cast<long long>(edges.size());
  for (const JudgedEdge& edge : edges) add_edge(errors, edge, min);
  errors.ink = ink_distance(edges);
  return errors;
}

}  // namespace epura::study
