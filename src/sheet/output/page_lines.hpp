// SPDX-License-Identifier: Apache-2.0
// The lines of a large drawing as arrays of numbers, for page/large.js.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// Whether a browser would be slow with an element for each line of the sheet.
bool is_large(const sheet::Sheet& sheet);

/// Whether a layer draws edges.
bool draws_edges(const sheet::Layer& layer);

/// JSON: all layers that draw edges, with the origin of their lines unless the page is `plain`. Arrays are base64, of
/// integers with as many bytes as they need (page/large.js reads them) or of 32-bit floats, little-endian. `points`:
/// steps from point to point, 0.0001 mm, y down. `heads`: 4 n + 2 (continuous) + 1 (closed) for n points. `kinds`:
/// indices of names. `edgeCounts`; `edges`: model, step from the last first vertex, step to the second one. `faces`:
/// their number, body, steps to the first two. Floats: `lengths`; `depths` of both ends, NaN if unknown. Throws
/// OutOfTime.
std::string packed_lines(const sheet::Sheet& sheet, bool plain, const Progress& progress);

}  // namespace epura::output
