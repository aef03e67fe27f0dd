// SPDX-License-Identifier: Apache-2.0
// Generates the manual page from the command line and the plugins.
#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/command_tree.hpp"
#include "projection/catalogue.hpp"

namespace epura {

/// Returns the source of a page of section 1, with the macros of man(7). Without projections, their section is omitted.
std::string manual_page(const CommandDescription& program, const ProgramTexts& texts,
                        const std::vector<projection::ProjectionEntry>& projections);

}  // namespace epura
