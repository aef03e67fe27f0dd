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

/// What is one piece, with what tells whether it equals others.
struct ItemBody {
  int model;
  std::vector<int> numbers;  ///< of the bodies that it consists of
  std::string name;          ///< empty if it has none
  std::vector<int> triangles;
};

using Parts = std::vector<importer::BodyPart>;

// Of the part that occurs there, or else of the body itself.
std::string name_of_part(const World& world, const scene::ModelDescription& description, const Parts& parts, int model,
                         int body) {
  const mesh::Mesh& mesh = *world.models[model].mesh;
  if (!parts.empty() && !parts[body].name.empty()) return parts[body].name;
  const std::string& name = scene::name_of_body(mesh, body);
  if (!name.empty()) return name;
  return mesh.report.bodies <= 1 && description.name.given() ? *description.name : std::string();
}

// The first body of the occurrence of a part to which a body belongs as a nameless piece, or else itself.
int piece_of(const Parts& parts, int body) {
  if (parts.empty() || parts[body].name.empty()) return body;
  const auto same = [&own = parts[body]](const importer::BodyPart& other) {
    return other.occurrence == own.occurrence && other.name == own.name;
  };
  return static_cast<int>(std::find_if(parts.begin(), parts.end(), same) - parts.begin());
}

// Which bodies of a model are surfaces beside the solids of one occurrence of a part, such as planes of construction.
std::vector<char> surfaces_of(const Placed& placed, const Parts& parts) {
  const mesh::Mesh& mesh = placed.mesh->whole();
  std::vector<char> surfaces(static_cast<std::size_t>(std::max(mesh.report.bodies, 1)), 0);
  std::map<int, int> bodies, solids;  // of an occurrence
  for (const importer::BodyPart& part : parts) ++bodies[part.occurrence];
  if (bodies.size() == parts.size()) return surfaces;
  const std::vector<Solid> measured = solids_of(mesh, placed.to_world);
  for (const Solid& solid : measured) solids[parts[solid.body].occurrence] += solid.fault.empty() ? 1 : 0;
  for (const Solid& solid : measured)
    surfaces[solid.body] = !solid.fault.empty() && solids[parts[solid.body].occurrence] > 0 ? 1 : 0;
  return surfaces;
}

// One named group is one body, whatever it consists of.
std::vector<ItemBody> bodies_of(const World& world, const std::vector<scene::ModelDescription>& models,
                                const std::vector<Parts>& parts, std::vector<std::string>& surfaces) {
  std::vector<ItemBody> bodies;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const mesh::Mesh& mesh = *world.models[m].mesh;
    const bool is_one = mesh.report.body_names.empty() && !mesh.report.only_body.empty();
    std::map<int, std::vector<int>> triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t)
      triangles[is_one ? 0 : mesh.body[t]].push_back(world.first_triangle[m] + t);
    const std::vector<char> is_surface = is_one ? std::vector<char>{0} : surfaces_of(world.models[m], parts[m]);
    std::map<int, std::size_t> of_piece;  // index in `bodies`
    for (auto& [body, own] : triangles) {
      std::string name = name_of_part(world, models[m], parts[m], static_cast<int>(m), body);
      if (is_surface[body] != 0) {
        surfaces.push_back(name.empty() ? scene::name_of(models[m]) : std::move(name));
        continue;
      }
      const auto [piece, is_new] = of_piece.try_emplace(piece_of(parts[m], body), bodies.size());
      if (is_new) bodies.push_back({static_cast<int>(m), {}, std::move(name), {}});
      ItemBody& whole = bodies[piece->second];
      whole.numbers.push_back(body);
      whole.triangles.insert(whole.triangles.end(), own.begin(), own.end());
    }
  }
  return bodies;
}

// Where the number at the end of a name begins; the length of the name if it has none.
std::size_t begin_of_number(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  return end == std::string::npos ? name.size() : end + 1;
}

// "nut_1", "nut-2", "nut 3", "nut:4" -> "nut". What has no separator may be a size: "nut M10".
std::string without_number(const std::string& name) {
  const std::size_t number = begin_of_number(name), base = name.find_last_not_of("_-.:# ", number - 1);
  return number == name.size() || base == std::string::npos || base + 1 == number ? name : name.substr(0, base + 1);
}

// FreeCAD calls copies of "nut M10" "nut M011" and "nut M012".
bool have_one_name(const std::string& a, const std::string& b) {
  return without_number(a) == without_number(b) || a.substr(0, begin_of_number(a)) == b.substr(0, begin_of_number(b));
}

/// An item while bodies are sorted into items.
struct Growing {
  Item item;
  std::string name;  ///< of its first body
  Shape shape;
};

bool is_joined(const Growing& item, const ItemBody& body, const Shape& shape, double tolerance) {
  const bool may_be = body.name.empty() || item.name.empty() || have_one_name(body.name, item.name);
  return may_be && are_congruent(item.shape, shape, tolerance);
}

// Open bodies have no mass.
void describe(Item& item, const World& world, const std::vector<scene::ModelDescription>& models,
              const ItemBody& body) {
  const Placed& model = world.models[body.model];
  const int first = body.numbers.front();
  const int number = static_cast<int>(body.model);
  if (const auto styles = world.styles_of(number); !styles.empty())
    item.material = styles[static_cast<std::size_t>(first)].material.value_or("");
  const double density = density_of(world, number, models[static_cast<std::size_t>(body.model)], first);
  if (!(density > 0)) return;
  std::vector<Solid> solids;
  for (Solid& solid : solids_of(model.mesh->whole(), model.to_world))
    if (std::find(body.numbers.begin(), body.numbers.end(), solid.body) != body.numbers.end())
      solids.push_back(std::move(solid));
  const std::vector<double> densities(solids.size(), density);
  if (std::all_of(solids.begin(), solids.end(), [](const Solid& solid) { return solid.fault.empty(); }))
    item.mass = sum_of(solids, densities).mass;
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

ItemList find_items(const World& world, const std::vector<scene::ModelDescription>& descriptions,
                    const std::vector<Parts>& parts) {
  ItemList list;
  std::vector<Growing> items;
  for (const ItemBody& body : bodies_of(world, descriptions, parts, list.surfaces)) {
    Shape shape = shape_of(world, body.triangles);
    if (shape.corners.empty()) continue;
    const double tolerance = 1e-6 * shape.reach.back() + 4 * world.rounding;
    const auto joins = [&](const Growing& one) { return is_joined(one, body, shape, tolerance); };
    auto found = std::find_if(items.begin(), items.end(),
                              [&](const Growing& one) { return one.name == body.name && joins(one); });
    if (found == items.end()) found = std::find_if(items.begin(), items.end(), joins);
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
    for (const int number : body.numbers) found->item.bodies.push_back({body.model, number});
  }
  name_items(items, descriptions);
  for (Growing& one : items) list.items.push_back(std::move(one.item));
  return list;
}

}  // namespace epura::world
