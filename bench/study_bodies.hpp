// SPDX-License-Identifier: Apache-2.0
// The bodies of `epura study paper` as shapes of Open CASCADE, from their descriptions (study::describe_bodies).
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <vector>

namespace epura::bench {

/// One shape for each row of the text; nothing if one of them is of a kind that Open CASCADE lacks.
std::optional<std::vector<TopoDS_Shape>> bodies_of(const std::string& text);

}  // namespace epura::bench
