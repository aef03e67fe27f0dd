// SPDX-License-Identifier: Apache-2.0
// Plugins, their parameters and what tests of them found, as text for the terminal.
#pragma once

#include <string>
#include <vector>

#include "foreign/check_result.hpp"
#include "projection/catalogue.hpp"

namespace epura {

/// The value by default, as it may be given: "45", "0,0,1" or a word; empty if it is found from the model.
std::string usual_value(const projection::Parameter& parameter);

/// "default 45; 0..90 [deg]"
std::string values_text(const projection::Parameter& parameter);

/// Followed by at least one blank.
std::string padded(std::string text, std::size_t width);

/// A line, with control characters made visible.
void print(const std::string& line);
/// Two lines for each parameter.
void print_parameters(const std::vector<projection::Parameter>& parameters);
/// A line for the result of a test, and one for its fault.
void print_check(const foreign::CheckResult& result);

}  // namespace epura
