// SPDX-License-Identifier: Apache-2.0
#include "output/svg_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "output/curve_pieces.hpp"
#include "output/in_order.hpp"
#include "output/svg_path_text.hpp"

namespace epura {

namespace {

constexpr std::size_t points_at_once = 8192;
// About 80 kB: libxml2, and what reads with it, refuses files above 10 MB with attributes of some 100 kB.
constexpr std::size_t most_points_of_path = 4000;

// A stroke and the number of the <path> that it goes into. Strokes of one path follow each other.
struct Part {
  const Stroke* stroke;
  std::size_t path;
};

using Chunk = std::span<const Part>;

// A stroke of fewer than two points has no ink.
bool has_line(const Stroke& stroke) { return stroke.points.size() >= 2; }

// Begins a new path where one would get too long.
void split_long_paths(std::vector<Part>& parts) {
  std::size_t points = 0, added = 0, previous = 0;
  for (Part& part : parts) {
    if (part.path != std::exchange(previous, part.path)) points = 0;
    points += part.stroke->points.size();
    if (points > most_points_of_path) {
      points = part.stroke->points.size();
      ++added;
    }
    part.path += added;
  }
}

std::vector<Part> parts_of(const Layer& layer, bool plain) {
  std::vector<Part> parts;
  parts.reserve(layer.strokes.size());
  std::map<std::string, std::size_t> path_of_dashes;
  for (const Stroke& stroke : layer.strokes) {
    if (!has_line(stroke)) continue;
    const std::size_t path =
        plain ? path_of_dashes.emplace(dash_array(stroke), path_of_dashes.size()).first->second : parts.size();
    parts.push_back({&stroke, path});
  }
  if (!plain) return parts;
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.path < b.path; });
  split_long_paths(parts);
  return parts;
}

std::vector<Chunk> chunks_of(const std::vector<Part>& parts) {
  std::vector<Chunk> chunks;
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    for (std::size_t points = 0; end < parts.size() && points < points_at_once; ++end)
      points += parts[end].stroke->points.size();
    chunks.push_back(Chunk(parts).subspan(begin, end - begin));
  }
  return chunks;
}

// The strokes as one path, with the numbers that Cairo draws. Dashes do not change it.
CairoPath cairo_path(const Canvas& canvas, Chunk chunk) {
  const CairoSurface surface(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, nullptr));
  const Pen pen = make_pen(surface);
  for (const Part& part : chunk) add_path(pen, canvas, *part.stroke);
  CairoPath path(cairo_copy_path(pen.get()));
  require(path->status, "SVG");
  return path;
}

/// Steps through a path of Cairo's, in units of the surface.
class PathReader {
 public:
  explicit PathReader(const cairo_path_t& path) : rest_(path.data, static_cast<std::size_t>(path.num_data)) {}

  [[nodiscard]] bool at(cairo_path_data_type_t type) const {
    return !rest_.empty() && rest_.front().header.type == type;
  }

  /// The last point of the step; the origin where it has none.
  Vec2 step() {
    const auto length = static_cast<std::size_t>(rest_.front().header.length);
    const Vec2 end = length > 1 ? Vec2(rest_[length - 1].point.x, rest_[length - 1].point.y) : Vec2(0, 0);
    rest_ = rest_.subspan(length);
    return end;
  }

 private:
  std::span<const cairo_path_data_t> rest_;
};

/// The path of one stroke in millimetres, y down.
class PathWriter {
 public:
  PathWriter(std::string& text, const Canvas& canvas, const PathStyle& style)
      : canvas_(canvas), height_(style.height), path_(text, style.decimals) {}

  void append_stroke(PathReader& reader, const Stroke& stroke);

 private:
  [[nodiscard]] Vec2 on_page(const Vec2& on_sheet) const { return {on_sheet.x, height_ - on_sheet.y}; }
  Vec2 next(PathReader& reader) const { return on_page(canvas_.to_sheet(reader.step())); }
  void append_arcs(const CurvePart& part);

  const Canvas& canvas_;
  double height_;
  SvgPathText path_;
};

// Arcs as SVG knows them. What turns counterclockwise with y up does so on the page.
void PathWriter::append_arcs(const CurvePart& part) {
  constexpr double degrees = 180 / std::numbers::pi;
  const Vec2 radii(glm::length(part.u), glm::length(part.v));
  const bool turned_over = part.u.x * part.v.y < part.u.y * part.v.x;
  const bool counterclockwise = (part.to > part.from) != turned_over;
  const double turn = radii.x == radii.y ? 0 : -std::atan2(part.u.y, part.u.x) * degrees;
  for (const Vec2& end : quarter_ends(part)) path_.arc(radii, turn, !counterclockwise, on_page(end));
}

void PathWriter::append_stroke(PathReader& reader, const Stroke& stroke) {
  check(reader.at(CAIRO_PATH_MOVE_TO), "Cairo left a stroke out");
  Vec2 start;
  while (reader.at(CAIRO_PATH_MOVE_TO)) start = next(reader);  // one more stands behind a path that is closed
  path_.move(start);
  std::size_t curve = 0;
  while (reader.at(CAIRO_PATH_LINE_TO) || reader.at(CAIRO_PATH_CURVE_TO)) {
    if (reader.at(CAIRO_PATH_LINE_TO)) {
      path_.line(next(reader));
      continue;
    }
    check(curve < stroke.curves.size(), "Cairo drew a curve of its own");
    const CurvePart& part = stroke.curves[curve++];
    for (std::size_t pieces = bezier_pieces(part).size(); pieces > 0; --pieces) {
      check(reader.at(CAIRO_PATH_CURVE_TO), "Cairo left a piece of a curve out");
      reader.step();
    }
    append_arcs(part);
  }
  if (!reader.at(CAIRO_PATH_CLOSE_PATH)) return;
  reader.step();
  path_.close();
}

