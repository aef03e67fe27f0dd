// SPDX-License-Identifier: Apache-2.0
// The lines of type 04.1 in a view: centre lines, what divides a half section, axes of symmetry.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "sheet/sheet_layers.hpp"
#include "views/draw_view.hpp"

namespace epura::pipeline {

/// Returns one layer, or none if the view has no such lines. Centre lines give way to the layers `lines`.
/// Throws OutOfTime.
std::vector<sheet::Layer> centre_layers(const ViewResult& view, const ViewOptions& options,
                                        const sheet::LineWidths& widths, std::span<const sheet::Layer> lines,
                                        const Progress& progress = {});

}  // namespace epura::pipeline
