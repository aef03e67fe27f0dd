// SPDX-License-Identifier: Apache-2.0
// The commands of epura-study and their options. Each returns the exit code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/options.hpp"
#include "study/methods/method.hpp"
#include "study/paper/rival.hpp"

namespace epura::study {

struct StabilityOptions {
  std::vector<std::string> outputs;  ///< "-" is standard output
  std::string format;                ///< of "-"
  std::string cases;                 ///< ids separated by commas; empty: all
  double size = 1;                   ///< factor for the number of parts in large scenes
  double beyond = 0;  ///< sweeps are continued until epura fails, or a step takes more seconds; 0: they are not
  int threads = 0;
  bool timings = false;
  ShowProgress progress = ShowProgress::automatic;
};

struct AccuracyOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> outputs;
  std::vector<scene::Located<scene::ProjectionRequest>> projections;  ///< for scenes that are models
  std::vector<std::filesystem::path> plugin_path;
  std::vector<Method> methods;  ///< none: a selection of all methods
  int runs = 5;
  double pairs = 2e5;  ///< of an edge and a triangle, for the truth
  bool maps = true;
  int threads = 0;
  ShowProgress progress = ShowProgress::automatic;
};

struct PaperOptions {
  std::vector<std::string> outputs;
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> bodies;  ///< none: all
  int finest = 192;                 ///< facets around
  std::vector<Rival> rivals;
  int runs = 5;
  int threads = 0;
  ShowProgress progress = ShowProgress::automatic;
};

int study_stability(const StabilityOptions& options);
int study_accuracy(const AccuracyOptions& options);
int study_paper(const PaperOptions& options);

const ProgramTexts& study_texts();

/// Adds the commands to the program, in the order of its help.
std::vector<DefinedCommand> define_study_commands(CLI::App& program);

}  // namespace epura::study
