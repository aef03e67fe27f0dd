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

/// Pages are not numbered here.
InkDifferences compare_ink(const Picture& before, const Picture& after, double tolerance);

struct TextDifferences {
  std::vector<Difference> differences{};
  std::vector<MarkedText> marked{};
};

/// Texts are the same that have the same words and boxes; one that has other words in its place was changed. Of the
/// others, one with the same words and size within 5 mm has moved.
TextDifferences compare_texts(const Picture& before, const Picture& after, double tolerance);

}  // namespace epura::compare
