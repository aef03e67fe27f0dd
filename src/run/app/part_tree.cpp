// SPDX-License-Identifier: Apache-2.0
#include "app/part_tree.hpp"

#include <algorithm>
#include <utility>

#include "base/groups.hpp"
#include "output/json_text.hpp"

namespace epura {

namespace {

using importer::TreePart;
using Lines = std::vector<std::string>;

/// Groups parts by parent: parts without a parent come first.
Groups<int> children_of(const std::vector<TreePart>& tree) {
  return {tree.size() + 1, [&](const auto& visit) {
            for (std::size_t i = 0; i < tree.size(); ++i)
              visit(static_cast<std::size_t>(tree[i].parent + 1), static_cast<int>(i));
          }};
}

std::string sizes_of(const TreePart& part) {
  std::string text;
  if (part.bodies > 1) text += ", " + std::to_string(part.bodies) + " bodies";
  if (part.faces > 0) text += ", " + std::to_string(part.faces) + (part.faces == 1 ? " face" : " faces");
  return text;
}

/// Equal parts under one parent: their number, name and sizes, and the lines below them.
struct TreeRow {
  int count;
  const TreePart* part;
  Lines below;
};

Lines lines_of_rows(const std::vector<TreeRow>& rows) {
  Lines lines;
  for (const TreeRow& row : rows) {
    lines.push_back((row.part->name.empty() ? "(no name)" : row.part->name) +
                    (row.count > 1 ? " x " + std::to_string(row.count) : "") + sizes_of(*row.part));
    for (const std::string& line : row.below) lines.push_back("  " + line);
  }
  return lines;
}

void add_row(std::vector<TreeRow>& rows, const TreePart& part, Lines below) {
  const auto same = std::find_if(rows.begin(), rows.end(), [&](const TreeRow& row) {
    return row.part->name == part.name && sizes_of(*row.part) == sizes_of(part) && row.below == below;
  });
  if (same != rows.end())
    ++same->count;
  else
    rows.push_back({1, &part, std::move(below)});
}

}  // namespace

std::vector<std::string> tree_lines(const std::vector<TreePart>& tree) {
  // Children follow their parents, so that in reverse order everything below a part is known.
  std::vector<Lines> below(tree.size() + 1);
  const Groups<int> children = children_of(tree);
  for (std::size_t parent = tree.size() + 1; parent-- > 0;) {
    std::vector<TreeRow> rows;
    for (const int child : children[parent])
      add_row(rows, tree[static_cast<std::size_t>(child)], std::move(below[static_cast<std::size_t>(child) + 1]));
    below[parent] = lines_of_rows(rows);
  }
  return below[0];
}

std::string tree_json(const std::vector<TreePart>& tree) {
  std::vector<std::string> parts(tree.size() + 1);
  const Groups<int> children = children_of(tree);
  for (std::size_t parent = tree.size() + 1; parent-- > 0;)
    parts[parent] = output::json_list(children[parent], [&](int child) {
      const TreePart& part = tree[static_cast<std::size_t>(child)];
      return "{\"name\": " + output::json_string(part.name) + ", \"bodies\": " + std::to_string(part.bodies) +
             ", \"faces\": " + std::to_string(part.faces) +
             ", \"parts\": " + parts[static_cast<std::size_t>(child) + 1] + "}";
    });
  return parts[0];
}

}  // namespace epura
