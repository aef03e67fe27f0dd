// SPDX-License-Identifier: Apache-2.0
#include "study/paper/report.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "study/accuracy/measure.hpp"

namespace epura::study {

namespace {

constexpr double narrow_line = 0.35;  // mm; an error of that width is seen

std::string rounded(double value) { return std::isfinite(value) ? format_rounded(value, 4) : "inf"; }

// 998000 as 998k.
std::string short_count(int count) {
  if (count >= 1000000) return format_rounded(count * 1e-6, 3) + "M";
  return count >= 10000 ? format_rounded(count * 1e-3, 3) + "k" : std::to_string(count);
}

Table::Column column(const char* name, const char* meaning, bool is_number = true, bool printed = true) {
  return {name, meaning, is_number, printed};
}

Table table_of(const std::vector<PaperSeries>& all) {
  Table table{
      {column("scene", "what is drawn", false, false),
       column("way", "with surfaces recognised, and arcs on them, or of the triangles as they are", false),
       column("around", "facets around the body, or around the tube of a torus"), column("triangles", "of the mesh"),
       column("error_mm", "Hausdorff distance of the visible lines on paper, both ways"),
       column("drawn_mm", "of drawn lines from true ones"), column("true_mm", "of true lines from drawn ones"),
       column("stated_mm", "the error that the drawing states"), column("dominant", "the largest term of that", false),
       column("missed_mm", "length of true lines that are farther away than stated"),
       column("phantom_mm", "length of drawn lines that are"),
       column("order", "of convergence with the length of facets, over the finer half", true, false),
       column("seconds", "median, from the mesh in memory to the lines on paper"),
       column("first_quartile", "seconds", true, false), column("third_quartile", "seconds", true, false),
       column("runs", "in turns", true, false),
       column("front", "1: no other run of the scene is both faster and better", true, false)},
      {}};
  for (const PaperSeries& series : all)
    for (const PaperRun& run : series.runs) {
      const PaperError& e = run.error;
      const auto [first, third] = quartiles_of(run.seconds);
      const bool states = e.budget.total() > 0;  // rivals do not
      const auto compared = [&](double value) { return states ? rounded(value) : ""; };
      table.rows.push_back({series.scene, series.way, std::to_string(run.around), std::to_string(run.triangles),
                            rounded(e.ink()), rounded(e.drawn), rounded(e.truth), compared(e.budget.total()),
                            states ? report::row_of(e.budget.dominant()).name : "", compared(e.missed),
                            compared(e.phantom), format_rounded(series.order(), 2), rounded(median_of(run.seconds)),
                            rounded(first), rounded(third), std::to_string(run.seconds.size()),
                            run.on_front ? "1" : "0"});
    }
  return table;
}

void mark_front(std::vector<PaperSeries>& scene) {
  const auto beats = [](const PaperRun& a, const PaperRun& b) {
    const double one = median_of(a.seconds), other = median_of(b.seconds);
    return one <= other && a.error.ink() <= b.error.ink() && (one < other || a.error.ink() < b.error.ink());
  };
  for (PaperSeries& series : scene)
    for (PaperRun& run : series.runs)
      run.on_front = std::none_of(scene.begin(), scene.end(), [&](const PaperSeries& other) {
        return std::any_of(other.runs.begin(), other.runs.end(), [&](const PaperRun& one) { return beats(one, run); });
      });
}

LogPlot diagram_of(const std::vector<PaperSeries>& scene, std::size_t number) {
  LogPlot plot{"plot-" + std::to_string(number),
               scene.front().scene,
               "seconds from mesh to drawing (median)",
               scene.front().share < 1
                   ? "error on paper of " + format_rounded(100 * scene.front().share, 4) + " % of the lines, mm"
                   : "error on paper, mm",
               {}};
  for (const PaperSeries& series : scene) {
    PlotCurve curve{series.way + (series.runs.size() > 1 ? " (" + format_rounded(series.order(), 2) + ")" : ""), {}};
    for (const PaperRun& run : series.runs)
      curve.points.push_back({{std::max(median_of(run.seconds), 1e-6), run.error.ink()},
                              short_count(run.triangles),
                              run.on_front,
                              quartiles_of(run.seconds)});
    plot.curves.push_back(std::move(curve));
  }
  plot.marks.push_back({"width of a narrow line", narrow_line, false});
  plot.note =
      "labels: triangles; full marks, grey line: nothing is both faster and better; bars: quartiles; (order of "
      "convergence)";
  return plot;
}

}  // namespace

StudyReport report_of(std::vector<PaperSeries> all) {
  StudyReport report{"paper", "Error on paper against run time", {}, {}, {}};
  std::vector<PaperSeries> marked;
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end = std::find_if(begin, all.end(), [&](const PaperSeries& s) { return s.scene != begin->scene; });
    std::vector<PaperSeries> scene(begin, end);
    mark_front(scene);
    report.chapters.push_back({diagram_of(scene, report.chapters.size()), table_of(scene), scene.front().scene});
    marked.insert(marked.end(), scene.begin(), scene.end());
    begin = end;
  }
  report.tables = {{"runs", table_of(marked)}};
  report.notes = meanings(report.tables.front().second);
  return report;
}

}  // namespace epura::study
