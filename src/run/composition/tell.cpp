// SPDX-License-Identifier: Apache-2.0
#include "composition/tell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "composition/layout.hpp"
#include "drawing/drawing.hpp"
#include "features/assembly_features.hpp"
#include "report/format.hpp"
#include "sheet/lettering.hpp"
#include "sheet/standard_scale.hpp"
#include "sizes/equal_features.hpp"
#include "view/condition.hpp"

namespace epura::pipeline {

namespace {

std::string digits_left(const view::Condition& condition) {
  return format_fixed(std::floor(condition.digits_left()), 0);
}

std::string in_digits(const view::Condition& condition) {
  const std::string number = digits_left(condition);
  return number + (number == "1" ? " digit" : " digits");
}

std::string numbers_of(const view::Condition& condition) {
  return "condition " + format_rounded(condition.number, 2) + ", " + in_digits(condition) + " left";
}

constexpr const char* more_digits =
    "export the model nearer to the origin, or with more digits (64-bit PLY, OBJ with all decimals)";

std::string sentence_of_scale(const SheetPlan& plan) {
  const std::string scale = "the scale is " + sheet::ratio_text(plan.scale);
  if (plan.inside && plan.fitting && !plan.crowded)
    return scale + "; " + sheet::ratio_text(*plan.fitting) + " fits with smaller pictorial views";
  return scale + ", the largest of ISO 5455 that fits";
}

std::string and_others(std::size_t count) {
  return " and " + std::to_string(count) + (count == 1 ? " other" : " others");
}

// The first ones of the many lengths of a row: "0, 12, 20 and 30 others".
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 40;
  std::size_t end = text.find(", ", longest), more = 0;
  if (end == std::string::npos) return text;
  for (std::size_t at = end; at != std::string::npos; at = text.find(", ", at + 1)) ++more;
  return text.substr(0, end) + and_others(more);
}

}  // namespace

void tell_of_requirements(const Messages& messages, const std::vector<report::RequirementRow>& rows, bool is_allowed) {
  constexpr std::size_t most = 20;
  std::size_t drawn = 0, missing = 0;
  std::string list;
  for (const report::RequirementRow& row : rows) {
    if (row.is_drawn()) ++drawn;
    if (row.is_missing() && ++missing <= most) list += "\n  " + one_line(row.id + " " + row.what + ": " + row.why);
  }
  if (missing > most) list += "\n  and " + std::to_string(missing - most) + " others, which the JSON has";
  const std::string all = std::to_string(drawn + missing) + " requirements of the models ";
  if (missing == 0 && drawn > 0) messages.print("all " + all + "are drawn\n");
  if (missing > 0)
    messages.warn(std::to_string(missing) + " of the " + all + (missing == 1 ? "is" : "are") + " not drawn:" + list +
                  (is_allowed ? "" : "\n  hint: --allow-missing-requirements accepts this"));
}

void tell_of_scales(const Messages& messages, const SheetPlan& plan, const scene::SheetDescription& sheet,
                    const SheetOfViews& views) {
  if (plan.chosen && plan.inside) messages.print(sentence_of_scale(plan) + "\n");
  if (sheet.size.value_or({}).kind == scene::PaperChoice::Kind::none) return;
  std::vector<double> chosen;
  const auto add = [&](const scene::Located<scene::ScaleChoice>& scale) {
    if (scale.given() && scale->fixed) chosen.push_back(*scale->fixed);
  };
  add(sheet.scale);
  for (const scene::ViewDescription& view : views.descriptions) add(view.scale);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::string unusual;
  for (const double scale : chosen) {
    const double nearest = sheet::nearest_standard_scale(scale);
    if (std::abs(nearest / scale - 1) <= 1e-9) continue;
    const std::string ratio = sheet::ratio_text(scale);
    unusual += (unusual.empty() ? "" : "; ") + (ratio.empty() ? format_rounded(scale, 6) : ratio) +
               " (the nearest is " + sheet::ratio_text(nearest) + ")";
  }
  if (!unusual.empty()) messages.warn("not a scale of ISO 5455: " + unusual);
}

std::string first_of(const std::vector<std::string>& texts) {
  constexpr std::size_t most = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, texts.size()); ++i)
    list += (i > 0 ? ", '" : "'") + shortened(texts[i]) + "'";
  const std::size_t more = texts.size() - std::min(most, texts.size());
  if (more > 0) list += and_others(more) + " (epura lint lists all)";
  return list;
}

