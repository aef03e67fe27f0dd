// SPDX-License-Identifier: Apache-2.0
// The revisions of a sheet, in a list on the title block. ISO 7200.
#pragma once

#include <string>
#include <vector>

#include "scene/description.hpp"
#include "sheet/lettering.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

struct RevisionList {
  std::vector<scene::RevisionDescription> rows;  ///< the first one is at the bottom
  std::string language{};                        ///< of the captions
};

/// Adds lines and texts. Dates and authors have columns if some revision has one. Returns warnings about texts that
/// were cut.
std::vector<std::string> draw_revisions(Layer& layer, const RevisionList& list, const Rectangle& box,
                                        const Lettering& lettering);

/// Writes the list of a sheet again, with as many rows and the same columns as before.
std::vector<std::string> rewrite_revisions(std::vector<Layer>& layers, const RevisionList& list,
                                           const Lettering& lettering);

}  // namespace epura::sheet
