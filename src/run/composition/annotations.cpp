// SPDX-License-Identifier: Apache-2.0
#include "composition/annotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "annotations/cutting_plane_line.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/seen_marks.hpp"
#include "features/assembly_features.hpp"
#include "features/true_extents.hpp"
#include "sizes/anchors.hpp"
#include "sizes/automatic.hpp"
#include "sizes/matches.hpp"
#include "sizes/overall.hpp"
#include "sizes/pictorial.hpp"
#include "sizes/thread_notes.hpp"
#include "sizes/twins.hpp"
#include "views/arrow_views.hpp"
#include "views/breaks.hpp"
#include "views/mass.hpp"

namespace epura::pipeline {

namespace {

bool is_open(const scene::DimensionDescription& dimension) {
  return dimension.type.value == DimensionType::automatic ||
         (dimension.type.value == DimensionType::overall && !dimension.direction.given());
}

const std::string& view_of(const scene::DimensionDescription& dimension, const scene::SceneDescription& scene) {
  return dimension.view.given() ? *dimension.view : *scene.views.front().name;
}

// Up to which distance points are on a plane of an aligned section: they are given with few decimals.
double on_plane(const world::World& world) { return 1e-3 * glm::length(world.box.size()); }

// A section may have cut off an end of the models: it shows their size only if no other view does. Details never do.
std::vector<sheet::NamedProjection> views_to_measure(const world::World& world,
                                                     std::span<const scene::ViewDescription> views,
                                                     std::span<const PlannedView> plans,
                                                     std::span<const view::ProjectedScene> seen,
                                                     const SectionSurfaces& sections) {
  std::vector<sheet::NamedProjection> whole, cut;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (views[i].detail.given() || plans[i].options.exploded) continue;
    sheet::NamedProjection& view = (views[i].section.given() ? cut : whole).emplace_back();
    view.name = *views[i].name;
    view.projection = seen[i].projection;
    view.slack = on_plane(world);
    view.shows_inside = plans[i].options.shows_inside;
    if (const auto section = sections.find(views[i].section.value_or("")); section != sections.end())
      view.section = &section->second;
  }
  whole.insert(whole.end(), cut.begin(), cut.end());
  return whole;
}

// How an aligned section turns what is at a point of the models.
Mat4 turn_at(const Vec3& point, const world::World& world, const ViewOptions& options, const std::string& where) {
  if (const auto turn = cut::turn_at(*options.turned, point, on_plane(world))) return *turn;
  throw Error(ErrorKind::input, where,
              "view '" + options.name + "' shows an aligned section, which leaves this point of the models out",
              "choose a point on one of its planes, or behind it");
}

// Where a view shows a point of the models.
Vec3 shown_at(const Vec3& point, const world::World& world, const ViewOptions& options, const std::string& where) {
  return options.turned ? Vec3(turn_at(point, world, options, where) * Vec4(point, 1)) : point;
}

// Whether a view along `n` shows a circle as such, or a diameter as a length.
bool shows(const Vec3& n, const sheet::WorldCircle& circle, bool is_diameter) {
  constexpr double parallel = 1e-6;
  const double along = std::abs(glm::dot(circle.axis, n));
  return along >= 1 - parallel || (is_diameter && circle.whole && along <= parallel);
}

// A circle of the models as an aligned section shows it: turned with the anchor of its dimension.
void turn_circle(scene::DimensionDescription& dimension, const world::World& world, const ViewOptions& options) {
  const sheet::AnchoredDimension anchored = sheet::find_anchors(world, {&dimension, 1}).front();
  const Vec3& anchor = dimension.circle ? dimension.circle->centre : anchored.points.front();
  const Mat4 turn = turn_at(anchor, world, options, dimension.where);
  std::vector<sheet::WorldCircle> circles = anchored.circles;
  for (sheet::WorldCircle& circle : circles) {
    circle.centre = Vec3(turn * Vec4(circle.centre, 1));
    circle.axis = Vec3(turn * Vec4(circle.axis, 0));
    for (Vec3& point : circle.rim) point = Vec3(turn * Vec4(point, 1));
  }
  const auto shown = std::find_if(circles.begin(), circles.end(), [&](const sheet::WorldCircle& circle) {
    return shows(options.turned->plane.normal, circle, *dimension.type == DimensionType::diameter);
  });
  const sheet::WorldCircle& circle = shown != circles.end() ? *shown : circles.front();
  dimension.circle = {circle.centre, circle.axis, circle.radius, circle.whole ? std::vector<Vec3>() : circle.rim};
}

// A dimension as a view shows it, whose parts may be turned. Ends of lengths are already there if the dimension is
// found. Throws Error{input} for exploded views.
scene::DimensionDescription shown_dimension(scene::DimensionDescription dimension, const world::World& world,
                                            const ViewOptions& options, bool is_found) {
  if (options.exploded)
    throw Error(ErrorKind::input, dimension.where, "view '" + options.name + "' is exploded and has no dimensions",
                "dimension a view of the whole assembly");
  if (!options.turned) return dimension;
  const DimensionType type = dimension.type.value_or(DimensionType::linear);
  if (type == DimensionType::radius || type == DimensionType::diameter || type == DimensionType::arc) {
    turn_circle(dimension, world, options);
    return dimension;
  }
  if (is_found) return dimension;
  for (scene::Anchor& anchor : dimension.anchors)
    anchor = shown_at(sheet::position_of(world, anchor, dimension.where), world, options, dimension.where);
  return dimension;
}

// Those that somebody asked for take the places of automatic ones in any view.
void replace_found(std::vector<std::vector<scene::DimensionDescription>>& found, std::vector<Annotations>& annotations,
                   const world::World& world, const features::PartFeatures& features,
                   std::span<const sheet::NamedProjection> projections) {
  std::vector<scene::DimensionDescription*> given;
  for (Annotations& of_view : annotations)
    for (scene::DimensionDescription& one : of_view.dimensions) given.push_back(&one);
  if (given.empty()) return;
  for (std::vector<scene::DimensionDescription>& of_view : found)
    sheet::replace_twins(of_view, given, world, features, projections);
}

template <class Element>
void append(std::vector<Element>& to, std::vector<Element> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

// Where automatic notes of several features may stand, too.
void add_equal(Annotations& of_view, std::span<const scene::DimensionDescription> found,
               const features::PartFeatures& features, std::span<const sheet::NamedProjection> views) {
  for (const scene::DimensionDescription& one : found) {
    of_view.equal.push_back(sheet::equal_circles(one, of_view.dimensions, features));
    if (sheet::only_pictorial(views, *one.view) != nullptr) append(of_view.equal.back(), sheet::rims_of(one, features));
  }
}

// What somebody asked for in each view, if there is one sheet.
std::optional<std::vector<sheet::DimensionsInView>> given_dimensions(const world::World& world,
                                                                     const scene::SceneDescription& scene,
                                                                     const SheetOfViews& sheet,
                                                                     std::span<const view::ProjectedScene> seen) {
  if (scene.sheets.size() > 1) return std::nullopt;
  std::vector<sheet::DimensionsInView> views;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    std::vector<scene::DimensionDescription> own;
    for (const scene::DimensionDescription& one : scene.dimensions)
      if (!is_open(one) && !one.match.given() && view_of(one, scene) == *sheet.descriptions[i].name) own.push_back(one);
    if (own.empty() || sheet.plans[i].options.exploded) continue;
    views.push_back({*sheet.descriptions[i].name, seen[i].projection, sheet::find_anchors(world, own)});
    if (const auto& turned = sheet.plans[i].options.turned) views.back().turned_about = turned->axis();
  }
  return views;
}

// Automatic dimensions of which the scene says more are asked for: little room is no reason to leave them out.
void match_found(std::vector<std::vector<scene::DimensionDescription>>& found, std::vector<Annotations>& annotations,
                 const world::World& world, const scene::SceneDescription& scene,
                 std::span<const sheet::NamedProjection> projections, const sheet::Notation& notation) {
  std::vector<scene::DimensionDescription> wishes;
  for (const scene::DimensionDescription& one : scene.dimensions)
    if (one.match.given()) wishes.push_back(one);
  if (wishes.empty()) return;
  const auto is_overall = [](const auto& one) { return one.type.value == DimensionType::overall; };
  for (std::size_t i = 0; i < found.size(); ++i) {
    Annotations& of_view = annotations[i];
    std::vector<scene::DimensionDescription> overall;
    std::copy_if(of_view.dimensions.begin(), of_view.dimensions.end(), std::back_inserter(overall), is_overall);
    std::erase_if(of_view.dimensions, is_overall);
    for (auto* automatic : {&overall, &found[i]}) {
      sheet::Matches matches = sheet::take_matches(*automatic, wishes, world, projections, notation);
      append(of_view.dimensions, std::move(matches.matched));
      of_view.sizes.add({std::move(matches.sizes), std::move(matches.met), std::move(matches.others)});
    }
    append(of_view.dimensions, std::move(overall));
  }
}

// Tables are of their views; what has no dimension is told once.
void keep_rest(sheet::AutomaticPlan& plan, std::vector<Annotations>& annotations,
               std::span<const scene::ViewDescription> views) {
  for (const sheet::HoleTable& table : plan.tables)
    for (std::size_t i = 0; i < views.size(); ++i)
      if (*views[i].name == table.view) annotations[i].tables.push_back(table);
  annotations.front().omitted.append(std::move(plan.omitted));
}

// Where two views look along one axis, what one hides may be seen in the other.
std::vector<sheet::NamedProjection> with_faces(std::vector<sheet::NamedProjection> views, const world::World& world) {
  for (sheet::NamedProjection& view : views) {
    const auto is_along = [&view](const sheet::NamedProjection& other) {
      return &other != &view && std::abs(glm::dot(other.projection.n, view.projection.n)) >= 1 - max_tilt * max_tilt;
    };
    if (view.section != nullptr || !projection::is_orthographic(view.projection) ||
        std::ranges::none_of(views, is_along))
      continue;
    const auto faces = std::make_shared<const FaceView>(view.name, view.projection, world);
    view.shows = [faces](const Vec3& point) { return faces->shows(point); };
  }
  return views;
}

void add_dimensions(std::vector<Annotations>& annotations, const world::World& world,
                    const scene::SceneDescription& scene, const SheetOfViews& sheet,
                    std::span<const view::ProjectedScene> seen, const SectionSurfaces& sections) {
  const std::vector<scene::ViewDescription>& views = sheet.descriptions;
  std::optional<std::array<features::Extent, 3>> extents;
  std::optional<features::PartFeatures> known;
  const auto features = [&]() -> const features::PartFeatures& {
    return known ? *known : known.emplace(features::features_to_dimension(world));
  };
  std::vector<sheet::NamedProjection> projections = views_to_measure(world, views, sheet.plans, seen, sections);
  if (dimensions_features(scene)) projections = with_faces(std::move(projections), world);
  const auto here = [&views](const std::string& name) {
    return std::find_if(views.begin(), views.end(), [&](const scene::ViewDescription& v) { return *v.name == name; });
  };
  const sheet::Notation notation = notation_of(world, scene.sheets[static_cast<std::size_t>(sheet.sheet)]);
  std::vector<std::vector<scene::DimensionDescription>> found(views.size());
  const auto add_to = [&](const scene::DimensionDescription& dimension, bool is_given) {
    const auto view = here(view_of(dimension, scene));
    if (view == views.end()) return;
    const auto number = std::size_t(view - views.begin());
    auto& dimensions = is_given ? annotations[number].dimensions : found[number];
    dimensions.push_back(dimension);
    dimensions.back().view = {*views[number].name, dimension.view.where};
  };
  const auto add = [&](const scene::DimensionDescription& dimension) { add_to(dimension, true); };
  const auto is_outside = [&](const scene::DimensionDescription& dimension) {
    const auto view = std::size_t(here(view_of(dimension, scene)) - views.begin());
    return view < views.size() && is_left_out(dimension, world, sheet.plans[view].options.breaks, seen[view]);
  };
  if (!scene.threads.empty() && sheet.sheet == 0 && !dimensions_features(scene)) {
    for (const scene::DimensionDescription& one :
         sheet::thread_dimensions(scene.threads, projections, features::find_part_features(world), notation))
      if (!is_outside(one)) add(one);
  }
  for (const scene::DimensionDescription& dimension : scene.dimensions) {
    if (dimension.match.given()) continue;
    if (!is_open(dimension)) {
      add(dimension);
    } else if (dimension.view.given() ? here(*dimension.view) != views.end() : sheet.sheet == 0) {
      if (!extents) extents = features::true_extents(world);
      const auto expanded = [&] {
        if (const auto* view = sheet::only_pictorial(projections, dimension.view.value_or(""))) {
          return sheet::pictorial_dimensions(dimension, *view, {world, features(), *extents}, notation);
        }
        if (*dimension.type == DimensionType::overall)
          return sheet::overall_dimensions(dimension, projections, *extents);
        sheet::AutomaticPlan plan = sheet::automatic_dimensions(dimension, projections, {world, features(), *extents},
                                                                notation, given_dimensions(world, scene, sheet, seen));
        keep_rest(plan, annotations, views);
        return std::move(plan.dimensions);
      };
      for (const scene::DimensionDescription& one : expanded())
        if (!is_outside(one)) add_to(one, *dimension.type == DimensionType::overall);
    }
  }
  if (known) annotations.front().unplaced = known->unplaced;
  if (known) replace_found(found, annotations, world, features(), projections);
  match_found(found, annotations, world, scene, projections, notation);
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::vector<scene::DimensionDescription>& dimensions = annotations[i].dimensions;
    annotations[i].found = found[i].size();
    if (known && !sheet.plans[i].options.turned) add_equal(annotations[i], found[i], *known, projections);
    dimensions.insert(dimensions.begin(), std::make_move_iterator(found[i].begin()),
                      std::make_move_iterator(found[i].end()));
    if (sheet.plans[i].options.turned) annotations[i].unturned = dimensions;
    for (std::size_t number = 0; number < dimensions.size(); ++number)
      dimensions[number] =
          shown_dimension(std::move(dimensions[number]), world, sheet.plans[i].options, number < annotations[i].found);
  }
}

