// SPDX-License-Identifier: Apache-2.0
// Formats the findings of a run as sentences.
#pragma once

#include <span>
#include <string>

#include "report/report.hpp"

namespace epura::report {

/// One sentence per line.
std::string format_verification(const Verification& verification);

/// An error in millimetres, to three digits, and no less than it is.
std::string rounded_up(double millimetres);

/// A table of the terms of the views, one row for each; terms that are 0 everywhere are left out.
std::string format_errors(std::span<const ViewError> errors);

}  // namespace epura::report
