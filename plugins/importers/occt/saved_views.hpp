// SPDX-License-Identifier: Apache-2.0
// Views that a STEP file has stored (ISO 10303-46: cameras), as its entities state them.
#pragma once

#include <STEPControl_Reader.hxx>
#include <string>
#include <string_view>
#include <vector>

#include "model.hpp"

namespace occt {

/// In the order of the file, of which `text` is the content. Names that are empty or there twice get a number. What
/// cannot be understood of a camera is left out, and said in a sentence that is added to `notes`.
std::vector<SavedView> saved_views_of(const STEPControl_Reader& reader, std::string_view text,
                                      std::vector<std::string>& notes);

}  // namespace occt
