// SPDX-License-Identifier: Apache-2.0
// Values with units in a STEP file, in millimetres and degrees.
#pragma once

#include <limits>
#include <string>

#include "step_graph.hpp"

namespace occt {

struct Measure {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< mm or degrees; NaN: none, or its unit is not known
  double unit = 0;                                          ///< of the file, in mm or degrees
  bool is_angle = false;
  bool has_unit = true;   ///< false: it has a number in a unit that is not known
  int decimals = -1;      ///< that are to be shown in the unit of the file; -1: the file does not say
  std::string name;       ///< "nominal value"
  std::string qualifier;  ///< "maximum"
};

/// The measure with this number. Its value is NaN if there is none.
Measure measure_of(const StepGraph& graph, EntityNumber number);

/// The unit of length of a context of representations, in mm; NaN: it states none.
double length_unit_of(const StepGraph& graph, EntityNumber context);

/// The unit of length of the first context in a file that states one, in mm; 1 if none does.
double length_unit_in(const StepGraph& graph);

/// Adds what these qualifiers say of a measure.
void qualify(Measure& measure, const StepGraph& graph, const std::vector<EntityNumber>& qualifiers);

/// The number at the beginning of a text, or in parentheses, as in "LENGTH_MEASURE(35.)"; NaN if there is none.
double number_in(std::string_view text);

/// A length in mm, with the digits of an exact number of inches.
std::string printed_length(double value);

}  // namespace occt
