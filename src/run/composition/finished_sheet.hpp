// SPDX-License-Identifier: Apache-2.0
// The result of a run: sheets ready to be written, with fewer lines if time is short.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drawing/drawing.hpp"
#include "report/report.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::pipeline {

/// A sheet, and its data for JSON.
struct FinishedSheet {
  sheet::Sheet sheet;
  double scale = 1;                              ///< main scale, mm on paper per unit of the world
  std::vector<drawing::ViewDrawing> drawings{};  ///< in order of the views; empty if no target needs them
  std::vector<std::string> warnings{};           ///< requests that could not be met
  sheet::Paper paper{};
  std::vector<report::Finding> findings{};           ///< faults of the dimensions on it
  std::vector<std::vector<std::size_t>> left_out{};  ///< by view: numbers of dimensions for which it has no room
  std::vector<std::vector<std::size_t>> unseen{};    ///< by view: of those that measure what the view does not show
  std::string answers{};                             ///< to the questions about its edges
  std::optional<int> next_size{};                    ///< as in SheetPlan
  std::vector<std::string> unplaced{};               ///< requirements of dimensions and callouts that are not drawn
  std::vector<std::pair<std::string, std::string>> zones{};  ///< of others: the field of the frame in which they are
  std::size_t without_room = 0;                              ///< notes, symbols, tables, rows of hole tables
  bool lacks_lines = false;                                  ///< time was over before all were found
  bool is_crowded = false;                                   ///< something has no place on it, or a worse one
};

/// How many dimensions, notes, symbols, tables and rows of hole tables a sheet has no room for; and how many of its
/// rows are fans, which lint finds and is less bad.
std::pair<std::size_t, std::size_t> faults_of(const FinishedSheet& sheet);

/// Whether all has its usual place on a sheet.
bool is_complete(const FinishedSheet& sheet);

/// Marks a sheet as incomplete since time was over in a stage; a further call replaces the stage.
void mark_partial(FinishedSheet& sheet, const std::string& stage);

/// Keeps the longest lines of the views, on the sheets and in the drawings, and notes in `partial` how many are
/// omitted. Returns whether so few are left that they take negligible time.
bool keep_longest_lines(std::span<FinishedSheet> sheets, report::Partial& partial);

}  // namespace epura::pipeline
