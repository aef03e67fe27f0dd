// SPDX-License-Identifier: Apache-2.0
#include "world/items.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "scene/body_styles.hpp"
#include "world/congruent.hpp"
#include "world/mass.hpp"

namespace epura::world {

namespace {

/// A body, with what tells whether it equals others.
struct Body {
  int model, number;
  std::string name;  ///< empty if it has none
  std::vector<int> triangles;
};

std::string name_of_part(const World& world, const std::vector<scene::ModelDescription>& models, int model, int body) {
  const std::string& name = scene::name_of_body(*world.models[model].mesh, body);
  if (!name.empty()) return name;
  const bool is_whole = world.models[model].mesh->report.bodies <= 1;
  return is_whole && models[model].name.given() ? *models[model].name : std::string();
}

// One named group is one body, whatever it consists of.
std::vector<Body> bodies_of(const World& world, const std::vector<scene::ModelDescription>& models) {
  std::vector<Body> bodies;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const mesh::Mesh& mesh = *world.models[m].mesh;
    const bool is_one = mesh.report.body_names.empty() && !mesh.report.only_body.empty();
    std::map<int, std::vector<int>> triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t)
      triangles[is_one ? 0 : mesh.body[t]].push_back(world.first_triangle[m] + t);
    for (auto& [body, own] : triangles)
      bodies.push_back(
          {static_cast<int>(m), body, name_of_part(world, models, static_cast<int>(m), body), std::move(own)});
  }
  return bodies;
}

// "nut_1", "nut-2", "nut 3", "nut:4" -> "nut"
std::string without_number(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size()) return name;
  const std::size_t base = name.find_last_not_of("_-.:# ", end);
  return base == std::string::npos || base == end ? name : name.substr(0, base + 1);
}

/// An item while bodies are sorted into items.
struct Growing {
  Item item;
  std::string name;  ///< of its first body
  Shape shape;
};

bool is_joined(const Growing& item, const Body& body, const Shape& shape, double tolerance) {
  if (!body.name.empty() && body.name == item.name) return true;
  const bool may_be = body.name.empty() || item.name.empty() || without_number(body.name) == without_number(item.name);
  return may_be && are_congruent(item.shape, shape, tolerance);
}

// Open bodies have no mass.
void describe(Item& item, const World& world, const std::vector<scene::ModelDescription>& models, const Body& body) {
  const Placed& model = world.models[body.model];
  if (!model.styles.empty()) item.material = model.styles[static_cast<std::size_t>(body.number)].material.value_or("");
  const double density = density_of(model, models[static_cast<std::size_t>(body.model)], body.number);
  if (!(density > 0)) return;
  for (const Solid& solid : solids_of(model.mesh->whole(), model.to_world))
    if (solid.body == body.number && solid.fault.empty()) item.mass = sum_of({&solid, 1}, {&density, 1}).mass;
}

// "part", or "part 1", "part 2" if the model has several items without names.
void name_items(std::vector<Growing>& items, const std::vector<scene::ModelDescription>& models) {
  std::map<int, int> count, number;
  for (const Growing& one : items)
    if (one.item.name.empty()) ++count[one.item.bodies.front()[0]];
  for (Growing& one : items) {
    if (!one.item.name.empty()) continue;
    const int model = one.item.bodies.front()[0];
    one.item.name = scene::name_of(models[model]);
    if (count[model] > 1) one.item.name += " " + std::to_string(++number[model]);
  }
}

}  // namespace

std::vector<Item> find_items(const World& world, const std::vector<scene::ModelDescription>& descriptions) {
  std::vector<Growing> items;
  for (const Body& body : bodies_of(world, descriptions)) {
    Shape shape = shape_of(world, body.triangles);
    if (shape.corners.empty()) continue;
    const double tolerance = 1e-6 * shape.reach.back() + 4 * world.rounding;
    const auto same = [&](const Growing& one) { return one.name == body.name && !body.name.empty(); };
    auto found = std::find_if(items.begin(), items.end(), same);
    if (found == items.end())
      found = std::find_if(items.begin(), items.end(),
                           [&](const Growing& one) { return is_joined(one, body, shape, tolerance); });
    if (found == items.end()) {
      Growing& added = items.emplace_back();
      added.item.name = added.name = body.name;
      describe(added.item, world, descriptions, body);
      added.shape = std::move(shape);
      found = items.end() - 1;
    }
    if (found->item.name.empty()) found->item.name = body.name;
    if (!body.name.empty() && found->item.name != body.name) found->item.name = without_number(found->item.name);
    ++found->item.quantity;
    found->item.bodies.push_back({body.model, body.number});
  }
  name_items(items, descriptions);
  std::vector<Item> result;
  for (Growing& one : items) result.push_back(std::move(one.item));
  return result;
}

}  // namespace epura::world
