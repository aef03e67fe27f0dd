// SPDX-License-Identifier: Apache-2.0
#include "visibility/edge_spans.hpp"

namespace epura {

HiddenSpans gather(const std::vector<Spans>& by_edge) {
  HiddenSpans hidden;
  hidden.first.reserve(by_edge.size() + 1);
  hidden.first.push_back(0);
  for (const Spans& spans : by_edge) {
    hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
    hidden.first.push_back(hidden.spans.size());
  }
  return hidden;
}

}  // namespace epura
