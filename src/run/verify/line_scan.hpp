// SPDX-License-Identifier: Apache-2.0
// Scans a drawing and its scene along lines of the page, for required positions and for ink.
#pragma once

#include <vector>

#include "verify/fold_rule.hpp"
#include "verify/line_marks.hpp"
#include "verify/scan_lines.hpp"

namespace epura::verify {

/// A position that requires a line.
struct AskedLine {
  Vec2 place;  ///< mm from ScanScene::origin
  LineMark mark;
};

enum class InkVerdict { right, unfounded, doubled };

/// A place at which visible ink crosses a line.
struct InkCrossing {
  double u;  ///< along the line, mm
  Vec2 place;
  int segment;  ///< of the drawing
  InkVerdict verdict;
};

struct LineFindings {
  std::vector<AskedLine> asked;
  std::vector<AskedLine> jumps;  ///< see LineMarks::jumps
  std::vector<InkCrossing> ink;
};

class LineScan {
 public:
  LineScan(const VerifyInput& input, const ScanScene& scene, const FoldRule& rule, const MarkLimits& limits,
           const ScanWindow& window);

  /// One entry for each line of a bundle. Throws OutOfTime.
  [[nodiscard]] std::vector<LineFindings> along(const LineBundle& bundle, const Progress& progress) const;
  /// One entry for each of many short lines. Throws OutOfTime.
  [[nodiscard]] std::vector<LineFindings> along(const std::vector<ScanLine>& lines, const Progress& progress) const;

  /// What is within `reach` of the middles of short lines. Throws OutOfTime.
  [[nodiscard]] std::vector<Around> around(const std::vector<ScanLine>& lines, double reach,
                                           const Progress& progress) const;

  /// The ends of visible ink, mm from ScanScene::origin.
  [[nodiscard]] std::array<Vec2, 2> segment(int number) const;
  /// Total lengths on the page, in mm, which determine how often random lines cut triangles and visible ink. No
  /// triangle counts for more than `max`.
  [[nodiscard]] double perimeter_of_triangles(double max) const;
  [[nodiscard]] double length_of_ink() const;

 private:
  template <class Through, class Judge>
  [[nodiscard]] auto scan(const std::vector<ScanLine>& lines, const Through& through, const Judge& judge,
                          const Progress& progress) const;
  template <class Judge>
  [[nodiscard]] auto scan_short(const std::vector<ScanLine>& lines, const Judge& judge, const Progress& progress) const;
  [[nodiscard]] LineFindings judge(const ScanLine& line, const MetByLine& met, std::span<const int> segments) const;
  void find_doubled(const LineMarks& marks, std::vector<InkCrossing>& ink) const;
  [[nodiscard]] bool shape_of(int triangle, std::array<Vec2, 3>& shape) const;
  [[nodiscard]] std::array<int, 2> edge_of(int segment) const;

  const VerifyInput& input_;
  const ScanScene& scene_;
  const FoldRule& rule_;
  MarkLimits limits_;
  ScanWindow window_;
};

}  // namespace epura::verify
