// SPDX-License-Identifier: Apache-2.0
// A drawing to compare with, and what was found.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "output/write.hpp"

namespace epura::test {

// A plate with a hole in a front view, with a hidden slot, a dimension and a title.
enum : std::size_t { hidden, visible, dimension, text };

inline sheet::Stroke circle(const Vec2& centre, double radius) {
  sheet::Stroke stroke;
  constexpr int corners = 36;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    stroke.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  stroke.closed = true;
  stroke.curves = {{0, corners, centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi}};
  return stroke;
}

inline sheet::Stroke line(const Vec2& from, const Vec2& to, const std::vector<sheet::ModelEdge>& edges = {}) {
  sheet::Stroke stroke{{from, to}};
  stroke.kind = EdgeKind::crease;
  stroke.edges = edges;
  return stroke;
}

inline sheet::Sheet plate() {
  sheet::Sheet sheet{210, 148, "plate", {}};
  sheet.layers = {{"front/hidden", {"hidden", 0.25, {3, 0.75}}, {}},
                  {"front/visible", {"visible", 0.5}, {}},
                  {"front/dimension", {"dimension", 0.25}, {}},
                  {"sheet/text", {"text", 0.35}, {}}};
  sheet.layers[hidden].strokes = {line({30, 60}, {90, 60}, {{0, {1, 2}}}), line({30, 70}, {90, 70}, {{0, {3, 4}}})};
  for (sheet::Stroke& stroke : sheet.layers[hidden].strokes) stroke.dashes = {2.9, 0.75};
  sheet::Stroke outline{{{20, 40}, {100, 40}, {100, 90}, {20, 90}}, true};
  outline.kind = EdgeKind::contour;
  outline.edges = {{0, {10, 11}}, {0, {11, 12}}, {0, {12, 13}}, {0, {10, 13}}};
  sheet.layers[visible].strokes = {outline, circle({60, 80}, 5), line({20, 50}, {100, 50}, {{0, {5, 6}}})};
  sheet.layers[dimension].strokes = {line({20, 30}, {100, 30})};
  sheet.layers[dimension].fills = {{{{{20, 30}, {23.5, 29.4}, {23.5, 30.6}}}}};
  sheet.layers[dimension].texts = {{"80", {60, 31}, 3.5, 0, sheet::Align::middle}};
  sheet.layers[text].texts = {{"Plate", {150, 20}, 5}, {"1:1", {150, 10}, 3.5}};
  return sheet;
}

inline compare::PictureFile as_svg(const sheet::Sheet& sheet, const output::VectorOptions& options = {}) {
  return {false, false, {compare::picture_of_svg(output::to_svg(sheet, options), "test.svg")}};
}

inline std::string changes(const compare::Comparison& comparison) {
  std::vector<std::string> names;
  for (const compare::Difference& difference : comparison.differences)
    names.emplace_back(compare::name_of(difference.change));
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? " " : "") + names[i];
  return text;
}

inline sheet::Stroke& stroke(sheet::Sheet& sheet, std::size_t layer, std::size_t number) {
  return sheet.layers[layer].strokes.at(number);
}

inline void move(sheet::Stroke& moved, const Vec2& by) {
  for (Vec2& p : moved.points) p += by;
  for (drawing::CurvePart& curve : moved.curves) curve.centre += by;
}

}  // namespace epura::test
