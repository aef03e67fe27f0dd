// SPDX-License-Identifier: Apache-2.0
// Converts between the library's plain values and those of the stages.
#pragma once

#include <epura/epura.hpp>
#include <vector>

#include "drawing/view_drawing.hpp"
#include "pipeline/options.hpp"
#include "report/error_budget.hpp"
#include "scene/description.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Error locations are members of the scene: "models[0].faces[3]". Throws Error{input} for meaningless values.
scene::SceneDescription describe_scene(const Scene& scene);

/// Throws Error{input} for values outside their range.
pipeline::RunOptions run_options_of(const Settings& settings);

/// `sheet` counts from 1.
DrawnView drawn_view(const drawing::ViewDrawing& drawing, int sheet);

/// Without the term of writing, which depends on the file.
ErrorBudget error_budget(const report::ViewError& error);

std::vector<SheetLayer> layers_of(const sheet::Sheet& sheet);

}  // namespace epura
