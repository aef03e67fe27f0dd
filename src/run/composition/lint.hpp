// SPDX-License-Identifier: Apache-2.0
// Checks the dimensions of a whole drawing against the features of its models.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "composition/annotations.hpp"
#include "composition/finished_sheet.hpp"
#include "composition/free_face_layer.hpp"
#include "definition/rules.hpp"
#include "report/report.hpp"
#include "sizes/coverage.hpp"
#include "view/projected_scene.hpp"
#include "views/messages.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// The dimensions of a sheet by view; `seen` and `annotations` are in the order of the views. Throws Error{input}: see
/// sizes/anchors.hpp.
std::vector<sheet::DimensionsInView> anchored_dimensions(const world::World& world, const SheetOfViews& sheet,
                                                         std::span<const view::ProjectedScene> seen,
                                                         std::span<const Annotations> annotations);

/// Takes out dimensions by their numbers in each view.
void leave_out(std::span<sheet::DimensionsInView> views, std::span<const std::vector<std::size_t>> numbers);

/// Faces of a model that a scene accepts as they are.
struct AcceptedFaces {
  int model;
  std::string feature;  ///< "face 12"
  std::vector<int> faces;
  std::string reason;
};

/// Sheets that are judged: what they show, and their dimensions.
struct JudgedSheets {
  const world::World& world;
  const scene::SceneDescription& scene;
  std::span<const sheet::DimensionsInView> views;
};

/// What readers of the sheets know beside their numbers.
struct Granted {
  std::span<const AcceptedFaces> accepted;
  definition::RuleSet rules;
};

/// Adds to a report the sizes of features that have no dimension, or several; the faces that the dimensions leave free,
/// how many they hold, and which dimensions follow from others. What is accepted of the face by which it is named, is
/// no fault. Returns the others. Throws OutOfTime.
HatchedFaces add_missing_sizes(report::Report& report, const JudgedSheets& sheets, const Granted& granted,
                               const Progress& progress);

/// Views, as in --projection, that show sizes which no dimension gives for want of one.
std::vector<std::string> views_for_sizes(const JudgedSheets& sheets, const Progress& progress);

/// Adds what of the finished sheets cannot be read (legibility.hpp).
void add_illegible_texts(report::Report& report, std::span<const FinishedSheet> sheets);

/// Tells which of them nothing is found of.
void warn_of_vain(const Messages& messages, std::span<const AcceptedFaces> accepted,
                  std::span<const report::Finding> findings);

/// Adds the requirements that the sheets lack to the findings, and `views` that would show some to those to add.
void add_missing_requirements(report::Report& report, std::span<const std::string> views);

/// Models whose faces are not recognised, and faces of free form, that neither a tolerance nor a note gives.
std::vector<report::Finding> undefined_free_forms(const world::World& world, const scene::SceneDescription& scene,
                                                  bool noted);

}  // namespace epura::pipeline
