#include "sheet/view_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "sheet/dash.hpp"

namespace epura {

namespace {

// What the segments say about a stroke: their kinds, each once, and the model edges, each run of one edge once.
void add_origin(Stroke& stroke, const Drawing& drawing, std::span<const int> segments) {
  std::vector<EdgeKind> kinds;
  std::array<int, 3> previous{-1, -1, -1};
  for (const int index : segments) {
    const Segment& segment = drawing.segments[static_cast<std::size_t>(index)];
    if (std::find(kinds.begin(), kinds.end(), segment.kind) == kinds.end()) kinds.push_back(segment.kind);
    if (segment.edge[0] < 0) continue;
    const auto [low, high] = std::minmax(segment.edge[0], segment.edge[1]);
    const std::array edge{segment.model, low, high};
    if (edge == std::exchange(previous, edge)) continue;
    if (!stroke.edges.empty()) stroke.edges += ' ';
    stroke.edges += std::to_string(segment.model) + ':' + std::to_string(low) + '-' + std::to_string(high);
  }
  for (const EdgeKind kind : kinds) {
    if (!stroke.kind.empty()) stroke.kind += ' ';
    stroke.kind += name_of(kind);
  }
}

Stroke continuous(const Drawing& drawing, const Chain& chain) {
  Stroke stroke;
  stroke.points = chain.points;
  stroke.closed = chain.closed;
  stroke.curves = chain.curves;
  add_origin(stroke, drawing, chain.segments);
  return stroke;
}

// The segments that draw a run; all of the chain where segments and points do not go side by side.
std::vector<int> segments_of(const Chain& chain, const DashRun& run) {
  const std::size_t lines = chain.points.size() - (chain.closed ? 0 : 1);
  if (chain.segments.size() != lines) return chain.segments;
  std::vector<int> segments;
  for (int i = run.first; i < run.last; ++i) segments.push_back(chain.segments[static_cast<std::size_t>(i) % lines]);
  return segments;
}

Stroke dashed_run(const Drawing& drawing, const Chain& chain, const DashRun& run, double width) {
  Stroke stroke;
  stroke.closed = run.closed;
  for (int i = run.first; i <= run.last - (run.closed ? 1 : 0); ++i)
    stroke.points.push_back(chain.points[static_cast<std::size_t>(i) % chain.points.size()]);
  const double length = length_of(stroke.points, stroke.closed);
  stroke.dashes = stroke.closed ? fit_closed(length, width) : fit_open(length, width);
  add_origin(stroke, drawing, segments_of(chain, run));
  return stroke;
}

void add_dashed(std::vector<Stroke>& strokes, const Drawing& drawing, const Chain& chain, double width) {
  const bool too_short = fit_open(length_of(chain.points, chain.closed), width).dash == 0;
  if (too_short || chain.points.size() < 2) {
    strokes.push_back(continuous(drawing, chain));
    return;
  }
  for (const DashRun& run : cut_at_corners(chain.points, chain.closed, width))
    strokes.push_back(dashed_run(drawing, chain, run, width));
}

struct Strokes {
  std::vector<Stroke> hidden, visible;
};

// In order of the chains, in parts of so many.
std::vector<Strokes> strokes_of(const Drawing& drawing, double hidden_width, HiddenLines hidden) {
  constexpr std::size_t chains_a_part = 4096;
  const std::size_t count = drawing.chains.size();
  std::vector<Strokes> parts((count + chains_a_part - 1) / chains_a_part);
  parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * chains_a_part; i < std::min(end * chains_a_part, count); ++i) {
      const Chain& chain = drawing.chains[i];
      Strokes& part = parts[i / chains_a_part];
      if (chain.visible) {
        part.visible.push_back(continuous(drawing, chain));
      } else if (hidden == HiddenLines::dashed) {
        add_dashed(part.hidden, drawing, chain, hidden_width);
      } else if (hidden == HiddenLines::solid) {
        part.hidden.push_back(continuous(drawing, chain));
      }
    }
  });
  return parts;
}

void append(std::vector<Stroke>& strokes, std::vector<Stroke>& more) {
  std::move(more.begin(), more.end(), std::back_inserter(strokes));
  more = {};
}

}  // namespace

HiddenLines parse_hidden_lines(std::string_view text, const std::string& where) {
  const std::vector<std::string> names = {"none", "dashed", "solid"};
  const auto found = std::find(names.begin(), names.end(), to_lower(text));
  if (found == names.end())
    throw Error(Trouble::input, where, "'" + std::string(text) + "' is no style of hidden lines",
                did_you_mean(text, names));
  return static_cast<HiddenLines>(found - names.begin());
}

LineWidths line_widths(const Paper& paper) {
  if (paper.width * paper.height >= 841.0 * 594.0) return {0.7, 0.35};
  return {0.5, 0.25};
}

std::vector<Layer> view_layers(const Drawing& drawing, const LineWidths& widths, HiddenLines hidden) {
  std::vector<Layer> layers;
  if (hidden != HiddenLines::none) {
    LineStyle style{"hidden", widths.narrow};
    if (hidden == HiddenLines::dashed) style.dashes = {dash_widths * widths.narrow, gap_widths * widths.narrow};
    layers.push_back({drawing.name + "/hidden", std::move(style), {}});
  }
  layers.push_back({drawing.name + "/visible", {"visible", widths.wide}, {}});

  std::vector<Strokes> parts = strokes_of(drawing, widths.narrow, hidden);
  for (Strokes& part : parts) {
    append(layers.front().strokes, part.hidden);
    append(layers.back().strokes, part.visible);
  }
  return layers;
}

}  // namespace epura
