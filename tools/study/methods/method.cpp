// SPDX-License-Identifier: Apache-2.0
#include "study/methods/method.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "study/methods/item_buffer.hpp"
#include "study/methods/sampled.hpp"
#include "view/projected_scene.hpp"

namespace epura::study {

namespace {

constexpr int usual_bits = 30;
constexpr double forgiven = 4;
// Half a unit in the last place of floats near 1.
constexpr double float_rounding = 0x1p-24;

view::ProjectedScene copy_for_visibility(const view::ProjectedScene& view) {
  view::ProjectedScene copy;
  copy.middle = view.middle;
  copy.extent = view.extent;
  copy.cell = view.cell;
  copy.contact = view.contact;
  copy.vertices = view.vertices;
  copy.grid.resize(view.grid.size());
  copy.triangles = view.triangles;
  return copy;
}

// Vertices that no triangle and no edge uses may lie anywhere; rounding may move others beyond the end of the grid.
void lay_on_grid(view::ProjectedScene& view, int bits) {
  const double half = std::ldexp(1.0, bits);
  const auto to_grid = [&](double cells) {
    if (!(std::abs(cells) <= 2 * half)) return 0;
    return static_cast<std::int32_t>(std::nearbyint(std::clamp(cells, 1 - half, half - 1)));
  };
  parallel_for(view.vertices.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      view.grid[v] = {to_grid(view.vertices[v].x / view.cell), to_grid(view.vertices[v].y / view.cell)};
  });
}

/// The view, for visibility only: it cannot map or clip. Its contact tolerance allows for its rounding: four units of
/// its coarsest coordinate, as the usual tolerance is four cells of the grid. The grid has 2^bits cells across the
/// window, 4 <= bits <= 30. Coordinates remain doubles.
view::ProjectedScene on_coarser_grid(const view::ProjectedScene& view, int bits) {
  view::ProjectedScene rounded = copy_for_visibility(view);
  rounded.cell = std::ldexp(view.cell, usual_bits - bits);
  rounded.contact.touching = std::max(view.contact.touching, forgiven * rounded.cell);
  lay_on_grid(rounded, bits);
  return rounded;
}

/// Page coordinates and depth rounded to 32-bit floats: the best that a pipeline of floats could deliver.
view::ProjectedScene in_floats(const view::ProjectedScene& view) {
  view::ProjectedScene rounded = copy_for_visibility(view);
  const double rounding = forgiven * float_rounding * view.extent;
  rounded.contact.touching = std::max(view.contact.touching, rounding);
  rounded.contact.joined = std::max(view.contact.joined, rounding);
  for (view::PageVertex& v : rounded.vertices)
    v = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.depth), v.w};
  lay_on_grid(rounded, usual_bits);
  return rounded;
}

struct Parameter {
  Algorithm algorithm;
  std::string key;
  double Method::*value;
  double min, max;
  bool whole;
  bool always_said;
};

const std::vector<std::pair<std::string, Algorithm>>& algorithms() {
  static const std::vector<std::pair<std::string, Algorithm>> all{{"exact", Algorithm::exact},
                                                                  {"float", Algorithm::floats},
                                                                  {"sampled", Algorithm::sampled},
                                                                  {"item-buffer", Algorithm::item_buffer},
                                                                  {"none", Algorithm::none}};
  return all;
}

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> all{{Algorithm::exact, "bits", &Method::bits, 4, 30, true, false},
                                          {Algorithm::sampled, "density", &Method::density, 1e-6, 1e6, false, true},
                                          {Algorithm::sampled, "halvings", &Method::halvings, 0, 60, true, false},
                                          {Algorithm::item_buffer, "dpi", &Method::dpi, 1, 1e5, false, true}};
  return all;
}

Algorithm algorithm_of(std::string_view name, const std::string& where) {
  std::vector<std::string> names;
  for (const auto& [known, algorithm] : algorithms()) {
    if (known == name) return algorithm;
    names.push_back(known);
  }
  throw Error(ErrorKind::input, where, "unknown value '" + std::string(name) + "'", did_you_mean(name, names));
}

void set(Method& method, std::string_view assignment, const std::string& where) {
  const std::string_view key = assignment.substr(0, assignment.find('='));
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters()) {
    if (parameter.algorithm != method.algorithm) continue;
    names.push_back(parameter.key);
    if (parameter.key != key) continue;
    const auto value = parse_number(assignment.substr(std::min(key.size() + 1, assignment.size())));
    if (!value || !(*value >= parameter.min && *value <= parameter.max) ||
        (parameter.whole && *value != std::floor(*value)))
      throw Error(ErrorKind::input, where, "'" + std::string(assignment) + "' is not possible",
                  parameter.key + " is a " + (parameter.whole ? "whole " : "") + "number from " +
                      format_number(parameter.min) + " to " + format_number(parameter.max));
    method.*parameter.value = *value;
    return;
  }
  throw Error(ErrorKind::input, where, name_of(method.algorithm) + " has no parameter '" + std::string(key) + "'",
              names.empty() ? "it has none" : did_you_mean(key, names));
}

}  // namespace

Method parse_method(std::string_view text, const std::string& where) {
  const std::vector<std::string_view> parts = split(text, ':');
  Method method;
  method.algorithm = algorithm_of(parts.front(), where);
  for (std::size_t i = 1; i < parts.size(); ++i) set(method, parts[i], where);
  return method;
}

std::string name_of(Algorithm algorithm) {
  for (const auto& [name, known] : algorithms())
    if (known == algorithm) return name;
  return {};
}

std::string parameters_of(const Method& method) {
  std::string text;
  for (const Parameter& parameter : parameters()) {
    if (parameter.algorithm != method.algorithm ||
        (!parameter.always_said && method.*parameter.value == Method().*parameter.value))
      continue;
    text += (text.empty() ? "" : ":") + parameter.key + "=" + format_number(method.*parameter.value);
  }
  return text;
}

std::string text_of(const Method& method) {
  const std::string turned = parameters_of(method);
  return name_of(method.algorithm) + (turned.empty() ? "" : ":") + turned;
}

visibility::HiddenSpans find_hidden(const world::World& world, const view::ProjectedScene& view,
                                    const edges::FeatureEdges& drawn, const Method& method, double mm) {
  switch (method.algorithm) {
    case Algorithm::exact:
      if (method.bits == Method().bits) return visibility::find_hidden(world, view, drawn);
      return visibility::find_hidden(world, on_coarser_grid(view, static_cast<int>(method.bits)), drawn);
    case Algorithm::floats:
      return visibility::find_hidden(world, in_floats(view), drawn);
    case Algorithm::sampled:
      return find_hidden_by_samples(world, view, drawn, {method.density * mm, static_cast<int>(method.halvings)});
    case Algorithm::item_buffer:
      return find_hidden_by_item_buffer(world, view, drawn, mm * method.dpi / 25.4);
    case Algorithm::none:
      return visibility::nothing_hidden(drawn);
  }
  return visibility::nothing_hidden(drawn);
}

}  // namespace epura::study