void warn_of_unplaced(const Messages& messages, const std::vector<Annotations>& by_view) {
  std::string list;
  sheet::Omitted omitted;
  for (const Annotations& of_view : by_view) {
    for (const std::string& one : features::unplaced_parts(of_view.unplaced)) append_to_list(list, one);
    omitted.append(of_view.omitted);
  }
  for (const auto& [view, count] : omitted.too_many)
    append_to_list(list, std::to_string(count) + (count == 1 ? " size" : " sizes") + " in the view '" + view + "'");
  if (!list.empty())
    messages.warn("left out, since a view has no room for so many: " + list +
                  "\n  hint: draw groups of parts, or add a [[dimension]] for each place that matters");
  std::string askew;
  for (const auto& [name, count] : omitted.askew) append_to_list(askew, sheet::times(count) + name);
  if (!askew.empty())
    messages.warn("no positions are given where axes are askew to faces and views: " + askew +
                  "\n  hint: add a view along the axis, auxiliary:direction=X,Y,Z, or turn the part by "
                  "--transform (epura lint tells how)");
}

namespace {

// Where a size with the text of a pattern is that asks for something else.
std::string remedy_of(const scene::DimensionDescription& wish, const MatchedSizes& sizes) {
  const auto other = std::find_if(sizes.others.begin(), sizes.others.end(),
                                  [&](const sheet::OtherMatch& one) { return one.where == wish.where; });
  if (sizes.texts.empty()) return "there are none without a [[dimension]] of type auto or overall, or --dimensions";
  if (other == sizes.others.end()) return did_you_mean(*wish.match, sizes.texts);
  if (wish.view.given() && *wish.view != other->view)
    return "it is in view '" + other->view + "', not in '" + *wish.view + "'";
  return "that in view '" + other->view + "' has another type or direction";
}

}  // namespace

bool warn_of_unmatched(const Messages& messages, const scene::SceneDescription& scene, MatchedSizes sizes) {
  std::sort(sizes.texts.begin(), sizes.texts.end());
  sizes.texts.erase(std::unique(sizes.texts.begin(), sizes.texts.end()), sizes.texts.end());
  bool is_unmatched = false;
  for (const scene::DimensionDescription& wish : scene.dimensions) {
    if (!wish.match.given() || std::find(sizes.where.begin(), sizes.where.end(), wish.where) != sizes.where.end())
      continue;
    is_unmatched = true;
    messages.warn(wish.match.where + ": no automatic size is '" + *wish.match + "'\n  hint: " + remedy_of(wish, sizes));
  }
  return is_unmatched;
}

void warn_if_empty(const Messages& messages, const ViewResult& result, const ViewInput& input) {
  if (!result.drawing.segments.empty() || !result.partial.stages.empty()) return;
  if (const auto& detail = input.options.detail)
    return messages.warn("detail '" + *detail->name + "' shows no line\n  hint: move its centre, or make it larger");
  const edges::EdgeOptions& edges = input.options.edges;
  const bool leaves_out_wires = !edges.wire && !input.world.wires.empty();
  if (!edges.contour || !edges.boundary || !edges.crease || leaves_out_wires)
    return messages.warn("nothing is drawn: no edge of the selected kinds is visible");
  if (result.work.view.window_given) return messages.warn("nothing is drawn: no edge is visible in the window");
  if (input.world.triangles.empty()) return messages.warn("nothing is drawn: every line is seen end-on");
  // Every face has an outline.
  throw Error(ErrorKind::input, "view '" + input.options.name + "'",
              "nothing is drawn: no face is larger than the rounding error of its coordinates (" +
                  format_rounded(input.world.rounding, 2) + ")",
              more_digits);
}

// "'a' 'b' 'c' ..."
std::string listed(const std::vector<std::string>& characters) {
  constexpr std::size_t most = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, characters.size()); ++i)
    text += (i > 0 ? " '" : "'") + characters[i] + "'";
  return characters.size() > most ? text + " ..." : text;
}

void warn_about(const Messages& messages, const ViewResult& result) {
  if (result.verification)
    messages.print(result.drawing.name + ": " + report::format_verification(*result.verification));
  constexpr double negligible = 1;  // mm
  if (result.unsymmetric > negligible)
    messages.warn("view '" + result.drawing.name + "' is not symmetric: what it leaves out differs in " +
                  std::to_string(std::llround(result.unsymmetric)) +
                  " mm of lines\n  hint: draw the whole view, or a part of it with 'break'");
}

