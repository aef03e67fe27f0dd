// SPDX-License-Identifier: Apache-2.0
// The lettering of a sheet, and where its texts begin, for all writers.
#pragma once

#include <optional>

#include "base/vec.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// The font if there are texts on the sheet: without text, no font is opened.
std::optional<sheet::Lettering> lettering_of(const sheet::Sheet& sheet);

/// Start of the base line of a text on the sheet, mm.
Vec2 start_of(const sheet::Text& text, const sheet::Lettering& lettering);

}  // namespace epura::output
