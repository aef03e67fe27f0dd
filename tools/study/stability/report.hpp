// SPDX-License-Identifier: Apache-2.0
// The stability study: every case at every step by every arithmetic. Verdicts follow from errors alone.
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

enum class Verdict {
  right,
  limited,  ///< off by more than is allowed, but by no more than the rounding of the input explains
  broken,   ///< wrong, or nothing comes out
};

std::string_view name_of(Verdict verdict);

/// One arithmetic at one step.
struct Outcome {
  Measured measured;    ///< empty where nothing came out
  std::string failure;  ///< why not

  /// Broken where one quantity is, or nothing came out.
  [[nodiscard]] Verdict verdict() const;
  /// The quantity with the worst verdict; of these the one farthest beyond what is allowed. nullptr without any.
  [[nodiscard]] const Quantity* worst() const;
  /// Of the worst quantity; infinite without any.
  [[nodiscard]] double error() const;
};

struct Row {
  double step;
  std::array<Outcome, arithmetics> outcomes;  ///< by Arithmetic
};

struct CaseReport {
  std::string id, what, parameter;
  std::vector<Row> rows;
  double seconds = 0;

  /// The first step that an arithmetic does not get right; nothing if it gets all.
  [[nodiscard]] std::optional<double> breaks_at(Arithmetic arithmetic) const;
  /// The worst of all steps.
  [[nodiscard]] Verdict verdict(Arithmetic arithmetic) const;
};

using Report = std::vector<CaseReport>;

/// `size` scales the numbers of parts of large scenes.
Report run(std::span<const Case> cases, double size, Progress progress = {});

}  // namespace epura::stability
