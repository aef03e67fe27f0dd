// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/report.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.hpp"
#include "study/accuracy/tables.hpp"

namespace epura::study {

namespace {

constexpr double guaranteed_part = 1e-6;  // docs/numerics.md

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

// Methods in the order given, and their points in order of time.
std::vector<PlotCurve> curves_of(const ViewMeasurements& view) {
  std::vector<PlotCurve> curves;
  for (const Measurement& one : view.methods) {
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const auto& c) { return c.name == one.method; });
    if (curve == curves.end()) curve = curves.insert(curves.end(), {one.method, {}});
    const auto [least, most] = quartiles_of(one.seconds);
    curve->points.push_back({{std::max(one.median, 1e-9), one.errors.longest / view.size},
                             one.parameters,
                             one.on_front,
                             {std::max(least, 1e-9), std::max(most, 1e-9)}});
  }
  return curves;
}

}  // namespace

LogPlot diagram_of(const ViewMeasurements& view, std::size_t number) {
  LogPlot plot{"plot-" + std::to_string(number), view.scene + ", " + view.view, "seconds to find hidden lines (median)",
               "longest misclassified span / size of the drawing", curves_of(view)};
  plot.note =
      "full marks, grey line: no other method is both faster and better; bars: quartiles; at 1e-10: no error found";
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
  plot.min_y = 1e-17;
  for (const MapMeasurement& one : maps) {
    if (!std::isfinite(one.error)) continue;
    const std::string name = one.map + ", " + one.way;
    auto curve = std::find_if(plot.curves.begin(), plot.curves.end(), [&](const auto& c) { return c.name == name; });
    if (curve == plot.curves.end()) curve = plot.curves.insert(plot.curves.end(), {name, {}});
    curve->points.push_back({{one.offset, one.error}, ""});
  }
  return plot;
}

StudyReport report_of(const AccuracyReport& report) {
  StudyReport all{"accuracy", "Error against run time", {}, {}, {}};
  for (std::size_t i = 0; i < report.views.size(); ++i) {
    const ViewMeasurements& view = report.views[i];
    all.chapters.push_back({diagram_of(view, i), table_of(std::span(&view, 1)), view.scene + ", " + view.view});
    all.notes += facts_of(view);
  }
  const Table maps = table_of_maps(report.maps);
  if (!report.maps.empty()) all.chapters.push_back({diagram_of(report.maps), maps, "Projection maps", false});
  all.tables = {{"methods", table_of(report.views)}, {"maps", maps}};
  all.notes += meanings(all.tables.front().second);
  return all;
}

}  // namespace epura::study