// The model that has all edges; nothing where there are several, or no edges.
std::optional<int> model_of(std::span<const ModelEdge> edges) {
  if (edges.empty()) return std::nullopt;
  const int model = edges.front().model;
  const auto differs = [model](const ModelEdge& edge) { return edge.model != model; };
  return std::any_of(edges.begin(), edges.end(), differs) ? std::nullopt : std::optional(model);
}

// What all lines of a layer have in common, and need not say.
struct Common {
  std::string dashes;
  std::optional<int> model;
};

void append_origin(std::string& text, const Stroke& stroke, std::optional<int> common_model) {
  if (stroke.kind) text.append(" data-kind=\"").append(name_of(*stroke.kind)) += '"';
  if (stroke.edges.empty()) return;
  const std::optional<int> model = model_of(stroke.edges);
  if (model && !common_model) text.append(" data-model=\"").append(std::to_string(*model)) += '"';
  text += " data-edge=\"";
  for (const ModelEdge& edge : stroke.edges) {
    if (&edge != &stroke.edges.front()) text += ' ';
    if (!model) text.append(std::to_string(edge.model)) += ':';
    text.append(std::to_string(edge.vertex[0])).append("-").append(std::to_string(edge.vertex[1]));
  }
  text += '"';
}

// All of a path but its lines.
void append_head(std::string& text, const Part& part, const Common& common, const PathStyle& style) {
  const Stroke& stroke = *part.stroke;
  text += "<path";
  if (!style.plain) {
    append_attribute(text, "id", line_id(style.first_line + part.path));
    append_origin(text, stroke, common.model);
  }
  const std::string dashes = dash_array(stroke);
  if (dashes != common.dashes) append_attribute(text, "stroke-dasharray", dashes);
  text += " d=\"";
}

}  // namespace

void append_millimetres(std::string& text, double value) { append_short(text, value, 4); }

std::string dash_array(const Dashes& dashes) {
  if (!(dashes.dash > 0)) return "none";
  std::string text;
  append_millimetres(text, dashes.dash);
  const auto append = [&text](double length) { append_millimetres(text += ' ', length); };
  append(dashes.gap);
  for (int i = 0; i < dashes.dots; ++i) {
    append(dashes.dot);
    append(dashes.gap);
  }
  return text;
}

std::string dash_array(const Stroke& stroke) {
  if (stroke.pattern.empty()) return dash_array(stroke.dashes);
  std::string text;
  for (const double length : stroke.pattern) append_millimetres(text.empty() ? text : text += ' ', length);
  return text;
}

std::string xml_text(std::string_view text) {
  std::string valid = valid_utf8(text);
  for (char& c : valid)
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') c = ' ';
  return valid;
}

void append_escaped(std::string& text, std::string_view value) {
  for (const char c : xml_text(value)) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '"') {
      text += "&quot;";
    } else if (c == '\n' || c == '\t') {
      text += c == '\n' ? "&#10;" : "&#09;";
    } else {
      text += c;
    }
  }
}

void append_attribute(std::string& text, std::string_view name, std::string_view value) {
  text.append(" ").append(name).append("=\"");
  append_escaped(text, value);
  text += '"';
}

std::optional<int> common_model(const Layer& layer) {
  std::optional<int> common;
  for (const Stroke& stroke : layer.strokes) {
    if (stroke.edges.empty()) continue;
    const std::optional<int> model = model_of(stroke.edges);
    if (!model || (common && model != common)) return std::nullopt;
    common = model;
  }
  return common;
}

std::string line_id(std::size_t number) { return "p" + std::to_string(number); }

std::size_t most_bytes(const Layer& layer) {
  constexpr std::size_t of_head = 100, of_edge = 24, of_point = 32;
  std::size_t bytes = 0;
  for (const Stroke& stroke : layer.strokes)
    bytes += of_head + of_edge * stroke.edges.size() + of_point * stroke.points.size();
  return bytes;
}

bool has_ink(const Layer& layer) {
  return !layer.fills.empty() || !layer.texts.empty() ||
         std::any_of(layer.strokes.begin(), layer.strokes.end(), has_line);
}

void append_paths(std::string& text, const Layer& layer, const Canvas& canvas, const PathStyle& style,
                  const Progress& progress) {
  const Common common{dash_array(layer.style.dashes), common_model(layer)};
  const std::vector<Part> parts = parts_of(layer, style.plain);
  const std::vector<Chunk> chunks = chunks_of(parts);
  const auto write = [&](Chunk chunk) {
    std::string lines;
    const CairoPath path = cairo_path(canvas, chunk);
    PathReader reader(*path);
    for (const Part& part : chunk) {
      const bool first = &part == parts.data() || (&part)[-1].path != part.path;
      const bool last = &part == &parts.back() || (&part)[1].path != part.path;
      if (first) append_head(lines, part, common, style);
      PathWriter(lines, canvas, style).append_stroke(reader, *part.stroke);
      if (last) lines += "\"/>\n";
    }
    progress.advance(chunk.size());
    return lines;
  };
  append_in_order(text, chunks.size(), progress, [&](std::size_t i) { return write(chunks[i]); });
}

}  // namespace epura
