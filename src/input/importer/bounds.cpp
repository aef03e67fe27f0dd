// SPDX-License-Identifier: Apache-2.0
#include "importer/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace epura::importer {

namespace {

constexpr double bytes_per_gigabyte = 1e9;

foreign::Parameter number(const std::string& name, const std::string& unit, const std::string& help, double least,
                          double most) {
  return {.name = name,
          .type = foreign::ParameterType::number,
          .unit = unit,
          .help = help,
          .choices = {},
          .initial = {std::numeric_limits<double>::quiet_NaN()},
          .min = least,
          .max = most};
}

}  // namespace

std::vector<foreign::Parameter> parameters_of_bounds() {
  return {number("memory", "GB", "that reading may take; by the size of the file unless given", 0.1, 1000),
          number("patience", "s", "that reading may go on without progress; by the size of the file unless given", 0.1,
                 1e6)};
}

bool is_bound(std::string_view parameter) {
  const std::vector<foreign::Parameter> rows = parameters_of_bounds();
  return std::any_of(rows.begin(), rows.end(), [&](const foreign::Parameter& row) { return row.name == parameter; });
}

Bounds given_bounds(const foreign::ParameterValues& values, const Bounds& usual) {
  const double memory = values[values.size() - 2][0], patience = values[values.size() - 1][0];
  return {std::isnan(memory) ? usual.memory : memory * bytes_per_gigabyte,
          std::isnan(patience) ? usual.patience : patience};
}

}  // namespace epura::importer
