// SPDX-License-Identifier: Apache-2.0
// Projections and their parameters as text.
#pragma once

#include <string>

#include "projection/catalogue.hpp"

namespace epura {

/// The value by default, as it may be given: "45", "0,0,1" or a word; empty if it is found from the model.
std::string usual_value(const projection::Parameter& parameter);

/// "default 45; 0..90 [deg]"
std::string values_text(const projection::Parameter& parameter);

}  // namespace epura
