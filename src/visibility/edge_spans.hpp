// SPDX-License-Identifier: Apache-2.0
// Hidden spans found edge by edge, as one list.
#pragma once

#include <vector>

#include "visibility/spans.hpp"
#include "visibility/visibility.hpp"

namespace epura {

/// The spans of all edges in their order; nothing is undecided.
HiddenSpans gather(const std::vector<Spans>& by_edge);

}  // namespace epura
