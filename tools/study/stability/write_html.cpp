// SPDX-License-Identifier: Apache-2.0
#include "base/text.hpp"
#include "output/html.hpp"
#include "study/stability/write.hpp"

namespace epura::stability {

namespace {

constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Stability</title><style>
body{font:14px sans-serif;max-width:70em;margin:2em auto}
table{border-collapse:collapse}td,th{padding:1px 8px;text-align:left;border-bottom:1px solid #ddd}
.broken{color:#b00}.limited{color:#a60}section svg{width:100%;max-width:560px;height:auto}
</style></head><body>
<h1>Stability</h1>
<p>Every case is drawn at every step by three arithmetics: 32-bit floats (dotted), one composed matrix in doubles
(dashed) and epura's own map (continuous). Errors are parts of the drawing's size; a cross marks what is not right, the
line with dots the error that is allowed.</p>
)";

std::string cell(std::string_view text) { return "<td>" + output::html_text(text) + "</td>"; }

std::string verdict_cell(const std::string& text, Verdict verdict) {
  return "<td class=\"" + std::string(name_of(verdict)) + "\">" + output::html_text(text) + "</td>";
}

std::string summary(const Report& report) {
  std::string text = "<table><tr><th>case<th><th>breaks at: float32<th>double<th>epura<th>epura is</tr>\n";
  for (const CaseReport& one : report) {
    text += "<tr><td><a href=\"#" + one.id + "\">" + one.id + "</a></td>" + cell(one.what);
    for (std::size_t a = 0; a < arithmetics; ++a) {
      const auto step = one.breaks_at(static_cast<Arithmetic>(a));
      text += cell(step ? format_rounded(*step, 3) : "-");
    }
    const Verdict verdict = one.verdict(Arithmetic::own);
    text += verdict_cell(std::string(name_of(verdict)), verdict) + "</tr>\n";
  }
  return text + "</table>\n";
}

std::string row_of(const Row& row, std::size_t a) {
  const Outcome& outcome = row.outcomes[a];
  std::string text = "<tr>" + cell(a == 0 ? format_rounded(row.step, 4) : "") + cell(arithmetic_names[a]);
  if (const Quantity* q = outcome.worst())
    text += cell(q->name) + cell(format_rounded(q->expected, 9)) + cell(format_rounded(q->got, 9)) +
            cell(format_rounded(q->error(), 3)) + cell(format_rounded(q->allowed, 3));
  else
    text += "<td colspan=\"5\">" + output::html_text(outcome.failure) + "</td>";
  return text + verdict_cell(std::string(name_of(outcome.verdict())), outcome.verdict()) + "</tr>\n";
}

std::string section_of(const CaseReport& one) {
  std::string text =
      "<section id=\"" + one.id + "\"><h2>" + one.id + " " + output::html_text(one.what) + "</h2>\n" +
      output::inline_svg(to_sheet(one), {.plain = true, .decimals = 2, .text = SvgText::text}) +
      "<details><summary>by " + output::html_text(one.parameter) +
      "</summary><table><tr><th>step<th><th>worst quantity<th>expected<th>got<th>error<th>allowed<th></tr>\n";
  for (const Row& row : one.rows)
    for (std::size_t a = 0; a < arithmetics; ++a) text += row_of(row, a);
  return text + "</table></details></section>\n";
}

}  // namespace

std::string to_html(const Report& report) {
  std::string text = std::string(head) + summary(report);
  for (const CaseReport& one : report) text += section_of(one);
  return text + "</body></html>\n";
}

}  // namespace epura::stability
