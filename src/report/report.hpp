// SPDX-License-Identifier: Apache-2.0
// Findings of a run: repairs, stages that ran, what the time limit cut short, condition of views, verification.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "report/verification.hpp"
#include "view/condition.hpp"

namespace epura::report {

/// What a stage took and what leaving it out saves, in seconds.
struct PlanTimes {
  std::optional<double> certificate;  ///< to find out whether it can be left out; nothing where that takes no time
  std::optional<double> stage;        ///< where it ran and was timed
  std::optional<double> estimated;    ///< saved, by what an item usually takes
  std::optional<double> measured;     ///< saved, by runs with and without it
};

/// One stage of the plan, for the report.
struct PlanStep {
  std::string stage;
  bool run;
  std::string why;  ///< why it ran or was skipped
  long long items_in = 0, items_out = 0;
  std::string view{};   ///< empty for what is done once
  long long skipped{};  ///< number of items skipped by a shortcut
  PlanTimes times{};    ///< empty unless requested: outputs are byte-stable
};

/// What a time limit left undone.
struct Partial {
  std::vector<std::string> stages{};   ///< that were cut, as progress names them; none: all is done
  long long edges = 0, undecided = 0;  ///< undecided edges are not drawn
  double searched = 1;                 ///< part of the search for intersection lines that was done, 0 to 1
  long long undrawn = 0;               ///< lines of decided edges, and dimensions, that are not drawn

  void add_stage(const std::string& stage) {
    if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
  }
  /// What of another view is left undone.
  void add(const Partial& other) {
    for (const std::string& stage : other.stages) add_stage(stage);
    edges += other.edges;
    undecided += other.undecided;
    searched = std::min(searched, other.searched);
    undrawn += other.undrawn;
  }
};

/// How many digits a view can have.
struct ViewCondition {
  std::string name;  ///< of the view
  view::Condition condition;
};

/// Largest distance of facets from the surfaces of the part that they represent.
struct Tessellation {
  double error = 0;     ///< length of the world
  double on_paper = 0;  ///< the same in the largest view, mm
};

struct Report {
  std::vector<mesh::MeshReport> meshes;
  std::vector<PlanStep> plan;
  std::vector<std::pair<std::string, double>> seconds;  ///< empty unless requested: outputs are byte-stable
  Partial partial{};                                    ///< without stages: the drawing is complete
  std::optional<Verification> verification;             ///< if requested
  std::vector<ViewCondition> conditions;                ///< by view, if requested
  std::optional<Tessellation> tessellation{};           ///< where round faces of a part are recognised
};

}  // namespace epura::report
