// SPDX-License-Identifier: Apache-2.0
// What every writer asks of a sheet: its facts, its views in words, its lettering, and where its texts begin.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// The value of a fact; empty if there is none.
std::string fact_of(const sheet::Sheet& sheet, std::string_view name);

/// Describes the views: "front 1:2, axonometric (isometric) 1:5".
std::string description_of(const sheet::Sheet& sheet);

/// The font if there are texts on the sheet: without text, no font is opened.
std::optional<sheet::Lettering> lettering_of(const sheet::Sheet& sheet);

/// Start of the base line of a text on the sheet, mm.
Vec2 start_of(const sheet::Text& text, const sheet::Lettering& lettering);

}  // namespace epura::output