// The view that marks the plane of a section: the one beside which the section is, otherwise the first uncut one that
// sees it edge-on, or another section.
std::optional<std::size_t> view_with_plane(const SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                                           const cut::CuttingSurface& section) {
  const std::string& name = section.plane.name;
  const auto rank = [&](std::size_t i) -> std::optional<int> {
    const scene::ViewDescription& view = sheet.descriptions[i];
    if (view.detail.given() || view.section.value == name || !sheet::sees_edge_on(seen[i].projection, section))
      return std::nullopt;
    for (std::size_t shown = 0; shown < seen.size(); ++shown)
      if (sheet.descriptions[shown].section.value == name && parent_of(sheet, shown) == i) return 0;
    return view.section.given() ? 2 : 1;
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (const auto one = rank(i); one && (!best || *one < *rank(*best))) best = i;
  return best;
}

void add_planes(std::vector<Annotations>& annotations, const SheetOfViews& sheet,
                std::span<const view::ProjectedScene> seen, const SectionSurfaces& sections) {
  for (const auto& [name, section] : sections) {
    const auto shows = [&name = name](const scene::ViewDescription& view) { return view.section.value == name; };
    if (std::none_of(sheet.descriptions.begin(), sheet.descriptions.end(), shows)) continue;
    if (const auto view = view_with_plane(sheet, seen, section)) annotations[*view].planes.push_back(section);
  }
}

void add_details(std::vector<Annotations>& annotations, const scene::SceneDescription& scene,
                 std::span<const scene::ViewDescription> views) {
  for (const scene::DetailDescription& detail : scene.details) {
    const auto shows = [&](const scene::ViewDescription& view) { return view.detail.value == *detail.name; };
    if (std::none_of(scene.views.begin(), scene.views.end(), shows)) continue;
    for (std::size_t i = 0; i < views.size(); ++i)
      if (*views[i].name == *detail.view) annotations[i].details.push_back(detail);
  }
}

void add_callouts(std::vector<Annotations>& annotations, const world::World& world,
                  const scene::SceneDescription& scene, const SheetOfViews& sheet) {
  for (const scene::CalloutDescription& callout : scene.callouts) {
    if (callout.dimension.given())
      for (std::size_t i = 0; i < annotations.size(); ++i)
        if (*sheet.descriptions[i].name == view_of_callout(callout, scene)) annotations[i].attached.push_back(callout);
    if (!callout.to.given()) continue;
    const std::string& name = callout.view.given() ? *callout.view : *scene.views.front().name;
    for (std::size_t i = 0; i < annotations.size(); ++i) {
      if (*sheet.descriptions[i].name != name) continue;
      const auto* anchor = std::get_if<scene::Anchor>(&*callout.to);
      const ViewOptions& options = sheet.plans[i].options;
      if (anchor != nullptr && options.exploded)
        throw Error(ErrorKind::input, callout.to.where,
                    "view '" + name + "' is exploded, where points of the models have moved",
                    "write where the leader ends on the sheet: to = {page = [x, y]}");
      if (anchor != nullptr)
        annotations[i].callouts.push_back(
            {callout, shown_at(sheet::position_of(world, *anchor, callout.to.where), world, options, callout.to.where),
             options.turned.has_value()});
      else
        annotations[i].callouts.push_back({callout, std::get<Vec2>(*callout.to)});
    }
  }
}

// Items may have their balloons in any whole view of the sheet; in exploded ones if there are any, which are for this.
void add_balloons(std::vector<Annotations>& annotations, const scene::SceneDescription& scene,
                  const SheetOfViews& sheet) {
  if (sheet.items.empty() || !scene.parts_list->balloons.value_or(true)) return;
  const auto exploded = [](const PlannedView& plan) { return plan.options.exploded; };
  const bool any_exploded = std::any_of(sheet.plans.begin(), sheet.plans.end(), exploded);
  const scene::LocatedText& wanted = scene.parts_list->view;
  for (std::size_t i = 0; i < sheet.plans.size(); ++i)
    annotations[i].balloons =
        wanted.given() ? *wanted == *sheet.descriptions[i].name
                       : !sheet.descriptions[i].detail.given() && (exploded(sheet.plans[i]) || !any_exploded);
}

}  // namespace

