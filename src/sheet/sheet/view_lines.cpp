// SPDX-License-Identifier: Apache-2.0
#include "sheet/view_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/drawing.hpp"
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
    const ModelEdge edge{drawing.number_in_scene(segment.model), {low, high}};
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
    check(place >= 0, "a place on a line is not before it");
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
  check(stroke.points.size() >= 2, "a line has two ends");
  const double start = distance(run.first), length = distance(run.last) - start;
  check(length >= 0, "a part of a line goes forwards");
  FittedDashes fitted =
      fit_crossings(length, width, stroke.closed, crossings_of_run(crossings, start, length, distances.back()));
  stroke.dashes = fitted.dashes;
  stroke.pattern = std::move(fitted.pattern);
  add_origin(stroke, drawing, chain.kind, segments_of(chain, run));
  return stroke;
}

// Lines too short for two dashes remain continuous.
bool is_dashed(const drawing::Chain& chain, double width) {
  return chain.points.size() >= 2 && length_of(chain.points, chain.closed, chain.curves) >=
                                         (chain.closed ? scene::dashed.shortest() : shortest_dashed) * width;
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
  check(end >= 1 && by >= 0, "a line is shorter than what it ends before");
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

/// What the lines of a layer have in common; in the order in which layers are painted.
struct LayerKey {
  scene::SheetLine line;
  std::string name;  ///< of the bodies that it is for; empty for all
  Colour colour;

  auto operator<=>(const LayerKey&) const = default;
};

scene::SheetLine stroke_line_of(EdgeKind kind, bool visible, const BodyStyle& look) {
  if (!visible) return look.hidden == HiddenLines::solid ? scene::SheetLine::hidden_solid : scene::SheetLine::hidden;
  return look.line == LineRole::visible ? edge_line(kind, true).value() : scene::line_of(look.line);
}

bool is_drawn(EdgeKind kind, bool visible, const BodyStyle& look) {
  return visible || (look.hidden != HiddenLines::none && edge_line(kind, false));
}

const BodyStyle& style_of(const drawing::ViewDrawing& drawing, const drawing::Chain& chain, const BodyStyles& styles) {
  const drawing::Segment& segment = drawing.segments[chain.segments.front()];
  return styles(segment.model, segment.body);
}

struct ChainPlan {
  scene::SheetLine line;
  bool in_dashes;
  std::size_t strokes;    ///< 0: not drawn
  std::size_t layer = 0;  ///< that has them
  std::size_t first = 0;  ///< of them in the layer
};

ChainPlan plan_of(const drawing::Chain& chain, const BodyStyle& look, const LineWidths& widths) {
  const scene::SheetLine line = stroke_line_of(chain.kind, chain.visible, look);
  if (!is_drawn(chain.kind, chain.visible, look)) return {line, false, 0};
  const scene::DashType type = dash_type(line, widths);
  const double width = line_width(line, widths);
  if (!type.is_broken() || type.dots > 0 || !is_dashed(chain, width)) return {line, false, 1};
  return {line, true, dash_runs(chain, width).size()};
}

struct ChainsToDraw {
  const drawing::ViewDrawing& drawing;
  const LineWidths& widths;
  const Crossings& crossings;
};

void draw_chain(Stroke* strokes, const ChainPlan& plan, const ChainsToDraw& all, std::size_t number) {
  const auto& [drawing, widths, crossings] = all;
  const drawing::Chain& chain = drawing.chains[number];
  const double width = line_width(plan.line, widths);
  if (plan.in_dashes) return draw_dashed(strokes, drawing, number, width, crossings);
  const scene::DashType type = dash_type(plan.line, widths);
  *strokes = type.dots > 0                            ? dotted(drawing, chain, width, type)
             : plan.line == scene::SheetLine::tangent ? tangent(drawing, chain, tangent_gap * widths.wide, crossings)
                                                      : continuous(drawing, chain);
}

// If lines are so dense that every gap would meet one, dashes cannot avoid them.
std::vector<std::size_t> without_crowded(const std::vector<std::size_t>& chains, const drawing::ViewDrawing& drawing,
                                         double width, const Progress& progress) {
  if (chains.empty()) return chains;
  const double min_gap = 2.5 * width, cell = 16 * width;
  // Lines in random directions cross another line 2 / pi times as often as their density suggests (Buffon).
  const double crowded = std::numbers::pi / 2 / min_gap;
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
  with_dashes = without_crowded(with_dashes, drawing, line_width(scene::SheetLine::hidden, widths), progress);
  const auto middle = chains.insert(chains.end(), with_dashes.begin(), with_dashes.end());
  std::inplace_merge(chains.begin(), middle, chains.end());
  return chains;
}

/// Strokes by layer, in painting order.
struct Strokes {
  std::vector<LayerKey> keys;  ///< ascending
  std::vector<std::vector<Stroke>> of_layer;
};

// The keys of all layers that have lines or are `always` there.
std::vector<LayerKey> layer_keys(const drawing::ViewDrawing& drawing, const BodyStyles& styles,
                                 const std::vector<ChainPlan>& plans, const std::vector<LayerKey>& always) {
  std::set<LayerKey> keys(always.begin(), always.end());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const BodyStyle& style = style_of(drawing, drawing.chains[i], styles);
    if (plans[i].strokes > 0) keys.insert({plans[i].line, style.layer, style.colour});
  }
  return {keys.begin(), keys.end()};
}

