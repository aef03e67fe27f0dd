// SPDX-License-Identifier: Apache-2.0
// Numbers, threads and classes of tolerances at the beginning of a text.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace epura::sheet {

struct NumberText {
  double value;
  double slack;  ///< half a unit of its last digit; of fractions, of 1/64
  bool has_decimals;
  std::size_t bytes;
};

/// Without a sign: "12", ".315", and in front of a sign of inches, which is not part of it, "3 5/32".
std::optional<NumberText> number_at(std::string_view text);

struct UnitText {
  double millimetres;
  std::size_t bytes;
};

/// "mm", " in", and the signs of inches.
std::optional<UnitText> unit_at(std::string_view text);

/// In degrees, with minutes and seconds behind their sign: "30°", "9°59'60\"".
std::optional<NumberText> degrees_at(std::string_view text);

struct DeviationsText {
  std::vector<double> values;  ///< in their order; 0 for both of "±"
  std::size_t bytes = 0;
};

/// "±0.1", "+0.2 -0.1", "+2/+1.5", "0/-0.1", in whatever unit; none if there are none.
DeviationsText deviations_at(std::string_view text);

struct ThreadText {
  double diameter, pitch;  ///< mm; pitch 0: not known
  std::size_t bytes;
};

/// "M6", "M6×0.75 - 6H", "G1/4", "5/16-18 UNC-2B", "UNF 10-32", "M8-LH".
std::optional<ThreadText> thread_at(std::string_view text);

/// The bytes of a class of ISO 286, or of those of a fit: "H7", "H7/g6"; 0 if there is none.
std::size_t fit_at(std::string_view text);

}  // namespace epura::sheet
