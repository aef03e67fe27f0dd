// SPDX-License-Identifier: Apache-2.0
// How far the lines of a view may be from those of the part, in millimetres on paper, and why.
//
// Each stage replaces lines by others close by: a surface by facets, positions by rounded ones, two lines by one,
// chords by arcs. A term is the largest distance between the lines before and after; by the triangle inequality, the
// lines on paper are no farther from those of the part than the sum. Distances are those of Hausdorff between the
// visible lines: where a line ends a little too late, it ends beside the contour that should hide it, which is ink,
// too. What the user leaves out (lines within a surface, short creases) is not an error.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace epura::report {

enum class ErrorTerm : std::uint8_t {
  surface,
  intersections,
  contours,
  file,
  map,
  grid,
  hiding,
  merging,
  curves,
  writing
};

/// How the number is known.
enum class Evidence : std::uint8_t { bound, measured, estimated };
inline constexpr std::array evidence_names{"bound", "measured", "estimated"};

/// A row of the table of terms.
struct ErrorTermRow {
  const char* name;
  Evidence evidence;
  double share;       ///< of --max-error, up to which a setting may use it; 0 if no setting is chosen by it
  const char* cause;  ///< what moves lines
  const char* remedy;
};

/// By ErrorTerm. Of `surface`, the evidence is `estimated` where ViewError::estimated says so.
inline constexpr std::array<ErrorTermRow, 10> error_terms{{
    {"surface", Evidence::measured, 0, "facets instead of their surface",
     "export the model with finer facets, or draw it from STEP"},
    {"intersections", Evidence::estimated, 0, "facets of faces that cross at a small angle, or that a section grazes",
     "export the model with finer facets, or draw it from STEP"},
    {"contours", Evidence::estimated, 0, "contours that begin, end and are hidden as those of facets",
     "export the model with finer facets, or draw it from STEP"},
    {"file", Evidence::bound, 0, "coordinates rounded in the file", "export the model with more digits"},
    {"map", Evidence::bound, 0, "rounding in the projection", "move the model or the viewer"},
    {"grid", Evidence::bound, 0, "lines that coincide on the page lattice", "draw a part of the scene"},
    {"hiding", Evidence::bound, 0, "spans too short to decide whether they are hidden", "draw a part of the scene"},
    {"merging", Evidence::measured, 0.2, "lines left out beside others", "lower --join-within"},
    {"curves", Evidence::measured, 0.35, "arcs instead of chords", "lower --arcs, or leave it out"},
    {"writing", Evidence::bound, 0.05, "rounding in the file that is written", "raise --decimals, or --dpi"},
}};

constexpr std::size_t index_of(ErrorTerm term) { return static_cast<std::size_t>(term); }
constexpr const ErrorTermRow& row_of(ErrorTerm term) { return error_terms[index_of(term)]; }

/// The terms of a view, mm on paper.
struct ViewError {
  std::string view;                             ///< its name
  std::array<double, error_terms.size()> mm{};  ///< by ErrorTerm
  bool estimated = false;                       ///< the surface is not known: its height is estimated from the folds

  double& operator[](ErrorTerm term) { return mm[index_of(term)]; }
  double operator[](ErrorTerm term) const { return mm[index_of(term)]; }
  [[nodiscard]] double total() const {
    double sum = 0;
    for (const double one : mm) sum += one;
    return sum;
  }
  /// Of two parts of a view, the worse one counts, term by term.
  void take_larger(const ViewError& other) {
    estimated = other.mm[0] > mm[0] ? other.estimated : estimated;
    for (std::size_t i = 0; i < mm.size(); ++i) mm[i] = std::max(mm[i], other.mm[i]);
  }
  [[nodiscard]] ErrorTerm dominant() const {
    return static_cast<ErrorTerm>(std::max_element(mm.begin(), mm.end()) - mm.begin());
  }
  [[nodiscard]] Evidence evidence(ErrorTerm term) const {
    return term == ErrorTerm::surface && estimated ? Evidence::estimated : row_of(term).evidence;
  }
};

}  // namespace epura::report
