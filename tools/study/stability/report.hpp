// SPDX-License-Identifier: Apache-2.0
// The stability study: every case at every step in every way. Verdicts depend only on errors.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "study/stability/case.hpp"

namespace epura::stability {

/// How a case is drawn: from its triangles by each arithmetic, or by epura's own with the faces of recognised parts.
enum class Way { single, composed, own, recognised };

inline constexpr std::array<std::string_view, 4> way_names{"float32", "double", "epura", "recognised"};

Lab lab_of(Way way, double size);

enum class Verdict {
  right,
  limited,  ///< error larger than allowed, but explained by the rounding of the input
  broken,   ///< wrong, or no result
};

std::string_view name_of(Verdict verdict);

/// The result in one way at one step.
struct Outcome {
  Measured measured;    ///< empty if there is no result
  std::string failure;  ///< the reason if there is no result

  /// Broken if one quantity is, or if there is no result.
  [[nodiscard]] Verdict verdict() const;
  /// The quantity with the worst verdict; among these, the one farthest beyond the allowed error. nullptr if there is
  /// none.
  [[nodiscard]] const Quantity* worst() const;
  /// The error of the worst quantity; infinite if there is none.
  [[nodiscard]] double error() const;
};

struct Row {
  double step;
  std::array<Outcome, way_names.size()> outcomes;  ///< by Way
};

struct CaseReport {
  std::string id, what, parameter;
  std::vector<Row> rows;
  double seconds = 0;

  /// The first step that goes wrong in one way; nothing if all are right.
  [[nodiscard]] std::optional<double> breaks_at(Way way) const;
  /// The worst of all steps in one way.
  [[nodiscard]] Verdict verdict(Way way) const;
  /// The worse of the two ways of epura.
  [[nodiscard]] Verdict verdict() const;
};

using Report = std::vector<CaseReport>;

Outcome outcome_of(const Case& one, double step, const Lab& lab);

/// `size` scales the numbers of parts in large scenes.
Report run(std::span<const Case> cases, double size, Progress progress = {});

}  // namespace epura::stability
