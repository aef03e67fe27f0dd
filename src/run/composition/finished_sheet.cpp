// SPDX-License-Identifier: Apache-2.0
#include "composition/finished_sheet.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "drawing/chains.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/drawing.hpp"
#include "sheet/partial_mark.hpp"
#include "views/budget.hpp"

namespace epura::pipeline {

namespace {

double length_of(const sheet::Stroke& stroke) {
  return stroke.points.empty() ? 0 : drawing::distances_along(stroke.points, stroke.closed, stroke.curves).back();
}

// Keeps the longest strokes, in their original order.
void keep_longest(std::vector<sheet::Stroke>& strokes, std::size_t count) {
  std::vector<double> length;
  for (const sheet::Stroke& stroke : strokes) length.push_back(length_of(stroke));
  std::vector<std::size_t> order(strokes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return length[a] > length[b]; });
  order.resize(std::min(count, order.size()));
  std::sort(order.begin(), order.end());
  std::vector<sheet::Stroke> kept;
  for (const std::size_t i : order) kept.push_back(std::move(strokes[i]));
  strokes = std::move(kept);
}

bool draws_edges(const sheet::Layer& layer) {
  return std::any_of(layer.strokes.begin(), layer.strokes.end(),
                     [](const sheet::Stroke& s) { return s.kind.has_value(); });
}

}  // namespace

std::pair<std::size_t, std::size_t> faults_of(const FinishedSheet& sheet) {
  std::size_t count = sheet.without_room;
  for (const std::vector<std::size_t>& of_view : sheet.left_out) count += of_view.size();
  const auto fans = std::count_if(sheet.findings.begin(), sheet.findings.end(),
                                  [](const report::Finding& one) { return one.kind == report::FindingKind::fan; });
  return {count, static_cast<std::size_t>(fans)};
}

bool is_complete(const FinishedSheet& sheet) {
  // No other layout shows more of the part.
  const auto is_of_layout = [](const report::Finding& one) { return one.kind != report::FindingKind::undimensioned; };
  return faults_of(sheet).first == 0 && std::none_of(sheet.findings.begin(), sheet.findings.end(), is_of_layout) &&
         !sheet.is_crowded;
}

void mark_partial(FinishedSheet& sheet, const std::string& stage) {
  sheet::Layer mark = sheet::partial_mark(sheet.paper, stage);
  std::erase_if(sheet.sheet.layers, [&](const sheet::Layer& layer) { return layer.name == mark.name; });
  sheet.sheet.layers.push_back(std::move(mark));
}

bool keep_longest_lines(std::span<FinishedSheet> sheets, report::Partial& partial) {
  std::size_t left = 0, layers = 0;
  for (FinishedSheet& sheet : sheets) {
    for (sheet::Layer& layer : sheet.sheet.layers) {
      if (!draws_edges(layer)) continue;
      const std::size_t before = layer.strokes.size();
      keep_longest(layer.strokes, fewer(before));
      partial.undrawn += static_cast<long long>(before - layer.strokes.size());
      left += layer.strokes.size();
      ++layers;
    }
    for (drawing::ViewDrawing& drawing : sheet.drawings)
      drawing::keep_longest_chains(drawing, fewer(drawing.chains.size()));
  }
  return left <= few_lines * layers;
}

}  // namespace epura::pipeline
