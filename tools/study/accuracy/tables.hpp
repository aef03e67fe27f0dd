// SPDX-License-Identifier: Apache-2.0
// Measurements as a table.
#pragma once

#include <span>

#include "study/accuracy/measure.hpp"
#include "study/table.hpp"

namespace epura::study {

/// A row for each method with each set of parameters.
Table table_of(std::span<const ViewMeasurements> views);

}  // namespace epura::study
