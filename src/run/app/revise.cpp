// SPDX-License-Identifier: Apache-2.0
#include "app/revise.hpp"

#include <algorithm>
#include <array>
#include <iterator>
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
#include "pipeline/targets.hpp"
#include "scene/choices.hpp"

namespace epura {

namespace {

using compare::Change;
using compare::Difference;

constexpr double tolerance = 1e-3;  // mm, as that of `epura compare`

/// The sheets of a version, as they would be written.
struct Version {
  compare::PictureFile pictures;
  std::vector<pipeline::FinishedSheet> sheets;
};

Version drawn(const scene::SceneDescription& scene, const pipeline::RunOptions& options) {
  pipeline::RunOptions run = options;
  run.verify = run.explain = run.lint = run.rebuild = false;
  run.why.clear();
  run.dump.reset();
  run.allow_missing = true;
  pipeline::Stopwatch watch;
  pipeline::DrawnScene result = pipeline::draw_scene(scene, run, {pipeline::silent_messages(), {}, watch});
  Version version{{}, std::move(result.sheets)};
  const std::vector<pipeline::Target> target{{"revision.svg", output::find_format("svg")}};
  for (const pipeline::FileBytes& file : pipeline::encode_all(target, version.sheets, {}, result.report, {})) {
    compare::PictureFile read = compare::pictures_of(file.bytes, "revision.svg");
    std::move(read.pages.begin(), read.pages.end(), std::back_inserter(version.pictures.pages));
  }
  version.pictures.requirements = std::move(result.report.requirements);
  return version;
}

// The older version on the sheets of the new one.
void use_sheets_of(const Version& version, scene::SceneDescription& older, const std::string& where) {
  for (std::size_t i = 0; i < std::min(version.sheets.size(), older.sheets.size()); ++i) {
    scene::SheetDescription& sheet = older.sheets[i];
    const pipeline::FinishedSheet& drawn = version.sheets[i];
    const Vec2 size(drawn.sheet.width, drawn.sheet.height);
    if (drawn.paper.width > 0) {
      sheet.size = {sheet::paper_of_size(size), where};
      sheet.orientation = {size.x >= size.y ? Orientation::landscape : Orientation::portrait, where};
    }
    sheet.scale = {scene::ScaleChoice{drawn.scale}, where};
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
  return change.before + " → " + change.after.substr(same);
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
    if (std::string words = one.before + " → " + one.after; std::find(items.begin(), items.end(), words) == items.end())
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

void add_row(scene::SceneDescription& scene, const std::string& revision, const std::string& text,
             const std::string& where) {
  scene::RevisionDescription row{{revision, where}, {}, {text, where}};
  if (const std::string date = scene.sheets.front().field("date"); !date.empty()) row.date = {date, where};
  if (const std::string by = scene.sheets.front().field("author"); !by.empty()) row.author = {by, where};
  scene.revisions.push_back(std::move(row));
}

}  // namespace

Revised revise(const DrawOptions& options, scene::SceneDescription& scene, const pipeline::Messages& messages) {
  const std::string where = "--revise";
  if (options.models.size() != 1)
    refuse_input(where, "compares one model or scene file, but there are " + std::to_string(options.models.size()),
                 "write a scene file with the models, and give its older version");
  DrawOptions before = options;
  before.models = {*options.revise};
  scene::SceneDescription older = describe(before);
  Revised revised{revision_of(scene)};
  const bool has_row = std::any_of(scene.revisions.begin(), scene.revisions.end(),
                                   [&](const auto& row) { return *row.revision == revised.revision; });
  // The row takes room that decides where everything else is.
  scene::SceneDescription with_row = scene;
  if (!has_row) add_row(with_row, revised.revision, "...", where);
  const Version now = drawn(with_row, options.run);
  older.revisions = with_row.revisions;
  use_sheets_of(now, older, where);
  const Version then = drawn(older, options.run);
  const compare::Comparison comparison = compare::compare(then.pictures, now.pictures, tolerance);
  revised.changes.resize(now.sheets.size());
  for (const Difference& one : comparison.differences)
    if (const auto page = static_cast<std::size_t>(one.page - 1); is_change(one) && page < revised.changes.size())
      revised.changes[page].push_back({glm::min(one.from, one.to), glm::max(one.from, one.to)});
  std::size_t clouds = 0;
  for (std::vector<sheet::Rectangle>& boxes : revised.changes) {
    boxes = sheet::united_changes(std::move(boxes));
    clouds += boxes.size();
  }
  if (clouds == 0 && comparison.requirements.empty()) {
    messages.print("nothing differs from " + *options.revise + ": no revision is marked\n");
    return revised;
  }
  const std::string text = text_of(comparison);
  if (!has_row) add_row(scene, revised.revision, text, where);
  messages.print("revision " + revised.revision + ": " + text + "; " + std::to_string(clouds) +
                 (clouds == 1 ? " cloud\n" : " clouds\n"));
  return revised;
}

void add_clouds(std::vector<pipeline::FinishedSheet>& sheets, const Revised& revised) {
  for (std::size_t i = 0; i < std::min(sheets.size(), revised.changes.size()); ++i) {
    if (revised.changes[i].empty()) continue;
    const sheet::LineWidths widths = sheet::line_widths(sheets[i].paper);
    sheets[i].sheet.layers.push_back(sheet::revision_clouds(revised.changes[i], revised.revision, widths));
  }
}

}  // namespace epura
