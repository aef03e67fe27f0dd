// SPDX-License-Identifier: Apache-2.0
#include "views/view_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "accuracy/view_error.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/near_lines.hpp"
#include "report/format.hpp"

namespace epura::pipeline {

namespace {

using report::ErrorTerm;

std::string millimetres(double length) { return report::rounded_up(length) + " mm"; }

// What does not depend on what is drawn, and so on no facets.
double bound_of(const report::ViewError& error) {
  double bound = 0;
  for (std::size_t i = 0; i < error.mm.size(); ++i)
    if (row_of(static_cast<ErrorTerm>(i)).evidence == report::Evidence::bound) bound += error.mm[i];
  return bound;
}

// The least --max-error that a view keeps which was drawn with `max_error`, mm.
double least_max_error(const report::ViewError& error, double max_error, bool has_arcs) {
  double fixed = 0, shares = 0;
  for (std::size_t i = 0; i < error.mm.size(); ++i) {
    const auto term = static_cast<ErrorTerm>(i);
    const bool is_chosen = term == ErrorTerm::merging || term == ErrorTerm::writing ||
                           (term == ErrorTerm::curves && has_arcs);  // by max_error, unless it was given
    const double share = is_chosen ? row_of(term).share : 0;
    const bool keeps_share = is_chosen && error[term] <= share * max_error;
    fixed += keeps_share ? 0 : error[term];
    shares += keeps_share ? share : 0;
  }
  return fixed / (1 - shares);
}

}  // namespace

double join_within(double max_error, double usual) {
  return std::min(usual, row_of(ErrorTerm::merging).share * max_error / drawing::NearLines{1}.reach_in_all());
}

void expect_certain(double max_error, double part) {
  if (part <= 0 || part >= accuracy::guaranteed_part) return;
  throw Error(ErrorKind::input, "--max-error",
              "is " + format_number(max_error) + " mm, but below " +
                  format_rounded(max_error * accuracy::guaranteed_part / part, 1) +
                  " mm no part of a line shorter than a millionth of the drawing is certain to be visible or hidden",
              "raise --max-error well above that: the nearer to it, the longer importers take");
}

void expect_within(double max_error, bool has_arcs, std::span<const report::ViewError> errors, const Facets& facets) {
  const auto worst = std::max_element(errors.begin(), errors.end(),
                                      [](const auto& one, const auto& other) { return one.total() < other.total(); });
  if (worst == errors.end() || worst->total() <= max_error) return;
  TooFar attempt{*worst, 0, facets};
  for (const report::ViewError& error : errors) {
    attempt.least = std::max(attempt.least, least_max_error(error, max_error, has_arcs));
    attempt.beyond_facets = std::max(attempt.beyond_facets, bound_of(error));
  }
  throw attempt;
}

double finer_by(const TooFar& attempt, const std::optional<TooFar>& last, double factor) {
  constexpr double most_triangles = 250'000;
  constexpr double least_gain = 0.9;  // above, what is off is not off by facets
  if (!attempt.facets.is_imported || (last && attempt.least > least_gain * last->least)) return 1;
  const double growth = last ? attempt.facets.triangles / last->facets.triangles : factor;
  if (growth * attempt.facets.triangles <= most_triangles) return factor;
  return std::sqrt(growth) * attempt.facets.triangles <= most_triangles ? std::sqrt(factor) : 1;
}

void refuse(double max_error, const TooFar& best) {
  const report::ViewError& error = best.worst;
  constexpr double above_rounding = 1.5;  // to one digit
  const ErrorTerm most = error.dominant();
  const bool by_facets = most == ErrorTerm::surface || most == ErrorTerm::intersections || most == ErrorTerm::contours;
  throw Error(ErrorKind::input, "--max-error",
              "is " + format_number(max_error) + " mm, but lines of view '" + error.view + "' may be off by " +
                  millimetres(error.total()) + "; " + millimetres(error[most]) + " of it by " + row_of(most).cause,
              "raise --max-error to " + format_rounded(above_rounding * best.least, 1) + " mm, or " +
                  (by_facets && best.facets.is_imported ? "draw at a smaller scale" : row_of(most).remedy));
}

std::string sentence_of(const report::ViewError& error) {
  const ErrorTerm most = error.dominant();
  return error.view + ": lines are within " + millimetres(error.total()) + " of the part; most of it, " +
         millimetres(error[most]) + ", by " + row_of(most).cause + " (" +
         report::evidence_names[static_cast<std::size_t>(error.evidence(most))] + ")\n";
}

}  // namespace epura::pipeline
