// SPDX-License-Identifier: Apache-2.0
// What the command line asks for, as text and plain values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "projection/plugin_process.hpp"

namespace epura {

/// Empty texts are not given.
struct DrawOptions {
  std::vector<std::string> models;   ///< or one scene file
  std::vector<std::string> outputs;  ///< "-" is standard output
  std::string format;                ///< of "-"
  std::vector<std::string> projections;
  std::string views;  ///< names of projections with commas, arranged on the sheet
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> transforms;
  std::string unit, up;
  std::string section;  ///< POINT:NORMAL
  std::string sheet, orientation, scale, angle, frame;
  std::vector<std::pair<std::string, std::string>> title_block;  ///< fields of ISO 7200 and what is written in them
  std::string hidden, edges;
  std::string dimensions;  ///< "overall"
  std::optional<double> crease_angle;
  std::string visibility = "exact";
  std::optional<double> max_error;  ///< mm
  std::optional<double> near, far, contact;
  int decimals = 4;  ///< of millimetres in SVG
  double dpi = 300;
  int threads = 0;
  bool plain = false;
  std::string arcs;  ///< tolerance, mm; empty: lines stay straight
  bool centre_lines = false;
  std::string svg_text = "outlines";
  bool timings = false;
  std::vector<std::string> why;  ///< edges to explain
  std::string dump;              ///< table to print: "edges", "spans" or none
  std::string progress = "auto";
  std::optional<double> time_limit;  ///< seconds
  bool verify = false;
  int verify_samples = 2000;
  std::string plan = "all";  ///< certificates that are used
  bool explain = false;      ///< print the plan
  bool measure = false;      ///< what certificates save, by runs without them
};

struct StabilityOptions {
  std::vector<std::string> outputs;  ///< "-" is standard output
  std::string format;                ///< of "-"
  std::string cases;                 ///< ids with commas; empty: all
  double size = 1;                   ///< factor of the numbers of parts of large scenes
  int threads = 0;
  bool timings = false;
  std::string progress = "auto";
};

struct AccuracyOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> outputs;
  std::vector<std::string> projections;  ///< of scenes that are models
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> methods;  ///< none: a choice of all
  int runs = 5;
  double pairs = 2e5;  ///< of edge and triangle, for the truth
  bool maps = true;
  int threads = 0;
  std::string progress = "auto";
};

struct PluginsOptions {
  std::string name;  ///< empty: list all
  std::vector<std::filesystem::path> plugin_path;
};

struct CheckPluginOptions {
  std::filesystem::path file;
  double time_limit = plugin_seconds;
};

struct NewProjectionOptions {
  std::string name;
};

struct CompareOptions {
  std::string before, after;  ///< files of drawings
  double tolerance = 0.001;   ///< mm
  std::string json, overlay;  ///< files to write; empty: none
};

struct SnapshotOptions {
  std::vector<std::string> folders;  ///< with cases in them, or cases
  bool accept = false;               ///< what comes is what is expected from now on
  double tolerance = 0.001;          ///< mm
  std::string report, junit;         ///< files to write; empty: none
  int threads = 0;                   ///< cases at the same time
};

}  // namespace epura
