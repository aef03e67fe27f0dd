// SPDX-License-Identifier: Apache-2.0
// Dashes as lines: for plotters, lasers and engravers, which draw every line from end to end.
#pragma once

#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The same ink in continuous strokes: each dash, and each dot, is a stroke with the origin of its line. Arcs stay
/// arcs.
Sheet with_real_dashes(Sheet sheet);

}  // namespace epura::sheet
