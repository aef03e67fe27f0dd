// SPDX-License-Identifier: Apache-2.0
// Options for drawing a scene, apart from those of its parts.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "definition/rules.hpp"
#include "explain/edge_question.hpp"
#include "projection/catalogue.hpp"
#include "scene/choices.hpp"
#include "views/shortcuts.hpp"

namespace epura::pipeline {

enum class DumpTable { edges, spans };
/// What has balloons apart from the items of parts lists: `characteristics`, dimensions and symbols that model files
/// require, with their numbers in an inspection.
enum class Balloons { none, characteristics };
/// Which lines count as hidden: `none` is a wireframe.
enum class Visibility { exact, none };
/// Which processes open nothing but what they were given: those of importers and workers, if the kernel can confine
/// them (foreign/sandbox.hpp); `on`: this process, too.
enum class Sandbox { automatic, on, off };

}  // namespace epura::pipeline

template <>
struct epura::scene::Words<epura::pipeline::DumpTable> {
  static constexpr std::array list{"edges", "spans"};
};
template <>
struct epura::scene::Words<epura::pipeline::Balloons> {
  static constexpr std::array list{"none", "characteristics"};
};
template <>
struct epura::scene::Words<epura::pipeline::Visibility> {
  static constexpr std::array list{"exact", "none"};
};
template <>
struct epura::scene::Words<epura::pipeline::Sandbox> {
  static constexpr std::array list{"auto", "on", "off"};
};

namespace epura::pipeline {

struct KeptModels;

/// How far facets of imported surfaces may be off: in mm, and as a part of the size of the model; 0 for no bound.
struct FacetPrecision {
  double tolerance = 0, relative_tolerance = 0;
};

struct RunOptions {
  std::vector<std::filesystem::path> plugin_path;        ///< more folders with projection plugins
  std::vector<projection::ProjectionEntry> projections;  ///< of the calling program, by name before those of plugins
  Sandbox sandbox = Sandbox::automatic;
  bool allow_outside = false;  ///< scene files and models may name files outside their folders
  Visibility visibility = Visibility::exact;
  std::optional<double> max_error;          ///< mm; no line of a view may be farther from the part
  double writing_error = 0;                 ///< mm; of the files that will be written
  std::optional<FacetPrecision> precision;  ///< instead of that which the scales and papers ask for
  std::optional<double> contact;            ///< world length
  std::optional<double> arcs;               ///< tolerance, mm; nothing: lines stay straight
  bool centre_lines = false;
  std::vector<explain::EdgeQuestion> why;  ///< edges to explain
  std::optional<DumpTable> dump;
  int threads = 0;                   ///< 0: all cores
  std::optional<double> time_limit;  ///< seconds
  bool verify = false;
  int verify_samples = 2000;
  Shortcuts plan;        ///< shortcuts in use
  bool explain = false;  ///< print the steps
  bool lint = false;     ///< report faults of the dimensions
  bool rebuild = false;  ///< find the faces of the part again from the numbers on the sheets
  definition::RuleSet rules = definition::rules_of(definition::Standard::iso);  ///< of both, without numbers
  bool hatch_free = false;     ///< with faults, hatch the faces that the dimensions leave free
  bool allow_missing = false;  ///< sheets may lack what model files require
  Balloons balloons = Balloons::none;
  bool error_note = false;      ///< sheets state above the title block how far lines may be from those of the part
  bool judges = false;          ///< finds the error budgets of the views
  bool keeps_drawings = false;  ///< in addition to the sheets
  std::shared_ptr<KeptModels> kept_models{};  ///< shared with other runs, which read the same files
  bool describes = false;                     ///< the sheets say in sentences what they show
  bool names_features = false;                ///< and of which feature their lines and dimensions are
  bool line_facts = false;                    ///< the sheets tell what the model knows of their lines
};

}  // namespace epura::pipeline
