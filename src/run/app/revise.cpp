// SPDX-License-Identifier: Apache-2.0
#include "app/revise.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "annotations/revision_clouds.hpp"
#include "app/describe.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "compare/comparison.hpp"
#include "output/format.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/targets.hpp"
#include "scene/choices.hpp"
#include "sheet/lettering.hpp"
#include "sheet/revision_list.hpp"

namespace epura {

namespace {

using compare::Change;
using compare::Difference;

// mm: facets of parts of different sizes are divided differently.
constexpr double tolerance = 2 * pipeline::usual_facets;
constexpr const char* revise_option = "--revise";

// The sheets as they would be written, and their requirements.
compare::PictureFile pictures_of(const pipeline::DrawnScene& drawn) {
  compare::PictureFile pictures;
  const std::vector<pipeline::Target> target{{"revision.svg", output::find_format("svg")}};
  for (const pipeline::FileBytes& file : pipeline::encode_all(target, drawn.sheets, {}, drawn.report, {})) {
    compare::PictureFile read = compare::pictures_of(file.bytes, "revision.svg");
    std::move(read.pages.begin(), read.pages.end(), std::back_inserter(pictures.pages));
  }
  pictures.requirements = drawn.report.requirements;
  return pictures;
}

pipeline::DrawnScene draw_unjudged(const scene::SceneDescription& scene, pipeline::RunOptions options) {
  options.verify = options.explain = options.lint = options.rebuild = false;
  options.why.clear();
  options.dump.reset();
  options.allow_missing = true;
  pipeline::Stopwatch watch;
  return pipeline::draw_scene(scene, options, {pipeline::silent_messages(), {}, watch});
}

// The older version on the sheets of the new one, with the views that were added to these, and lying as that does.
void use_sheets(const pipeline::DrawnScene& newer, scene::SceneDescription& older) {
  const std::vector<pipeline::FinishedSheet>& sheets = newer.sheets;
  if (std::ranges::any_of(older.views, &scene::ViewDescription::is_automatic)) {
    older.views = newer.scene.views;
    for (scene::ViewDescription& view : older.views) view.is_automatic = false;
    for (std::size_t i = 0; i < std::min(newer.scene.models.size(), older.models.size()); ++i)
      if (!older.models[i].transform.given()) older.models[i].transform = newer.scene.models[i].transform;
  }
  for (std::size_t i = 0; i < std::min(sheets.size(), older.sheets.size()); ++i) {
    scene::SheetDescription& sheet = older.sheets[i];
    const pipeline::FinishedSheet& drawn = sheets[i];
    const Vec2 size(drawn.sheet.width, drawn.sheet.height);
    if (drawn.paper.width > 0) {
      sheet.size = {sheet::paper_of_size(size), revise_option};
      sheet.orientation = {size.x >= size.y ? Orientation::landscape : Orientation::portrait, revise_option};
    }
    sheet.scale = {scene::ScaleChoice{drawn.scale}, revise_option};
  }
}

// Frames, tables and texts of the sheet itself change with every revision; dimensions that only moved are no change.
bool is_change(const Difference& one) {
  constexpr std::array<std::string_view, 8> of_models{"visible", "hidden", "hidden-solid", "narrow",
                                                      "tangent", "thread", "section",      "wide"};
  if (one.is_view || one.change == Change::size || one.view.empty() || one.view == "sheet") return false;
  if (one.change != Change::moved) return true;
  return !one.is_text && std::find(of_models.begin(), of_models.end(), one.after) != of_models.end();
}

// "diameter 5 H7 mm -> 5 H8 mm"
std::string words_of(const compare::RequirementChange& change) {
  if (change.before.empty()) return "added: " + change.after;
  if (change.after.empty()) return "removed: " + change.before;
  std::size_t same = 0;
  const std::size_t shorter = std::min(change.before.size(), change.after.size());
  for (std::size_t i = 0; i < shorter && change.before[i] == change.after[i]; ++i)
    if (change.before[i] == ' ') same = i + 1;
  return change.before + " -> " + change.after.substr(same);
}

// What the row of the table says: the requirements that differ, or texts, or else which views do.
std::string text_of(const compare::Comparison& comparison) {
  constexpr std::size_t longest = 90;  // characters; the table has room for them
  std::vector<std::string> items, views;
  std::string changed;
  for (const compare::RequirementChange& change : comparison.requirements) items.push_back(words_of(change));
  for (const Difference& one : comparison.differences) {
    if (!is_change(one)) continue;
    if (std::find(views.begin(), views.end(), one.view) == views.end())
      append_to_list(changed, views.emplace_back(one.view));
    if (one.change != Change::text || !comparison.requirements.empty()) continue;
    if (std::string words = one.before + " -> " + one.after;
        std::find(items.begin(), items.end(), words) == items.end())
      items.push_back(std::move(words));
  }
  if (items.empty()) items = {"lines of " + changed};
  std::string text = one_line(items.front());
  std::size_t used = 1;
  while (used < items.size() && text.size() + items[used].size() <= longest) text += "; " + one_line(items[used++]);
  return used == items.size() ? text : text + "; " + std::to_string(items.size() - used) + " more";
}

// "C" after "B", "Z" after "Y", "AA" after "Z"; "2" after "1".
std::string after(const std::string& last) {
  std::string next = last;
  for (std::size_t i = next.size(); i > 0; --i) {
    char& c = next[i - 1];
    const bool is_last = c == 'Z' || c == 'z' || c == '9';
    if (!is_last) {
      ++c;
      return next;
    }
    c = c == '9' ? '0' : c == 'Z' ? 'A' : 'a';
  }
  return (next.empty() ? "A" : next.front() == '0' ? "1" : next.substr(0, 1)) + next;
}

std::string revision_of(const scene::SceneDescription& scene) {
  if (const std::string given = scene.sheets.front().field("revision"); !given.empty()) return given;
  return scene.revisions.empty() ? "A" : after(*scene.revisions.back().revision);
}

void add_row(scene::SceneDescription& scene, const std::string& revision) {
  scene::RevisionDescription row{{revision, revise_option}, {}, {"...", revise_option}};
  if (const std::string date = scene.sheets.front().field("date"); !date.empty()) row.date = {date, revise_option};
  if (const std::string by = scene.sheets.front().field("author"); !by.empty()) row.author = {by, revise_option};
  scene.revisions.push_back(std::move(row));
}

// The row takes the same room whatever it says.
void write_row(pipeline::FinishedSheet& sheet, const scene::SceneDescription& scene,
               const pipeline::Messages& messages) {
  sheet::RevisionList list{{}, scene.sheets.front().field("language")};
  for (const scene::RevisionDescription& row : scene.revisions)
    if (row.sheet.value_or(1) == 1) list.rows.push_back(row);
  const sheet::Lettering lettering(sheet.sheet.font);
  for (std::string& warning : sheet::rewrite_revisions(sheet.sheet.layers, list, lettering)) {
    messages.warn(warning);
    sheet.warnings.push_back(std::move(warning));
  }
}

using BoxesBySheet = std::vector<std::vector<sheet::Rectangle>>;

// Changes of different views are in clouds of their own.
BoxesBySheet changes_of(const compare::Comparison& comparison, std::size_t sheets) {
  std::map<std::pair<std::size_t, std::string>, std::vector<sheet::Rectangle>> by_view;
  for (const Difference& one : comparison.differences)
    if (const auto page = static_cast<std::size_t>(one.page - 1); is_change(one) && page < sheets)
      by_view[{page, one.view}].push_back({glm::min(one.from, one.to), glm::max(one.from, one.to)});
  BoxesBySheet changes(sheets);
  for (auto& [place, boxes] : by_view)
    std::ranges::copy(sheet::united_changes(std::move(boxes)), std::back_inserter(changes[place.first]));
  return changes;
}

// Returns how many there are.
std::size_t add_clouds(std::vector<pipeline::FinishedSheet>& sheets, const BoxesBySheet& changes,
                       const std::string& revision) {
  std::size_t clouds = 0;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (changes[i].empty()) continue;
    clouds += changes[i].size();
    const sheet::LineWidths widths = sheet::line_widths(sheets[i].paper);
    sheets[i].sheet.layers.push_back(sheet::revision_clouds(changes[i], revision, widths));
  }
  return clouds;
}

}  // namespace

