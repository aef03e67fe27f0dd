// SPDX-License-Identifier: Apache-2.0
#include "sheet/parts_list.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "sheet/captions.hpp"
#include "sheet/list_table.hpp"

namespace epura::sheet {

namespace {

constexpr double number_width = 14, material_width = 40, mass_width = 24;  // mm

}  // namespace

std::vector<std::string> draw_parts_list(Layer& layer, const PartsList& list, const Rectangle& box,
                                         const Lettering& lettering) {
  const auto named = [&list](const char* key) { return std::string(caption(key, list.language)); };
  ListColumn item{named("item"), number_width, true, {}}, quantity{named("quantity"), number_width, true, {}};
  ListColumn name{named("name"), 0, false, {}}, material{named("material"), material_width, false, {}};
  ListColumn mass{named("mass"), mass_width, true, {}};
  double heaviest = 0;
  for (const world::Item& one : list.items) heaviest = std::max(heaviest, one.mass.value_or(0));
  for (const world::Item& one : list.items) {
    check(one.quantity > 0, "an item of the list is in the assembly");
    item.texts.push_back(std::to_string(item.texts.size() + 1));
    quantity.texts.push_back(std::to_string(one.quantity));
    name.texts.push_back(one.name);
    material.texts.push_back(one.material);
    mass.texts.push_back(one.mass ? mass_text(*one.mass, list.sign, heaviest) : std::string());
  }
  std::vector<ListColumn> columns{item, quantity, name};
  for (const ListColumn& column : {material, mass})
    if (std::any_of(column.texts.begin(), column.texts.end(), [](const std::string& text) { return !text.empty(); }))
      columns.push_back(column);
  return draw_list(layer, std::move(columns), box, {"parts-list", "parts list"}, lettering);
}

}  // namespace epura::sheet
