// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/tables.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

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

}  // namespace

Table table_of(std::span<const ViewMeasurements> views) {
  Table table{columns(), {}};
  for (const ViewMeasurements& view : views)
    for (const Measurement& one : view.methods) table.rows.push_back(row_of(view, one));
  return table;
}

}  // namespace epura::study
