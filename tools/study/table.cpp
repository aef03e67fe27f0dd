// SPDX-License-Identifier: Apache-2.0
#include "study/table.hpp"

#include <algorithm>

#include "base/csv.hpp"
#include "base/utf8.hpp"
#include "sheet/lettering.hpp"

namespace epura::study {

namespace {

std::string quoted_json(const std::string& cell) {
  std::string text = "\"";
  for (const char c : valid_utf8(cell)) {
    if (c == '"' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text + "\"";
}

// The cells, each formatted by `write`, with separators between them.
template <class Write>
std::string joined(const std::vector<std::string>& cells, const std::string& between, const Write& write) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : between) + write(i);
  return text;
}

}  // namespace

std::string to_csv(const Table& table) {
  std::vector<std::string> names;
  for (const Table::Column& column : table.columns) names.push_back(column.name);
  const auto line = [](const std::vector<std::string>& cells) {
    return joined(cells, ",", [&](std::size_t i) { return csv_field(cells[i]); }) + "\r\n";
  };
  std::string text = line(names);
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string to_json_list(const Table& table) {
  std::string text;
  for (const auto& row : table.rows) {
    text += text.empty() ? "\n  {" : ",\n  {";
    text += joined(row, ", ", [&](std::size_t i) {
      const bool number = table.columns[i].number;
      const std::string value = !number ? quoted_json(row[i]) : row[i].empty() || row[i] == "inf" ? "null" : row[i];
      return "\"" + table.columns[i].name + "\": " + value;
    });
    text += "}";
  }
  return "[" + text + "]";
}

sheet::Sheet to_sheet(const Table& table, const std::string& title, Columns columns) {
  constexpr double margin = 10, row_height = 5, letters = 1.8, gap = 4;
  const sheet::Lettering lettering;
  sheet::Layer layer{"table", {"plot-text", 0.25}, {}, {}, {}};
  const double height = 2 * margin + 12 + row_height * static_cast<double>(table.rows.size() + 1);
  double x = margin;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Table::Column& column = table.columns[i];
    if (columns == Columns::printed && !column.printed) continue;
    double width = lettering.width(column.name, letters);
    for (const auto& row : table.rows) width = std::max(width, lettering.width(row[i], letters));
    const double at = column.number ? x + width : x;
    const sheet::Align align = column.number ? sheet::Align::right : sheet::Align::left;
    double y = height - margin - 12;
    layer.texts.push_back({column.name, {at, y}, letters, 0, align, "head"});
    for (const auto& row : table.rows)
      layer.texts.push_back({row[i], {at, y -= row_height}, letters, 0, align, "cell"});
    x += width + gap;
  }
  constexpr double title_letters = 3.5;
  layer.texts.push_back(
      {title, {margin, height - margin - title_letters}, title_letters, 0, sheet::Align::left, "title"});
  const double width = std::max(x - gap, margin + lettering.width(title, title_letters));
  return {width + margin, height, title, {std::move(layer)}};
}

}  // namespace epura::study
