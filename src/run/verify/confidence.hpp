// SPDX-License-Identifier: Apache-2.0
// Confidence bounds of a sample.
#pragma once

namespace epura::verify {

inline constexpr double stated_confidence = 0.95;  ///< of the bounds in reports

/// Returns the greatest share of failures that is possible at `confidence` (0 to 1) given `failures` in `trials`
/// independent trials: the p at which so few failures have probability 1 - confidence. Exact (Clopper & Pearson,
/// Biometrika 26, 1934), one-sided; without failures 1 - (1 - confidence)^(1 / trials), the "rule of three".
double greatest_share(int failures, int trials, double confidence);

}  // namespace epura::verify
