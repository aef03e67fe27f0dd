// SPDX-License-Identifier: Apache-2.0
#include "pipeline/draw_scene.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "composition/annotations.hpp"
#include "composition/compose.hpp"
#include "composition/detail_layers.hpp"
#include "composition/dimension_facts.hpp"
#include "composition/free_forms.hpp"
#include "composition/line_facts.hpp"
#include "composition/lint.hpp"
#include "composition/seen_items.hpp"
#include "composition/state_requirements.hpp"
#include "composition/summary.hpp"
#include "composition/tell.hpp"
#include "composition/wanted_views.hpp"
#include "drawing/drawing.hpp"
#include "pipeline/find_features.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/recognise_parts.hpp"
#include "pipeline/replace_helical_threads.hpp"
#include "pipeline/within_error.hpp"
#include "sizes/anchors.hpp"
#include "view/condition.hpp"
#include "views/arrow_views.hpp"
#include "views/breaks.hpp"
#include "views/coarse_meshes.hpp"
#include "views/constructions.hpp"
#include "views/mass.hpp"
#include "views/questions.hpp"
#include "views/sections.hpp"
#include "views/shown_worlds.hpp"
#include "views/time_for_lines.hpp"
#include "views/view_error.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

namespace {

template <class Item>
void add_all(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

// Triangles: drawing more once again, only to arrange the views better, takes too long.
constexpr std::size_t max_drawn_again = 200'000;

using WorldOfView = std::function<const world::World&(std::size_t)>;

/// What the sheets of a run add to its result.
struct Gathered {
  std::size_t views_left;  ///< not drawn yet
  report::Report report{};
  bool has_lines = false;
  std::string answers{};
  std::vector<sheet::DimensionsInView> dimensioned{};  ///< for lint
  MatchedSizes sizes{};
  std::optional<sheet::RebuiltPart> rebuilt{};
};

/// A sheet before its views are positioned.
struct PreparedSheet {
  SheetOfViews views;
  std::vector<view::ProjectedScene> seen;  ///< empty once it is drawn
  std::vector<Annotations> annotations;
  std::vector<sheet::DimensionsInView> anchored;  ///< for lint
  std::vector<std::string> lacks;                 ///< views that would show what requirements need
};

/// One way to draw a prepared sheet.
struct Trial {
  SheetPlan plan;
  std::optional<std::size_t> max_left_out{};
  bool verifies = false;  ///< whether its views are tested
};

// Whether somebody asks what the dimensions measure.
bool needs_anchors(const RunOptions& options) { return options.lint || options.rebuild || options.keeps_drawings; }

struct Attempt;
using DrawSheet = std::function<FinishedSheet(const Trial&)>;

/// The state of a run.
struct Run {
  scene::SceneDescription scene;
  const RunOptions& options;
  Messages messages;
  Progress progress;
  Stopwatch& watch;
  Gathered gathered;
  std::vector<std::vector<importer::BodyPart>> parts{};  ///< of the bodies of each model
  bool refers_to_models = false;                         ///< for free forms
  std::map<const world::World*, std::optional<KnownIntersections>> intersections{};
  PartsByModel known_parts{};
  std::vector<FileRequirements> required{};
  std::vector<std::string> lacking_views{};  ///< for requirements, as in --projection
  double facets = usual_facets;              ///< mm on paper by which those of imported surfaces are off
  std::optional<world::FacetHeights> heights{};
  std::string cut_before_sheets{};  ///< the first stage on the models that the time limit cut short

  void note(const ViewResult& result);
  void note(const FinishedSheet& sheet);
  void judge(const std::vector<report::ViewError>& errors) const;
  void find_heights(const world::World& world);
  ViewTime time_of_next_view();
  std::vector<view::ProjectedScene> map_views(const WorldOfView& world, const SheetOfViews& views);
  PreparedSheet prepare_sheet(const ShownWorlds& worlds, SheetOfViews views);
  PreparedSheet prepare_with_added_views(const ShownWorlds& worlds, SheetOfViews views);
  [[nodiscard]] SheetPlan usual_plan(const ShownWorlds& worlds, PreparedSheet& sheet) const;
  SheetPlan plan_of(const ShownWorlds& worlds, PreparedSheet& sheet, const LayoutRequest& layout) const;
  FinishedSheet draw_sheet(const ShownWorlds& worlds, PreparedSheet& prepared, const Trial& trial);
  DrawSheet drawing(const ShownWorlds& worlds, PreparedSheet& sheet) {
    return [this, &worlds, &sheet](const Trial& trial) { return draw_sheet(worlds, sheet, trial); };
  }
  void finish(FinishedSheet& sheet, const SheetPlan& plan, std::vector<sheet::DimensionsInView> anchored);
  Attempt attempt(const Trial& trial, const DrawSheet& draw);
  void verify_kept(const ShownWorlds& worlds, PreparedSheet& sheet, Attempt& kept);
  std::optional<Attempt> attempt_if(const Trial& trial, const DrawSheet& draw,
                                    const std::function<bool(const FinishedSheet&)>& is_better);
  std::optional<Attempt> attempt_better(const ShownWorlds& worlds, PreparedSheet& sheet, const SheetPlan& usual);
  Attempt draw_in_best_layout(const ShownWorlds& worlds, PreparedSheet& sheet);
  PreparedSheet with_holes(const ShownWorlds& worlds, PreparedSheet sheet, HoleDimensions holes) const;
  FinishedSheet draw_best_sheet(const ShownWorlds& worlds, SheetOfViews views);
  std::vector<FinishedSheet> draw_sheets(const std::vector<SheetOfViews>& sheets);
  void lint(std::span<FinishedSheet> sheets, const ShownWorlds& worlds);
};

void Run::find_heights(const world::World& world) {
  if (!options.judges && !options.max_error && !options.error_note && !options.verify) return;
  progress.begin("judging facets");
  try {
    heights = world::facet_heights(world, progress.with_part_of_the_time(part_for_judging));
  } catch (const OutOfTime& cut) {
    gathered.report.partial.add_stage(cut.stage);
  }
}

void Run::judge(const std::vector<report::ViewError>& errors) const {
  if (!options.max_error) return;
  expect_within(*options.max_error, options.arcs.has_value(), errors, facets_of(gathered.report.meshes));
  for (const report::ViewError& error : errors) messages.print(sentence_of(error));
}

// For several views, the report has everything omitted for lack of time, and the verification that found most errors.
void Run::note(const ViewResult& result) {
  warn_about(messages, result);
  gathered.report.plan.insert(gathered.report.plan.end(), result.plan.begin(), result.plan.end());
  gathered.has_lines = gathered.has_lines || !result.drawing.segments.empty();
  if (auto& found = gathered.report.tessellation; found && !result.drawing.projection.central)
    found->on_paper = std::max(found->on_paper, found->error * result.drawing.scale);
  if (result.error) {
    gathered.report.errors.push_back(*result.error);
    gathered.report.errors.back()[report::ErrorTerm::writing] = options.writing_error;
  }
  if (result.verification &&
      (!gathered.report.verification || gathered.report.verification->errors() < result.verification->errors()))
    gathered.report.verification = result.verification;
}

void Run::note(const FinishedSheet& sheet) {
  for (const std::string& warning : sheet.warnings) messages.warn(warning);
  if (options.lint) add_all(gathered.report.findings, sheet.findings);
  warn_about(messages, sheet.sheet);
}

ViewTime Run::time_of_next_view() {
  return {progress,
          progress.with_part_of_the_time(1 / (static_cast<double>(gathered.views_left--) + views_for_the_rest))};
}

std::vector<view::ProjectedScene> Run::map_views(const WorldOfView& world, const SheetOfViews& views) {
  progress.begin("mapping", views.plans.size());
  std::vector<view::ProjectedScene> seen;
  for (std::size_t i = 0; i < views.plans.size(); ++i) {
    progress.expect_time();
    seen.push_back(project_scene(world(i), views.plans[i], views.descriptions[i]));
    const view::Condition map = view::condition_of(seen.back().projection, world(i).box, world(i).one_rounding);
    const report::ViewCondition condition{views.plans[i].options.name, map};
    warn_about(messages, condition);
    if (options.explain) gathered.report.conditions.push_back(condition);
    progress.advance(1);
  }
  watch.lap("view");
  return seen;
}

// All that does not depend on where the views are on the sheet.
PreparedSheet Run::prepare_sheet(const ShownWorlds& worlds, SheetOfViews views) {
  const world::World& whole = worlds.main();
  const auto world = [&](std::size_t view) -> const world::World& { return worlds.seen_in(views.descriptions[view]); };
  orient_arrow_views(views, world);
  std::vector<view::ProjectedScene> seen = map_views(world, views);
  choose_by_world(views, scene, worlds, seen);
  find_breaks(views, seen, world);
  views.epura = epura_views(scene.sheets[static_cast<std::size_t>(views.sheet)], views, seen);
  expect_constructions(views, seen);
  views.items = listed_items(whole, scene, parts, views.sheet, messages);
  std::vector<std::string> lacks = state_requirements(scene, required, {views, seen, worlds});
  std::vector<Annotations> annotations = annotate(whole, scene, views, seen, worlds.surfaces());
  for (const Annotations& of_view : annotations) gathered.sizes.add(of_view.sizes);
  warn_of_unplaced(messages, annotations);
  std::vector<sheet::DimensionsInView> anchored;
  if (needs_anchors(options)) anchored = anchored_dimensions(whole, views, seen, annotations);
  return {std::move(views), std::move(seen), std::move(annotations), std::move(anchored), std::move(lacks)};
}

// What is lacking is known before anything is drawn.
PreparedSheet Run::prepare_with_added_views(const ShownWorlds& worlds, SheetOfViews views) {
  if (std::ranges::none_of(views.descriptions, &scene::ViewDescription::is_automatic))
    return prepare_sheet(worlds, std::move(views));
  const Gathered before = gathered;
  const scene::SceneDescription described = scene;
  const std::vector<FileRequirements> open = required;
  HeldMessages held;
  const Messages outside = std::exchange(messages, held.messages());
  PreparedSheet sheet = prepare_sheet(worlds, views);
  messages = outside;
  std::vector<std::string> lacking = sheet.lacks;
  if (dimensions_features(scene)) {
    const auto anchored = anchored_dimensions(worlds.main(), sheet.views, sheet.seen, sheet.annotations);
    add_all(lacking, views_for_sizes({worlds.main(), scene, anchored}, progress));
    add_all(lacking, views_for_hidden(worlds.main(), sheet.views, sheet.seen, sheet.annotations, progress));
  }
  scene::SceneDescription extended = described;
  const std::size_t added = add_views(extended, views.sheet, lacking);
  if (added == 0) {
    held.tell(messages);
    return sheet;
  }
  gathered = before;
  gathered.views_left += added;
  required = open;
  scene = std::move(extended);
  SheetOfViews all = std::move(views_by_sheet(scene, plan_views(scene, options))[std::size_t(views.sheet)]);
  all.states_error = views.states_error;
  find_details(all, scene);
  return prepare_sheet(worlds, std::move(all));
}

// Projecting takes less time than keeping a copy takes memory.
void project_again(PreparedSheet& sheet, const ShownWorlds& worlds) {
  if (!sheet.seen.empty()) return;
  for (std::size_t i = 0; i < sheet.views.plans.size(); ++i) {
    const scene::ViewDescription& view = sheet.views.descriptions[i];
    sheet.seen.push_back(project_scene(worlds.seen_in(view), sheet.views.plans[i], view));
  }
}

SheetPlan Run::plan_of(const ShownWorlds& worlds, PreparedSheet& sheet, const LayoutRequest& layout) const {
  project_again(sheet, worlds);
  sheet.views.layout = layout;
  return plan_sheet(worlds.main(), scene, sheet.views, sheet.seen, sheet.annotations);
}

FinishedSheet Run::draw_sheet(const ShownWorlds& worlds, PreparedSheet& prepared, const Trial& trial) {
  project_again(prepared, worlds);
  std::vector<view::ProjectedScene> seen = std::exchange(prepared.seen, {});
  SheetOfViews views = prepared.views;
  if (!trial.verifies)
    for (PlannedView& view : views.plans) view.options.verify.reset();
  const SheetPlan& plan = trial.plan;
  const std::vector<Annotations>& annotations = prepared.annotations;
  const auto shown = [&](std::size_t view) -> const ShownWorld& { return worlds.of(views.descriptions[view]); };
  const auto world = [&](std::size_t view) -> const world::World& { return worlds.seen_in(views.descriptions[view]); };
  set_least_threads(views, plan);
  tell_of_scales(messages, plan, scene.sheets[static_cast<std::size_t>(views.sheet)], views);
  warn_about_details(messages, views, plan);
  std::vector<ViewResult> results;
  std::string answers_of_sheet;
  CoarseMeshes coarse(scene, known_parts);
  std::vector<std::vector<std::optional<SeenPoint>>> items_seen(seen.size());
  std::vector<std::vector<std::optional<sheet::CalloutTarget>>> targets;
  report::Partial partial;
  const Budget budget{progress, progress, partial};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::vector<BrokenOutSection> broken_out =
        cut_broken_outs(world(i), scene, views.descriptions[i], seen[i].projection, messages);
    const CutSection* section = section_of(shown(i).sections, views.descriptions[i]);
    ViewInput input{world(i), section, views.plans[i].options, plan.places[i], shown(i).traces, broken_out};
    input.known = scene.views.size() > 1 ? &intersections[&world(i)] : nullptr;
    input.heights = heights ? &*heights : nullptr;
    // Of a detail, this is said of the view that it enlarges.
    if (section != nullptr && !input.options.detail)
      warn_if_unseen(messages, *section, seen[i], views.plans[i].options.name);
    results.push_back(draw_view(input, std::move(seen[i]), time_of_next_view(), watch));
    warn_if_empty(messages, results.back(), input);
    coarse.look(input, results.back().drawing, progress);
    note(results.back());
    CalloutTargets found =
        find_targets(world(i), results.back().drawing, annotations[i].callouts, !results.back().partial.stages.empty());
    for (const std::string& warning : found.warnings) messages.warn(warning);
    targets.push_back(std::move(found.targets));
    if (annotations[i].balloons) items_seen[i] = seen_items(world(i), results.back().drawing, views.items);
    partial.add(results.back().partial);
    answers_of_sheet +=
        budget.or_nothing([&](const Progress& until) { return answer(options, input, results.back(), until); });
    results.back().work = {};  // frees memory for what follows
  }
  for (const std::string& warning : coarse.warnings()) messages.warn(warning);
  if (options.arcs) tell_of_curves(messages, results);
  if (!plan.inside || plan.crowded) warn_about(messages, plan);
  gathered.report.cut_off = gathered.report.cut_off || !plan.on_paper;
  const bool has_numbers = options.balloons == Balloons::characteristics;
  const auto numbers = has_numbers ? numbered_characteristics(required) : std::map<std::string, int>();
  FinishedSheet sheet = compose({worlds.main(), scene, views, plan, annotations, std::move(targets),
                                 balloons_of(scene, views, items_seen, messages), numbers, trial.max_left_out},
                                results, budget);
  finish(sheet, plan, prepared.anchored);
  gathered.answers += sheet.answers = std::move(answers_of_sheet);
  if (options.line_facts)
    for (std::size_t i = 0; i < sheet.drawings.size(); ++i) add_line_facts(sheet.sheet, sheet.drawings[i], world(i));
  if (const std::string cut = partial.stages.empty() ? cut_before_sheets : partial.stages.front(); !cut.empty())
    mark_partial(sheet, cut);
  sheet.lacks_lines = !partial.stages.empty() || !cut_before_sheets.empty();
  gathered.report.partial.add(partial);
  if (!options.keeps_drawings) sheet.drawings = {};
  note(sheet);
  gathered.report.plan.push_back(text_step(sheet.sheet, options.plan.text));
  watch.lap("sheet");
  return sheet;
}

void Run::finish(FinishedSheet& sheet, const SheetPlan& plan, std::vector<sheet::DimensionsInView> anchored) {
  sheet.next_size = plan.next_size;
  std::vector<std::vector<std::size_t>> undrawn = sheet.left_out;
  for (std::size_t view = 0; view < sheet.unseen.size(); ++view) add_all(undrawn[view], sheet.unseen[view]);
  for (std::vector<std::size_t>& numbers : undrawn) std::sort(numbers.begin(), numbers.end());
  for (sheet::Layer& layer : sheet.sheet.layers)
    for (sheet::DimensionObject& object : layer.dimensions)
      for (std::size_t view = 0; view < anchored.size(); ++view)
        if (layer.name.starts_with(anchored[view].view + "/"))
          object.number -= static_cast<int>(std::ranges::count_if(
              undrawn[view], [&object](std::size_t one) { return std::cmp_less(one, object.number); }));
  leave_out(anchored, undrawn);
  add_all(gathered.dimensioned, std::move(anchored));
}

/// A sheet that is drawn, but not noted as a result yet.
struct Attempt {
  Trial trial;
  FinishedSheet sheet;
  HeldMessages told;
  Gathered gathered;
};

// Leaves `gathered` as it was. If the sheet cannot be drawn, the messages are told.
Attempt Run::attempt(const Trial& trial, const DrawSheet& draw) {
  const Messages outside = messages;
  const Gathered before = gathered;
  HeldMessages held;
  messages = held.messages();
  try {
    FinishedSheet sheet = draw(trial);
    messages = outside;
    return {trial, std::move(sheet), std::move(held), std::exchange(gathered, before)};
  } catch (...) {
    messages = outside;
    gathered = before;
    held.tell(messages);
    throw;
  }
}

// Nothing unless it is complete and `is_better`; another sheet is drawn then.
std::optional<Attempt> Run::attempt_if(const Trial& trial, const DrawSheet& draw,
                                       const std::function<bool(const FinishedSheet&)>& is_better) {
  constexpr double part = 0.4;  // of the time left
  const Messages outside = std::exchange(messages, silent_messages());
  const Progress whole = std::exchange(progress, progress.with_part_of_the_time(part));
  std::optional<Attempt> result;
  const auto restore = [&] {
    messages = outside;
    progress = whole;
  };
  try {
    result = attempt(trial, draw);
  } catch (const OutOfTime&) {
  } catch (const Error&) {
    // Something is not on this paper. What is wrong on any paper is told of the other sheet.
  } catch (...) {
    restore();
    throw;
  }
  restore();
  if (result && !(is_better(result->sheet) && result->gathered.report.partial.stages.empty())) return std::nullopt;
  return result;
}

// The room for dimensions in the usual layout is an estimate: many share lines or are on one side of their view. So a
// better layout, which has a part of it, counts if everything has a place; then one that is better still may.
std::optional<Attempt> Run::attempt_better(const ShownWorlds& worlds, PreparedSheet& sheet, const SheetPlan& usual) {
  if (!usual.inside || !dimensions_features(scene) || worlds.main().triangles.size() > max_drawn_again)
    return std::nullopt;
  const scene::SheetDescription& description = scene.sheets[static_cast<std::size_t>(sheet.views.sheet)];
  std::optional<SheetPlan> tried;
  for (const LayoutRequest& wish : better_layouts(description, usual)) {
    const SheetPlan better = plan_of(worlds, sheet, wish);
    if (!better.inside || better.crowded || !is_better(better, tried.value_or(usual))) continue;
    if (auto found = attempt_if({better, 0}, drawing(worlds, sheet), is_complete)) {
      auto larger = better.chosen ? attempt_better(worlds, sheet, better) : std::nullopt;
      return larger ? std::move(larger) : std::move(found);
    }
    tried = better;
  }
  return std::nullopt;
}

// With less room for dimensions than usual, which is told, if the views have no place on the sheet otherwise.
SheetPlan Run::usual_plan(const ShownWorlds& worlds, PreparedSheet& sheet) const {
  SheetPlan usual = plan_of(worlds, sheet, {});
  if (usual.inside) return usual;
  for (const double share : smaller_rooms) {
    SheetPlan closer = plan_of(worlds, sheet, {0, std::nullopt, share});
    if (!closer.inside) continue;
    closer.crowded = true;
    closer.fitting = usual.fitting;
    return closer;
  }
  return usual;
}

Attempt Run::draw_in_best_layout(const ShownWorlds& worlds, PreparedSheet& sheet) {
  const SheetPlan usual = usual_plan(worlds, sheet);
  std::optional<Attempt> best = attempt_better(worlds, sheet, usual);
  // The only one if no features are dimensioned, as a rule, and tested at once.
  if (!best) best = attempt({usual, std::nullopt, !dimensions_features(scene)}, drawing(worlds, sheet));
  const scene::SheetDescription& description = scene.sheets[static_cast<std::size_t>(sheet.views.sheet)];
  for (const LayoutRequest& wish : roomier_layouts(description, usual)) {
    const auto faults = faults_of(best->sheet);
    const bool is_sized = is_sized_by_scale(description);
    // A smaller scale does not make rows shorter.
    if (faults.first == 0 && (faults.second == 0 || !is_sized)) break;
    if (progress.is_out_of_time() || (!is_sized && worlds.main().triangles.size() > max_drawn_again)) break;
    const SheetPlan plan = plan_of(worlds, sheet, wish);
    if (!plan.inside) continue;
    auto other = attempt_if({plan, faults.first}, drawing(worlds, sheet),
                            [&](const FinishedSheet& drawn) { return faults_of(drawn) < faults; });
    if (other) best = std::move(other);
  }
  return std::move(*best);
}

// The same sheet with another way to dimension holes.
PreparedSheet Run::with_holes(const ShownWorlds& worlds, PreparedSheet sheet, HoleDimensions holes) const {
  scene::SceneDescription other = scene;
  for (scene::DimensionDescription& dimension : other.dimensions) dimension.holes.value = holes;
  project_again(sheet, worlds);
  sheet.annotations = annotate(worlds.main(), other, sheet.views, sheet.seen, worlds.surfaces());
  if (needs_anchors(options))
    sheet.anchored = anchored_dimensions(worlds.main(), sheet.views, sheet.seen, sheet.annotations);
  return sheet;
}

// Holes in a table instead of a fan of positions, or dimensioned where the sheet has no room for a table.
std::optional<HoleDimensions> other_holes(const FinishedSheet& drawn, const PreparedSheet& sheet) {
  const bool has_table = std::any_of(sheet.annotations.begin(), sheet.annotations.end(),
                                     [](const Annotations& view) { return !view.tables.empty(); });
  if (has_table && drawn.without_room > 0) return HoleDimensions::notes;
  if (!has_table && faults_of(drawn).second > 0) return HoleDimensions::table;
  return std::nullopt;
}

// Drawn again for it, which takes a small part of the time of the tests that other layouts are spared. Untested if time
// runs out.
void Run::verify_kept(const ShownWorlds& worlds, PreparedSheet& sheet, Attempt& kept) {
  if (!options.verify || kept.trial.verifies) return;
  kept.trial.verifies = true;
  auto tested = attempt_if(kept.trial, drawing(worlds, sheet), [](const FinishedSheet&) { return true; });
  if (tested) return void(kept = std::move(*tested));
  kept.gathered.report.partial.add_stage("verifying");
  mark_partial(kept.sheet, "verifying");
}

FinishedSheet Run::draw_best_sheet(const ShownWorlds& worlds, SheetOfViews views) {
  PreparedSheet sheet = prepare_with_added_views(worlds, std::move(views));
  add_all(lacking_views, sheet.lacks);
  Attempt best = draw_in_best_layout(worlds, sheet);
  bool is_without_table = false;
  if (const auto holes = other_holes(best.sheet, sheet); holes && !progress.is_out_of_time()) {
    const auto faults = faults_of(best.sheet);
    std::optional<Attempt> other;
    std::optional<PreparedSheet> changed;
    const auto draw = [&](const Trial&) {
      changed = with_holes(worlds, sheet, *holes);
      other = draw_in_best_layout(worlds, *changed);
      return FinishedSheet{};
    };
    if (attempt_if({}, draw, [&](const FinishedSheet&) { return faults_of(other->sheet) < faults; })) {
      best = std::move(*other);
      sheet = std::move(*changed);
      is_without_table = *holes == HoleDimensions::notes;
    }
  }
  verify_kept(worlds, sheet, best);
  best.told.tell(messages);
  gathered = std::move(best.gathered);
  if (is_without_table) {
    const std::string what = "no room for the table of the holes, which have dimensions instead";
    messages.warn("the sheet has " + what + "\n  hint: use a larger sheet or a smaller scale");
    if (options.lint) gathered.report.findings.push_back({report::FindingKind::off_sheet, "", "there is " + what});
  }
  return std::move(best.sheet);
}

std::vector<FinishedSheet> Run::draw_sheets(const std::vector<SheetOfViews>& sheets) {
  ReadWorld read = read_models(scene, reading_of(scene, options, facets), gathered.report.meshes, messages, progress);
  parts = std::move(read.parts);
  required = std::move(read.required);
  choose_notation(scene, required);
  scene.explosions = std::move(read.explosions);
  world::World world = std::move(read.world);
  watch.lap("read");
  // Without its faces a part is drawn as a mesh; without time for lines, nothing is.
  const double for_views = seconds_for_views(world, seconds_now(progress), scene.views.size());
  recognise_parts(world, scene, options, gathered.report, progress.with_more_time(-for_views));
  doubt_unit(messages, scene, world, read.without_unit);
  place_datums(scene, world);
  turn_to_own_axes(world, scene, messages);
  find_features(scene, world);
  if (!scene.requirements.empty()) state_by_features(required, scene, world);
  if (options.balloons == Balloons::characteristics) warn_of_no_characteristics(messages, required);
  if (std::any_of(sheets.begin(), sheets.end(), shows_parts))
    world = replace_helical_threads(std::move(world), scene, messages, progress);
  find_threads(world, scene);
  complete_mass(scene, world, messages);
  refers_to_models = refer_to_models(scene, world);
  if (refers_to_models) warn_of_unrecognised(messages, scene, world);
  find_heights(world);
  if (!gathered.report.partial.stages.empty()) cut_before_sheets = gathered.report.partial.stages.front();
  watch.lap("features");
  const ShownWorlds worlds(std::move(world), scene, messages, progress);
  if (!scene.explosions.empty() || !worlds.surfaces().empty()) watch.lap("section");
  std::vector<FinishedSheet> finished;
  for (SheetOfViews sheet : sheets) {
    sheet.states_error = options.error_note;
    find_details(sheet, scene);
    finished.push_back(draw_best_sheet(worlds, std::move(sheet)));
    take_back(required, finished.back().unplaced);
    set_zones(required, finished.back().zones);
  }
  gathered.report.unmatched_sizes = warn_of_unmatched(messages, scene, gathered.sizes);
  gathered.report.requirements = end_ledger(required, messages, options.allow_missing);
  if (options.keeps_drawings) add_dimension_facts(finished, gathered.dimensioned, worlds.main(), scene);
  if (options.lint) lint(finished, worlds);
  if (options.describes)
    describe(finished, sheets, {worlds.main(), scene, parts, options.names_features},
             {progress, progress, gathered.report.partial});
  if (options.rebuild)
    gathered.rebuilt = sheet::rebuild_part(gathered.dimensioned, worlds.main(), features::true_extents(worlds.main()),
                                           notation_of(worlds.main(), scene.sheets.front()), options.rules);
  return finished;
}

void Run::lint(std::span<FinishedSheet> sheets, const ShownWorlds& worlds) {
  report::Report& report = gathered.report;
  if (!options.allow_missing) add_missing_requirements(report, lacking_views);
  const std::vector<AcceptedFaces> accepted = accepted_faces(scene, worlds.main());
  const HatchedFaces free =
      add_missing_sizes(report, {worlds.main(), scene, gathered.dimensioned}, {accepted, options.rules}, progress);
  add_illegible_texts(report, sheets);
  add_all(report.findings, undefined_free_forms(worlds.main(), scene, refers_to_models));
  warn_of_vain(messages, accepted, report.findings);
  if (options.hatch_free) hatch_free_faces(sheets, scene, worlds, free);
}

DrawnScene draw_once(const scene::SceneDescription& scene, const RunOptions& options, const RunContext& context,
                     const std::vector<SheetOfViews>& sheets, double facets) {
  Run run{scene, options, context.messages, context.progress, context.watch, {scene.views.size()}};
  run.facets = facets;
  run.gathered.report.plan.push_back(plugins_step(sheets));
  std::vector<FinishedSheet> finished = run.draw_sheets(sheets);
  context.progress.expect_not_stopped();
  // An empty sheet is not a drawing.
  if (!run.gathered.report.partial.stages.empty() && !run.gathered.has_lines)
    throw OutOfTime{run.gathered.report.partial.stages.front()};
  run.judge(run.gathered.report.errors);
  return {std::move(finished), std::move(run.gathered.report), std::move(run.gathered.answers),
          std::move(run.gathered.rebuilt), std::move(run.scene)};
}

}  // namespace

DrawnScene draw_scene(const scene::SceneDescription& scene, const RunOptions& options, const RunContext& context) {
  const ThreadLimit threads(options.threads);
  const std::vector<SheetOfViews> sheets = views_by_sheet(scene, plan_views(scene, options));
  context.watch.lap("prepare");
  const auto draw = [&](double facets, const Messages& messages) {
    return draw_once(scene, options, {messages, context.progress, context.watch}, sheets, facets);
  };
  if (!options.max_error) return draw(usual_facets, context.messages);
  return draw_within_error(*options.max_error, part_of_drawings(scene, *options.max_error), context.messages, draw);
}

}  // namespace epura::pipeline
