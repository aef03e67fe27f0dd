// SPDX-License-Identifier: Apache-2.0
// The result of an independent test of a drawing. Filled by `verify`, printed as JSON and text.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "edges/edge_kind.hpp"

namespace epura::report {

/// A facet of a model, by its face number in the file.
struct FacetName {
  int model, face;
};

/// A point where the drawing is wrong.
struct Mismatch {
  std::string what;  ///< "drawn hidden", "drawn visible" or "not drawn"
  int model;
  std::array<int, 2> edge;        ///< vertex numbers in the file; {-1, -1} for an intersection line
  std::vector<FacetName> facets;  ///< for an intersection line: the two that cross
  double t;                       ///< 3D parameter along the edge
  Vec2 page;                      ///< mm
  std::optional<FacetName> hider;
  double length;  ///< of the span on which it was found, mm
};

/// Lines with a common visibility, kind and range of lengths.
struct Stratum {
  bool visible;
  EdgeKind kind;
  double min;                    ///< least length of the spans, as a fraction of the drawing's size
  double length = 0;             ///< total length of its spans, mm
  int samples = 0;               ///< random points
  int undecided = 0, wrong = 0;  ///< number of these points
};

/// A line that is missing, or that should not be there.
struct OutlineFault {
  std::string what;               ///< "missing", "unfounded" or "doubled"
  Vec2 page;                      ///< mm; a point on the line
  double length;                  ///< length of the faulty part of the straight line through that point, mm
  int model;                      ///< -1: none
  std::array<int, 2> edge;        ///< vertex numbers in the file; {-1, -1} for none
  std::vector<FacetName> facets;  ///< seen on both sides of a missing line
};

/// Findings along random lines across the page: positions that require a line, and visible ink.
struct OutlineCheck {
  int lines = 0;
  int asked = 0, missing = 0;               ///< positions that require a line; those without ink
  int ink = 0, unfounded = 0, doubled = 0;  ///< positions with ink; those without a reason, and duplicate lines
  int undecided = 0;                        ///< positions that are wrong over too short a length
  double length = 0;                        ///< mm that one position represents
  double at_most = 1;                       ///< upper bound for the fraction of these positions that is wrong, with a
                                            ///< confidence of 95 %, one-sided
  std::vector<OutlineFault> worst;          ///< longest first, at most ten

  [[nodiscard]] int wrong() const { return missing + unfounded + doubled; }
};

/// Ink that was not judged, and why.
struct Unjudged {
  std::string reason;  ///< "lines of threads"
  double length;       ///< mm
};

/// The ink that the user gets, judged where it is: whether there is a reason for it, and whether it is complete.
struct InkCheck {
  double error = 0;                 ///< how far lines may be from their reasons, mm
  double length = 0;                ///< of all ink, mm
  double judged = 0;                ///< of it, mm
  double by_surfaces = 0;           ///< of what was judged: ink of models whose surfaces are known, mm
  std::vector<Unjudged> unjudged;   ///< the rest
  double unfounded = 0;             ///< ink without a reason, mm
  double missing = 0;               ///< lines that triangles and surfaces require, but that have no ink, mm
  int faults = 0;                   ///< stretches of both
  std::vector<OutlineFault> worst;  ///< longest first, at most ten
};

struct Verification {
  int samples = 0;             ///< random points, on which the estimates are based
  int points = 0;              ///< all points tested: also the middles and both sides of the ends of the spans that
                               ///< were hit
  int decided = 0, wrong = 0;  ///< of all points; `decided` includes the wrong ones
  int either_way = 0;          ///< of the others: points with visible ink, which stays if they are hidden
  double length = 0;           ///< of all lines, including those that coincide, mm
  double untested = 0;         ///< fraction of it in spans too short to be guaranteed
  double undecided = 0;        ///< estimated fraction
  double misclassified = 0;    ///< estimated fraction
  double at_most = 1;          ///< upper bound for the same with a confidence of 95 %, one-sided
  std::vector<Stratum> strata;
  std::vector<Mismatch> worst;  ///< longest spans first, at most ten
  OutlineCheck outline;
  InkCheck ink;

  [[nodiscard]] int errors() const { return wrong + outline.wrong() + ink.faults; }
  /// Whether so many points tell something of the drawing that their being right says that it is right: half of them,
  /// counting those whose ink is right either way, and a tenth by their own answers.
  [[nodiscard]] bool is_conclusive() const { return 2 * (decided + either_way) >= points && 10 * decided >= points; }
  [[nodiscard]] bool is_right() const { return errors() == 0 && is_conclusive(); }
};

}  // namespace epura::report