// If nothing fits, the scale is any number. Given positions may leave too little room at any scale.
void warn_about(const Messages& messages, const SheetPlan& plan) {
  std::string scale = sheet::ratio_text(plan.scale);
  if (scale.empty()) scale = format_rounded(plan.scale, 3);
  const std::string fitting = plan.fitting ? sheet::ratio_text(*plan.fitting) : "";
  if (plan.crowded)
    messages.warn("the views fill the sheet at " + scale +
                  (fitting.empty() ? "\n  hint: use a larger sheet" : "; " + fitting + " leaves room around them"));
  else if (plan.fitting && *plan.fitting >= plan.scale)
    messages.warn("views may be on one another, on the title block or beyond the frame at " + scale +
                  "\n  hint: change their positions, 'at', or leave these out");
  else
    messages.warn("the drawing is larger than the sheet at " + scale +
                  (plan.fitting ? "; it fits at " + fitting : "\n  hint: use a larger sheet, or fewer views"));
}

void warn_about(const Messages& messages, const report::Partial& partial) {
  std::string cut, sentence = "the drawing is partial: ";
  for (const std::string& stage : partial.stages)
    if (!partial.too_many_crossings || stage != "finding intersections") append_to_list(cut, "'" + stage + "'");
  if (partial.too_many_crossings) sentence += "faces cross in too many places to find all lines where they do";
  if (!cut.empty()) sentence += (partial.too_many_crossings ? "; " : "") + ("the time limit cut short " + cut);
  sentence += "; missing: " + std::to_string(partial.undecided) + " of " + std::to_string(partial.edges) + " edges";
  if (partial.searched < 1)
    sentence += ", " + format_fixed(100 * (1 - partial.searched), 1) + " % of the search for intersection lines";
  if (partial.undrawn > 0) sentence += ", " + std::to_string(partial.undrawn) + " lines and dimensions";
  messages.warn(sentence + "\n  hint: " +
                (partial.too_many_crossings ? "leave out bodies that lie in one another, or intersection in --edges"
                                            : "raise --time-limit, or select fewer edges with --edges"));
}

Error nothing_drawn(const std::string& stage) {
  return {ErrorKind::time, "--time-limit",
          "time ran out at '" + stage + "', before there was anything to show; nothing was written",
          "raise --time-limit"};
}

void warn_about(const Messages& messages, const report::ViewCondition& view) {
  const view::Condition& condition = view.condition;
  if (condition.moved_by_files > std::pow(10, -view::fewest_digits_of_files))
    return messages.warn("view '" + view.name + "': the coordinates in the files are too coarsely rounded (" +
                         in_digits(condition) + " left): lines may be off by " +
                         format_rounded(condition.moved_by_files, 2) + " of the drawing\n  hint: " + more_digits);
  if (condition.digits_lost() < view::too_many_lost_digits) return;
  messages.warn("view '" + view.name + "': its projection loses many digits (" + numbers_of(condition) + "), because " +
                condition.why + "\n  hint: rounding of the input moves lines by 1e-" + digits_left(condition) +
                " of the drawing; move the model or the viewer");
}

std::string format_condition(const report::ViewCondition& view) {
  return "view '" + view.name + "': " + numbers_of(view.condition) + "\n";
}

void tell_of_curves(const Messages& messages, const std::vector<ViewResult>& results) {
  drawing::CurveReport all;
  for (const ViewResult& result : results) all += result.curves;
  messages.print("arcs: " + std::to_string(all.circles) + " of circles, " + std::to_string(all.ellipses) +
                 " of ellipses; corners lie within " + format_rounded(all.deviation, 2) +
                 " mm of them; deviation from the replaced lines up to " + format_rounded(all.bulge, 2) + " mm\n");
}

void warn_about(const Messages& messages, const sheet::Sheet& sheet) {
  const sheet::FontNotes notes = sheet::font_notes(sheet);
  std::string fonts;
  for (const auto& [font, characters] : notes.borrowed)
    fonts += (fonts.empty() ? "" : "; ") + listed(characters) + " from " + font;
  if (!fonts.empty()) messages.warn("characters that the lettering font lacks are drawn in other fonts: " + fonts);
  if (!notes.missing.empty())
    messages.warn("no installed font has " + listed(notes.missing) + " (in the " + notes.role +
                  "): boxes are drawn\n  hint: install a font that has them, such as a Debian package fonts-noto-*");
}

void tell_timings(const Messages& messages, const Stopwatch& watch) {
  std::string text;
  for (const auto& [stage, seconds] : watch.laps()) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%-12s %8s s\n", stage.c_str(), format_fixed(seconds, 4).c_str());
    text += line.data();
  }
  messages.print(text);
}

}  // namespace epura::pipeline
