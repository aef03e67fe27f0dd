// SPDX-License-Identifier: Apache-2.0
#include "library/results.hpp"

#include <algorithm>
#include <array>

#include "drawing/drawing.hpp"

namespace epura {

namespace {

std::array<double, 2> pair_of(const Vec2& p) { return {p.x, p.y}; }

}  // namespace

DrawnView drawn_view(const drawing::ViewDrawing& drawing, int sheet) {
  DrawnView view{drawing.name, drawing.projection.name, sheet, drawing.scale, {}, {}, {}, {}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      view.world_to_page[static_cast<std::size_t>(4 * row + column)] = drawing.world_to_page[column][row];
  view.lines.reserve(drawing.segments.size());
  for (const drawing::Segment& segment : drawing.segments)
    view.lines.push_back({pair_of(segment.from), pair_of(segment.to), segment.kind, segment.visible,
                          drawing.number_in_scene(segment.model), segment.body, segment.edge, segment.t});
  for (const drawing::Chain& chain : drawing.chains)
    for (const drawing::CurvePart& curve : chain.curves)
      view.arcs.push_back(
          {pair_of(curve.centre), pair_of(curve.u), pair_of(curve.v), curve.from, curve.to, chain.kind, chain.visible});
  return view;
}

ErrorBudget error_budget(const report::ViewError& error) {
  ErrorBudget budget;
  for (std::size_t i = 0; i < report::error_terms.size(); ++i) {
    const auto term = static_cast<report::ErrorTerm>(i);
    if (term == report::ErrorTerm::writing || error[term] == 0) continue;
    budget.total += error[term];
    budget.terms.push_back(
        {row_of(term).name, error[term], report::evidence_names[static_cast<std::size_t>(error.evidence(term))]});
  }
  std::stable_sort(budget.terms.begin(), budget.terms.end(),
                   [](const ErrorTerm& a, const ErrorTerm& b) { return a.mm > b.mm; });
  return budget;
}

std::vector<SheetLayer> layers_of(const sheet::Sheet& sheet) {
  std::vector<SheetLayer> layers;
  for (const sheet::Layer& layer : sheet.layers) {
    SheetLayer& made = layers.emplace_back(SheetLayer{layer.name, layer.style.width, {}});
    for (const sheet::Stroke& stroke : layer.strokes) {
      auto& points = made.strokes.emplace_back();
      for (const Vec2& p : stroke.points) points.push_back(pair_of(p));
      if (stroke.closed && !points.empty()) points.push_back(points.front());
    }
  }
  return layers;
}

}  // namespace epura
