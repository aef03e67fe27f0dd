// SPDX-License-Identifier: Apache-2.0
// The report of the study as text, CSV, JSON, HTML, and as a sheet of plots.
#pragma once

#include <string>

#include "sheet/sheet.hpp"
#include "study/stability/limits.hpp"
#include "study/stability/report.hpp"

namespace epura::stability {

/// A table of all cases with the steps at which each way breaks; with `rows`, also every step.
std::string to_text(const Report& report, bool rows);

/// A table of where cases end, and why.
std::string to_text(std::span<const CaseLimit> limits);

/// One line for each quantity of each step and way.
std::string to_csv(const Report& report);

/// docs/reports.md. Seconds only with `timings`: otherwise the same report gives the same bytes.
std::string to_json(const Report& report, bool timings);

/// One self-contained page with tables and plots.
std::string to_html(const Report& report);

/// Errors over the parameter, with all cases on one sheet.
sheet::Sheet to_sheet(const Report& report);

/// A single case.
sheet::Sheet to_sheet(const CaseReport& report);

}  // namespace epura::stability
