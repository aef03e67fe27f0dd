// SPDX-License-Identifier: Apache-2.0
// The table of stiff and extreme cases: projections P1 to P16, alignments and views V1 to V13, meshes M1 to M37.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "laboratory/lab.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

struct Case {
  std::string id;
  std::string what;
  std::string parameter;
  std::vector<double> steps;  ///< from mild to extreme
  /// Draws at one step and measures. Throws Error if nothing can be drawn.
  std::function<Measured(const Lab&, double step)> measure;
};

std::vector<Case> projection_cases();
std::vector<Case> viewer_cases();  ///< also projections: the position of the viewer
std::vector<Case> alignment_cases();
std::vector<Case> line_cases();  ///< alignments of single lines
std::vector<Case> body_cases();
std::vector<Case> surface_cases();
std::vector<Case> size_cases();      ///< meshes of many parts; `Lab::size` scales their numbers
std::vector<Case> number_cases();    ///< meshes with unusual coordinates
std::vector<Case> modeller_cases();  ///< meshes as modellers write them
std::vector<Case> section_cases();   ///< meshes cut by a plane

/// All of them, in order of their ids.
std::vector<Case> all_cases();

}  // namespace epura::stability
