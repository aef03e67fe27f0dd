// SPDX-License-Identifier: Apache-2.0
#include "sheet/revision_list.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "sheet/captions.hpp"
#include "sheet/list_table.hpp"

namespace epura::sheet {

namespace {

constexpr const char* revision_role = "revision";

}  // namespace

std::vector<std::string> draw_revisions(Layer& layer, const RevisionList& list, const Rectangle& box,
                                        const Lettering& lettering) {
  constexpr double index_width = 14, date_width = 26, author_width = 34;  // mm
  const auto named = [&list](const char* key) { return std::string(caption(key, list.language)); };
  ListColumn index{named("revision"), index_width, false, {}}, text{named("change"), 0, false, {}};
  ListColumn date{named("change_date"), date_width, false, {}}, author{named("changed_by"), author_width, false, {}};
  for (const scene::RevisionDescription& one : list.rows) {
    index.texts.push_back(*one.revision);
    text.texts.push_back(*one.text);
    date.texts.push_back(one.date.value_or(""));
    author.texts.push_back(one.author.value_or(""));
  }
  std::vector<ListColumn> columns{index, text};
  for (const ListColumn& column : {date, author})
    if (std::any_of(column.texts.begin(), column.texts.end(), [](const std::string& cell) { return !cell.empty(); }))
      columns.push_back(column);
  return draw_list(layer, std::move(columns), box, {revision_role, "list of revisions"}, lettering);
}

std::vector<std::string> rewrite_revisions(std::vector<Layer>& layers, const RevisionList& list,
                                           const Lettering& lettering) {
  const auto layer = std::find_if(layers.begin(), layers.end(), [](const Layer& one) {
    return !one.tables.empty() && !one.texts.empty() && one.texts.front().role == revision_role;
  });
  check(layer != layers.end() && layer->tables.front().rows.size() == list.rows.size() + 1,
        "a list that is written again has as many rows as before");
  const TableObject table = layer->tables.front();
  const double width = std::accumulate(table.widths.begin(), table.widths.end(), 0.0);
  const double height = table.row_height * static_cast<double>(table.rows.size());
  layer->strokes.clear();
  layer->texts.clear();
  layer->tables.clear();
  return draw_revisions(*layer, list, {table.corner - Vec2(0, height), table.corner + Vec2(width, 0)}, lettering);
}

}  // namespace epura::sheet
