// SPDX-License-Identifier: Apache-2.0
#include "composition/dimension_facts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "composition/annotations.hpp"
#include "features/tolerances.hpp"
#include "features/true_extents.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/free_faces.hpp"
#include "sizes/place_joins.hpp"

namespace epura::pipeline {

namespace {

// "+0.2 -0.1", "±0.1", "H7/g6"
std::string text_of(const sheet::Tolerance& tolerance) {
  if (tolerance.deviations) {
    const auto signed_text = [](double value) { return (value > 0 ? "+" : "") + format_number(value); };
    const auto [lower, upper] = std::pair(tolerance.deviations->lower, tolerance.deviations->upper);
    if (upper == -lower) return "±" + format_number(upper);
    return signed_text(upper) + " " + signed_text(lower);
  }
  std::string text = tolerance.hole ? tolerance.hole->text() : "";
  if (tolerance.shaft) text += (text.empty() ? "" : "/") + tolerance.shaft->text();
  return text;
}

std::string point_text(const Vec3& p) {
  return "(" + format_rounded(p.x, 6) + ", " + format_rounded(p.y, 6) + ", " + format_rounded(p.z, 6) + ")";
}

// What it measures, along which axis of the world: "linear:x:face 1-4". Without faces, by the places of its ends.
std::string measured_by(const sheet::AnchoredDimension& dimension, const sheet::DimensionsInView& view,
                        const std::vector<int>& faces) {
  std::string text(scene::word_of(dimension.type));
  if (const auto along = sheet::measured_along(dimension, view)) {
    const int axis = sheet::world_axis(*along);
    text += axis < 0 ? ":" + point_text(*along) : std::string(":") + "xyz"[axis];
  }
  std::string what;
  for (const int face : faces) what += (what.empty() ? "face " : "-") + std::to_string(face);
  if (what.empty())
    for (const Vec3& point : dimension.points) what += point_text(point);
  if (what.empty() && !dimension.circles.empty()) what = point_text(dimension.circles.front().centre);
  return text + ":" + what;
}

}  // namespace

void add_dimension_facts(std::span<FinishedSheet> sheets, std::span<const sheet::DimensionsInView> views,
                         const world::World& world, const scene::SceneDescription& scene) {
  const auto faces =
      sheet::measured_faces(views, world, features::true_extents(world), notation_of(world, scene.sheets.front()));
  std::map<std::string, int> times;
  for (FinishedSheet& sheet : sheets)
    for (sheet::Layer& layer : sheet.sheet.layers) {
      const std::string name = layer.name.substr(0, layer.name.rfind('/'));
      const auto view = std::find_if(views.begin(), views.end(), [&name](const auto& one) { return one.view == name; });
      if (view == views.end()) continue;
      for (sheet::DimensionObject& object : layer.dimensions) {
        const auto number = static_cast<std::size_t>(object.number);
        if (object.number < 0 || number >= view->dimensions.size()) continue;
        const sheet::AnchoredDimension& dimension = view->dimensions[number];
        object.faces = faces[static_cast<std::size_t>(view - views.begin())][number];
        if (dimension.tolerance) object.tolerance = text_of(*dimension.tolerance);
        object.id = dimension.name.empty() ? measured_by(dimension, *view, object.faces) : dimension.name;
        if (const int count = ++times[object.id]; count > 1) object.id += "#" + std::to_string(count);
      }
    }
}

}  // namespace epura::pipeline
