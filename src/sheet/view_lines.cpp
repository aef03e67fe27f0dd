// SPDX-License-Identifier: Apache-2.0
#include "sheet/view_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "drawing/curve_part.hpp"
#include "sheet/crossings.hpp"
#include "sheet/dash.hpp"
#include "sheet/ink_density.hpp"

namespace epura::sheet {

namespace {

constexpr double tangent_gap = 2;  // wide lines
constexpr std::size_t chains_a_part = 1024;

// Sets the origin of a stroke from the segments of the chain: their kind, and the model edges, each run of one edge
// once.
void add_origin(Stroke& stroke, const drawing::ViewDrawing& drawing, EdgeKind kind, std::span<const int> segments) {
  stroke.kind = kind;
  for (const int index : segments) {
    const drawing::Segment& segment = drawing.segments[static_cast<std::size_t>(index)];
    if (segment.edge[0] < 0) continue;
    const auto [low, high] = std::minmax(segment.edge[0], segment.edge[1]);
    const ModelEdge edge{segment.model, {low, high}};
    if (stroke.edges.empty() || edge != stroke.edges.back()) stroke.edges.push_back(edge);
  }
}

Stroke continuous(const drawing::ViewDrawing& drawing, const drawing::Chain& chain) {
  Stroke stroke;
  stroke.points = chain.points;
  stroke.closed = chain.closed;
  stroke.curves = chain.curves;
  add_origin(stroke, drawing, chain.kind, chain.segments);
  return stroke;
}

// The segments that a run draws; all of the chain if segments and points do not correspond one to one.
std::vector<int> segments_of(const drawing::Chain& chain, const DashRun& run) {
  const std::size_t lines = chain.points.size() - (chain.closed ? 0 : 1);
  if (chain.segments.size() != lines) return chain.segments;
  std::vector<int> segments;
  for (int i = run.first; i < run.last; ++i) segments.push_back(chain.segments[static_cast<std::size_t>(i) % lines]);
  return segments;
}

// The crossings on a run, from its beginning, which is at `start` on the chain; `around` is the length of the chain.
std::vector<double> crossings_of_run(const std::vector<double>& crossings, double start, double length, double around) {
  std::vector<double> found;
  for (const double s : crossings) {
    const double from_start = s >= start ? s - start : s + around - start;
    if (from_start <= length) found.push_back(from_start);
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Converts positions along the straight lines of a chain to positions along its curves.
std::vector<double> onto_curves(std::vector<double> places, const drawing::Chain& chain,
                                const std::vector<double>& distances) {
  if (chain.curves.empty()) return places;
  const std::vector<double> straight = drawing::distances_along(chain.points, chain.closed, {});
  std::size_t i = 0;
  for (double& place : places) {
    while (i + 2 < straight.size() && straight[i + 1] < place) ++i;
    const double step = straight[i + 1] - straight[i];
    const double part = step > 0 ? (place - straight[i]) / step : 0;
    place = distances[i] + part * (distances[i + 1] - distances[i]);
  }
  return places;
}

/// A chain to be dashed.
struct DashedChain {
  const drawing::ViewDrawing& drawing;
  const drawing::Chain& chain;
  double width;
  std::vector<double> distances;  ///< of its points
  std::vector<double> crossings;  ///< positions along it

  [[nodiscard]] double distance(int i) const {
    const int count = static_cast<int>(chain.points.size());
    return i < count ? distances[i] : distances[i - count] + distances.back();
  }
  [[nodiscard]] Stroke stroke(const DashRun& run) const;
};

Stroke DashedChain::stroke(const DashRun& run) const {
  Stroke stroke;
  stroke.closed = run.closed;
  for (int i = run.first; i <= run.last - (run.closed ? 1 : 0); ++i)
    stroke.points.push_back(chain.points[static_cast<std::size_t>(i) % chain.points.size()]);
  stroke.curves = drawing::curves_between(chain.curves, chain.points, run.first, run.last);
  const double start = distance(run.first), length = distance(run.last) - start;
  FittedDashes fitted =
      fit_crossings(length, width, stroke.closed, crossings_of_run(crossings, start, length, distances.back()));
  stroke.dashes = fitted.dashes;
  stroke.pattern = std::move(fitted.pattern);
  add_origin(stroke, drawing, chain.kind, segments_of(chain, run));
  return stroke;
}

// Lines too short for two dashes remain continuous.
bool is_dashed(const drawing::Chain& chain, double width) {
  return chain.points.size() >= 2 &&
         length_of(chain.points, chain.closed, chain.curves) >= scene::dashed.shortest() * width;
}

std::vector<DashRun> dash_runs(const drawing::Chain& chain, double width) {
  return cut_at_corners(chain.points, chain.closed, scene::dashed.shortest() * width, chain.curves);
}

// Draws a stroke for each run.
void draw_dashed(Stroke* strokes, const drawing::ViewDrawing& drawing, std::size_t number, double width,
                 const Crossings& crossings) {
  const drawing::Chain& chain = drawing.chains[number];
  std::vector<double> distances = drawing::distances_along(chain.points, chain.closed, chain.curves);
  std::vector<double> places = onto_curves(crossings.along(number, width), chain, distances);
  const DashedChain dashed_chain{drawing, chain, width, std::move(distances), std::move(places)};
  for (const DashRun& run : dash_runs(chain, width)) *strokes++ = dashed_chain.stroke(run);
}

// A line with dots is fitted as a whole.
Stroke dotted(const drawing::ViewDrawing& drawing, const drawing::Chain& chain, double width,
              const scene::DashType& type) {
  Stroke stroke = continuous(drawing, chain);
  const double length = length_of(chain.points, chain.closed, chain.curves);
  stroke.dashes = chain.closed ? fit_closed(length, width, type) : fit_open(length, width, type);
  return stroke;
}

// Takes `by` off the end of a longer line. The curve there is kept up to its last remaining point.
void shorten(Stroke& stroke, double by) {
  std::vector<Vec2>& points = stroke.points;
  std::size_t end = points.size() - 1;
  for (; end > 1 && glm::distance(points[end], points[end - 1]) <= by; --end)
    by -= glm::distance(points[end], points[end - 1]);
  stroke.curves = drawing::curves_between(stroke.curves, points, 0, static_cast<int>(end) - 1);
  points.resize(end + 1);
  const Vec2 step = points[end - 1] - points[end];
  points[end] += step * (by / glm::length(step));
}

void turn_round(Stroke& stroke) {
  const int last = static_cast<int>(stroke.points.size()) - 1;
  std::reverse(stroke.points.begin(), stroke.points.end());
  std::reverse(stroke.curves.begin(), stroke.curves.end());
  for (drawing::CurvePart& curve : stroke.curves) {
    std::swap(curve.from, curve.to);
    curve.first = last - std::exchange(curve.last, last - curve.first);
  }
}

// Tangent edges end short of outlines (ISO 128-3, imaginary intersections).
Stroke tangent(const drawing::ViewDrawing& drawing, const drawing::Chain& chain, double gap,
               const Crossings& crossings) {
  Stroke stroke = continuous(drawing, chain);
  if (chain.closed || chain.points.size() < 2 || length_of(chain.points, false) < 4 * gap) return stroke;
  const bool at_last = crossings.has_outline_at(chain.points.back());
  const bool at_first = crossings.has_outline_at(chain.points.front());
  if (at_last) shorten(stroke, gap);
  if (at_first) {
    turn_round(stroke);
    shorten(stroke, gap);
    turn_round(stroke);
  }
  return stroke;
}

using Strokes = std::array<std::vector<Stroke>, scene::sheet_lines.size()>;

std::vector<Stroke>& strokes_of(Strokes& strokes, scene::SheetLine line) {
  return strokes[static_cast<std::size_t>(line)];
}

scene::SheetLine line_of(EdgeKind kind, bool visible, const ModelStyle& look) {
  if (!visible) return look.hidden == HiddenLines::solid ? scene::SheetLine::hidden_solid : scene::SheetLine::hidden;
  return look.line == LineRole::visible ? edge_line(kind, true).value() : scene::line_of(look.line);
}

bool is_drawn(EdgeKind kind, bool visible, const ModelStyle& look) {
  return visible || (look.hidden != HiddenLines::none && edge_line(kind, false));
}

struct Looks {
  const std::vector<ModelStyle>& by_model;

  const ModelStyle& operator()(const drawing::ViewDrawing& drawing, const drawing::Chain& chain) const {
    return by_model[static_cast<std::size_t>(drawing.segments[chain.segments.front()].model)];
  }
};

struct ChainPlan {
  scene::SheetLine line;
  bool in_dashes;
  std::size_t strokes;  ///< 0: not drawn
};

ChainPlan plan_of(const drawing::Chain& chain, const ModelStyle& look, const LineWidths& widths) {
  const scene::SheetLine line = line_of(chain.kind, chain.visible, look);
  if (!is_drawn(chain.kind, chain.visible, look)) return {line, false, 0};
  if (line != scene::SheetLine::hidden || !is_dashed(chain, widths.narrow)) return {line, false, 1};
  return {line, true, dash_runs(chain, widths.narrow).size()};
}

struct ChainsToDraw {
  const drawing::ViewDrawing& drawing;
  const LineWidths& widths;
  const Crossings& crossings;
};

void draw_chain(Stroke* strokes, const ChainPlan& plan, const ChainsToDraw& all, std::size_t number) {
  const auto& [drawing, widths, crossings] = all;
  const drawing::Chain& chain = drawing.chains[number];
  if (plan.in_dashes) return draw_dashed(strokes, drawing, number, widths.narrow, crossings);
  const scene::DashType& type = scene::row_of(plan.line).dashes;
  *strokes = type.dots > 0 ? dotted(drawing, chain, line_style(plan.line, widths).width, type)
             : plan.line == scene::SheetLine::tangent ? tangent(drawing, chain, tangent_gap * widths.wide, crossings)
                                                      : continuous(drawing, chain);
}

// If lines are so dense that every gap would meet one, dashes cannot avoid them.
std::vector<std::size_t> without_crowded(const std::vector<std::size_t>& chains, const drawing::ViewDrawing& drawing,
                                         double width, const Progress& progress) {
  if (chains.empty()) return chains;
  const double least_gap = 2.5 * width, cell = 16 * width;
  // Lines in random directions cross another line 2 / pi times as often as their density suggests (Buffon).
  const double crowded = std::numbers::pi / 2 / least_gap;
  const InkDensity density(drawing.chains, cell, progress);
  std::vector<char> keep(chains.size(), 0);
  parallel_for(chains.size(), chains_a_part, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      keep[i] = static_cast<char>(density.along(drawing.chains[chains[i]]) < crowded);
  });
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (keep[i] != 0) kept.push_back(chains[i]);
  return kept;
}

// Chains whose dashes depend on crossings, and chains that end short of others.
std::vector<std::size_t> crossed_chains(const drawing::ViewDrawing& drawing, const LineWidths& widths,
                                        const std::vector<ChainPlan>& plans, const Progress& progress) {
  std::vector<std::size_t> with_dashes, chains;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (plans[i].in_dashes) with_dashes.push_back(i);
    if (plans[i].line == scene::SheetLine::tangent && plans[i].strokes > 0) chains.push_back(i);
  }
  with_dashes = without_crowded(with_dashes, drawing, widths.narrow, progress);
  const auto middle = chains.insert(chains.end(), with_dashes.begin(), with_dashes.end());
  std::inplace_merge(chains.begin(), middle, chains.end());
  return chains;
}

// In order of the chains. Strokes take most of the memory of a large drawing: they are counted first and built in
// place.
Strokes strokes_of(const drawing::ViewDrawing& drawing, const LineWidths& widths, const Looks& styles,
                   const Progress& progress) {
  const std::size_t count = drawing.chains.size();
  std::vector<ChainPlan> plans(count);
  parallel_for(count, chains_a_part, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      plans[i] = plan_of(drawing.chains[i], styles(drawing, drawing.chains[i]), widths);
  });
  const Crossings crossings(drawing.chains, crossed_chains(drawing, widths, plans, progress), progress);
  std::vector<std::size_t> first(count);  // first stroke of each chain among those of its line type
  std::array<std::size_t, scene::sheet_lines.size()> all{};
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t& counted = all[static_cast<std::size_t>(plans[i].line)];
    first[i] = std::exchange(counted, counted + plans[i].strokes);
  }
  Strokes strokes;
  for (std::size_t line = 0; line < all.size(); ++line) strokes[line].resize(all[line]);
  parallel_for(count, chains_a_part, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (plans[i].strokes > 0)
        draw_chain(strokes_of(strokes, plans[i].line).data() + first[i], plans[i], {drawing, widths, crossings}, i);
    progress.advance(end - begin);
  });
  return strokes;
}

}  // namespace

