// SPDX-License-Identifier: Apache-2.0
#include "composition/lint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "composition/free_forms.hpp"
#include "composition/legibility.hpp"
#include "features/assembly_features.hpp"
#include "features/true_extents.hpp"
#include "sizes/free_faces.hpp"
#include "sizes/noted_dimensions.hpp"
#include "sizes/text_judge.hpp"

namespace epura::pipeline {

namespace {

// Whether a point lies outside the boundary of a detail, seen along the normal of its view.
bool is_outside(const scene::DetailDescription& detail, const projection::Projection& projection, const Vec3& point) {
  constexpr double slack = 1e-6;  // relative
  const Vec3 off = point - detail.centre.value_or(Vec3(0));
  const Vec2 at(glm::dot(off, projection.u), glm::dot(off, projection.v));
  if (detail.radius.given()) return glm::length(at) > *detail.radius * (1 + slack);
  if (!detail.size.given()) return false;
  const Vec2 half = *detail.size / 2.0 * (1 + slack);
  return std::abs(at.x) > half.x || std::abs(at.y) > half.y;
}

// The places at which a dimension is attached: of a circle, the point nearest to the middle of the detail.
std::vector<Vec3> places_of(const sheet::AnchoredDimension& dimension, const scene::DetailDescription& detail) {
  std::vector<Vec3> places = dimension.points;
  for (const sheet::WorldCircle& circle : dimension.circles) {
    const Vec3 off = detail.centre.value_or(Vec3(0)) - circle.centre;
    const Vec3 across = off - glm::dot(off, circle.axis) * circle.axis;
    if (const double length = glm::length(across); length > circle.radius)
      places.push_back(circle.centre + circle.radius / length * across);
  }
  return places;
}

// Dimensions of details whose ends are beyond the boundary, where nothing is drawn.
void find_cut_off(std::vector<report::Finding>& findings, const scene::SceneDescription& scene,
                  const sheet::DimensionsInView& view) {
  const auto shown = std::find_if(scene.views.begin(), scene.views.end(),
                                  [&](const scene::ViewDescription& one) { return one.name.value == view.view; });
  if (shown == scene.views.end() || !shown->detail.given()) return;
  const auto detail =
      std::find_if(scene.details.begin(), scene.details.end(),
                   [&](const scene::DetailDescription& one) { return one.name.value == shown->detail.value; });
  if (detail == scene.details.end()) return;
  for (const sheet::AnchoredDimension& dimension : view.dimensions) {
    const std::vector<Vec3> places = places_of(dimension, *detail);
    if (std::any_of(places.begin(), places.end(),
                    [&](const Vec3& place) { return is_outside(*detail, view.projection, place); }))
      findings.push_back(
          {report::FindingKind::off_sheet, view.view,
           "the dimension of " + dimension.where + " ends outside the boundary of detail " + *detail->name});
  }
}

void add_distinct(std::vector<std::string>& list, std::span<const std::string> more) {
  for (const std::string& one : more)
    if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
}

// `held`: as of FreeFaces.
sheet::Coverage coverage_of(const JudgedSheets& sheets, const features::PartFeatures& features,
                            std::span<const char> held) {
  const auto& [world, scene, views] = sheets;
  const auto extents = features::true_extents(world);
  return sheet::find_coverage(views, {world, features, extents}, notation_of(world, scene.sheets.front()), held);
}

void add_uncovered_sizes(report::Report& report, const JudgedSheets& sheets, std::span<const char> held,
                         const Progress& progress) {
  const auto& [world, scene, views] = sheets;
  const features::PartFeatures features = features::features_to_dimension(world, progress);
  sheet::Coverage coverage = coverage_of(sheets, features, held);
  std::vector<report::Finding>& findings = report.findings;
  for (const std::string& what : coverage.undimensioned)
    findings.push_back({report::FindingKind::undimensioned, "", what});
  for (const std::string& what : features::unplaced_parts(features.unplaced))
    findings.push_back({report::FindingKind::undimensioned, "", what});
  if (const std::size_t small = features.of_assembly ? features::parts_without_place(world) : 0; small > 0)
    findings.push_back({report::FindingKind::undecided, "",
                        "where parts are that are smaller than a hundredth of the assembly: " + std::to_string(small)});
  for (const sheet::DimensionsInView& view : views) find_cut_off(findings, scene, view);
  for (const std::string& what : coverage.repeated) findings.push_back({report::FindingKind::repeated, "", what});
  report.sizes = std::move(coverage.counts);
  add_distinct(report.views_to_add, coverage.views_to_add);
  report.transform_to_add = std::move(coverage.transform_to_add);
}

HatchedFaces add_free_faces(report::Report& report, sheet::FreeFaces found, const Granted& granted) {
  std::set<int> faulty, accepted_free;
  for (const sheet::FreeFace& one : found.free) {
    const auto by = std::find_if(granted.accepted.begin(), granted.accepted.end(), [&](const AcceptedFaces& known) {
      return known.model == 0 && std::find(known.faces.begin(), known.faces.end(), one.face) != known.faces.end();
    });
    const std::string reason = by == granted.accepted.end() ? "" : by->reason;
    report.findings.push_back({report::FindingKind::undimensioned, "", one.sentence, one.number, reason});
    (reason.empty() ? faulty : accepted_free).insert(one.faces.begin(), one.faces.end());
  }
  for (const int face : faulty) accepted_free.erase(face);
  found.count.given += static_cast<int>(accepted_free.size());
  for (const std::string& what : found.undecided) report.findings.push_back({report::FindingKind::undecided, "", what});
  for (const std::string& what : found.contradictory)
    report.findings.push_back({report::FindingKind::contradictory, "", what});
  // From what those follow that features show to be there twice.
  const bool any_twice = std::any_of(report.findings.begin(), report.findings.end(),
                                     [](const auto& one) { return one.kind == report::FindingKind::repeated; });
  if (!any_twice) found.repeated.clear();
  for (const std::string& what : found.repeated) report.findings.push_back({report::FindingKind::follows, "", what});
  if (found.count.all > 0) report.sizes.push_back(std::move(found.count));
  return {{faulty.begin(), faulty.end()}, std::move(found.numbers)};
}

std::string one_line(const scene::NoteText& note) {
  std::string text;
  for (const std::string& line : note.lines) text += (text.empty() ? "" : " ") + line;
  return text;
}

// Each line of notes without a leader.
std::vector<std::string> general_notes(const scene::SceneDescription& scene) {
  std::vector<std::string> lines;
  for (const scene::CalloutDescription& callout : scene.callouts)
    if (const auto* note = std::get_if<scene::NoteText>(&callout.content);
        note != nullptr && !callout.to.given() && !callout.dimension.given())
      lines.insert(lines.end(), note->lines.begin(), note->lines.end());
  return lines;
}

sheet::LeaderNote leader_note(const scene::NoteText& note, const ViewCallout& callout) {
  sheet::LeaderNote found;
  found.text = one_line(note);
  if (const Vec3* at = std::get_if<Vec3>(&callout.to)) found.at = *at;
  if (const auto& rim = callout.description.rim) found.rim = {rim->centre, rim->axis, rim->radius, {}, true};
  return found;
}

}  // namespace

std::vector<sheet::DimensionsInView> anchored_dimensions(const world::World& world, const SheetOfViews& sheet,
                                                         std::span<const view::ProjectedScene> seen,
                                                         std::span<const Annotations> annotations) {
  std::vector<sheet::DimensionsInView> views;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::optional<cut::CuttingSurface>& turned = sheet.plans[i].options.turned;
    views.push_back({*sheet.descriptions[i].name, seen[i].projection,
                     sheet::find_anchors(world, turned ? annotations[i].unturned : annotations[i].dimensions)});
    views.back().has_centre_lines = sheet.plans[i].options.centre_lines;
    views.back().shows_inside = sheet.plans[i].options.shows_inside;
    for (const sheet::HoleTable& table : annotations[i].tables)
      for (const sheet::HoleRow& row : table.rows) views.back().sizes_in_tables[row.label] = row.size;
    for (const ViewCallout& callout : annotations[i].callouts)
      if (const auto* note = std::get_if<scene::NoteText>(&callout.description.content))
        views.back().notes.push_back(leader_note(*note, callout));
    if (turned) views.back().turned_about = turned->axis();
  }
  return views;
}

