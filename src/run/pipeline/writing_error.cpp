// SPDX-License-Identifier: Apache-2.0
#include "pipeline/writing_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "drawing/near_lines.hpp"
#include "report/error_budget.hpp"
#include "views/draw_view.hpp"
#include "views/view_error.hpp"

namespace epura::pipeline {

using report::ErrorTerm;

void choose_writing(output::VectorOptions& options, std::span<const Target> targets, double max_error, bool has_arcs) {
  const double allowed = row_of(ErrorTerm::writing).share * max_error;
  const auto holds = [&](const output::VectorOptions& tried) {
    return error_of_writing(targets, tried, has_arcs) <= allowed;
  };
  if (!options.decimals) {
    output::VectorOptions tried = options;
    tried.dpi = 1e9;  // the other choice is not to count
    for (tried.decimals = 1; *tried.decimals < output::max_decimals && !holds(tried);) ++*tried.decimals;
    options.decimals = tried.decimals;
  }
  if (!options.dpi) {
    constexpr double max_dpi = 1200;
    const double needed = 25.4 / std::numbers::sqrt2 / allowed;
    options.dpi = std::clamp(std::ceil(needed), output::usual_dpi, max_dpi);
  }
}

double error_of_writing(std::span<const Target> targets, const output::VectorOptions& options, bool has_arcs) {
  double largest = 0;
  for (const Target& target : targets) largest = std::max(largest, target.format->error(options, has_arcs));
  return largest;
}

std::string sentence_of_choices(double max_error, bool has_arcs, const output::VectorOptions& options) {
  const double curves = row_of(ErrorTerm::curves).share * max_error;
  return "max-error " + format_number(max_error) + " mm: lines merged within " +
         format_rounded(drawing::NearLines{join_within(max_error, ViewOptions{}.join_within)}.reach_in_all(), 3) +
         " mm, " + (has_arcs ? "arcs within " + format_rounded(curves, 3) + " mm, " : "") +
         std::to_string(options.decimals.value_or(output::usual_decimals)) +
         " decimals in SVG; hidden lines by the exact method\n";
}

}  // namespace epura::pipeline
