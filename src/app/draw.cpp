// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/choose.hpp"
#include "app/compose.hpp"
#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "app/explain.hpp"
#include "app/messages.hpp"
#include "app/pipeline.hpp"
#include "app/plan_steps.hpp"
#include "app/questions.hpp"
#include "app/read_models.hpp"
#include "app/sections.hpp"
#include "app/targets.hpp"
#include "app/tell.hpp"
#include "app/thin.hpp"
#include "app/view_plan.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "sheet/standard_scale.hpp"
#include "study/verify/verify.hpp"
#include "view/condition.hpp"

namespace epura {

namespace {

using WorldOfView = std::function<const World&(std::size_t)>;

/// What a run needs from beginning to end.
struct Run {
  const DrawOptions& options;
  const SceneDescription& scene;
  const Questions& questions;
  const Messages& messages;
  Progress progress;
  Stopwatch& watch;
  LeaveOut leave_out;
  bool keeps_drawings;     ///< beside the sheets
  std::size_t views_left;  ///< to be drawn
  Report report{};
  bool has_lines = false;
  std::string answers{};

  void note(const ViewResult& result);
  ViewTime time_of_next_view();
  std::vector<View> map_views(const WorldOfView& world, const SheetOfViews& views);
  FinishedSheet draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views);
  std::vector<FinishedSheet> draw_sheets(const std::vector<SheetOfViews>& sheets);
};

// Of several views the report has all that time left out, and the test that found most wrong.
void Run::note(const ViewResult& result) {
  warn_about(messages, result);
  has_lines = has_lines || !result.drawing.segments.empty();
  if (!result.verification) return;
  const auto wrong = [](const Verification& found) { return found.wrong + found.outline.wrong(); };
  if (!report.verification || wrong(*report.verification) < wrong(*result.verification))
    report.verification = result.verification;
}

// The sheet and the files take what views leave.
ViewTime Run::time_of_next_view() {
  constexpr double views_for_the_rest = 0.25;
  return {progress, progress.with_part_of_the_time(1 / (static_cast<double>(views_left--) + views_for_the_rest))};
}

std::vector<View> Run::map_views(const WorldOfView& world, const SheetOfViews& views) {
  progress.begin("mapping", views.plans.size());
  std::vector<View> seen;
  for (std::size_t i = 0; i < views.plans.size(); ++i) {
    progress.expect_time();
    seen.push_back(look_at(world(i), views.plans[i], views.descriptions[i]));
    const Condition map = condition_of(seen.back().projection, world(i).box, world(i).one_rounding);
    const ViewCondition condition{views.plans[i].wish.name, map};
    warn_about(messages, condition);
    if (options.explain) report.conditions.push_back(condition);
    progress.advance(1);
  }
  watch.lap("view");
  return seen;
}

FinishedSheet Run::draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views) {
  const auto section = [&](std::size_t view) { return section_of(sections, views.descriptions[view]); };
  const auto world = [&](std::size_t view) -> const World& {
    return section(view) == nullptr ? whole : section(view)->cut.world;
  };
  std::vector<View> seen = map_views(world, views);
  const std::vector<Annotations> annotations = annotate(scene, views.sheet, views.descriptions, seen, sections);
  const SheetPlan plan = plan_sheet(whole, scene, views.sheet, views.descriptions, seen, annotations);
  if (plan.chosen) messages.warn("the scale is " + ratio_text(plan.scale) + ", the largest of ISO 5455 that fits");
  std::vector<ViewResult> results;
  Partial partial;
  const Budget budget{progress, progress, partial};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const ViewWish& wish = views.plans[i].wish;
    results.push_back(draw_view(world(i), section(i), std::move(seen[i]), wish, plan.places[i], report.plan, watch,
                                time_of_next_view()));
    warn_if_empty(messages, results.back(), wish, world(i));
    note(results.back());
    partial.add(results.back().partial);
    answers += budget.or_nothing(
        [&](const Progress& until) { return answer(questions, world(i), wish, results.back(), until); });
    results.back().work = {};  // what follows takes its room
  }
  if (!options.arcs.empty()) tell_of_curves(messages, results);
  if (!plan.inside) messages.warn("the drawing is larger than the sheet at this scale");
  FinishedSheet sheet = compose(whole, scene, views, plan, results, annotations, budget);
  if (!partial.stages.empty()) mark_partial(sheet, partial.stages.front());
  report.partial.add(partial);
  if (!keeps_drawings) sheet.drawings = {};
  for (const std::string& warning : sheet.warnings) messages.warn(warning);
  warn_about(messages, sheet.sheet);
  report.plan.push_back(text_step(sheet.sheet, leave_out.text));
  watch.lap("sheet");
  return sheet;
}

std::vector<FinishedSheet> Run::draw_sheets(const std::vector<SheetOfViews>& sheets) {
  World world = read_models(scene.models, report.meshes, messages, progress);
  watch.lap("read");
  const CutSections sections = cut_sections(world, scene, messages, progress);
  if (!sections.empty()) watch.lap("section");
  std::vector<FinishedSheet> finished;
  for (const SheetOfViews& sheet : sheets) finished.push_back(draw_sheet(world, sections, sheet));
  return finished;
}

