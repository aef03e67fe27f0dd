// SPDX-License-Identifier: Apache-2.0
#include "output/page_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "output/json_text.hpp"
#include "output/svg_path_text.hpp"
#include "output/xml_text.hpp"
#include "scene/choices.hpp"

namespace epura::output {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

std::string packed(const std::vector<float>& numbers) {
  return '"' + base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)}) + '"';
}

/// Integers in as few bytes as they need: seven bits in each, the lowest first, with 128 in all but the last; the sign
/// is the lowest bit of all.
class PackedIntegers {
 public:
  void add(std::int64_t number) {
    auto rest = static_cast<std::uint64_t>(number < 0 ? ~number : number) << 1 | (number < 0 ? 1U : 0U);
    for (; rest >= 128; rest >>= 7) bytes_ += static_cast<char>((rest & 127) | 128);
    bytes_ += static_cast<char>(rest);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string packed(const PackedIntegers& integers) { return '"' + base64(integers.bytes()) + '"'; }

/// The arrays of a layer.
struct LineArrays {
  PackedIntegers points{}, heads{}, kinds{}, edge_counts{}, edges{}, faces{};
  std::vector<float> lengths{}, depths{};
  std::array<long long, 2> point{};  ///< the last one
  int vertex = 0, face = 0;          ///< the last ones

  void add_ink(const sheet::Stroke& stroke, double height, bool in_dashed_layer);
  void add_origin(const sheet::Stroke& stroke, const sheet::LineFacts& facts);
};

void LineArrays::add_ink(const sheet::Stroke& stroke, double height, bool in_dashed_layer) {
  const bool is_continuous = !in_dashed_layer || (!(stroke.dashes.dash > 0) && stroke.pattern.empty());
  heads.add(
      static_cast<std::int64_t>(stroke.points.size() << 2 | (is_continuous ? 2U : 0U) | (stroke.closed ? 1U : 0U)));
  for (const Vec2& p : stroke.points) {
    const std::array<long long, 2> next{parts_of(p.x, 1e4), parts_of(height - p.y, 1e4)};
    for (const std::size_t i : {0, 1}) points.add(next[i] - point[i]);
    point = next;
  }
  kinds.add(static_cast<int>(stroke.kind.value_or(EdgeKind{})));
}

void LineArrays::add_origin(const sheet::Stroke& stroke, const sheet::LineFacts& facts) {
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  edge_counts.add(static_cast<std::int64_t>(stroke.edges.size()));
  for (const sheet::ModelEdge& edge : stroke.edges) {
    edges.add(edge.model);
    edges.add(edge.vertex[0] - vertex);
    edges.add(edge.vertex[1] - edge.vertex[0]);
    vertex = edge.vertex[0];
  }
  faces.add(static_cast<std::int64_t>(facts.faces.size()) + facts.more_faces);
  faces.add(std::max(facts.body, 0));
  for (std::size_t i = 0; i < std::min<std::size_t>(2, facts.faces.size()); ++i) {
    faces.add(facts.faces[i] - face);
    face = facts.faces[i];
  }
  const bool has_depths = facts.depth.size() == 1 || facts.depth.size() == 2;
  lengths.push_back(static_cast<float>(facts.length));
  depths.push_back(has_depths ? static_cast<float>(facts.depth.front()) : unknown);
  depths.push_back(has_depths ? static_cast<float>(facts.depth.back()) : unknown);
}

std::string dashes_of(const sheet::Dashes& dashes) {
  std::vector<double> lengths;
  if (dashes.dash > 0) lengths = {dashes.dash, dashes.gap};
  for (int i = 0; i < dashes.dots && dashes.dash > 0; ++i) lengths.insert(lengths.end(), {dashes.dot, dashes.gap});
  return json_list(lengths, json_number, ",");
}

std::string packed_layer(const sheet::Sheet& sheet, const sheet::Layer& layer, bool plain) {
  const sheet::Stroke no_stroke;
  const sheet::LineFacts no_facts;
  LineArrays arrays;
  for (const sheet::Stroke& stroke : layer.strokes) {
    if (stroke.points.size() < 2) continue;
    arrays.add_ink(stroke, sheet.height, layer.style.dashes.dash > 0);
    const bool has_facts = !plain && stroke.facts >= 0;
    arrays.add_origin(plain ? no_stroke : stroke,
                      has_facts ? sheet.line_facts[static_cast<std::size_t>(stroke.facts)] : no_facts);
  }
  const std::size_t slash = layer.name.rfind('/');
  const std::string view = layer.name.substr(0, slash == std::string::npos ? 0 : slash);
  std::string json =
      "{\"view\":" + json_string(view) + ",\"layer\":" + json_string(layer.name.substr(view.empty() ? 0 : slash + 1)) +
      ",\"width\":" + json_number(layer.style.width) + ",\"colour\":" + json_string(hexadecimal(layer.style.colour)) +
      ",\"dashes\":" + dashes_of(layer.style.dashes);
  const auto add = [&json](std::string_view name, const auto& array) {
    json.append(",\"").append(name).append("\":").append(packed(array));
  };
  add("points", arrays.points);
  add("heads", arrays.heads);
  add("kinds", arrays.kinds);
  add("edgeCounts", arrays.edge_counts);
  add("edges", arrays.edges);
  add("lengths", arrays.lengths);
  add("faces", arrays.faces);
  add("depths", arrays.depths);
  return json + "}";
}

}  // namespace

bool draws_edges(const sheet::Layer& layer) {
  return std::any_of(layer.strokes.begin(), layer.strokes.end(),
                     [](const sheet::Stroke& stroke) { return stroke.kind.has_value(); });
}

bool is_large(const sheet::Sheet& sheet) {
  constexpr std::size_t max_lines = 20000, max_points = 400000;
  std::size_t lines = 0, points = 0;
  for (const sheet::Layer& layer : sheet.layers) {
    lines += layer.strokes.size();
    for (const sheet::Stroke& stroke : layer.strokes) points += stroke.points.size();
  }
  return lines > max_lines || points > max_points;
}

std::string packed_lines(const sheet::Sheet& sheet, bool plain, const Progress& progress) {
  std::vector<std::string> names, layers;
  for (const char* name : scene::Words<EdgeKind>::list) names.emplace_back(name);
  for (const sheet::Layer& layer : sheet.layers) {
    if (!draws_edges(layer)) continue;
    progress.expect_time();
    layers.push_back(packed_layer(sheet, layer, plain));
    progress.advance(layer.strokes.size());
  }
  const auto itself = [](const std::string& json) { return json; };
  return "{\"kinds\":" + json_list(names, json_string, ",") + ",\"layers\":" + json_list(layers, itself, ",\n") + "}";
}

}  // namespace epura::output
