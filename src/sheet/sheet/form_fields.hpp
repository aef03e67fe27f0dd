// SPDX-License-Identifier: Apache-2.0
// Which fields of a title block the texts of templates are.
#pragma once

#include <string>
#include <vector>

#include "svg/artwork.hpp"

namespace epura::sheet {

/// The named fields, and those that the sheet has by itself.
std::vector<std::string> known_fields();

/// A field as forms name it: "Surface treatment" -> "surface_treatment".
std::string form_name(const std::string& field);

/// The name of the field of a text. Names that are usual in FreeCAD's templates, in several languages, become those of
/// the known fields: "AUTHOR_NAME" -> "creator".
std::string field_of(const svg::Words& words);

}  // namespace epura::sheet
