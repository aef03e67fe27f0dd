// SPDX-License-Identifier: Apache-2.0
// Where a sheet is occupied, so that annotations stay clear of it.
#pragma once

#include <span>
#include <vector>

#include "composition/layout.hpp"
#include "dimensions/conflicts.hpp"
#include "sheet/furniture.hpp"
#include "sheet/sheet_layers.hpp"
#include "views/draw_view.hpp"

namespace epura::pipeline {

/// Adds the lines, areas and texts of a layer.
void add_boxes(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& layer, const sheet::Lettering& lettering);

/// Adds a box for each line of a layer: symbols have many short ones.
void add_outlines(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& symbols);

/// Objects on the sheet apart from the views.
sheet::Neighbours neighbours_of(const sheet::SheetFurniture& furniture, const std::vector<sheet::Text>& labels,
                                const std::vector<sheet::Layer>& marks, const sheet::Lettering& lettering);

/// The same with all views but one.
sheet::Neighbours with_other_views(sheet::Neighbours neighbours, std::span<const ViewResult> views, std::size_t view);

/// Adds the centre lines of all views; some reach far beyond their view.
void add_centre_lines(std::vector<sheet::TurnedBox>& boxes, const SheetInput& input, std::span<const ViewResult> views,
                      const sheet::Lettering& lettering);

/// The parts of a sheet on which no table may lie; of many boxes, the cells of a grid that they are in.
std::vector<sheet::Rectangle> taken_by(const sheet::Neighbours& around, std::span<const ViewResult> views);

}  // namespace epura::pipeline
