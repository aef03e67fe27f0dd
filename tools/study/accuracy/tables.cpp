// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/tables.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "output/html.hpp"

namespace epura::study {

namespace {

// Six digits: more than the accuracy of any measurement here.
std::string number(double value) { return std::isfinite(value) ? format_rounded(value, 6) : "inf"; }

std::string number(long long value) { return std::to_string(value); }

std::vector<Table::Column> columns() {
  constexpr bool text = false, number = true, printed = true;
  return {{"scene", "what is drawn", text},
          {"view", "how", text},
          {"method", "by which hidden lines were found", text, printed},
          {"knob", "its setting", text, printed},
          {"E_max_mm", "longest misclassified span", number, printed},
          {"E_sum_mm", "all misclassified spans together", number, printed},
          {"E_ink_mm", "Hausdorff distance of the visible ink, both ways", number, printed},
          {"end_mm", "farthest shift of an end of a visible span", number, printed},
          {"E_max", "the same four as parts of the drawing's longest side"},
          {"E_sum", ""},
          {"E_ink", ""},
          {"end", ""},
          {"missed", "visible spans of which nothing is shown", number, printed},
          {"phantom", "spans shown visible of which nothing is", number, printed},
          {"cracks", "gaps in visible spans", number, printed},
          {"wrong", "edges with a misclassified span", number, printed},
          {"judged", "edges that were compared with the truth", number, printed},
          {"edges", "all drawn edges"},
          {"at_most_wrong", "share of wrong edges: measured where all were judged, otherwise with 95 % confidence"},
          {"undecided", "share of the judged length about which the input does not tell"},
          {"seconds", "median", number, printed},
          {"fastest", "seconds"},
          {"slowest", "seconds"},
          {"runs", "in turns with the other methods"},
          {"memory_MB", "by which the process grew at most", number, printed},
          {"read_seconds", "to read the models"},
          {"front", "1: no other method is both faster and better", number, printed}};
}

std::vector<std::string> row_of(const ViewMeasurements& view, const Measurement& one) {
  const Errors& e = one.errors;
  const auto [fastest, slowest] = std::minmax_element(one.seconds.begin(), one.seconds.end());
  const bool ran = !one.seconds.empty();
  return {view.scene,
          view.view,
          one.method,
          one.parameters,
          number(e.longest),
          number(e.sum),
          number(e.ink),
          number(e.end_point),
          number(e.longest / view.size),
          number(e.sum / view.size),
          number(e.ink / view.size),
          number(e.end_point / view.size),
          number(e.missed),
          number(e.phantom),
          number(e.cracks),
          number(e.edges),
          number(e.judged),
          number(static_cast<long long>(view.edges)),
          number(one.at_most_wrong),
          number(view.undecided),
          number(one.median),
          ran ? number(*fastest) : "",
          ran ? number(*slowest) : "",
          number(static_cast<long long>(one.seconds.size())),
          one.memory ? number(*one.memory * 1e-6) : "",
          number(view.read_seconds),
          one.on_front ? "1" : "0"};
}

std::string quoted_csv(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

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

Table table_of(std::span<const ViewMeasurements> views) {
  Table table{columns(), {}};
  for (const ViewMeasurements& view : views)
    for (const Measurement& one : view.methods) table.rows.push_back(row_of(view, one));
  return table;
}

std::string to_csv(const Table& table) {
  std::vector<std::string> names;
  for (const Table::Column& column : table.columns) names.push_back(column.name);
  const auto line = [](const std::vector<std::string>& cells) {
    return joined(cells, ",", [&](std::size_t i) { return quoted_csv(cells[i]); }) + "\r\n";
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

sheet::Sheet to_sheet(const Table& table, const std::string& title) {
  constexpr double margin = 10, text_column = 26, number_column = 17.5, row_height = 5, letters = 1.8;
  sheet::Layer layer{"table", {"plot-text", 0.25}, {}, {}, {}};
  const double height = 2 * margin + 12 + row_height * static_cast<double>(table.rows.size() + 1);
  double x = margin;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Table::Column& column = table.columns[i];
    if (!column.printed) continue;
    const double step = column.number ? number_column : text_column;
    const double at = column.number ? x + step - 2 : x;
    const sheet::Align align = column.number ? sheet::Align::right : sheet::Align::left;
    double y = height - margin - 12;
    layer.texts.push_back({column.name, {at, y}, letters, 0, align, "head"});
    for (const auto& row : table.rows)
      layer.texts.push_back({row[i], {at, y -= row_height}, letters, 0, align, "cell"});
    x += step;
  }
  layer.texts.push_back({title, {margin, height - margin - 3.5}, 3.5, 0, sheet::Align::left, "title"});
  return {x + margin, height, title, {std::move(layer)}};
}

std::string to_html(const Table& table) {
  std::string text = "<table>\n<thead><tr>";
  for (const Table::Column& column : table.columns)
    text += "<th title=\"" + output::html_text(column.meaning) + "\">" + output::html_text(column.name) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows)
    text +=
        "<tr>" +
        joined(row, "",
               [&](std::size_t i) {
                 return (table.columns[i].number ? "<td class=\"n\">" : "<td>") + output::html_text(row[i]) + "</td>";
               }) +
        "</tr>\n";
  return text + "</tbody>\n</table>\n";
}

}  // namespace epura::study
