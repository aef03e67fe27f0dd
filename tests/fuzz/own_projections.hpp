// SPDX-License-Identifier: Apache-2.0
// The projections of the installation, loaded into this process, where their faults are seen.
#pragma once

#include <vector>

#include "projection/catalogue.hpp"

namespace epura::fuzz {

const std::vector<projection::ProjectionEntry>& own_projections();

}  // namespace epura::fuzz
