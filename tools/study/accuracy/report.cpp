// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/report.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.hpp"
#include "study/accuracy/measure.hpp"
#include "study/table.hpp"

namespace epura::study {

namespace {

// Six digits: more than the accuracy of any measurement here.
std::string number(double value) { return std::isfinite(value) ? format_rounded(value, 6) : "inf"; }

std::string number(long long value) { return std::to_string(value); }

std::vector<Table::Column> columns() {
  constexpr bool text = false, number = true, printed = true;
  return {{"scene", "what is drawn", text},
          {"view", "how", text},
          {"method", "by which hidden lines were found", text, printed},
          {"knob", "its setting", text, printed},
          {"E_max_mm", "longest misclassified span", number, printed},
          {"E_sum_mm", "all misclassified spans together", number, printed},
          {"E_ink_mm", "Hausdorff distance of the visible ink, both ways", number, printed},
          {"end_mm", "farthest shift of an end of a visible span", number, printed},
          {"E_max", "the same four as parts of the drawing's longest side"},
          {"E_sum", ""},
          {"E_ink", ""},
          {"end", ""},
          {"missed", "visible spans of which nothing is shown", number, printed},
          {"phantom", "spans shown visible of which nothing is", number, printed},
          {"cracks", "gaps in visible spans", number, printed},
          {"wrong", "edges with a misclassified span", number, printed},
          {"judged", "edges that were compared with the truth", number, printed},
          {"edges", "all drawn edges"},
          {"at_most_wrong", "share of wrong edges: measured where all were judged, otherwise with 95 % confidence"},
          {"undecided", "share of the judged length about which the input does not tell"},
          {"seconds", "median", number, printed},
          {"fastest", "seconds"},
          {"slowest", "seconds"},
          {"runs", "in turns with the other methods"},
          {"memory_MB", "by which the process grew at most", number, printed},
          {"read_seconds", "to read the models"},
          {"front", "1: no other method is both faster and better", number, printed}};
}

std::vector<std::string> row_of(const ViewMeasurements& view, const Measurement& one) {
  const Errors& e = one.errors;
  const auto [fastest, slowest] = std::minmax_element(one.seconds.begin(), one.seconds.end());
  const bool ran = !one.seconds.empty();
  return {view.scene,
          view.view,
          one.method,
          one.parameters,
          number(e.longest),
          number(e.sum),
          number(e.ink),
          number(e.end_point),
          number(e.longest / view.size),
          number(e.sum / view.size),
          number(e.ink / view.size),
          number(e.end_point / view.size),
          number(e.missed),
          number(e.phantom),
          number(e.cracks),
          number(e.edges),
          number(e.judged),
          number(static_cast<long long>(view.edges)),
          number(one.at_most_wrong),
          number(view.undecided),
          number(one.median),
          ran ? number(*fastest) : "",
          ran ? number(*slowest) : "",
          number(static_cast<long long>(one.seconds.size())),
          one.memory ? number(*one.memory * 1e-6) : "",
          number(view.read_seconds),
          one.on_front ? "1" : "0"};
}

/// A row for each method with each set of parameters.
Table table_of(std::span<const ViewMeasurements> views) {
  Table table{columns(), {}};
  for (const ViewMeasurements& view : views)
    for (const Measurement& one : view.methods) table.rows.push_back(row_of(view, one));
  return table;
}

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
