// SPDX-License-Identifier: Apache-2.0
// Metadata of a sheet.
#pragma once

#include <string>
#include <string_view>

#include "sheet/sheet.hpp"

namespace epura::output {

/// The value of a fact; empty if there is none.
std::string fact_of(const sheet::Sheet& sheet, std::string_view name);

/// Describes the views: "front 1:2, axonometric (isometric) 1:5".
std::string description_of(const sheet::Sheet& sheet);

}  // namespace epura::output
