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

/// A facet of a model: face number of the file.
struct FacetName {
  int model, face;
};

/// A point where the drawing is wrong.
struct Mismatch {
  std::string what;  ///< "drawn hidden", "drawn visible" or "not drawn"
  int model;
  std::array<int, 2> edge;        ///< vertex numbers of the file; {-1, -1} for an intersection line
  std::vector<FacetName> facets;  ///< of an intersection line: the two that cross
  double t;                       ///< 3D parameter along the edge
  Vec2 page;                      ///< mm
  std::optional<FacetName> hider;
  double length;  ///< of the span that it was found on, mm
};

/// Lines of one look, kind and range of lengths.
struct Stratum {
  bool visible;
  EdgeKind kind;
  double min;                    ///< spans are at least so long, in parts of the drawing's size
  double length = 0;             ///< of its spans together, mm
  int samples = 0;               ///< points drawn at random
  int undecided = 0, wrong = 0;  ///< of these
};

/// A line that is missing, or that should not be there.
struct OutlineFault {
  std::string what;               ///< "missing", "unfounded" or "doubled"
  Vec2 page;                      ///< mm; a place of it
  double length;                  ///< mm of the straight line through that place that are so
  int model;                      ///< -1: none
  std::array<int, 2> edge;        ///< vertex numbers of the file; {-1, -1} for none
  std::vector<FacetName> facets;  ///< seen on both sides of a line that is missing
};

/// Findings along random lines across the page: places that require a line, and visible ink.
struct OutlineCheck {
  int lines = 0;
  int asked = 0, missing = 0;               ///< places that require a line; those without ink
  int ink = 0, unfounded = 0, doubled = 0;  ///< places with ink; those without reason, and duplicate lines
  int undecided = 0;                        ///< wrong over too short a length
  double length = 0;                        ///< mm that one place represents
  double at_most = 1;                       ///< share of all these that is wrong, with a confidence of 95 %, one-sided
  std::vector<OutlineFault> worst;          ///< longest first, at most ten

  [[nodiscard]] int wrong() const { return missing + unfounded + doubled; }
};

struct Verification {
  int samples = 0;             ///< points at random, on which the estimates rest
  int points = 0;              ///< all that were tested: also middles and both sides of ends of the spans met
  int decided = 0, wrong = 0;  ///< of all points; what is neither decided nor wrong is undecided
  double length = 0;           ///< of all lines, mm, also of those that coincide
  double untested = 0;         ///< share of it in spans too short to be guaranteed
  double undecided = 0;        ///< estimated share
  double misclassified = 0;    ///< estimated share
  double at_most = 1;          ///< the same with a confidence of 95 %, one-sided
  std::vector<Stratum> strata;
  std::vector<Mismatch> worst;  ///< longest spans first, at most ten
  OutlineCheck outline;

  [[nodiscard]] bool is_right() const { return wrong == 0 && outline.wrong() == 0; }
};

}  // namespace epura::report
