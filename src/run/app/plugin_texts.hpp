// SPDX-License-Identifier: Apache-2.0
// Formats plugins, their parameters and their test results for the terminal.
#pragma once

#include <string>
#include <vector>

#include "foreign/check_result.hpp"
#include "projection/catalogue.hpp"

namespace epura {

/// Returns the default value in the form accepted as input: "45", "0,0,1" or a word; empty if it is derived from the
/// model.
std::string usual_value(const projection::Parameter& parameter);

/// "default 45; 0..90 [deg]"
std::string values_text(const projection::Parameter& parameter);

/// Pads `text` with blanks, at least one.
std::string padded(std::string text, std::size_t width);

/// Prints a line, with control characters made visible.
void print(const std::string& line);
/// Prints two lines for each parameter.
void print_parameters(const std::vector<projection::Parameter>& parameters);
/// Prints a line with the result of a test, and one with its fault.
void print_check(const foreign::CheckResult& result);

}  // namespace epura