std::optional<scene::SheetLine> edge_line(EdgeKind kind, bool visible) {
  if (!visible) return edges::is_within_surface(kind) ? std::nullopt : std::optional(scene::SheetLine::hidden);
  if (kind == EdgeKind::section) return scene::SheetLine::section;
  if (kind == EdgeKind::wire) return scene::SheetLine::wire;
  return edges::is_within_surface(kind) ? scene::SheetLine::tangent : scene::SheetLine::visible;
}

int line_strength(EdgeKind kind, bool visible, const ModelStyle& style) {
  return is_drawn(kind, visible, style) ? static_cast<int>(line_of(kind, visible, style)) : -1;
}

std::vector<Layer> view_layers(const drawing::ViewDrawing& drawing, const LineWidths& widths,
                               const std::vector<ModelStyle>& styles, const Progress& progress) {
  progress.begin("fitting dashes", drawing.chains.size());
  Strokes strokes = strokes_of(drawing, widths, {styles}, progress);
  const auto wants = [&](HiddenLines hidden) {
    return std::any_of(styles.begin(), styles.end(), [&](const ModelStyle& look) { return look.hidden == hidden; });
  };
  const auto is_always_there = [&](scene::SheetLine line) {
    return line == scene::SheetLine::visible || (line == scene::SheetLine::hidden && wants(HiddenLines::dashed)) ||
           (line == scene::SheetLine::hidden_solid && wants(HiddenLines::solid));
  };
  std::vector<Layer> layers;
  for (const scene::SheetLineRow& row : scene::sheet_lines) {
    std::vector<Stroke>& drawn = strokes_of(strokes, row.line);
    if (drawn.empty() && !is_always_there(row.line)) continue;
    Layer& layer = layers.emplace_back(empty_layer(drawing.name, row.line, widths));
    layer.strokes = std::move(drawn);
    const bool alone = row.line == scene::SheetLine::hidden_solid && !wants(HiddenLines::dashed);
    if (alone) layer.name = drawing.name + "/" + scene::row_of(scene::SheetLine::hidden).layer;
  }
  return layers;
}

}  // namespace epura::sheet
