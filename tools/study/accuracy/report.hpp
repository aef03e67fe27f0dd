// SPDX-License-Identifier: Apache-2.0
// The report of the study of methods that find hidden lines.
#pragma once

#include <vector>

#include "study/accuracy/maps.hpp"
#include "study/accuracy/measure.hpp"
#include "study/study_report.hpp"

namespace epura::study {

struct AccuracyReport {
  std::vector<ViewMeasurements> views;
  std::vector<MapMeasurement> maps;
};

/// The work-precision diagram of a view: error over time, one curve for each method, with filled marks on the front.
LogPlot diagram_of(const ViewMeasurements& view, std::size_t number);
/// Error of the projection maps over the distance from the origin of the world.
LogPlot diagram_of(const std::vector<MapMeasurement>& maps);

StudyReport report_of(const AccuracyReport& report);

}  // namespace epura::study
