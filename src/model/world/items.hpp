// SPDX-License-Identifier: Apache-2.0
// The items of a parts list: equal bodies of the models, counted. ISO 7573.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "importer/assemble.hpp"
#include "scene/description.hpp"
#include "world/world.hpp"

namespace epura::world {

struct Item {
  std::string name;
  int quantity = 0;
  std::string material{};
  std::optional<double> mass{};              ///< of one, kg; nothing without a density or for open bodies
  std::vector<std::array<int, 2>> bodies{};  ///< their models, and their numbers there
};

struct ItemList {
  std::vector<Item> items;              ///< in the order of the models and bodies
  std::vector<std::string> surfaces{};  ///< names of open bodies beside the solids of a part, which are no items
};

/// Bodies of the same shape are one item if their names are equal, differ only by a number at the end, or are missing.
/// The name of a body is that of the part of which the file says that it occurs there, otherwise its own; bodies of
/// one occurrence whose part has a name, but which have none themselves, are counted as one. An item without a name has
/// that of its model. `descriptions` and `parts` of bodies: of the models, in their order; a model without parts has an
/// empty list. Lengths of the world are mm.
ItemList find_items(const World& world, const std::vector<scene::ModelDescription>& descriptions,
                    const std::vector<std::vector<importer::BodyPart>>& parts);

}  // namespace epura::world
