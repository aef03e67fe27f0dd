// SPDX-License-Identifier: Apache-2.0
// Error against run time: a view computed by many methods, each compared with the truth and timed.
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

/// A view of a scene with its drawn edges.
struct StudiedView {
  std::string scene, name;
  const world::World& world;
  const view::ProjectedScene& view;
  const view::ViewLimits& limits;
  const edges::FeatureEdges& drawn;
  view::PaperMap paper;
};

/// A named method of computing hidden spans.
struct Contender {
  std::string method, parameters;
  std::function<visibility::HiddenSpans()> run;
};

Contender contender(const StudiedView& studied, const Method& method);

struct Measurement {
  std::string method, parameters;
  Errors errors;                 ///< mm
  std::vector<double> seconds;   ///< of its runs
  double median = 0;             ///< median of these
  std::optional<double> memory;  ///< maximum growth of the process, bytes
  double at_most_wrong = 0;      ///< fraction of all edges that is wrong, at 95 % confidence
  bool on_front = false;         ///< no other is both faster and more accurate
};

struct ViewMeasurements {
  std::string scene, view;
  std::size_t triangles = 0, edges = 0;
  double size = 0;          ///< mm, longest side of the drawing
  double read_seconds = 0;  ///< time to read the scene's models
  double undecided = 0;     ///< fraction of the tested length
  std::vector<Measurement> methods{};
};

struct StudyEffort {
  int runs = 5;
  TruthEffort truth{};
};

/// The correct hidden spans of a view.
std::vector<EdgeTruth> truth_of(const StudiedView& studied, const TruthEffort& effort);

Errors errors_of(const StudiedView& studied, const std::vector<EdgeTruth>& truth, const visibility::HiddenSpans& shown);

/// The methods run in turn, so that other load on the machine affects all alike; one preliminary run warms up, and
/// measures errors and memory.
ViewMeasurements measure(const StudiedView& studied, std::span<const Contender> contenders, const StudyEffort& effort);

double median_of(std::vector<double> values);
/// The first and third quartile, between neighbouring values linearly; of no values, {0, 0}.
std::array<double, 2> quartiles_of(std::vector<double> values);

}  // namespace epura::study
