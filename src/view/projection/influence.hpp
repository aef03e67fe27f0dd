// SPDX-License-Identifier: Apache-2.0
// Which parameters of a projection set what it consists of, found by trying other values: no plugin needs to say so.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// What a projection consists of, as in epura_view.
enum class Quantity { point, normal, up, projector, scale, window, front, back };
inline constexpr std::size_t quantities = 8;

/// The names of the parameters that change each quantity, in the order of the table.
using Influence = std::array<std::vector<std::string>, quantities>;

/// Values that the plugin rejects change nothing. Throws Error as `make_projection` does.
Influence influence_of(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene);

}  // namespace epura::projection
