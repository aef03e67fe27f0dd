// SPDX-License-Identifier: Apache-2.0
// Suspected faults of an outline, found by lines across the page: how far each extends along its own line.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "verify/line_scan.hpp"
#include "verify/outline.hpp"

namespace epura::verify {

/// What an outline is tested with.
class OutlineScan {
 public:
  /// The arguments must outlive it.
  OutlineScan(const VerifyInput& drawn, const Tolerance& tolerance, const OutlineOptions& how);

  const VerifyInput& input;
  const OutlineOptions& options;
  double reach, least;  ///< mm: places this close are one; faults of this length count
  ScanScene scene;
  FoldRule rule;
  ScanWindow window;
  LineScan scan;

  /// For each position that requires a line, whether the drawing has ink there.
  [[nodiscard]] std::vector<bool> inked(const std::vector<AskedLine>& asked) const;
};

enum class FaultKind { missing, unfounded, doubled };

/// A suspected fault at the place where a line met it.
struct Suspect {
  FaultKind kind;
  Vec2 place;
  std::array<Vec2, 2> ends;  ///< of the straight line that the fault is part of
  std::array<int, 2> edge, triangles;
  int segment;
  int met = 1;  ///< how often it was met
  double length = 0;

  [[nodiscard]] auto key() const { return std::tuple(edge, edge[0] < 0 ? triangles : edge, segment); }
};

/// Suspects in the order in which they are met, each once.
class Suspects {
 public:
  void add(const Suspect& found);
  [[nodiscard]] const std::vector<Suspect>& all() const { return all_; }

 private:
  std::vector<Suspect> all_;
  std::map<decltype(std::declval<Suspect>().key()), std::size_t> known_;
};

/// The same, those met most often first. Their lengths are found by short lines across them, but only for the first
/// ones. Throws OutOfTime.
std::vector<Suspect> followed(const OutlineScan& on, std::vector<Suspect> suspects);

/// By suspect: whether it extends far enough to count. Those that were not followed do if most of the others do.
std::vector<char> are_faults(const OutlineScan& on, const std::vector<Suspect>& followed);

}  // namespace epura::verify
