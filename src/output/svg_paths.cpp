#include "output/svg_paths.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "output/curve_pieces.hpp"
#include "output/in_order.hpp"

namespace epura {

namespace {

constexpr int decimals = 5;  // of a millimetre
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

// The strokes as one path, as Cairo writes it. Dashes are attributes of their own and do not change it.
std::string cairo_path(const Canvas& canvas, const LineStyle& style, Chunk chunk) {
  std::string bytes;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append_bytes, &bytes, canvas.size.x, canvas.size.y));
  {
    const Pen pen = make_pen(surface);
    begin_vector_file(pen, canvas);
    std::vector<const Stroke*> strokes;
    for (const Part& part : chunk) strokes.push_back(part.stroke);
    draw(pen, canvas, style, strokes);
  }
  finish(surface, "SVG");
  pugi::xml_document drawn;
  check(bool(drawn.load_buffer_inplace(bytes.data(), bytes.size())), "Cairo wrote no XML");
  const pugi::xml_node without_ink = drawn.child("svg").child("g").child("path");
  return without_ink.next_sibling("path").attribute("d").value();
}

// Reads "M x y L x y ... Z M x y ", in units of the surface.
class PathReader {
 public:
  explicit PathReader(std::string_view path) : path_(path) {}

  [[nodiscard]] bool at(char command) const { return path_.starts_with(command); }

  void skip_command() { path_.remove_prefix(std::min(path_.size(), std::size_t{2})); }

  Vec2 point() {
    const double x = number();
    return {x, number()};
  }

 private:
  double number() {
    double value = 0;
    const auto [end, error] = std::from_chars(path_.data(), path_.data() + path_.size(), value);
    check(error == std::errc{}, "Cairo wrote an SVG path in another form");
    path_.remove_prefix(static_cast<std::size_t>(end - path_.data()));
    path_.remove_prefix(std::min(path_.size(), std::size_t{1}));
    return value;
  }

  std::string_view path_;
};

/// The path of one stroke in millimetres, y down.
struct PathWriter {
  std::string& text;
  const Canvas& canvas;
  double height;

  void append_point(const Vec2& p) const {
    append_millimetres(text, p.x);
    append_millimetres(text += ' ', height - p.y);
  }
  void append(char command, const Vec2& on_surface) const {
    text += command;
    append_point(canvas.to_sheet(on_surface));
  }
  void append_arcs(const CurvePart& part) const;
  void append_stroke(PathReader& reader, const Stroke& stroke) const;
};

// Arcs as SVG knows them. What turns counterclockwise with y up does so on the page.
void PathWriter::append_arcs(const CurvePart& part) const {
  constexpr double degrees = 180 / std::numbers::pi;
  const double u = glm::length(part.u), v = glm::length(part.v);
  const bool turned_over = part.u.x * part.v.y < part.u.y * part.v.x;
  const bool counterclockwise = (part.to > part.from) != turned_over;
  for (const Vec2& end : quarter_ends(part)) {
    append_millimetres(text += 'A', u);
    append_millimetres(text += ' ', v);
    append_fixed(text += ' ', u == v ? 0 : -std::atan2(part.u.y, part.u.x) * degrees, 6);
    text += counterclockwise ? " 0 0 " : " 0 1 ";
    append_point(end);
  }
}

void PathWriter::append_stroke(PathReader& reader, const Stroke& stroke) const {
  check(reader.at('M'), "Cairo left a stroke out");
  Vec2 start;
  for (; reader.at('M'); start = reader.point()) reader.skip_command();  // one more M stands behind a Z
  append('M', start);
  std::size_t curve = 0;
  while (reader.at('L') || reader.at('C')) {
    if (reader.at('L')) {
      reader.skip_command();
      append('L', reader.point());
      continue;
    }
    check(curve < stroke.curves.size(), "Cairo drew a curve of its own");
    const CurvePart& part = stroke.curves[curve++];
    for (std::size_t pieces = bezier_pieces(part).size(); pieces > 0; --pieces) {
      check(reader.at('C'), "Cairo left a piece of a curve out");
      reader.skip_command();
      for (int i = 0; i < 3; ++i) reader.point();
    }
    append_arcs(part);
  }
  if (!reader.at('Z')) return;
  reader.skip_command();
  text += 'Z';
}

struct Look {
  std::string id, usual_dashes;
  bool plain;
};

// All of a path but its lines.
void append_head(std::string& text, const Part& part, const Look& look) {
  const Stroke& stroke = *part.stroke;
  text += "<path";
  if (!look.plain) {
    append_attribute(text, "id", look.id + "-" + std::to_string(part.path));
    if (!stroke.kind.empty()) append_attribute(text, "data-kind", stroke.kind);
    if (!stroke.edges.empty()) append_attribute(text, "data-edges", stroke.edges);
  }
  const std::string dashes = dash_array(stroke);
  if (dashes != look.usual_dashes) append_attribute(text, "stroke-dasharray", dashes);
  text += " d=\"";
}

}  // namespace

void append_millimetres(std::string& text, double value) { append_fixed(text, value, decimals); }

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

std::size_t most_bytes(const Layer& layer, const std::string& id) {
  constexpr std::size_t of_head = 100, of_point = 32;
  std::size_t bytes = 0;
  for (const Stroke& stroke : layer.strokes)
    bytes += of_head + id.size() + stroke.kind.size() + stroke.edges.size() + of_point * stroke.points.size();
  return bytes;
}

bool has_ink(const Layer& layer) {
  return !layer.fills.empty() || !layer.texts.empty() ||
         std::any_of(layer.strokes.begin(), layer.strokes.end(), has_line);
}

void append_paths(std::string& text, const Layer& layer, const Canvas& canvas, double height, const std::string& id,
                  bool plain) {
  const Look look{id, dash_array(layer.style.dashes), plain};
  const std::vector<Part> parts = parts_of(layer, plain);
  const std::vector<Chunk> chunks = chunks_of(parts);
  const auto write = [&](Chunk chunk) {
    std::string lines;
    const std::string path = cairo_path(canvas, layer.style, chunk);
    PathReader reader(path);
    for (const Part& part : chunk) {
      const bool first = &part == parts.data() || (&part)[-1].path != part.path;
      const bool last = &part == &parts.back() || (&part)[1].path != part.path;
      if (first) append_head(lines, part, look);
      PathWriter{lines, canvas, height}.append_stroke(reader, *part.stroke);
      if (last) lines += "\" />\n";
    }
    return lines;
  };
  append_in_order(text, chunks.size(), [&](std::size_t i) { return write(chunks[i]); });
}

}  // namespace epura
