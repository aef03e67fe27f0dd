// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/measure.hpp"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "drawing/make_drawing.hpp"
#include "oracle/span_sets.hpp"
#include "verify/confidence.hpp"
#include "visibility/limits.hpp"

namespace epura::study {

namespace {

// A line such as "VmHWM:     1234 kB".
std::optional<double> bytes_in_status(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_of("0123456789");
    const auto number = begin == std::string::npos
                            ? std::nullopt
                            : parse_number(std::string_view(line).substr(begin, line.find(' ', begin) - begin));
    if (number) return *number * 1024;
  }
  return std::nullopt;
}

bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

/// Runs `work` and returns by how many bytes the process grew at most in the meantime. Nothing if the system does not
/// report it (Linux: /proc/self/clear_refs, proc(5)).
std::optional<double> peak_memory_of(const std::function<void()>& work) {
  malloc_trim(0);  // otherwise memory freed by earlier work would be reused without being counted
  const bool told = forget_peak();
  const std::optional<double> before = bytes_in_status("VmRSS:");
  work();
  const std::optional<double> peak = bytes_in_status("VmHWM:");
  if (!told || !before || !peak) return std::nullopt;
  return std::max(*peak - *before, 0.0);
}

constexpr double confidence = 0.95;

double seconds_of(const std::function<visibility::HiddenSpans()>& run) {
  const auto start = std::chrono::steady_clock::now();
  const visibility::HiddenSpans found = run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void mark_front(std::vector<Measurement>& methods) {
  for (Measurement& one : methods)
    one.on_front = std::none_of(methods.begin(), methods.end(), [&](const Measurement& other) {
      const bool worse = other.median > one.median || other.errors.longest > one.errors.longest;
      return !worse && (other.median < one.median || other.errors.longest < one.errors.longest);
    });
}

std::array<Vec2, 2> on_paper(const StudiedView& studied, int edge) {
  const edges::FeatureEdge& drawn = studied.drawn.edges[edge];
  return {drawing::position_on_paper(studied.view, studied.paper, drawn, 0),
          drawing::position_on_paper(studied.view, studied.paper, drawn, 1)};
}

double undecided_share(const StudiedView& studied, const std::vector<EdgeTruth>& truth) {
  double all = 0, undecided = 0;
  for (const EdgeTruth& edge : truth) {
    const auto [from, to] = on_paper(studied, edge.edge);
    const double length = glm::distance(from, to);
    all += length;
    for (const auto& span : without(edge.perhaps, edge.surely)) undecided += (span[1] - span[0]) * length;
  }
  return all > 0 ? undecided / all : 0;
}

// The exact fraction if all edges were tested, otherwise a bound.
double share_of_wrong(const Errors& errors, bool all) {
  const auto wrong = static_cast<int>(errors.edges), judged = static_cast<int>(errors.judged);
  if (!all) return verify::greatest_share(wrong, judged, confidence);
  return judged > 0 ? static_cast<double>(wrong) / judged : 0;
}

}  // namespace

Contender contender(const StudiedView& studied, const Method& method) {
  return {name_of(method.algorithm), parameters_of(method), [&studied, method] {
            return find_hidden(studied.world, studied.view, studied.drawn, method, studied.paper.scale);
          }};
}

std::vector<EdgeTruth> truth_of(const StudiedView& studied, const TruthEffort& effort) {
  drawing::ViewDrawing drawing;
  drawing.projection = studied.view.projection;
  drawing.world_to_page = view::world_to_page(studied.view, studied.paper);
  const visibility::HiddenSpans hidden = visibility::nothing_hidden(studied.drawn);
  return find_truth({studied.world, studied.view.projection, studied.limits, studied.drawn, hidden, drawing},
                    studied.view, effort);
}

Errors errors_of(const StudiedView& studied, const std::vector<EdgeTruth>& truth,
                 const visibility::HiddenSpans& shown) {
  std::vector<JudgedEdge> edges;
  const double min = visibility::min_piece * studied.view.extent * studied.paper.scale;
  for (const EdgeTruth& edge : truth) {
    const auto [from, to] = on_paper(studied, edge.edge);
    if (glm::distance(from, to) <= min) continue;
    const visibility::Spans spans = hidden_parts(shown, static_cast<std::size_t>(edge.edge));
    edges.push_back({from, to, spans, nearest_right(spans, edge)});
  }
  return measure_errors(edges, min);
}

ViewMeasurements measure(const StudiedView& studied, std::span<const Contender> contenders, const StudyEffort& effort) {
  ViewMeasurements result{studied.scene, studied.name, studied.view.triangles.size(), studied.drawn.edges.size(),
                          studied.view.extent * studied.paper.scale};
  const std::vector<EdgeTruth> truth = truth_of(studied, effort.truth);
  result.undecided = undecided_share(studied, truth);
  for (const Contender& contender : contenders) {
    Measurement& one = result.methods.emplace_back();
    one.method = contender.method;
    one.parameters = contender.parameters;
    visibility::HiddenSpans found;
    one.memory = peak_memory_of([&] { found = contender.run(); });
    one.errors = errors_of(studied, truth, found);
    one.at_most_wrong = share_of_wrong(one.errors, truth.size() == studied.drawn.edges.size());
  }
  for (int run = 0; run < effort.runs; ++run)
    for (std::size_t i = 0; i < contenders.size(); ++i)
      result.methods[i].seconds.push_back(seconds_of(contenders[i].run));
  for (Measurement& one : result.methods) one.median = median_of(one.seconds);
  mark_front(result.methods);
  return result;
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::array<double, 2> quartiles_of(std::vector<double> values) {
  if (values.empty()) return {0, 0};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const double place = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double above = values[std::min(below + 1, values.size() - 1)];
    return values[below] + (place - static_cast<double>(below)) * (above - values[below]);
  };
  return {at(0.25), at(0.75)};
}

}  // namespace epura::study
