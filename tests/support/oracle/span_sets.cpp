// SPDX-License-Identifier: Apache-2.0
#include "oracle/span_sets.hpp"

#include <algorithm>

namespace epura {

visibility::Spans hidden_parts(const visibility::HiddenSpans& hidden, std::size_t e) {
  const auto at = [&](std::size_t i) { return hidden.spans.begin() + static_cast<std::ptrdiff_t>(hidden.first[i]); };
  return {at(e), at(e + 1)};
}

visibility::HiddenSpans gather(const std::vector<visibility::Spans>& by_edge) {
  visibility::HiddenSpans hidden;
  hidden.first.reserve(by_edge.size() + 1);
  hidden.first.push_back(0);
  for (const visibility::Spans& spans : by_edge) {
    hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
    hidden.first.push_back(hidden.spans.size());
  }
  return hidden;
}

visibility::Spans common(const visibility::Spans& a, const visibility::Spans& b) {
  visibility::Spans both;
  for (auto i = a.begin(), k = b.begin(); i != a.end() && k != b.end();) {
    const double from = std::max((*i)[0], (*k)[0]), to = std::min((*i)[1], (*k)[1]);
    if (from < to) both.push_back({from, to});
    ++((*i)[1] < (*k)[1] ? i : k);
  }
  return both;
}

visibility::Spans without(const visibility::Spans& a, const visibility::Spans& b) {
  visibility::Spans rest;
  auto cut = b.begin();
  for (const auto& [begin, end] : a) {
    double from = begin;
    while (cut != b.end() && (*cut)[1] <= from) ++cut;
    for (auto next = cut; next != b.end() && (*next)[0] < end; ++next) {
      if ((*next)[0] > from) rest.push_back({from, (*next)[0]});
      from = (*next)[1];
    }
    if (from < end) rest.push_back({from, end});
  }
  return rest;
}

visibility::Spans united(visibility::Spans a, const visibility::Spans& b) {
  for (const auto& span : b) visibility::add_span(a, span);
  return a;
}

}  // namespace epura
