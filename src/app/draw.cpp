#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/choose.hpp"
#include "app/commands.hpp"
#include "app/compose.hpp"
#include "app/console.hpp"
#include "app/describe.hpp"
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

namespace epura {

namespace {

void warn_about(Console& console, const ViewResult& result) {
  if (result.drawing.segments.empty() && !result.partial)
    console.warn("nothing is drawn: no edge of the wanted kinds is visible");
  if (const MethodChoice& choice = result.choice; !choice.reason.empty())
    console.print(result.drawing.name + ": hidden lines by " + text_of(choice.method) + ", since " + choice.reason +
                  "; no span longer than " + format_rounded(choice.bound, 3) + " mm is wrong\n");
}

void warn_about(Console& console, const Partial& partial) {
  std::string sentence = "the drawing is partial: the time limit left out " + std::to_string(partial.undecided) +
                         " of " + std::to_string(partial.edges) + " edges";
  if (partial.searched < 1)
    sentence += " and " + format_fixed(100 * (1 - partial.searched), 1) + " % of the search for intersection lines";
  console.warn(sentence + "\n  hint: give a longer --time-limit, or ask for less with --edges");
}

void tell_of(Console& console, const std::vector<ViewResult>& results) {
  CurveReport all;
  for (const ViewResult& result : results) all += result.curves;
  console.print("arcs: " + std::to_string(all.circles) + " of circles, " + std::to_string(all.ellipses) +
                " of ellipses; corners lie within " + format_rounded(all.deviation, 2) +
                " mm of them, they rise over the lines that they replace by up to " + format_rounded(all.bulge, 2) +
                " mm\n");
}

void warn_about(Console& console, const Sheet& sheet) {
  for (const MissingCharacter& missing : missing_characters(sheet))
    console.warn("the font has no glyph for '" + missing.character + "' (in the " + missing.role + ")");
}

void print_timings(Console& console, const Stopwatch& watch) {
  std::string text;
  for (const auto& [stage, seconds] : watch.laps()) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%-12s %8s s\n", stage.c_str(), format_fixed(seconds, 4).c_str());
    text += line.data();
  }
  console.print(text);
}

bool shows_progress(const DrawOptions& options) {
  return choose<bool>("--progress", options.progress, {{"auto", is_terminal()}, {"always", true}, {"never", false}});
}

/// What a run needs from beginning to end.
struct Run {
  const DrawOptions& options;
  const SceneDescription& scene;
  const Questions& questions;
  Console& console;
  Progress progress;
  Stopwatch& watch;
  Report report{};
  std::string answers{};

  FinishedSheet draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views);
};

FinishedSheet Run::draw_sheet(const World& whole, const CutSections& sections, const SheetOfViews& views) {
  progress.begin("mapping");
  const auto section = [&](std::size_t view) { return section_of(sections, views.descriptions[view]); };
  const auto world = [&](std::size_t view) -> const World& {
    return section(view) == nullptr ? whole : section(view)->cut.world;
  };
  std::vector<View> seen;
  for (std::size_t i = 0; i < views.plans.size(); ++i)
    seen.push_back(look_at(world(i), views.plans[i], views.descriptions[i]));
  watch.lap("view");

  const std::vector<Annotations> annotations = annotate(scene, views.sheet, views.descriptions, seen, sections);
  const SheetPlan plan = plan_sheet(whole, scene, views.sheet, views.descriptions, seen, annotations);
  if (plan.chosen) console.warn("the scale is " + ratio_text(plan.scale) + ", the largest of ISO 5455 that fits");
  std::vector<ViewResult> results;
  std::vector<ViewWish> wishes;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    wishes.push_back(views.plans[i].wish);
    results.push_back(
        draw_view(world(i), section(i), std::move(seen[i]), wishes[i], plan.places[i], report.plan, watch, progress));
    warn_about(console, results.back());
    answers += answer(questions, world(i), wishes[i], results.back());
    results.back().work = {};  // what follows takes its room
  }
  if (!options.arcs.empty()) tell_of(console, results);
  if (!plan.inside) console.warn("the drawing is larger than the sheet at this scale");
  for (const ViewResult& result : results) {
    if (result.partial) report.partial = result.partial;
    if (result.verification) report.verification = result.verification;
  }
  FinishedSheet sheet = compose(whole, scene, views, plan, results, annotations);
  for (const std::string& warning : sheet.warnings) console.warn(warning);
  warn_about(console, sheet.sheet);
  watch.lap("sheet");
  return sheet;
}

// Says what was found on the way, and returns the exit code. On standard error, since a drawing may go to standard
// output.
int conclude(Console& console, const Report& report) {
  if (report.verification) console.print(in_words(*report.verification));
  if (report.partial) warn_about(console, *report.partial);
  if (report.verification && report.verification->wrong > 0) return 1;
  return report.partial ? partial_exit_code : 0;
}

}  // namespace

int draw(const DrawOptions& options) {
  Stopwatch watch;
  ProgressBoard board;
  Console console(board, shows_progress(options));
  const Progress progress(board, options.time_limit);
  const ThreadLimit threads(options.threads);
  const std::vector<Target> targets = targets_of(options);
  const VectorOptions vector_options{
      options.plain, options.dpi, options.decimals,
      choose<SvgText>("--svg-text", options.svg_text, {{"outlines", SvgText::outlines}, {"text", SvgText::text}})};
  const Questions questions = parse_questions(options);
  const SceneDescription scene = describe(options);
  const std::vector<SheetOfViews> sheets = views_by_sheet(scene, plan_views(scene, options));
  watch.lap("prepare");

  Run run{options, scene, questions, console, progress, watch};
  World world = read_models(scene.models, run.report.meshes, console, progress);
  watch.lap("read");
  CutSections sections = cut_sections(world, scene, console);
  if (!sections.empty()) watch.lap("section");
  std::vector<FinishedSheet> finished;
  for (const SheetOfViews& sheet : sheets) finished.push_back(run.draw_sheet(world, sections, sheet));
  world = {};  // what follows takes its room
  sections.clear();

  if (options.timings) run.report.seconds = watch.laps();
  const std::vector<FileBytes> files = encode_all(targets, finished, vector_options, run.report, progress);
  for (const FileBytes& file : files) write(file, progress);
  watch.lap("write");
  console.print("");  // the line of progress makes room
  std::fputs(run.answers.c_str(), stdout);
  if (options.timings) print_timings(console, watch);
  return conclude(console, run.report);
}

}  // namespace epura