std::vector<Annotations> annotate(const world::World& world, const scene::SceneDescription& scene,
                                  const SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                                  const SectionSurfaces& sections) {
  std::vector<Annotations> annotations(sheet.descriptions.size());
  add_dimensions(annotations, world, scene, sheet, seen, sections);
  add_planes(annotations, sheet, seen, sections);
  add_details(annotations, scene, sheet.descriptions);
  add_callouts(annotations, world, scene, sheet);
  add_balloons(annotations, scene, sheet);
  for (std::size_t i = 0; i < annotations.size(); ++i) {
    const scene::Located<bool>& wanted = sheet.descriptions[i].centre_of_gravity;
    if (wanted.value_or(false) && !sheet.plans[i].options.exploded)
      annotations[i].centre_of_gravity = mass_of(world, scene, false, wanted.where).centre;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto parent = parent_of(sheet, i);
    const scene::ViewDescription& view = sheet.descriptions[i];
    // The arrows of a cutting plane say where its view is seen from.
    const auto is_shown = [&](const cut::CuttingSurface& plane) { return view.section.value == plane.plane.name; };
    if (!parent || std::any_of(annotations[*parent].planes.begin(), annotations[*parent].planes.end(), is_shown))
      continue;
    annotations[*parent].arrows.push_back({view.label.given() ? *view.label : *view.section,
                                           sight_on_page(seen[*parent].projection, seen[i].projection.n)});
  }
  return annotations;
}

