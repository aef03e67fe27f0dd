// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/report.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.hpp"
#include "output/write.hpp"
#include "study/accuracy/tables.hpp"
#include "study/report_page.hpp"

namespace epura::study {

namespace {

constexpr double guaranteed_part = 1e-6;  // docs/numerics.md
constexpr double picture_dpi = 120;

Table table_of_maps(const std::vector<MapMeasurement>& maps) {
  Table table{{{"map", "matrix of the projection", false},
               {"way", "how it is computed", false},
               {"offset", "of the model from the origin, in its sizes"},
               {"error", "of places on the page, in sizes of the model"},
               {"seconds_per_vertex", "median"}},
              {}};
  for (const MapMeasurement& one : maps)
    table.rows.push_back({one.map, one.way, format_rounded(one.offset, 6),
                          std::isfinite(one.error) ? format_rounded(one.error, 6) : "inf",
                          format_rounded(one.seconds, 6)});
  return table;
}

std::string facts_of(const ViewMeasurements& view) {
  const long long judged = view.methods.empty() ? 0 : view.methods.front().errors.judged;
  return view.scene + ", " + view.view + ": " + std::to_string(view.triangles) + " triangles, " +
         std::to_string(view.edges) + " drawn edges, of which " + std::to_string(judged) +
         " were compared with the truth; the drawing is " + format_rounded(view.size, 4) + " mm long.\n";
}

std::string meanings(const Table& table) {
  std::string text;
  for (const Table::Column& column : table.columns)
    if (!column.meaning.empty()) text += "\n" + column.name + ": " + column.meaning;
  return text + "\n";
}

// Each diagram above its table.
std::string to_html(const AccuracyReport& report) {
  std::vector<sheet::Sheet> sheets;
  std::string notes;
  for (std::size_t i = 0; i < report.views.size(); ++i) {
    const ViewMeasurements& view = report.views[i];
    sheets.push_back(stacked(to_sheet(diagram_of(view, i)),
                             to_sheet(table_of(std::span(&view, 1)), view.scene + ", " + view.view, Columns::all)));
    notes += facts_of(view);
  }
  if (!report.maps.empty())
    sheets.push_back(stacked(to_sheet(diagram_of(report.maps)),
                             to_sheet(table_of_maps(report.maps), "Projection maps", Columns::all)));
  return report_page("Error against run time", sheets, notes + meanings(table_of(report.views)));
}

std::string to_json(const AccuracyReport& report) {
  return "{\"epura_study\": \"accuracy\",\n \"methods\": " + to_json_list(table_of(report.views)) +
         ",\n \"maps\": " + to_json_list(table_of_maps(report.maps)) + "}\n";
}

std::vector<sheet::Sheet> sheets_of(const AccuracyReport& report) {
  std::vector<sheet::Sheet> sheets;
  for (std::size_t i = 0; i < report.views.size(); ++i) sheets.push_back(to_sheet(diagram_of(report.views[i], i)));
  if (!report.maps.empty()) sheets.push_back(to_sheet(diagram_of(report.maps)));
  return sheets;
}

// Diagrams, each followed by its table.
std::string to_pdf(const AccuracyReport& report) {
  std::vector<sheet::Sheet> sheets;
  for (std::size_t i = 0; i < report.views.size(); ++i) {
    const ViewMeasurements& view = report.views[i];
    sheets.push_back(to_sheet(diagram_of(view, i)));
    sheets.push_back(to_sheet(table_of(std::span(&view, 1)), view.scene + ", " + view.view, Columns::printed));
  }
  if (!report.maps.empty()) sheets.push_back(to_sheet(diagram_of(report.maps)));
  output::Pages pages;
  for (const sheet::Sheet& sheet : sheets) pages.push_back(&sheet);
  return epura::output::to_pdf(pages);
}

// Methods in the order given, and their points in order of time.
std::vector<PlotCurve> curves_of(const ViewMeasurements& view) {
  std::vector<PlotCurve> curves;
  for (const Measurement& one : view.methods) {
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const auto& c) { return c.name == one.method; });
    if (curve == curves.end()) curve = curves.insert(curves.end(), {one.method, {}});
    curve->points.push_back(
        {{std::max(one.median, 1e-9), one.errors.longest / view.size}, one.parameters, one.on_front});
  }
  return curves;
}

}  // namespace

LogPlot diagram_of(const ViewMeasurements& view, std::size_t number) {
  LogPlot plot{"plot-" + std::to_string(number), view.scene + ", " + view.view, "seconds to find hidden lines (median)",
               "longest misclassified span / size of the drawing", curves_of(view)};
  plot.note = "full marks: no other method is both faster and better; at 1e-10: no error found";
  plot.marks.push_back({"guaranteed: 1e-6", guaranteed_part, false});
  if (view.read_seconds > 0) plot.marks.push_back({"time to read the models", view.read_seconds, true});
  return plot;
}

LogPlot diagram_of(const std::vector<MapMeasurement>& maps) {
  LogPlot plot{"plot-maps",
               "Projection maps",
               "distance of the model from the origin / its size",
               "error of places on the page / size of the model",
               {}};
  plot.least_y = 1e-17;
  for (const MapMeasurement& one : maps) {
    if (!std::isfinite(one.error)) continue;
    const std::string name = one.map + ", " + one.way;
    auto curve = std::find_if(plot.curves.begin(), plot.curves.end(), [&](const auto& c) { return c.name == name; });
    if (curve == plot.curves.end()) curve = plot.curves.insert(plot.curves.end(), {name, {}});
    curve->points.push_back({{one.offset, one.error}, ""});
  }
  return plot;
}

std::vector<std::string> to_files(const AccuracyReport& report, ReportFormat format) {
  const auto each_sheet = [&](const auto& write) {
    std::vector<std::string> files;
    for (const sheet::Sheet& sheet : sheets_of(report)) files.push_back(write(sheet));
    return files;
  };
  switch (format) {
    case ReportFormat::html:
      return {to_html(report)};
    case ReportFormat::pdf:
      return {to_pdf(report)};
    case ReportFormat::csv:
      return {to_csv(table_of(report.views))};
    case ReportFormat::json:
      return {to_json(report)};
    case ReportFormat::svg:
      return each_sheet([](const sheet::Sheet& sheet) { return output::to_svg(sheet, {}); });
    case ReportFormat::png:
      return each_sheet([](const sheet::Sheet& sheet) { return output::to_png(sheet, picture_dpi); });
  }
  return {};
}

}  // namespace epura::study
