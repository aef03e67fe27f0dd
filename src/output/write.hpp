// SPDX-License-Identifier: Apache-2.0
// Sheets -> the bytes of a file. Nothing is computed here but the encoding.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "mesh/mesh.hpp"
#include "output/verification.hpp"
#include "scene/choices.hpp"
#include "sheet/sheet.hpp"
#include "view/condition.hpp"

namespace epura {

enum class Format { svg, pdf, ps, eps, png, dxf, json };

/// By file extension, in any case; nothing when unknown.
std::optional<Format> format_of(std::string_view extension);
/// What to write instead of a format that is unknown.
std::string format_hint(std::string_view extension);
/// All extensions, for help and hints.
const std::vector<std::string>& format_names();

template <>
struct Words<SvgText> {
  static constexpr std::array list{"outlines", "text"};
};

struct VectorOptions {
  bool plain = false;  ///< leave the origin of lines out
  double dpi = 300;    ///< PNG only
  int decimals = 4;    ///< of coordinates in millimetres, SVG only: no point is off by more than 0.0001 mm
  SvgText text = SvgText::outlines;
};

/// Sheets that become pages of one file, at least one.
using Pages = std::vector<const Sheet*>;

// The same sheet gives the same bytes, always: no clock, no counter, no locale. A file is written as a whole, or
// OutOfTime is thrown.
std::string to_svg(const Sheet& sheet, const VectorOptions& options, const Progress& progress = {});
std::string to_pdf(const Pages& sheets, const Progress& progress = {});
std::string to_ps(const Pages& sheets, const Progress& progress = {});
std::string to_eps(const Sheet& sheet, const Progress& progress = {});
std::string to_png(const Sheet& sheet, double dpi, const Progress& progress = {});
/// AutoCAD 2000 (AC1015), in millimetres.
std::string to_dxf(const Sheet& sheet, const Progress& progress = {});

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
  std::string why;  ///< it ran, or the certificate by which it was left out
  long long items_in = 0, items_out = 0;
  std::string view{};   ///< empty for what is done once
  long long skipped{};  ///< of the items that came in, those that a certificate left out
  PlanTimes times{};    ///< empty unless asked for: outputs are byte-stable
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
  Condition condition;
};

struct Report {
  std::vector<MeshReport> meshes;
  std::vector<PlanStep> plan;
  std::vector<std::pair<std::string, double>> seconds;  ///< empty unless asked for: outputs are byte-stable
  Partial partial{};                                    ///< without stages: the drawing is complete
  std::optional<Verification> verification;             ///< where it was asked for
  std::vector<ViewCondition> conditions;                ///< by view, where they were asked for
};

/// Drawing JSON, schema 1 (docs/formats.md).
std::string to_json(const Sheet& sheet, double scale, std::span<const ViewDrawing> drawings, const Report& report,
                    const Progress& progress = {});

}  // namespace epura
