// SPDX-License-Identifier: Apache-2.0
// Standard scales: 1, 2 or 5 times powers of ten. ISO 5455.
#pragma once

#include <string>

namespace epura::sheet {

/// The largest standard scale that is not above `scale`, a positive number, apart from a rounding error. Between
/// 1:10^300 and 5*10^301:1.
double standard_scale_up_to(double scale);

/// The standard scale above a standard scale.
double next_standard_scale(double standard);

/// The standard scale nearest to `scale` in proportion.
double nearest_standard_scale(double scale);

/// The scale as a ratio with one side 1 and at most three significant digits, standard or not ("1:2", "5:1", "1:1",
/// "1:2.5"); empty if there is none ("1:3.07263") or if it exceeds 10^9.
std::string ratio_text(double scale);

}  // namespace epura::sheet