// In order of the chains. Strokes take most of the memory of a large drawing: they are counted first and built in
// place.
Strokes strokes_of(const drawing::ViewDrawing& drawing, const LineWidths& widths, const BodyStyles& styles,
                   const std::vector<LayerKey>& always, const Progress& progress) {
  const std::size_t count = drawing.chains.size();
  std::vector<ChainPlan> plans(count);
  parallel_for(count, chains_a_part, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      plans[i] = plan_of(drawing.chains[i], style_of(drawing, drawing.chains[i], styles), widths);
  });
  const Crossings crossings(drawing.chains, crossed_chains(drawing, widths, plans, progress), progress);
  Strokes strokes{layer_keys(drawing, styles, plans, always), {}};
  std::vector<std::size_t> all(strokes.keys.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (plans[i].strokes == 0) continue;
    const BodyStyle& style = style_of(drawing, drawing.chains[i], styles);
    const LayerKey key{plans[i].line, style.layer, style.colour};
    plans[i].layer = static_cast<std::size_t>(std::lower_bound(strokes.keys.begin(), strokes.keys.end(), key) -
                                              strokes.keys.begin());
    plans[i].first = std::exchange(all[plans[i].layer], all[plans[i].layer] + plans[i].strokes);
  }
  for (const ChainPlan& plan : plans)
    check(plan.first + plan.strokes <= all[plan.layer] || plan.strokes == 0, "every line has its place in a layer");
  for (const std::size_t number : all) strokes.of_layer.emplace_back(number);
  parallel_for(count, chains_a_part, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (plans[i].strokes > 0)
        draw_chain(strokes.of_layer[plans[i].layer].data() + plans[i].first, plans[i], {drawing, widths, crossings}, i);
    progress.advance(end - begin);
  });
  return strokes;
}

// Layers for the lines of all bodies, which are there even without lines.
std::vector<LayerKey> usual_layers(const BodyStyles& styles) {
  const auto wants = [&](HiddenLines hidden) {
    return styles.any([&](const BodyStyle& style) { return style.hidden == hidden; });
  };
  std::vector<LayerKey> keys{{scene::SheetLine::visible, {}, {}}};
  if (wants(HiddenLines::dashed)) keys.push_back({scene::SheetLine::hidden, {}, {}});
  if (wants(HiddenLines::solid)) keys.push_back({scene::SheetLine::hidden_solid, {}, {}});
  return keys;
}

Layer layer_of(const LayerKey& key, const drawing::ViewDrawing& drawing, const LineWidths& widths, bool alone) {
  Layer layer = empty_layer(drawing.name, key.line, widths);
  if (alone) layer.name = drawing.name + "/" + scene::row_of(scene::SheetLine::hidden).layer;
  if (!key.name.empty()) {
    std::string name = key.name;
    std::replace(name.begin(), name.end(), '/', '-');  // which ends the name of the view
    layer.name += " " + name;
  }
  if (key.colour != Colour{}) layer.name += " " + hexadecimal(key.colour);
  if (key.colour != Colour{}) layer.style.colour = key.colour;
  return layer;
}

}  // namespace

std::optional<scene::SheetLine> edge_line(EdgeKind kind, bool visible) {
  if (!visible) return edges::is_within_surface(kind) ? std::nullopt : std::optional(scene::SheetLine::hidden);
  if (kind == EdgeKind::section) return scene::SheetLine::section;
  if (kind == EdgeKind::wire) return scene::SheetLine::wire;
  if (kind == EdgeKind::thread) return scene::SheetLine::thread;
  return edges::is_within_surface(kind) ? scene::SheetLine::tangent : scene::SheetLine::visible;
}

const BodyStyle& BodyStyles::operator()(int model, int body) const {
  const std::vector<BodyStyle>& styles = of_model[static_cast<std::size_t>(model)];
  return styles.size() == 1 || body < 0 ? styles.front() : styles[static_cast<std::size_t>(body)];
}

int line_strength(EdgeKind kind, bool visible, const BodyStyle& style) {
  return is_drawn(kind, visible, style) ? static_cast<int>(stroke_line_of(kind, visible, style)) : -1;
}

std::vector<Layer> view_layers(const drawing::ViewDrawing& drawing, const LineWidths& widths, const BodyStyles& styles,
                               const Progress& progress) {
  progress.begin("fitting dashes", drawing.chains.size());
  Strokes strokes = strokes_of(drawing, widths, styles, usual_layers(styles), progress);
  const bool has_dashed = styles.any([](const BodyStyle& style) { return style.hidden == HiddenLines::dashed; });
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < strokes.keys.size(); ++i) {
    const bool alone = strokes.keys[i].line == scene::SheetLine::hidden_solid && !has_dashed;
    layers.push_back(layer_of(strokes.keys[i], drawing, widths, alone));
    layers.back().strokes = std::move(strokes.of_layer[i]);
  }
  return layers;
}

}  // namespace epura::sheet
