// SPDX-License-Identifier: Apache-2.0
#include "output/svg_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/decimal_text.hpp"
#include "base/text.hpp"
#include "output/curve_pieces.hpp"
#include "output/in_order.hpp"
#include "output/svg_path_text.hpp"
#include "output/svg_tree.hpp"
#include "sheet/walk_stroke.hpp"

namespace epura::output {

namespace {

constexpr std::size_t points_at_once = 2048;
// About 80 kB: libxml2 and programs based on it refuse files above 10 MB with attributes of some 100 kB.
constexpr std::size_t max_points_of_path = 4000;

std::string dash_array(const sheet::Stroke& stroke) {
  if (stroke.pattern.empty()) return output::dash_array(stroke.dashes);
  std::string text;
  for (const double length : stroke.pattern) append_millimetres(text.empty() ? text : text += ' ', length);
  return text;
}

// A stroke and the number of its <path>. The strokes of a path are consecutive.
struct Part {
  const sheet::Stroke* stroke;
  std::size_t path;
};

using Chunk = std::span<const Part>;

// Begins a new path where one would become too long. Closed loops come first, and stay together: programs that fill
// paths take a loop inside another one for a hole only if both are in one path.
void split_long_paths(std::vector<Part>& parts) {
  std::size_t added = 0;
  for (auto begin = parts.begin(), end = begin; begin != parts.end(); begin = end) {
    end = std::find_if(begin, parts.end(), [&](const Part& part) { return part.path != begin->path; });
    std::size_t points = 0;
    for (auto part = begin; part != end; ++part) points += part->stroke->points.size();
    if (points > max_points_of_path)
      std::stable_partition(begin, end, [](const Part& part) { return part.stroke->closed; });
    points = 0;
    for (auto part = begin; part != end; ++part) {
      points += part->stroke->points.size();
      if (points > max_points_of_path && !part->stroke->closed) {
        points = part->stroke->points.size();
        ++added;
      }
      part->path += added;
    }
  }
}

// A stroke with fewer than two points has no ink.
std::vector<Part> parts_of(const sheet::Layer& layer, bool plain) {
  std::vector<Part> parts;
  parts.reserve(layer.strokes.size());
  std::map<std::string, std::size_t> path_of_dashes;
  for (const sheet::Stroke& stroke : layer.strokes) {
    if (stroke.points.size() < 2) continue;
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

// Arcs as SVG defines them. A counterclockwise turn with y up is counterclockwise on the page.
void append_arcs(SvgPathText& path, const drawing::CurvePart& part, double height) {
  const Vec2 radii(glm::length(part.u), glm::length(part.v));
  const bool turned_over = part.u.x * part.v.y < part.u.y * part.v.x;
  const bool counterclockwise = (part.to > part.from) != turned_over;
  const double turn = radii.x == radii.y ? 0 : -std::atan2(part.u.y, part.u.x) * degrees;
  for (const Vec2& end : quarter_ends(part)) path.arc(radii, turn, !counterclockwise, {end.x, height - end.y});
}

void append_line(std::string& svg, const sheet::Stroke& stroke, const SvgDocument& document) {
  SvgPathText path(svg, document.decimals);
  const auto on_page = [&](const Vec2& p) { return Vec2(p.x, document.height - p.y); };
  path.move(on_page(stroke.points.front()));
  sheet::walk_stroke(
      stroke, [&](const Vec2& point) { path.line(on_page(point)); },
      [&](const drawing::CurvePart& part) { append_arcs(path, part, document.height); });
  if (stroke.closed) path.close();
  path.end();
}

// The common model of all edges; nothing if there are several, or no edges.
std::optional<int> model_of(std::span<const sheet::ModelEdge> edges) {
  if (edges.empty()) return std::nullopt;
  const int model = edges.front().model;
  const auto differs = [model](const sheet::ModelEdge& edge) { return edge.model != model; };
  return std::any_of(edges.begin(), edges.end(), differs) ? std::nullopt : std::optional(model);
}

// Attributes that all lines of a layer share, so that they need not be repeated.
struct Common {
  std::string dashes;
  std::optional<int> model;
};

void append_origin(std::string& svg, const sheet::Stroke& stroke, std::optional<int> common_model) {
  if (stroke.kind) svg.append(" data-kind=\"").append(edges::name_of(*stroke.kind)) += '"';
  if (stroke.edges.empty()) return;
  const std::optional<int> model = model_of(stroke.edges);
  if (model && !common_model) svg.append(" data-model=\"").append(std::to_string(*model)) += '"';
  svg += " data-edge=\"";
  std::array<char, 3 * (longest_decimal + 1)> buffer;
  for (const sheet::ModelEdge& edge : stroke.edges) {
    char* at = buffer.data();
    if (&edge != &stroke.edges.front()) *at++ = ' ';
    if (!model) {
      at = write_whole(at, edge.model);
      *at++ = ':';
    }
    at = write_whole(at, edge.vertex[0]);
    *at++ = '-';
    svg.append(buffer.data(), write_whole(at, edge.vertex[1]));
  }
  svg += '"';
}

std::string rounded_numbers(const std::vector<double>& values, int digits) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + format_rounded(value, digits);
  return text;
}

// LENGTH;FACES;BODY;DEPTHS, in at most so many bytes: depths and faces are omitted if they are longer.
void append_facts(std::string& svg, const sheet::LineFacts& facts, std::size_t most) {
  std::string text = " data-about=\"" + format_rounded(facts.length, 6) + ";";
  std::string faces;
  for (const int face : facts.faces) faces += (faces.empty() ? "" : " ") + std::to_string(face);
  if (facts.more_faces > 0) faces += " +" + std::to_string(facts.more_faces);
  const std::string body = ";" + (facts.body > 0 ? std::to_string(facts.body) : std::string());
  // Planes need more digits: their coefficients are multiplied by positions.
  const std::string depths = ";" + rounded_numbers(facts.depth, facts.depth.size() == 3 ? 9 : 6);
  const auto fits = [&](std::size_t more) { return text.size() + more + body.size() + 1 <= most; };
  if (fits(faces.size())) text += faces;
  text += body;
  if (fits(depths.size())) text += depths;
  if (fits(0)) svg += text + '"';
}

}  // namespace

std::string dash_array(const sheet::Dashes& dashes) {
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

std::optional<int> common_model(const sheet::Layer& layer) {
  std::optional<int> common;
  for (const sheet::Stroke& stroke : layer.strokes) {
    if (stroke.edges.empty()) continue;
    const std::optional<int> model = model_of(stroke.edges);
    if (!model || (common && model != common)) return std::nullopt;
    common = model;
  }
  return common;
}

std::size_t max_bytes(const sheet::Layer& layer) {
  constexpr std::size_t of_head = 120, of_edge = 24, of_point = 32;
  std::size_t bytes = 0;
  for (const sheet::Stroke& stroke : layer.strokes)
    bytes += of_head + of_edge * stroke.edges.size() + of_point * stroke.points.size();
  return bytes;
}

void append_paths(std::string& svg, const sheet::Layer& layer, const SvgDocument& document, std::size_t first_line,
                  const Progress& progress) {
  const Common common{dash_array(layer.style.dashes), common_model(layer)};
  const std::vector<Part> parts = parts_of(layer, document.plain);
  const std::vector<Chunk> chunks = chunks_of(parts);
  const auto begin_path = [&](std::string& lines, const Part& part) {
    lines += "<path";
    if (!document.plain) {
      if (document.page == nullptr)
        lines.append(" id=\"").append(document.prefix).append(std::to_string(first_line + part.path)) += '"';
      append_origin(lines, *part.stroke, common.model);
      if (document.named != nullptr && part.stroke->kind)
        append_name(lines, name_of(*part.stroke, layer, *document.named));
    }
    const std::string dashes = dash_array(*part.stroke);
    if (dashes != common.dashes) lines.append(" stroke-dasharray=\"").append(dashes) += '"';
    lines += " d=\"";
  };
  const auto write = [&](Chunk chunk, std::string& lines) {
    std::size_t begin = 0;
    for (const Part& part : chunk) {
      const bool first = &part == parts.data() || (&part)[-1].path != part.path;
      const bool last = &part == &parts.back() || (&part)[1].path != part.path;
      if (first) begin = lines.size();
      if (first) begin_path(lines, part);
      append_line(lines, *part.stroke, document);
      if (!last) continue;
      lines += '"';
      if (document.page != nullptr && part.stroke->facts >= 0 && !document.plain) {
        // In the file, the line has an id, and a page may be 1.3 times as large.
        const std::size_t id = 9 + std::to_string(first_line + part.path).size();
        const std::size_t in_file = lines.size() - begin + 3 + id;
        append_facts(lines, document.page->line_facts[static_cast<std::size_t>(part.stroke->facts)],
                     in_file * 3 / 10 + id + document.spare);
      }
      lines += "/>\n";
    }
    progress.advance(chunk.size());
  };
  append_in_order(svg, chunks.size(), progress, [&](std::size_t i, std::string& lines) { write(chunks[i], lines); });
}

}  // namespace epura::output
