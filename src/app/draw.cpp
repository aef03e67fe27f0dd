#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/choose.hpp"
#include "app/compose.hpp"
#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "app/messages.hpp"
#include "app/pipeline.hpp"
#include "app/questions.hpp"
#include "app/read_models.hpp"
#include "app/sections.hpp"
#include "app/targets.hpp"
#include "app/view_plan.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "sheet/lettering.hpp"
#include "sheet/standard_scale.hpp"
#include "study/verify/verify.hpp"
#include "view/condition.hpp"

namespace epura {

namespace {

void warn_about(const Messages& messages, const ViewResult& result) {
  if (result.drawing.segments.empty() && !result.partial)
    messages.warn("nothing is drawn: no edge of the wanted kinds is visible");
}

void warn_about(const Messages& messages, const Partial& partial) {
  std::string sentence = "the drawing is partial: the time limit left out " + std::to_string(partial.undecided) +
                         " of " + std::to_string(partial.edges) + " edges";
  if (partial.searched < 1)
    sentence += " and " + format_fixed(100 * (1 - partial.searched), 1) + " % of the search for intersection lines";
  messages.warn(sentence + "\n  hint: give a longer --time-limit, or ask for less with --edges");
}

// What the map of a view can keep is told where it is asked for, and where it is little.
void tell_of(const Messages& messages, const ViewCondition& view, bool asked) {
  const Condition& condition = view.condition;
  const std::string numbers = "condition " + format_rounded(condition.number, 2) + ", " +
                              format_fixed(std::floor(condition.digits_left()), 0) + " digits left";
  if (condition.digits_lost() >= too_many_lost_digits)
    messages.warn("view '" + view.name + "': its map keeps few digits (" + numbers + "), because " + condition.why +
                 "\n  hint: rounding of the input moves lines by 1e-" +
                 format_fixed(std::floor(condition.digits_left()), 0) +
                 " of the drawing; move the model or the viewer");
  else if (asked)
    messages.print("view '" + view.name + "': map: " + numbers + "\n");
}

void tell_of(const Messages& messages, const std::vector<ViewResult>& results) {
  CurveReport all;
  for (const ViewResult& result : results) all += result.curves;
  messages.print("arcs: " + std::to_string(all.circles) + " of circles, " + std::to_string(all.ellipses) +
                 " of ellipses; corners lie within " + format_rounded(all.deviation, 2) +
                 " mm of them, they rise over the lines that they replace by up to " + format_rounded(all.bulge, 2) +
                 " mm\n");
}

void warn_about(const Messages& messages, const Sheet& sheet) {
  for (const MissingCharacter& missing : missing_characters(sheet))
    messages.warn("the font has no glyph for '" + missing.character + "' (in the " + missing.role + ")");
}

void print_timings(const Messages& messages, const Stopwatch& watch) {
  std::string text;
  for (const auto& [stage, seconds] : watch.laps()) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%-12s %8s s\n", stage.c_str(), format_fixed(seconds, 4).c_str());
    text += line.data();
  }
  messages.print(text);
}

/// What a run needs from beginning to end.
struct Run {
  const DrawOptions& options;
  const SceneDescription& scene;
  const Questions& questions;
  const Messages& messages;
  Progress progress;
  Stopwatch& watch;
  Report report{};
  std::string answers{};

  FinishedSheet draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views);
  void tell_condition(const ViewCondition& view);
};

void Run::tell_condition(const ViewCondition& view) {
  tell_of(messages, view, options.explain);
  if (options.explain) report.conditions.push_back(view);
}

FinishedSheet Run::draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views) {
  progress.begin("mapping");
  const auto section = [&](std::size_t view) { return section_of(sections, views.descriptions[view]); };
  const auto world = [&](std::size_t view) -> const World& {
    return section(view) == nullptr ? whole : section(view)->cut.world;
  };
  std::vector<View> seen;
  for (std::size_t i = 0; i < views.plans.size(); ++i) {
    seen.push_back(look_at(world(i), views.plans[i], views.descriptions[i]));
    tell_condition({views.plans[i].wish.name, condition_of(seen.back().projection, world(i).box)});
  }
  watch.lap("view");

  const std::vector<Annotations> annotations = annotate(scene, views.sheet, views.descriptions, seen, sections);
  const SheetPlan plan = plan_sheet(whole, scene, views.sheet, views.descriptions, seen, annotations);
  if (plan.chosen) messages.warn("the scale is " + ratio_text(plan.scale) + ", the largest of ISO 5455 that fits");
  std::vector<ViewResult> results;
  std::vector<ViewWish> wishes;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    wishes.push_back(views.plans[i].wish);
    results.push_back(
        draw_view(world(i), section(i), std::move(seen[i]), wishes[i], plan.places[i], report.plan, watch, progress));
    warn_about(messages, results.back());
    answers += answer(questions, world(i), wishes[i], results.back());
    results.back().work = {};  // what follows takes its room
  }
  if (!options.arcs.empty()) tell_of(messages, results);
  if (!plan.inside) messages.warn("the drawing is larger than the sheet at this scale");
  for (const ViewResult& result : results) {
    if (result.partial) report.partial = result.partial;
    if (result.verification) report.verification = result.verification;
  }
  FinishedSheet sheet = compose(whole, scene, views, plan, results, annotations);
  for (const std::string& warning : sheet.warnings) messages.warn(warning);
  warn_about(messages, sheet.sheet);
  watch.lap("sheet");
  return sheet;
}

}  // namespace

DrawnFiles draw_files(const DrawOptions& options, const Messages& messages, Progress progress) {
  Stopwatch watch;
  const ThreadLimit threads(options.threads);
  const std::vector<Target> targets = targets_of(options);
  const VectorOptions vector_options{
      options.plain, options.dpi, options.decimals,
      choose<SvgText>("--svg-text", options.svg_text, {{"outlines", SvgText::outlines}, {"text", SvgText::text}})};
  const Questions questions = parse_questions(options);
  const SceneDescription scene = describe(options);
  const std::vector<SheetOfViews> sheets = views_by_sheet(scene, plan_views(scene, options));
  watch.lap("prepare");

  Run run{options, scene, questions, messages, progress, watch};
  World world = read_models(scene.models, run.report.meshes, messages, progress);
  watch.lap("read");
  CutSections sections = cut_sections(world, scene, messages);
  if (!sections.empty()) watch.lap("section");
  std::vector<FinishedSheet> finished;
  for (const SheetOfViews& sheet : sheets) finished.push_back(run.draw_sheet(world, sections, sheet));
  world = {};  // what follows takes its room
  sections.clear();

  if (options.timings) run.report.seconds = watch.laps();
  const std::vector<FileBytes> files = encode_all(targets, finished, vector_options, run.report, progress);
  std::vector<std::string> paths;
  for (const FileBytes& file : files) {
    write(file, progress);
    paths.push_back(file.path);
  }
  watch.lap("write");
  return {std::move(paths), std::move(run.report), std::move(run.answers), watch};
}

void tell_the_end(const Messages& messages, const DrawOptions& options, const DrawnFiles& drawn) {
  if (options.timings) print_timings(messages, drawn.watch);
  if (drawn.report.verification) messages.print(in_words(*drawn.report.verification));
  if (drawn.report.partial) warn_about(messages, *drawn.report.partial);
}

}  // namespace epura
