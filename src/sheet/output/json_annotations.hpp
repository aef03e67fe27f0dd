// SPDX-License-Identifier: Apache-2.0
// What stands on a sheet beside its views, as data: dimensions, notes, tolerance frames, tables, title fields.
#pragma once

#include <string>

#include "sheet/sheet.hpp"

namespace epura::output {

/// An object in JSON; empty if the sheet has no dimension, note, frame or table. Schema: annotations.schema.json.
/// Positions in mm on paper, y up; values in the unit of dimensions, angles in degrees.
std::string json_of_annotations(const sheet::Sheet& sheet);

}  // namespace epura::output
