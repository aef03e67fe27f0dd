// SPDX-License-Identifier: Apache-2.0
#include "report/format.hpp"

#include <algorithm>
#include <vector>

#include "base/text.hpp"

namespace epura::report {

namespace {

std::string millimetres(double length) { return format_fixed(length, 3) + " mm"; }

std::string percent(double share) { return format_fixed(100 * share, 4) + " %"; }

std::string name_of(const FacetName& facet) {
  return "facet " + std::to_string(facet.face) + " of model " + std::to_string(facet.model);
}

std::string position_of(const Mismatch& mismatch) {
  std::string text = "model " + std::to_string(mismatch.model) + " edge " + std::to_string(mismatch.edge[0]) + "-" +
                     std::to_string(mismatch.edge[1]);
  if (mismatch.facets.size() == 2)
    text = "where " + name_of(mismatch.facets[0]) + " crosses " + name_of(mismatch.facets[1]);
  return text + " at t = " + format_number(mismatch.t) + ", page " + format_fixed(mismatch.page.x, 3) + "," +
         format_fixed(mismatch.page.y, 3);
}

std::string reason_of(const Mismatch& mismatch) {
  if (mismatch.what == "not drawn") return "the drawing has no line there";
  return mismatch.hider ? name_of(*mismatch.hider) + " hides it" : "nothing hides it";
}

std::string what_of(const OutlineFault& fault) {
  std::string text = fault.what == "missing"   ? "a line is missing"
                     : fault.what == "doubled" ? "a line is drawn twice"
                                               : "a line without reason";
  text += " at page " + format_fixed(fault.page.x, 3) + "," + format_fixed(fault.page.y, 3) + ", " +
          millimetres(fault.length) + " long";
  if (fault.edge[0] >= 0)
    return text + ": model " + std::to_string(fault.model) + " edge " + std::to_string(fault.edge[0]) + "-" +
           std::to_string(fault.edge[1]);
  for (std::size_t i = 0; i < fault.facets.size(); ++i) text += (i == 0 ? ": " : " and ") + name_of(fault.facets[i]);
  return text;
}

std::string format_outline(const OutlineCheck& outline) {
  const auto at = [&](int places) {
    return std::to_string(places) + " (" + millimetres(places * outline.length) + ")";
  };
  std::string text = "outline: " + std::to_string(outline.lines) + " lines across the page meet " + at(outline.asked) +
                     " places that need ink, " + at(outline.missing) + " without it; " + at(outline.ink) +
                     " places with ink, " + at(outline.unfounded) + " unfounded, " + at(outline.doubled) +
                     " doubled; " + std::to_string(outline.undecided) + " undecided; with 95 % confidence at most " +
                     percent(outline.at_most) + " wrong\n";
  for (const OutlineFault& fault : outline.worst) text += "wrong: " + what_of(fault) + "\n";
  return text;
}

std::string format_ink(const InkCheck& ink) {
  if (!(ink.length > 0)) return {};
  std::string text = "ink: " + millimetres(ink.judged) + " of " + millimetres(ink.length) + " (" +
                     percent(ink.judged / ink.length) + ") judged where it is drawn, " + millimetres(ink.by_surfaces) +
                     " of it by surfaces, to within " + millimetres(ink.error) + ": " + millimetres(ink.unfounded) +
                     " without reason, " + millimetres(ink.missing) + " missing";
  for (const Unjudged& one : ink.unjudged) text += "; not judged: " + millimetres(one.length) + " of " + one.reason;
  text += "\n";
  for (const OutlineFault& fault : ink.worst) text += "wrong: " + what_of(fault) + "\n";
  return text;
}

}  // namespace

std::string format_verification(const Verification& v) {
  std::string text = "verified " + std::to_string(v.points) + " points: " + std::to_string(v.decided) + " decided, " +
                     std::to_string(v.wrong) + " wrong, " + std::to_string(v.points - v.decided) + " undecided (" +
                     std::to_string(v.either_way) + " of them on visible lines, which hide what lies behind them)\n";
  text += "misclassified by " + std::to_string(v.samples) +
          " of them at random: " + millimetres(v.misclassified * v.length) + " of " + millimetres(v.length) + " (" +
          percent(v.misclassified) + "), with 95 % confidence at most " + millimetres(v.at_most * v.length) + " (" +
          percent(v.at_most) + "); undecided " + percent(v.undecided) + ", too short to test " + percent(v.untested) +
          "\n";
  for (const Mismatch& mismatch : v.worst)
    text += "wrong: " + position_of(mismatch) + " is " + mismatch.what + ", but " + reason_of(mismatch) + "\n";
  text += format_outline(v.outline) + format_ink(v.ink);
  if (!v.is_conclusive())
    text += "inconclusive: only " + std::to_string(v.decided) + " of " + std::to_string(v.points) +
            " points are decided, so this proves nothing about what is hidden; turn the view a little, or leave out "
            "models that lie behind one another\n";
  return text;
}

std::string rounded_up(double millimetres) {
  constexpr double digits = 1.005;  // half of the last digit at most is rounded off
  return format_rounded(millimetres * digits, 3);
}

std::string format_errors(std::span<const ViewError> errors) {
  std::vector<std::vector<std::string>> rows{{"error on paper, mm"}, {"total"}};
  for (const ViewError& view : errors) {
    rows[0].push_back(view.view);
    rows[1].push_back(rounded_up(view.total()));
  }
  for (std::size_t i = 0; i < error_terms.size(); ++i) {
    std::vector<std::string> row{error_terms[i].name};
    for (const ViewError& view : errors) row.push_back(rounded_up(view.mm[i]));
    const auto is_zero = [i](const ViewError& view) { return view.mm[i] == 0; };
    if (std::all_of(errors.begin(), errors.end(), is_zero)) continue;
    const auto is_estimated = [i](const ViewError& view) {
      return view.evidence(static_cast<ErrorTerm>(i)) == Evidence::estimated;
    };
    const bool estimated = std::any_of(errors.begin(), errors.end(), is_estimated);
    row.push_back(evidence_names[static_cast<std::size_t>(estimated ? Evidence::estimated : error_terms[i].evidence)]);
    row.emplace_back(error_terms[i].cause);
    rows.push_back(std::move(row));
  }
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += row[i] + (i + 1 < row.size() ? std::string(widths[i] - row[i].size() + 2, ' ') : "\n");
  }
  return text;
}

}  // namespace epura::report
