// SPDX-License-Identifier: Apache-2.0
#include "verify/confidence.hpp"

#include <cmath>

namespace epura::verify {

namespace {

// The probability of at most `failures` in `trials` trials that fail with probability p, 0 < p < 1.
double probability_of_so_few(int failures, int trials, double p) {
  double sum = 0;
  for (int k = 0; k <= failures; ++k)
    sum += std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) + k * std::log(p) +
                    (trials - k) * std::log1p(-p));
  return sum;
}

}  // namespace

double greatest_share(int failures, int trials, double confidence) {
  if (failures >= trials) return 1;
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (probability_of_so_few(failures, trials, middle) > 1 - confidence ? low : high) = middle;
  }
  return high;
}

}  // namespace epura::verify