void leave_out(std::span<sheet::DimensionsInView> views, std::span<const std::vector<std::size_t>> numbers) {
  for (std::size_t i = 0; i < views.size(); ++i)
    for (auto number = numbers[i].rbegin(); number != numbers[i].rend(); ++number)
      views[i].dimensions.erase(views[i].dimensions.begin() + static_cast<std::ptrdiff_t>(*number));
}

HatchedFaces add_missing_sizes(report::Report& report, const JudgedSheets& sheets, const Granted& granted,
                               const Progress& progress) {
  const auto& [world, scene, views] = sheets;
  const sheet::Notation notation = notation_of(world, scene.sheets.front());
  const std::vector<std::string> general = general_notes(scene);
  const std::vector<sheet::DimensionsInView> given = sheet::with_noted_sizes(views, general, world, notation);
  sheet::FreeFaces found = sheet::find_free_faces(given, world, features::true_extents(world), notation, granted.rules);
  add_uncovered_sizes(report, {world, scene, given}, found.held, progress);
  const sheet::JudgedTexts texts = sheet::judge_texts(views, general, world, notation);
  for (const std::string& what : texts.untrue) report.findings.push_back({report::FindingKind::untrue, "", what});
  for (const std::string& what : texts.unjudged) report.findings.push_back({report::FindingKind::unjudged, "", what});
  return add_free_faces(report, std::move(found), granted);
}

std::vector<std::string> views_for_sizes(const JudgedSheets& sheets, const Progress& progress) {
  return coverage_of(sheets, features::features_to_dimension(sheets.world, progress), {}).views_to_add;
}

void add_illegible_texts(report::Report& report, std::span<const FinishedSheet> sheets) {
  for (const FinishedSheet& sheet : sheets)
    for (report::Finding& found : illegible_texts(sheet.sheet)) report.findings.push_back(std::move(found));
}

void warn_of_vain(const Messages& messages, std::span<const AcceptedFaces> accepted,
                  std::span<const report::Finding> findings) {
  for (const AcceptedFaces& one : accepted)
    if (std::none_of(findings.begin(), findings.end(),
                     [&one](const report::Finding& finding) { return finding.accepted == one.reason; }))
      messages.warn("nothing is found of the accepted " + one.feature + "\n  hint: remove it from the scene");
}

void add_missing_requirements(report::Report& report, std::span<const std::string> views) {
  add_distinct(report.views_to_add, views);
  for (const report::RequirementRow& row : report.requirements)
    if (row.is_missing())
      report.findings.push_back(
          {report::FindingKind::not_drawn, "",
           row.model + ", " + row.id + ": " + row.what + (row.why.empty() ? "" : ", " + row.why)});
}

std::vector<report::Finding> undefined_free_forms(const world::World& world, const scene::SceneDescription& scene,
                                                  bool noted) {
  std::vector<report::Finding> findings;
  for (const std::string& what : free_forms_without_tolerance(scene, world, noted))
    findings.push_back({report::FindingKind::undimensioned, "", what});
  return findings;
}

}  // namespace epura::pipeline
