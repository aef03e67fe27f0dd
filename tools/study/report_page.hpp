// SPDX-License-Identifier: Apache-2.0
// Reports of studies as pages for a browser, which show sheets.
#pragma once

#include <string>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::study {

/// One sheet above another, with the title of the first.
sheet::Sheet stacked(sheet::Sheet upper, sheet::Sheet lower);

/// A self-contained page (output::to_html) with the sheets, and a text beside them.
std::string report_page(const std::string& title, const std::vector<sheet::Sheet>& sheets, const std::string& notes);

}  // namespace epura::study
