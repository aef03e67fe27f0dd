// SPDX-License-Identifier: Apache-2.0
// Models, views and descriptions for tests of dimensions.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "dimensions/dimensions.hpp"
#include "scene/transform.hpp"
#include "shapes.hpp"
#include "view/paper_map.hpp"

namespace epura::test {

inline const Vec3 from_front{0, -1, 0}, from_left{-1, 0, 0}, from_corner{1, -1, 1};

inline world::World placed(const Shape& shape, const std::string& steps = "") {
  return world::make_world({{std::make_shared<const mesh::Mesh>(mesh_of(shape)), scene::parse_transform(steps)}});
}

/// Its front is the triangle 40, 30, 50; 10 deep. Vertices 0 (right angle at 1) to 2, and 3 to 5 behind them.
inline Shape wedge() {
  Shape shape;
  shape.points = {{0, 0, 0}, {40, 0, 0}, {40, 0, 30}, {0, 10, 0}, {40, 10, 0}, {40, 10, 30}};
  shape.faces = {{0, 1, 2}, {5, 4, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
  return shape;
}

/// A prism of `n` corners on a circle around the z axis; vertex 0 is at (radius, 0, 0).
inline Shape cylinder(int n, double radius, double height) {
  Shape shape;
  std::vector<int> bottom, top;
  for (int i = 0; i < 2 * n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    shape.points.push_back({radius * std::cos(a), radius * std::sin(a), i < n ? 0 : height});
  }
  for (int i = 0; i < n; ++i) {
    shape.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

/// A view in its place, `scale` mm for a unit of the world, its middle at (100, 100).
inline drawing::ViewDrawing drawing_of(const world::World& world, const projection::Projection& projection,
                                       double scale = 1) {
  view::ProjectedScene view = view::project_scene(world, projection, {});
  const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  return drawing::make_drawing({world, view, drawn, hidden}, view::make_paper_map(view, scale, {100, 100}),
                               {"view", true});
}

template <class Enum>
scene::Located<Enum> located_word(const std::string& word, const std::string& where) {
  for (std::size_t i = 0; i < scene::Words<Enum>::list.size(); ++i)
    if (scene::Words<Enum>::list[i] == word) return {static_cast<Enum>(i), where};
  return {{}, where};
}

inline scene::DimensionDescription dimension(const std::string& type, const std::vector<int>& vertices,
                                             const std::string& direction = "") {
  scene::DimensionDescription description;
  description.where = "scene.toml:7";
  description.type = located_word<DimensionType>(type, "scene.toml:8:8");
  description.direction = located_word<DimensionDirection>(direction, "scene.toml:9:13");
  for (const int v : vertices) description.anchors.emplace_back(std::array{0, v});
  return description;
}

inline sheet::Layer layer_of(const world::World& world, const drawing::ViewDrawing& drawing,
                             const std::vector<scene::DimensionDescription>& dimensions) {
  return sheet::place_dimensions({world, drawing, dimensions}, {sheet::Lettering(), 0.25}).layer;
}

/// What is written at the only dimension.
inline std::string text_of(const world::World& world, const drawing::ViewDrawing& drawing,
                           const scene::DimensionDescription& dimension) {
  return layer_of(world, drawing, {dimension}).texts.at(0).text;
}

/// Where the arrows of the n-th dimension point to.
inline std::array<Vec2, 2> tips(const sheet::Layer& layer, std::size_t n = 0) {
  return {layer.fills.at(2 * n).rings[0][0], layer.fills.at(2 * n + 1).rings[0][0]};
}

}  // namespace epura::test
