// SPDX-License-Identifier: Apache-2.0
// The table of stiff and extreme cases: projections P1 to P16, alignments and views V1 to V13, meshes M1 to M37,
// recognition R1 to R9, sections S1 to S3, dimensions D1 to D5.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/lab.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

struct Case {
  std::string id;
  std::string what;
  std::string parameter;
  std::vector<double> steps;  ///< from mild to extreme, or kinds
  /// Draws at one step and measures. Throws Error if nothing can be drawn.
  std::function<Measured(const Lab&, double step)> measure;
  bool kinds = false;  ///< steps are kinds without an order: nothing lies beyond the last one
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
std::vector<Case> recognition_cases();
std::vector<Case> dimension_cases();

/// The letters with which ids begin, in the order of the reports.
inline constexpr std::string_view families = "PVMRSD";

/// All of them, in order of their ids.
std::vector<Case> all_cases();

}  // namespace epura::stability
