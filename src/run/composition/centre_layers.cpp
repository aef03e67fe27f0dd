// SPDX-License-Identifier: Apache-2.0
#include "composition/centre_layers.hpp"

#include <algorithm>
#include <utility>

#include "annotations/centre_lines.hpp"
#include "annotations/cutting_plane_line.hpp"
#include "annotations/limit_lines.hpp"

namespace epura::pipeline {

std::vector<sheet::Layer> centre_layers(const ViewResult& view, const ViewOptions& options,
                                        const sheet::LineWidths& widths, std::span<const sheet::Layer> lines,
                                        const Progress& progress) {
  const bool divides = view.section && !view.section->divides.empty();
  const bool is_half = std::any_of(view.drawing.shown.limits.begin(), view.drawing.shown.limits.end(),
                                   [](const drawing::Limit& limit) { return limit.symmetric; });
  if (!options.centre_lines && !divides && !is_half) return {};
  progress.begin("drawing centre lines");
  sheet::Layer layer = sheet::empty_layer(view.drawing.name, scene::SheetLine::centre, widths);
  if (options.centre_lines)
    layer = sheet::centre_lines({view.drawing, view.features, options.styles}, widths, lines, progress);
  if (divides) sheet::add_dividing_lines(layer, view.drawing, *view.section, widths);
  sheet::add_symmetry_lines(layer, view.drawing, widths);
  return {std::move(layer)};
}

}  // namespace epura::pipeline
