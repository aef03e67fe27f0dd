// SPDX-License-Identifier: Apache-2.0
#include "sheet/revision_list.hpp"

#include <algorithm>
#include <utility>

#include "sheet/captions.hpp"
#include "sheet/list_table.hpp"

namespace epura::sheet {

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
  return draw_list(layer, std::move(columns), box, {"revision", "list of revisions"}, lettering);
}

}  // namespace epura::sheet
