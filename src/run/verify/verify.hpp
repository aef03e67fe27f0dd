// SPDX-License-Identifier: Apache-2.0
// Tests a finished drawing independently.
//
// Two things can go wrong: an edge is split wrongly into visible and hidden spans, or a span does not reach the paper.
// Points are therefore drawn from the spans of all drawn edges before coincident lines are resolved, so that they cover
// every edge, even if another line is drawn in its place. Each point is judged by geometry (verify/judge.hpp), and then
// searched for among the segments of the drawing, which the user gets.
//
// Confidence: X wrong points of N, n_h of them in stratum h, whose share of the total length is W_h. The number of
// wrong points is a sum of independent trials, whose lower tail is bounded by a binomial with the mean share
// (Hoeffding, Ann. Math. Stat. 27, 1956, theorem 4); so with c = max_h W_h N / n_h the misclassified share is at most c
// times the bound of Clopper and Pearson for X of N. Undecided points are not part of that claim: their share is
// reported separately.
#pragma once

#include "base/progress.hpp"
#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// Tests `samples` random points. Trusts the drawing in nothing but its units. Hidden lines are searched for in the
/// drawing if `hidden_drawn`. Throws OutOfTime.
report::Verification verify(const VerifyInput& input, const Tolerance& tolerance, int samples, bool hidden_drawn,
                            const Progress& progress = {});

}  // namespace epura::verify
