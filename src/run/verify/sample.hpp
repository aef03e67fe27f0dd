// SPDX-License-Identifier: Apache-2.0
// Chooses the tested points of a drawing.
#pragma once

#include <array>
#include <vector>

#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/judge.hpp"
#include "verify/probe_grid.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// A drawn edge as a line of the page, and how to get from places on it to places in space.
struct PageLine {
  double length;            ///< mm; 0 if positions in space cannot be distinguished well enough
  std::array<double, 2> t;  ///< of its ends
  std::array<double, 2> w;  ///< distances of the ends from the centre; 1 in parallel views

  /// 3D parameter of the page parameter `s`, 0 to 1 (seed 003, perspective division).
  [[nodiscard]] double t_at(double s) const;
};

struct TestedSpan {
  int edge;
  double from, to;  ///< page parameters
  bool visible;     ///< as drawn
  int stratum;      ///< -1: too short to be guaranteed
};

/// Everything that is drawn.
struct Population {
  std::vector<PageLine> lines;  ///< of the drawn edges
  std::vector<TestedSpan> spans;
  std::vector<report::Stratum> strata;
  double length = 0;  ///< mm

  [[nodiscard]] double length_of(const TestedSpan& span) const {
    return (span.to - span.from) * lines[span.edge].length;
  }
};

/// A point, and the span of the population that it belongs to.
struct Sample {
  int span;
  double s;        ///< page parameter along the edge
  bool at_random;  ///< one of those that represent the total length
};

/// Spans shorter than this fraction of the drawing are not guaranteed.
inline constexpr double guaranteed = 1e-6;

Population population_of(const VerifyInput& input, const Viewing& viewing, const Tolerance& tolerance,
                         const PageFrame& frame);

/// Returns `count` random points (with a fixed seed): half of them spread evenly over the strata, half in proportion to
/// their lengths; within a stratum, every place on its lines is equally likely. Adds, for each span that was hit, its
/// middle and the places 1e-6 of the drawing's size to either side of both ends. Notes in the strata how many random
/// points they got.
std::vector<Sample> draw_samples(Population& population, const Tolerance& tolerance, int count);

/// Returns the probe at page parameter `s` of an edge.
Probe probe_at(const Population& population, int edge, double s);

}  // namespace epura::verify
