// SPDX-License-Identifier: Apache-2.0
// Findings of a run: repairs, stages that ran, what the time limit cut short, condition of views, verification.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "report/error_budget.hpp"
#include "report/verification.hpp"
#include "view/condition.hpp"

namespace epura::report {

/// The time a stage took, and the time saved by omitting it, in seconds.
struct PlanTimes {
  std::optional<double> certificate;  ///< time to find out whether the stage can be omitted; nothing if that takes no
                                      ///< time
  std::optional<double> stage;        ///< time of the stage, if it ran and was timed
  std::optional<double> estimated;    ///< time saved, estimated from the usual time per item
  std::optional<double> measured;     ///< time saved, measured by runs with and without the stage
};

/// One stage of the plan, for the report.
struct PlanStep {
  std::string stage;
  bool run;
  std::string why;  ///< why it ran or was skipped
  long long items_in = 0, items_out = 0;
  std::string view{};   ///< empty for a stage that runs once for all views
  long long skipped{};  ///< number of items skipped by a shortcut
  PlanTimes times{};    ///< empty unless requested: outputs are byte-stable
};

/// Work that was left undone because of a time limit, or because faces cross in too many places.
struct Partial {
  std::vector<std::string> stages{};   ///< stages cut short, by their names in Progress; none: everything is done
  long long edges = 0, undecided = 0;  ///< undecided edges are not drawn
  double searched = 1;                 ///< fraction of the search for intersection lines that was done, 0 to 1
  long long undrawn = 0;               ///< lines of decided edges, and dimensions, that are not drawn
  bool too_many_crossings = false;     ///< whether their number ended the search for intersection lines, not time

  void add_stage(const std::string& stage) {
    if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
  }
  /// Adds what another view left undone.
  void add(const Partial& other) {
    for (const std::string& stage : other.stages) add_stage(stage);
    edges += other.edges;
    undecided += other.undecided;
    searched = std::min(searched, other.searched);
    too_many_crossings = too_many_crossings || other.too_many_crossings;
    undrawn += other.undrawn;
  }
};

/// How many digits a view can have.
struct ViewCondition {
  std::string name;  ///< of the view
  view::Condition condition;
};

/// Largest distance between facets and the surfaces of the part that they represent.
struct Tessellation {
  double error = 0;     ///< in units of length of the world
  double on_paper = 0;  ///< the same in the largest view, mm
};

/// What is judged of a drawing, each apart: no number adds them up.
enum class Axis : std::uint8_t { requirements, completeness, fidelity, legibility, restraint };
inline constexpr std::array axis_names{"requirements", "completeness", "fidelity", "legibility", "restraint"};

enum class FindingKind {
  not_drawn,
  undimensioned,
  undecided,
  contradictory,
  untrue,
  unjudged,
  crossing,
  fan,
  small_text,
  off_sheet,
  repeated,
  follows
};

/// A row of the table of kinds.
struct FindingRow {
  const char* name;
  Axis axis;
  bool is_fault = true;  ///< otherwise it is said, and the drawing may be right
};

/// By FindingKind.
inline constexpr std::array<FindingRow, 12> finding_rows{{
    {"not drawn", Axis::requirements},
    {"not dimensioned", Axis::completeness},
    {"cannot tell", Axis::completeness, false},
    {"contradictory", Axis::fidelity},
    {"untrue", Axis::fidelity},
    {"not judged", Axis::fidelity, false},
    {"crossing", Axis::legibility},
    {"crowded", Axis::legibility},
    {"too small", Axis::legibility},
    {"off the sheet", Axis::legibility},
    {"dimensioned twice", Axis::restraint},
    {"follows from others", Axis::restraint},
}};

/// What is found of the dimensions of a drawing.
struct Finding {
  FindingKind kind;
  std::string view;  ///< name of the view; empty if it concerns none in particular
  std::string what;
  int face = 0;            ///< its number in scenes; 0: none in particular
  std::string accepted{};  ///< why it is no fault; empty: nothing says so

  [[nodiscard]] const FindingRow& row() const { return finding_rows[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] bool is_fault() const { return row().is_fault && accepted.empty(); }
};

/// How many faces or holes of the models have a size and a place on the sheets.
struct SizeCount {
  std::string kind;  ///< "plane faces"
  int given, all;
  int unsure = 0;  ///< of the others: those of which nobody can tell

  [[nodiscard]] int missing() const { return all - given - unsure; }
};

/// What a model file requires, and where the sheets say so.
struct RequirementRow {
  std::string model;       ///< its name in dimensions
  std::string id;          ///< in the file
  std::string kind;        ///< "dimension", "tolerance", "datum" or "note"
  std::string what;        ///< in words
  std::string view{};      ///< that shows it; empty: none does, or it belongs to the sheet
  int sheet = 0;           ///< from 1; 0: none shows it
  std::string zone{};      ///< field of its frame, as "B4"; empty: none
  int characteristic = 0;  ///< its number in an inspection; 0: it is not measured
  std::string why{};       ///< it is not drawn, or not all of it
  bool wanted = true;      ///< the sheets are to show it

  [[nodiscard]] bool is_drawn() const { return sheet > 0; }
  /// Whether the drawing lacks it.
  [[nodiscard]] bool is_missing() const { return wanted && !is_drawn(); }
};

struct Report {
  std::vector<mesh::MeshReport> meshes;
  std::vector<PlanStep> plan;
  std::vector<std::pair<std::string, double>> seconds;  ///< empty unless requested: outputs are byte-stable
  Partial partial{};                                    ///< no stages: the drawing is complete
  std::optional<Verification> verification;             ///< if requested
  std::vector<ViewCondition> conditions;                ///< one for each view, if requested
  std::optional<Tessellation> tessellation{};           ///< if round faces of a part are recognised
  std::vector<ViewError> errors{};                      ///< one for each view, if requested
  std::vector<Finding> findings{};                      ///< if requested
  std::vector<SizeCount> sizes{};                       ///< with findings
  std::vector<std::string> views_to_add{};              ///< projections that show what has no dimension, with findings
  std::string transform_to_add{};                       ///< of a model, instead of these
  std::vector<RequirementRow> requirements{};           ///< of model files, in their order
  bool cut_off = false;                                 ///< views extend beyond the paper
  bool unmatched_sizes = false;                         ///< what is said of sizes fits none of them
};

}  // namespace epura::report