bool follows_asme(const scene::SheetDescription& sheet) {
  return sheet.field("standard").find("ASME") != std::string::npos;
}

sheet::Notation notation_of(const world::World& world, const scene::SheetDescription& sheet) {
  const Vec3 size = world.box.max - world.box.min;
  const Unit unit = sheet.dimension_unit.value_or(Unit::mm);
  const int usual = sheet::usual_decimals(std::max({size.x, size.y, size.z}), unit);
  return {sheet.decimals.value_or(usual), unit, sheet.decimal_sign.value_or(DecimalSign::point), follows_asme(sheet)};
}

void expect_views_of_annotations(const scene::SceneDescription& scene) {
  std::vector<std::string> names;
  for (const scene::ViewDescription& view : scene.views) names.push_back(*view.name);
  const auto expect = [&names](const scene::LocatedText& view) {
    if (view.given() && std::count(names.begin(), names.end(), *view) == 0)
      throw Error(ErrorKind::input, view.where, "there is no view '" + *view + "'", did_you_mean(*view, names));
  };
  for (const scene::DimensionDescription& dimension : scene.dimensions) expect(dimension.view);
  const auto expect_sheet = [&scene](const scene::Located<int>& sheet, const std::string& what) {
    const int sheets = static_cast<int>(scene.sheets.size());
    if (sheet.value_or(1) > sheets)
      throw Error(ErrorKind::input, sheet.where,
                  what + " is for sheet " + std::to_string(*sheet) + " of " + std::to_string(sheets),
                  "add a [[sheet]]");
  };
  for (const scene::CalloutDescription& callout : scene.callouts) {
    expect(callout.view);
    expect_sheet(callout.sheet, name_of(callout));
  }
  expect_datums(scene);
  for (const scene::TableDescription& table : scene.tables) expect_sheet(table.sheet, "the table");
  for (const scene::RevisionDescription& revision : scene.revisions)
    expect_sheet(revision.sheet, "revision " + *revision.revision);
  if (!scene.parts_list) return;
  const scene::PartsListDescription& list = *scene.parts_list;
  expect(list.view);
  expect_sheet(list.sheet, "the parts list");
  if (list.view.given() && list.balloons.value_or(true))
    for (const scene::ViewDescription& view : scene.views)
      if (*view.name == *list.view && view.sheet.value_or(1) != list.sheet.value_or(1))
        throw Error(ErrorKind::input, list.view.where,
                    "view '" + *list.view + "' is not on the sheet of the parts list",
                    "balloons are beside the list that explains them");
}

}  // namespace epura::pipeline
