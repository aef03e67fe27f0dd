// SPDX-License-Identifier: Apache-2.0
// The report of a study: diagrams and tables as HTML or PDF, tables as CSV or JSON, diagrams as SVG or PNG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/accuracy/log_plot.hpp"
#include "study/accuracy/maps.hpp"
#include "study/accuracy/measure.hpp"

namespace epura::study {

struct AccuracyReport {
  std::vector<ViewMeasurements> views;
  std::vector<MapMeasurement> maps;
};

/// The work-precision diagram of a view: error over time, one curve for each method, with filled marks on the front.
LogPlot diagram_of(const ViewMeasurements& view, std::size_t number);
/// Error of the projection maps over the distance from the origin of the world.
LogPlot diagram_of(const std::vector<MapMeasurement>& maps);

enum class ReportFormat { html, pdf, csv, json, svg, png };

/// One self-contained file; for SVG and PNG, one file for each diagram.
std::vector<std::string> to_files(const AccuracyReport& report, ReportFormat format);

}  // namespace epura::study
