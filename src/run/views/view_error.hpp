// SPDX-License-Identifier: Apache-2.0
// The settings that keep the error of a view below --max-error.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "report/error_budget.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"

namespace epura::pipeline {

// What --max-error chooses.

/// Returns the distance within which lines are merged, mm.
double join_within(double max_error, double usual);
/// Refuses a --max-error that is below what is certain of any drawing. `part`: it, as a fraction of the largest
/// drawing; 0: unknown. Throws Error{input}.
void expect_certain(double max_error, double part);

/// What is drawn, as far as it decides on finer facets.
struct Facets {
  double triangles;  ///< of all models
  bool is_imported;  ///< some may be asked to be finer
};

/// An attempt whose lines are farther off than --max-error.
struct TooFar {
  report::ViewError worst;
  double least;  ///< the --max-error that it keeps, mm: what is chosen by it keeps to its share
  Facets facets;
  double beyond_facets = 0;  ///< of a view, what the finest facets would leave, mm
};

/// Throws TooFar if a view is farther off than --max-error.
void expect_within(double max_error, bool has_arcs, std::span<const report::ViewError> errors, const Facets& facets);

/// By what facets should be finer to keep --max-error and still be made in about a minute: by a factor, or by its root,
/// or by no more than 1. From facets as coarse as is usual on, their number grows as it did at the last step.
double finer_by(const TooFar& attempt, const std::optional<TooFar>& last, double factor);

/// Refuses --max-error, and names the value that the best attempt keeps. Throws Error{input}.
[[noreturn]] void refuse(double max_error, const TooFar& best);

/// "front: lines are within 0.021 mm of the part; most of it, 0.02 mm, by facets instead of their surface (measured)"
std::string sentence_of(const report::ViewError& error);

}  // namespace epura::pipeline
