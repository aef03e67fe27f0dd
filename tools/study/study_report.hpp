// SPDX-License-Identifier: Apache-2.0
// The report of a study: diagrams and tables as HTML or PDF, tables as CSV or JSON, diagrams as SVG or PNG.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "study/log_plot.hpp"
#include "study/report_targets.hpp"
#include "study/table.hpp"

namespace epura::study {

/// A diagram above the table with its numbers.
struct Chapter {
  LogPlot diagram;
  Table table;
  std::string title;    ///< of the table
  bool printed = true;  ///< the table is part of the PDF, too
};

struct StudyReport {
  std::string command;  ///< in JSON: "accuracy"
  std::string title;
  std::vector<Chapter> chapters;
  std::vector<std::pair<std::string, Table>> tables;  ///< all numbers, by name; CSV has the first one
  std::string notes;                                  ///< beside the diagrams of a page
};

enum class ReportFormat { html, pdf, csv, json, svg, png };

/// One self-contained file; for SVG and PNG, one file for each diagram.
std::vector<std::string> to_files(const StudyReport& report, ReportFormat format);

/// The names and meanings of the columns, a line each.
std::string meanings(const Table& table);

/// By the extensions of the paths. Throws Error{input} for others.
std::vector<ReportTarget<ReportFormat>> report_targets(const std::vector<std::string>& paths);

/// Writes the report to every target, numbered files where it has several. Throws Error{input} rather than overwrite an
/// input.
void write_report(const StudyReport& report, const std::vector<ReportTarget<ReportFormat>>& targets,
                  const std::vector<std::string>& inputs, const Progress& progress);

}  // namespace epura::study
