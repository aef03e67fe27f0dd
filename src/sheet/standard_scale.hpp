// SPDX-License-Identifier: Apache-2.0
// Standard scales: 1, 2 or 5 times powers of ten. ISO 5455.
#pragma once

#include <string>

namespace epura::sheet {

/// The largest standard scale that is not above `scale`, a positive number; one that is above by a rounding error only
/// counts as not above. Between 1:10^300 and 5*10^301:1.
double standard_scale_up_to(double scale);

/// "1:2", "5:1", "1:1": the scale as a ratio to one with at most three significant digits, standard or not ("1:2.5");
/// empty when it is none ("1:3.07263"), or
/// more than 10^9.
std::string ratio_text(double scale);

}  // namespace epura::sheet
