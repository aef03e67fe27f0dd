// SPDX-License-Identifier: Apache-2.0
#include "visibility/spans.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura::visibility {

namespace {

bool is_ascending(const Spans& spans) {
  double at = 0;
  for (const auto& [from, to] : spans) {
    if (!(from >= at && to >= from)) return false;
    at = to;
  }
  return at <= 1;
}

}  // namespace

void add_span(Spans& spans, const std::array<double, 2>& span) {
  check(span[0] <= span[1], "a span goes forwards");
  auto begin = std::lower_bound(spans.begin(), spans.end(), span[0], [](const auto& s, double t) { return s[1] < t; });
  auto end = begin;
  std::array<double, 2> whole = span;
  for (; end != spans.end() && (*end)[0] <= span[1]; ++end)
    whole = {std::min(whole[0], (*end)[0]), std::max(whole[1], (*end)[1])};
  if (begin == end)
    spans.insert(begin, whole);
  else {
    *begin = whole;
    spans.erase(begin + 1, end);
  }
}

bool covers(const Spans& spans, double from, double to) {
  const auto span = std::lower_bound(spans.begin(), spans.end(), to, [](const auto& s, double t) { return s[1] < t; });
  return span != spans.end() && (*span)[0] <= from;
}

std::optional<std::array<double, 2>> open_part(const Spans& spans, double from, double to, double min, double length) {
  std::optional<std::array<double, 2>> open;
  auto next = std::lower_bound(spans.begin(), spans.end(), from, [](const auto& s, double t) { return s[1] < t; });
  double begin = next == spans.begin() ? 0 : (*(next - 1))[1];
  bool held = next != spans.begin() && begin - (*(next - 1))[0] >= min;  // by a span that is not dropped
  while (begin < to) {
    const bool last = next == spans.end();
    const double end = last ? length : (*next)[0];
    const bool holds = !last && (*next)[1] - (*next)[0] >= min;
    const bool closes = end - begin < min && (held || holds);
    const std::array part{std::max(begin, from), std::min(end, to)};
    if (!closes && part[0] < part[1]) open = {open ? (*open)[0] : part[0], part[1]};
    check(end >= begin, "the spans of an edge are ordered");
    if (last) break;
    held = holds;
    begin = (*next++)[1];
  }
  return open;
}

void absorb_slivers(Spans& spans, double min) {
  if (spans.empty()) return;
  if (min >= 1) {
    double hidden = 0;
    for (const auto& span : spans) hidden += span[1] - span[0];
    spans = hidden > 0.5 ? Spans{{0.0, 1.0}} : Spans{};
    return;
  }
  std::size_t joined = 0;  // merged spans are written over those they are made of
  for (const auto& span : spans) {
    if (joined > 0 && span[0] - spans[joined - 1][1] < min)
      spans[joined - 1][1] = span[1];
    else
      spans[joined++] = span;
  }
  spans.resize(joined);
  std::erase_if(spans, [&](const auto& span) { return span[1] - span[0] < min; });
  if (spans.empty()) return;
  if (spans.front()[0] < min) spans.front()[0] = 0;
  if (1 - spans.back()[1] < min) spans.back()[1] = 1;
  check(is_ascending(spans), "the spans of an edge are ordered and on it");
}

}  // namespace epura::visibility
