// SPDX-License-Identifier: Apache-2.0
// Error against run time: a view decided by many methods, each measured against the truth and by the clock.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracle/truth.hpp"
#include "study/accuracy/errors.hpp"
#include "study/methods/method.hpp"
#include "view/paper_map.hpp"

namespace epura::study {

/// A view of a scene, as far as its drawn edges are known.
struct StudiedView {
  std::string scene, name;
  const scene::World& world;
  const view::ProjectedScene& view;
  const view::ViewLimits& limits;
  const edges::FeatureEdges& drawn;
  view::PaperMap paper;
};

/// What is measured: a way to hidden spans under a name.
struct Contender {
  std::string method, parameters;
  std::function<visibility::HiddenSpans()> run;
};

Contender contender(const StudiedView& studied, const Method& method);

struct Measurement {
  std::string method, parameters;
  Errors errors;                 ///< mm
  std::vector<double> seconds;   ///< of its runs
  double median = 0;             ///< of these
  std::optional<double> memory;  ///< bytes that the process grew by at most
  double at_most_wrong = 0;      ///< share of all edges that is wrong, at 95 % confidence
  bool on_front = false;         ///< no other is both faster and better
};

struct ViewMeasurements {
  std::string scene, view;
  std::size_t triangles = 0, edges = 0;
  double size = 0;          ///< mm, longest side of the drawing
  double read_seconds = 0;  ///< of the scene's models
  double undecided = 0;     ///< share of the judged length
  std::vector<Measurement> methods{};
};

struct StudyEffort {
  int runs = 5;
  TruthEffort truth{};
};

/// The truth for a view.
std::vector<EdgeTruth> truth_of(const StudiedView& studied, const TruthEffort& effort);

Errors errors_of(const StudiedView& studied, const std::vector<EdgeTruth>& truth, const visibility::HiddenSpans& shown);

/// Runs take turns, so that what else the machine does meets all alike; one before them warms up, and tells errors and
/// memory.
ViewMeasurements measure(const StudiedView& studied, std::span<const Contender> contenders, const StudyEffort& effort);

double median_of(std::vector<double> values);

}  // namespace epura::study
