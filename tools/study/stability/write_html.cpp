// SPDX-License-Identifier: Apache-2.0
#include "base/text.hpp"
#include "study/report_page.hpp"
#include "study/stability/write.hpp"
#include "study/table.hpp"

namespace epura::stability {

namespace {

using study::Columns;
using study::Table;

const std::string notes =
    "Every case is drawn at every step from its triangles by three arithmetics: 32-bit floats (dotted), one composed "
    "matrix in doubles (dashed) and epura's own map (continuous); and by that with the faces of recognised parts "
    "(short and long dashes). Errors are parts of the drawing's size; a cross marks what is not "
    "right, the line with dots the error that is allowed.\n\nThe first sheet has the first step that is not "
    "right in each way, of steps from mild to extreme; - where all are right.\n";

Table summary(const Report& report) {
  Table table{{{"case", "", false},
               {"what", "", false},
               {"float32", ""},
               {"double", ""},
               {"epura", ""},
               {"recognised", ""},
               {"epura is", ""}},
              {}};
  for (const CaseReport& one : report) {
    std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{one.id, one.what});
    for (std::size_t way = 0; way < way_names.size(); ++way) {
      const auto step = one.breaks_at(static_cast<Way>(way));
      row.push_back(step ? format_rounded(*step, 3) : "-");
    }
    row.emplace_back(name_of(one.verdict()));
  }
  return table;
}

std::vector<std::string> cells_of(const Row& row, std::size_t way) {
  const Outcome& outcome = row.outcomes[way];
  std::vector<std::string> cells{format_rounded(row.step, 4), std::string(way_names[way])};
  if (const Quantity* q = outcome.worst())
    cells.insert(cells.end(), {q->name, format_rounded(q->expected, 9), format_rounded(q->got, 9),
                               format_rounded(q->error(), 3), format_rounded(q->allowed, 3)});
  else
    cells.insert(cells.end(), {outcome.failure, "", "", "", ""});
  cells.emplace_back(name_of(outcome.verdict()));
  return cells;
}

Table table_of(const CaseReport& one) {
  Table table{{{"step", ""},
               {"way", "", false},
               {"worst quantity", "", false},
               {"expected", ""},
               {"got", ""},
               {"error", ""},
               {"allowed", ""},
               {"verdict", "", false}},
              {}};
  for (const Row& row : one.rows)
    for (std::size_t way = 0; way < way_names.size(); ++way) table.rows.push_back(cells_of(row, way));
  return table;
}

}  // namespace

std::string to_html(const Report& report) {
  std::vector<sheet::Sheet> sheets{to_sheet(summary(report), "Stability", Columns::all)};
  for (const CaseReport& one : report) {
    sheets.push_back(study::stacked(to_sheet(one), to_sheet(table_of(one), "by " + one.parameter, Columns::all)));
    sheets.back().title = one.id + " " + one.what;
  }
  return study::report_page("Stability", sheets, notes);
}

}  // namespace epura::stability
