// SPDX-License-Identifier: Apache-2.0
#include "sizes/automatic.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "features/assembly_features.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/cone_dimensions.hpp"
#include "sizes/cylinder_dimensions.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/free_face_dimensions.hpp"
#include "sizes/hexagon_widths.hpp"
#include "sizes/hole_dimensions.hpp"
#include "sizes/place_joins.hpp"
#include "sizes/planning.hpp"
#include "sizes/prism_dimensions.hpp"
#include "sizes/radius_dimensions.hpp"
#include "sizes/ring_dimensions.hpp"
#include "sizes/slope_dimensions.hpp"

namespace epura::sheet {

namespace {

using scene::DimensionDescription;

// Whether the radius of a round end and the place of its centre give the size over it: it bulges beyond all plane
// faces, or is as wide as the models.
bool is_over_round_end(const Planning& plan, int axis) {
  const std::vector<RoundEnd>& ends = plan.table.round_ends;
  const auto& flat = plan.table.flat_ends[static_cast<std::size_t>(axis)];
  return std::any_of(ends.begin(), ends.end(), [&](const RoundEnd& end) {
    const bool low = end.ends_models(axis, 0, plan.extent(axis)), high = end.ends_models(axis, 1, plan.extent(axis));
    return plan.views.along(end.axis) != nullptr &&
           ((low && high) || (low && !flat[0] && end.bulges(axis, 0)) || (high && !flat[1] && end.bulges(axis, 1)));
  });
}

// Those that follow from other sizes are auxiliary.
Planned overall_sizes(const Planning& plan, std::span<const NamedProjection> views) {
  DimensionDescription overall = plan.wanted;
  overall.type = {DimensionType::overall, plan.wanted.type.where};
  overall.anchors.clear();
  overall.circle.reset();
  Planned planned{overall_dimensions(overall, views, plan.subject.extents)};
  for (DimensionDescription& dimension : planned.dimensions)
    if (const int axis = axis_of(*dimension.direction); is_over_round_end(plan, axis) ||
                                                        is_across_corners(plan, axis) ||
                                                        is_over_turned_part(plan, axis) || is_over_slope(plan, axis))
      dimension.text = {"(<>)", plan.wanted.where};
  return planned;
}

// The radius of a round end is half of the width of a bar, and its distance from the faces that are tangent to it.
Planned places_beside_round_ends(const Planning& plan) {
  Planned planned;
  for (const RoundEnd& end : plan.table.round_ends)
    for (int axis = 0; axis < 3; ++axis) {
      const bool low = end.ends_models(axis, 0, plan.extent(axis)), high = end.ends_models(axis, 1, plan.extent(axis));
      if ((low && high) || (low && end.has_side(axis, 0)) || (high && end.has_side(axis, 1)))
        planned.places.emplace_back(KnownPlace{axis, end.centre[axis]});
    }
  for (const std::vector<RoundEnd>* ends : {&plan.table.round_ends, &plan.table.channels})
    for (const RoundEnd& end : *ends)
      for (int axis = 0; axis < 3 && plan.views.along(end.axis) != nullptr; ++axis)
        for (const int side : {0, 1})
          if (end.has_side(axis, side)) planned.places.emplace_back(KnownPlace{axis, end.at_side(axis, side)});
  return planned;
}

Planned dimensions_of_features(const Planning& plan, std::span<const NamedProjection> views) {
  Planned planned = overall_sizes(plan, views);
  if (features::has_too_many_parts(plan.subject.features)) {
    planned.append(holes_left_out(plan));
    return planned;
  }
  planned.append(places_beside_round_ends(plan));
  planned.append(hexagon_dimensions(plan));
  planned.append(radial_hole_dimensions(plan));
  planned.append(hole_dimensions(plan));
  planned.append(pitch_circle_dimensions(plan));
  planned.append(cylinder_dimensions(plan));
  planned.append(slot_dimensions(plan));
  planned.append(prism_dimensions(plan));
  planned.append(arc_positions(plan));
  planned.append(ball_positions(plan));
  planned.append(arc_dimensions(plan));
  planned.append(round_dimensions(plan, planned.dimensions));
  planned.append(ball_dimensions(plan, planned.dimensions));
  planned.append(chamfer_dimensions(plan));
  planned.append(cone_dimensions(plan));
  planned.append(ring_dimensions(plan));
  planned.append(slope_dimensions(plan));
  return planned;
}

// Aligned sections count where no other view does.
std::vector<const NamedProjection*> in_order(const ViewChoice& views) {
  std::vector<const NamedProjection*> all = views.all();
  all.insert(all.end(), views.aligned().begin(), views.aligned().end());
  return all;
}

// What others say of places.
void join_given(Coordinates& coordinates, std::span<const DimensionsInView> given) {
  for (const DimensionsInView& view : given)
    for (const AnchoredDimension& dimension : view.dimensions) {
      const std::optional<Vec3> along = measured_along(dimension, view);
      const int axis = along && !dimension.arrangement && !is_auxiliary(dimension) ? world_axis(*along) : -1;
      if (axis >= 0) coordinates.join(axis, dimension.points[0][axis], dimension.points[1][axis]);
    }
}

// Each place once, unless it is known before.
Planned position_dimensions(const Planning& plan, const Planned& planned, std::span<const DimensionsInView> given) {
  Coordinates coordinates(plan.subject, plan.datums, plan.table.round_ends, in_order(plan.views));
  std::vector<SlantedPlace> slanted;
  for (const auto& place : planned.places)
    if (const auto* known = std::get_if<KnownPlace>(&place))
      coordinates.know(known->axis, known->at);
    else if (const auto* coordinate = std::get_if<Coordinate>(&place))
      coordinates.add(*coordinate);
    else
      slanted.push_back(std::get<SlantedPlace>(place));
  Planned positions = level_positions(plan.subject, plan.views, coordinates);
  for (const auto& level : positions.places) coordinates.add(std::get<Coordinate>(level));
  positions.places.clear();
  join_given(coordinates, given);
  positions.append({slanted_dimensions(plan, slanted)});
  positions.append({coordinates.dimensions(plan.wanted, plan.notation)});
  check(positions.places.empty(), "each place has its dimension");
  return positions;
}

// Machines of a hundred parts have more features than a sheet has room for.
Planned without_excess(Planned planned) {
  std::map<std::pair<std::string, int>, std::size_t> count;
  std::erase_if(planned.dimensions, [&](const DimensionDescription& dimension) {
    if (dimension.is_label) return false;
    const int row = dimension.direction.given() ? static_cast<int>(*dimension.direction) : -1;
    if (++count[{*dimension.view, row}] <= max_of_a_kind) return false;
    ++planned.omitted.too_many[*dimension.view];
    return true;
  });
  return planned;
}

Planned with_positions(const Planning& plan, const Planned& planned, std::span<const DimensionsInView> given) {
  Planned all = planned;
  all.append(position_dimensions(plan, planned, given));
  return all;
}

// What a sheet says with automatic dimensions beside those that are given.
std::vector<DimensionsInView> with_others(std::span<const DimensionsInView> given,
                                          const std::vector<DimensionDescription>& dimensions,
                                          std::span<const NamedProjection> views, const world::World& world) {
  std::vector<DimensionsInView> all(given.begin(), given.end());
  for (const NamedProjection& view : views) {
    std::vector<DimensionDescription> own;
    std::copy_if(dimensions.begin(), dimensions.end(), std::back_inserter(own),
                 [&](const DimensionDescription& one) { return *one.view == view.name; });
    all.push_back({view.name, view.projection, find_anchors(world, own)});
    if (view.aligned()) all.back().turned_about = view.section->axis();
  }
  return all;
}

}  // namespace

AutomaticPlan automatic_dimensions(const DimensionDescription& wanted, std::span<const NamedProjection> views,
                                   const DimensionSubject& subject, const Notation& notation,
                                   const std::optional<std::vector<DimensionsInView>>& given) {
  if (wanted.tolerance.given() || wanted.limits.given())
    throw Error(ErrorKind::input, wanted.tolerance.given() ? wanted.tolerance.where : wanted.limits.where,
                "automatic dimensions have no common tolerance",
                "add a [[dimension]] for the size, or general_tolerance to the [title_block]");
  const Planning plan(wanted, views, subject, notation);
  Planned planned = dimensions_of_features(plan, views);
  const std::span<const DimensionsInView> others =
      given ? std::span<const DimensionsInView>(*given) : std::span<const DimensionsInView>();
  Planned all = with_positions(plan, planned, others);
  FreeFaceDimensions of_faces;
  if (given && !wanted.view.given())
    of_faces = dimensions_of_free_faces(plan, with_others(*given, all.dimensions, views, subject.world));
  Planned& missing = of_faces.planned;
  if (!missing.dimensions.empty() || !missing.places.empty() || !missing.omitted.too_many.empty()) {
    // Before places that are thought to be known.
    std::swap(planned.places, missing.places);
    planned.append(std::move(missing));
    all = with_positions(plan, planned, others);
  }
  if (of_faces.are_all) all.omitted.askew.clear();
  for (const DimensionDescription& dimension : all.dimensions)
    check(dimension.view.given() && dimension.type.given(), "an automatic dimension has a type and a view");
  all = without_excess(std::move(all));
  return {std::move(all.dimensions), std::move(all.tables), std::move(all.omitted)};
}

}  // namespace epura::sheet
