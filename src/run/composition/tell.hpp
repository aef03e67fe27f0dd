// SPDX-License-Identifier: Apache-2.0
// Messages about the results of a run.
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "composition/annotations.hpp"
#include "composition/layout.hpp"
#include "report/report.hpp"
#include "sheet/sheet.hpp"
#include "views/draw_view.hpp"
#include "views/messages.hpp"

namespace epura::pipeline {

/// Of a sheet on which not all has the usual room.
void warn_about(const Messages& messages, const SheetPlan& plan);

/// Tells the scale that was found, which is of ISO 5455 or as large as possible, and warns of others that are given.
void tell_of_scales(const Messages& messages, const SheetPlan& plan, const scene::SheetDescription& sheet,
                    const SheetOfViews& views);

/// The first of many texts: "'⌀8', '20', '30' and 3 others (epura lint lists all)".
std::string first_of(const std::vector<std::string>& texts);

/// Warns of places of parts that are too many for a view.
void warn_of_unplaced(const Messages& messages, const std::vector<Annotations>& by_view);

/// Warns of each [[dimension]] whose pattern no automatic size matches. Returns whether there is one.
bool warn_of_unmatched(const Messages& messages, const scene::SceneDescription& scene, MatchedSizes sizes);

/// Warns of a view without lines of the selected kinds, or without any in its window. Throws Error{input} for a view
/// that should have lines, but has lost all of them in the rounding of coordinates.
void warn_if_empty(const Messages& messages, const ViewResult& result, const ViewInput& input);
void warn_about(const Messages& messages, const ViewResult& result);
void warn_about(const Messages& messages, const report::Partial& partial);
/// The error if the time limit leaves nothing to show.
Error nothing_drawn(const std::string& stage);
/// Warns if the map of a view preserves few digits.
void warn_about(const Messages& messages, const report::ViewCondition& view);
/// Warns of characters missing from the font.
void warn_about(const Messages& messages, const sheet::Sheet& sheet);

/// Tells which requirements of model files the sheets lack, and why; it is a fault unless that is allowed.
void tell_of_requirements(const Messages& messages, const std::vector<report::RequirementRow>& rows, bool is_allowed);

/// A line about the precision of the map of a view.
std::string format_condition(const report::ViewCondition& view);

/// Prints the number of curves found in the lines.
void tell_of_curves(const Messages& messages, const std::vector<ViewResult>& results);
void tell_timings(const Messages& messages, const Stopwatch& watch);

}  // namespace epura::pipeline
