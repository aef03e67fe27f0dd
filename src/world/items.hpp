// SPDX-License-Identifier: Apache-2.0
// The items of a parts list: equal bodies of the models, counted. ISO 7573.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace epura::world {

struct Item {
  std::string name;
  int quantity = 0;
  std::string material{};
  std::optional<double> mass{};              ///< of one, kg; nothing without a density or for open bodies
  std::vector<std::array<int, 2>> bodies{};  ///< their models, and their numbers there
};

/// In the order of the models and bodies. Bodies of one name are one item; bodies whose names differ only by a number
/// at the end, and bodies without names, if they have the same shape. An item without a name has that of its model.
/// `descriptions`: of the models, in their order. Lengths of the world are mm.
std::vector<Item> find_items(const World& world, const std::vector<scene::ModelDescription>& descriptions);

}  // namespace epura::world
