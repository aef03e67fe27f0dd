// SPDX-License-Identifier: Apache-2.0
// Differences between the lines and texts of two pages.
#pragma once

#include <vector>

#include "compare/comparison.hpp"

namespace epura::compare {

struct InkDifferences {
  std::vector<Difference> differences{};
  std::vector<MarkedPiece> marked{};
};

/// The differences have no page numbers yet.
InkDifferences compare_ink(const Picture& before, const Picture& after, double tolerance);

struct TextDifferences {
  std::vector<Difference> differences{};
  std::vector<MarkedText> marked{};
};

/// Texts with the same words and boxes are the same; a text with other words at the same position was changed. Of the
/// others, a text with the same words and size within 5 mm has moved.
TextDifferences compare_texts(const Picture& before, const Picture& after, double tolerance);

}  // namespace epura::compare
