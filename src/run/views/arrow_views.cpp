// SPDX-License-Identifier: Apache-2.0
#include "views/arrow_views.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::pipeline {

namespace {

std::optional<std::size_t> find_view(const SheetOfViews& sheet, const std::string& name) {
  const auto found = std::find_if(sheet.descriptions.begin(), sheet.descriptions.end(),
                                  [&](const scene::ViewDescription& view) { return *view.name == name; });
  if (found == sheet.descriptions.end()) return std::nullopt;
  return static_cast<std::size_t>(found - sheet.descriptions.begin());
}

std::string words_of(const Vec3& v) { return format_number(v.x) + "," + format_number(v.y) + "," + format_number(v.z); }

void expect_true_length(const scene::ViewDescription& view, const projection::Projection& parent, const Vec3& from) {
  if (is_orthographic(parent) && std::abs(glm::dot(from, parent.n)) <= parallel_sine) return;
  throw Error(ErrorKind::input, view.from.where,
              "view '" + *view.of + "' does not show the direction " + words_of(*view.from) + " in true length",
              "choose a parent that looks along a perpendicular direction");
}

// The direction of the world that is upwards in a view from `from` (length 1), folded about a line of the parent that
// is perpendicular to it.
Vec3 upwards(const projection::Projection& parent, const Vec3& from) {
  const Vec2 sight = sight_on_page(parent, from);
  const Vec2 fold(-sight.y, sight.x), across = -sight;  // on the page; `across` is to the left of `fold`
  const Vec3 along_fold = fold.x * parent.u + fold.y * parent.v;
  return fold.y * along_fold + across.y * glm::cross(from, along_fold);
}

}  // namespace

Vec2 sight_on_page(const projection::Projection& parent, const Vec3& from) {
  return -glm::normalize(Vec2(glm::dot(from, parent.u), glm::dot(from, parent.v)));
}

std::optional<std::size_t> parent_of(const SheetOfViews& sheet, std::size_t view) {
  const scene::LocatedText& of = sheet.descriptions[view].of;
  return of.given() ? find_view(sheet, *of) : std::nullopt;
}

void orient_arrow_views(SheetOfViews& sheet, const std::function<const world::World&(std::size_t)>& world) {
  for (std::size_t i = 0; i < sheet.plans.size(); ++i) {
    // A detail has the projection of the view that it enlarges.
    const auto& detail = sheet.plans[i].options.detail;
    const auto shown = detail ? find_view(sheet, *detail->view) : std::optional(i);
    if (!shown || !sheet.descriptions[*shown].of.given()) continue;
    const scene::ViewDescription& view = sheet.descriptions[*shown];
    const auto parent = parent_of(sheet, *shown);
    if (!parent)
      throw Error(ErrorKind::input, view.of.where, "view '" + *view.of + "' is on another sheet",
                  "give both views the same 'sheet'");
    const PlannedView& plan = sheet.plans[*parent];
    const projection::Projection seen = projection::make_projection(plan.entry, plan.request, world(*parent).box);
    const Vec3 from = glm::normalize(*view.from);
    expect_true_length(view, seen, from);
    sheet.plans[i].request.assignments.emplace_back("up", words_of(upwards(seen, from)));
  }
}

}  // namespace epura::pipeline
