// SPDX-License-Identifier: Apache-2.0
// One run from a scene to its sheets, for the program and the library.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "composition/finished_sheet.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "sizes/rebuilt_part.hpp"
#include "views/draw_view.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"

namespace epura::pipeline {

/// The connections of a run to its environment.
struct RunContext {
  const Messages& messages;
  Progress progress{};
  Stopwatch& watch;
};

struct DrawnScene {
  std::vector<FinishedSheet> sheets;  ///< most of the memory
  report::Report report;
  std::string answers;                          ///< to RunOptions::why and dump
  std::optional<sheet::RebuiltPart> rebuilt{};  ///< if requested, and possible
  scene::SceneDescription scene{};              ///< with the views that were added on request, and the model as it lies
};

/// Reads the models and draws all views. The scene must have models, named views and sheets. Several threads may draw
/// at the same time. Throws Error; OutOfTime if time is over before there is a line to show.
DrawnScene draw_scene(const scene::SceneDescription& scene, const RunOptions& options, const RunContext& context);

}  // namespace epura::pipeline