// JSON alone has drawings in it, all other formats have sheets.
bool want_drawings(const std::vector<Target>& targets) {
  return std::any_of(targets.begin(), targets.end(),
                     [](const Target& target) { return target.format == Format::json; });
}

// The whole run once more, from reading on, by other certificates.
std::string draw_again(const DrawOptions& options, const SceneDescription& scene, std::vector<SheetOfViews> sheets,
                       std::vector<Target> targets, const VectorOptions& vector_options, const LeaveOut& leave_out) {
  for (SheetOfViews& sheet : sheets)
    for (PlannedView& view : sheet.plans) {
      view.wish.leave_out = leave_out;
      view.wish.verify.reset();
    }
  if (targets.empty()) targets.push_back({"explain.svg", Format::svg});
  const Questions none;
  Stopwatch watch;
  const Messages silent{[](const std::string&) {}, [](std::string_view) {}};
  Run run{options, scene, none, silent, {}, watch, leave_out, want_drawings(targets), scene.views.size()};
  const std::vector<FinishedSheet> finished = run.draw_sheets(sheets);
  std::string bytes;
  for (const FileBytes& file : encode_all(targets, finished, vector_options, {}, {})) bytes += file.bytes;
  return bytes;
}

// The formats of a run are told to people alone: what is in a file does not depend on the files beside it.
std::string explanation(const Report& report, const PlanStep& formats) {
  std::vector<PlanStep> plan = report.plan;
  plan.push_back(formats);
  std::string text = plan_table(plan);
  for (const ViewCondition& view : report.conditions) text += in_words(view);
  return text;
}

// Where there is no time to write all lines, the longest ones.
std::vector<FileBytes> encode_in_time(const std::vector<Target>& targets, std::vector<FinishedSheet>& sheets,
                                      const VectorOptions& vector_options, Report& report, const Progress& progress) {
  const auto make = [&](const Progress& until) { return encode_all(targets, sheets, vector_options, report, until); };
  const auto leave_out = [&](const std::string& stage) {
    report.partial.add_stage(stage);
    for (FinishedSheet& sheet : sheets) mark_partial(sheet, report.partial.stages.front());
    return keep_longest_lines(sheets, report.partial);
  };
  return make_in_time(progress, Budget{progress, progress, report.partial}.last(), make, leave_out);
}

std::vector<std::string> paths_of(const std::vector<FileBytes>& files) {
  std::vector<std::string> paths;
  for (const FileBytes& file : files) paths.push_back(file.path);
  return paths;
}

void forget_times(std::vector<PlanStep>& plan) {
  for (PlanStep& step : plan) step.times = {};
}

}  // namespace

namespace {

DrawnFiles draw_within(const DrawOptions& options, const Messages& messages, Progress progress) {
  Stopwatch watch;
  progress.begin("preparing");
  const ThreadLimit threads(options.threads);
  const std::vector<Target> targets = targets_of(options);
  const VectorOptions vector_options{
      options.plain, options.dpi, options.decimals,
      choose<SvgText>("--svg-text", options.svg_text, {{"outlines", SvgText::outlines}, {"text", SvgText::text}})};
  const Questions questions = parse_questions(options);
  if (options.measure && options.time_limit)
    throw Error(Trouble::input, "--measure", "draws several times, and knows no --time-limit", "leave out one of them");
  const SceneDescription scene = describe(options);
  const std::vector<SheetOfViews> sheets = views_by_sheet(scene, plan_views(scene, options));
  refuse_overwriting(files_of(targets, sheets.size()), inputs_of(options, scene));
  watch.lap("prepare");

  const LeaveOut leave_out = parse_leave_out(options.plan);
  Run run{options, scene, questions, messages, progress, watch, leave_out, want_drawings(targets), scene.views.size()};
  run.report.plan.push_back(plugins_step(sheets));
  std::vector<FinishedSheet> finished = run.draw_sheets(sheets);
  // An empty sheet is no drawing.
  if (!run.report.partial.stages.empty() && !run.has_lines) throw OutOfTime{run.report.partial.stages.front()};
  estimate_savings(run.report.plan);
  if (options.measure) {
    const auto again = [&](const LeaveOut& other) {
      return draw_again(options, scene, sheets, targets, vector_options, other);
    };
    measure_savings(run.report.plan, leave_out, again);
  }
  if (options.explain) run.answers += explanation(run.report, formats_step(targets));

  if (options.timings) run.report.seconds = watch.laps();
  if (!options.timings && !options.measure) forget_times(run.report.plan);
  const std::vector<FileBytes> files = encode_in_time(targets, finished, vector_options, run.report, progress);
  progress.lift_limit();
  for (const FileBytes& file : files) write(file, progress);
  watch.lap("write");
  return {paths_of(files), std::move(run.report), std::move(run.answers), watch, std::move(finished)};
}

}  // namespace

DrawnFiles draw_files(const DrawOptions& options, const Messages& messages, Progress progress) {
  try {
    return draw_within(options, messages, progress);
  } catch (const OutOfTime& cut) {
    throw nothing_drawn(cut.stage);
  }
}

void tell_the_end(const Messages& messages, const DrawOptions& options, const DrawnFiles& drawn) {
  if (options.timings) tell_timings(messages, drawn.watch);
  if (!drawn.report.partial.stages.empty()) warn_about(messages, drawn.report.partial);
}

}  // namespace epura
