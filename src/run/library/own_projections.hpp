// SPDX-License-Identifier: Apache-2.0
// Projections of the calling program, as those of plugins.
#pragma once

#include <epura/own_projection.hpp>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura {

/// Throws Error{plugin} for tables that would be wrong in a plugin, too, and for two projections with one name.
std::vector<projection::ProjectionEntry> entries_of(const std::vector<OwnProjection>& projections);

}  // namespace epura
