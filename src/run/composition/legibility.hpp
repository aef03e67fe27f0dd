// SPDX-License-Identifier: Apache-2.0
// Judges whether the texts of a finished sheet can be read, by its ink alone: nothing of how it was placed.
#pragma once

#include <vector>

#include "report/report.hpp"
#include "sheet/sheet.hpp"

namespace epura::pipeline {

/// Texts that a line or another text goes through, texts of dimensions inside another view, and dimension lines and
/// leaders that cross. The ink of texts counts, not the room that is left around them; broken lines count as whole.
/// Each pair once, in the order of the layers.
std::vector<report::Finding> illegible_texts(const sheet::Sheet& sheet);

}  // namespace epura::pipeline