Revising begin_revision(const DrawOptions& options, scene::SceneDescription& scene) {
  if (options.models.size() != 1)
    refuse_input(revise_option,
                 "compares one model or scene file, but there are " + std::to_string(options.models.size()),
                 "write a scene file with the models, and give its older version");
  DrawOptions before = options;
  before.models = {*options.revise};
  Revising revising{*options.revise, revision_of(scene), true, describe(before)};
  revising.adds_row = std::none_of(scene.revisions.begin(), scene.revisions.end(),
                                   [&](const auto& row) { return *row.revision == revising.revision; });
  if (revising.adds_row) add_row(scene, revising.revision);
  return revising;
}

bool mark_revision(Revising revising, const pipeline::RunOptions& options, scene::SceneDescription& scene,
                   pipeline::DrawnScene& drawn, const pipeline::Messages& messages) {
  revising.older.revisions = scene.revisions;
  use_sheets(drawn, revising.older);
  pipeline::RunOptions as_new = options;
  if (!options.max_error) as_new.precision = pipeline::precision_of(scene);
  const pipeline::DrawnScene older = draw_unjudged(revising.older, as_new);
  const compare::Comparison comparison = compare::compare(pictures_of(older), pictures_of(drawn), tolerance);
  const std::size_t clouds = add_clouds(drawn.sheets, changes_of(comparison, drawn.sheets.size()), revising.revision);
  if (clouds == 0 && comparison.requirements.empty()) {
    messages.print("nothing differs from " + revising.older_file + ": no revision is marked\n");
    if (revising.adds_row) scene.revisions.pop_back();
    return !revising.adds_row;
  }
  const std::string text = text_of(comparison);
  if (revising.adds_row) {
    scene.revisions.back().text = {text, revise_option};
    write_row(drawn.sheets.front(), scene, messages);
  }
  messages.print("revision " + revising.revision + ": " + text + "; " + std::to_string(clouds) +
                 (clouds == 1 ? " cloud\n" : " clouds\n"));
  return true;
}

}  // namespace epura
