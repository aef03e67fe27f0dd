// SPDX-License-Identifier: Apache-2.0
#include "sizes/cylinder_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/thread_notes.hpp"

namespace epura::sheet {

namespace {

using features::are_on_one_axis;
using features::are_parallel;
using features::are_same;
using features::CylinderFeature;
using features::SlotFeature;
using CylinderGroup = std::vector<const CylinderFeature*>;

// The end of a cylinder from which extension lines to the outside are short.
Vec3 outer_end(const CylinderFeature& cylinder, const Vec3& middle) {
  const auto off = [&](const Vec3& p) { return std::abs(glm::dot(p - middle, cylinder.axis)); };
  return off(cylinder.from) > off(cylinder.to) ? cylinder.from : cylinder.to;
}

// Useful lengths of threads, as positions of their ends.
Planned ends_of_threads(const CylinderGroup& group, const NamedProjection& view) {
  Planned planned;
  for (const CylinderFeature* cylinder : group) {
    const int axis = world_axis(cylinder->axis);
    if (axis < 0 || !cylinder->thread || !cylinder->thread->length) continue;
    const bool horizontal = std::abs(view.projection.u[axis]) > 0.5;
    const Vec3 towards = cylinder->called() * (horizontal ? -view.projection.v : view.projection.u);
    const Vec3& end = cylinder->thread->end;
    planned.places.emplace_back(Coordinate{&view, axis, end[axis], end + towards, -1, end - towards});
  }
  return planned;
}

double length_of(const CylinderFeature& cylinder) { return glm::distance(cylinder.from, cylinder.to); }

// Whether what lies between two equal cylinders on one axis is a groove, and no collar or shoulder: it is not longer
// than the shorter one.
bool are_parted_by_groove(const CylinderFeature& a, const CylinderFeature& b,
                          const std::vector<CylinderFeature>& cylinders) {
  if (!are_on_one_axis(a, b)) return false;
  const auto middle = [&](const CylinderFeature& one) { return glm::dot((one.from + one.to) / 2.0, a.axis); };
  const auto [low, high] = std::minmax({middle(a), middle(b)});
  const double apart = high - low - (length_of(a) + length_of(b)) / 2;
  if (apart > (1 + features::same_size) * std::min(length_of(a), length_of(b))) return false;
  bool any = false;
  for (const CylinderFeature& one : cylinders) {
    if (!are_on_one_axis(a, one) || middle(one) <= low || middle(one) >= high || are_same(one.radius, a.radius))
      continue;
    if ((one.radius > a.radius) != a.inwards) return false;
    any = true;
  }
  return any;
}

// Those that grooves part are one.
std::size_t count_cylinders(const CylinderGroup& group, const std::vector<CylinderFeature>& cylinders) {
  DisjointSets sets(group.size());
  std::size_t count = group.size();
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const int one = static_cast<int>(i), other = static_cast<int>(j);
      if (sets.root(one) == sets.root(other) || !are_parted_by_groove(*group[i], *group[j], cylinders)) continue;
      sets.join(one, other);
      --count;
    }
  return count;
}

Planned dimensions_of_equal(const Planning& plan, const CylinderGroup& group) {
  Planned planned;
  const Vec3& axis = group.front()->axis;
  std::vector<scene::FeatureCircle> rims;
  for (const CylinderFeature* one : group)
    for (const Vec3& at : {one->from, one->to}) rims.push_back({at, axis, one->called(), {}});
  const NamedProjection* along = plan.views.showing(rims);
  const auto end = [&](const CylinderFeature& cylinder) { return outer_end(cylinder, plan.box.centre()); };
  const NamedProjection* across = group.front()->inwards ? nullptr : plan.views.across(axis, end(*group.front()));
  // Across an interrupted one, its outline may not be seen.
  const bool is_clear = across != nullptr && (group.front()->whole || along == nullptr);
  const NamedProjection* view = is_clear ? across : along;
  if (view == nullptr && group.front()->whole)
    view = view_beside<CylinderFeature>(plan.views, group, end, group.front()->inwards);
  if (view == nullptr) return planned;
  const CylinderFeature& shown = *uppermost<CylinderFeature>(group, *view, end);
  check(shown.called() > 0, "a cylinder has a radius");
  planned.dimensions.push_back(
      plan.dimension(DimensionType::diameter, *view,
                     times(count_cylinders(group, plan.subject.features.cylinders)) + name_in_note(shown.thread),
                     {end(shown), axis, shown.called(), {}}));
  if (across != nullptr) planned.append(ends_of_threads(group, *across));
  std::vector<Vec3> centres;
  for (const CylinderFeature* cylinder : group) centres.push_back(cylinder->from);
  planned.append(positions_of(plan, centres, axis, along,
                              plan.group_of(SizeKind::cylinder, plan.subject.features.cylinders, group.front())));
  return planned;
}

Vec3 span_of(const SlotFeature& slot) { return slot.centres[1] - slot.centres[0]; }

/// Slots whose centres have one distance, which is one dimension.
struct SlotLength {
  int axis;
  std::vector<const SlotFeature*> slots;
  std::size_t dimension;  ///< its number
};

// Whether the same extension lines reach the centres of both.
bool are_in_line(const SlotFeature& a, const SlotFeature& b, int axis) {
  const auto ends = [&](const SlotFeature& slot) {
    return std::minmax({slot.centres[0][axis], slot.centres[1][axis]});
  };
  const auto [low, high] = ends(a);
  const auto [other_low, other_high] = ends(b);
  const double slack = features::same_size * (high - low);
  return are_parallel(a.axis, b.axis) && std::abs(low - other_low) <= slack && std::abs(high - other_high) <= slack;
}

// Half of the end of a slot.
scene::FeatureCircle end_of(const SlotFeature& slot) {
  const Vec3 along = glm::normalize(span_of(slot)), out = glm::cross(slot.axis, along);
  std::vector<Vec3> arc;
  for (const double turn : {-1.0, 0.0, 1.0})
    arc.push_back(slot.centres[1] + slot.radius * (turn * out + (1 - std::abs(turn)) * along));
  return {slot.centres[1], slot.axis, slot.radius, std::move(arc)};
}

}  // namespace

Planned cylinder_dimensions(const Planning& plan) {
  Planned planned;
  for (CylinderGroup& group : equal_features(plan.table, SizeKind::cylinder, plan.subject.features.cylinders)) {
    std::erase_if(group, [&](const CylinderFeature* one) { return !one->inwards && is_overall(plan.subject, *one); });
    if (!group.empty()) planned.append(dimensions_of_equal(plan, group));
  }
  return planned;
}

Planned slot_dimensions(const Planning& plan) {
  const std::vector<SlotFeature>& slots = plan.subject.features.slots;
  const auto size_of = [&](const SlotFeature& slot) -> const FeatureSize& {
    return plan.table.size_of(SizeKind::slot, static_cast<std::size_t>(&slot - slots.data()));
  };
  const auto equal = [&](const SlotFeature& a, const SlotFeature& b) {
    return size_of(a).equal_to == size_of(b).equal_to && are_same(glm::length(span_of(a)), glm::length(span_of(b))) &&
           are_parallel(glm::normalize(span_of(a)), glm::normalize(span_of(b)));
  };
  Planned planned;
  std::vector<SlotLength> lengths;
  const auto add_length = [&](const std::vector<const SlotFeature*>& group, const NamedProjection& view, int axis) {
    const auto known = std::ranges::find_if(lengths, [&](const SlotLength& length) {
      return length.axis == axis && std::ranges::any_of(length.slots, [&](const SlotFeature* a) {
               return std::ranges::any_of(group, [&](const SlotFeature* b) { return are_in_line(*a, *b, axis); });
             });
    });
    if (known == lengths.end()) {
      lengths.push_back({axis, group, planned.dimensions.size()});
      planned.dimensions.push_back(plan.dimension(DimensionType::aligned, view, times(group.size()) + "<>"));
      planned.dimensions.back().anchors = {group.front()->centres[0], group.front()->centres[1]};
    } else {
      known->slots.insert(known->slots.end(), group.begin(), group.end());
      planned.dimensions[known->dimension].text = {times(known->slots.size()) + "<>", plan.wanted.where};
    }
  };
  for (const auto& group : groups_of<SlotFeature>(slots, equal)) {
    const SlotFeature& slot = *group.front();
    check(slot.radius > 0 && slot.centres[0] != slot.centres[1], "a slot has a width and a length");
    std::array<scene::FeatureCircle, 2> rims{end_of(slot), end_of(slot)};
    for (Vec3& point : rims[1].arc) point -= slot.reach * slot.axis;
    const NamedProjection* view = plan.views.showing(rims);
    if (view == nullptr) continue;
    planned.dimensions.push_back(
        plan.dimension(DimensionType::radius, *view, times(2 * group.size()) + "<>", end_of(slot)));
    const int axis = world_axis(glm::normalize(span_of(slot)));
    if (axis >= 0) add_length(group, *view, axis);
    const int number = plan.group_of(SizeKind::slot, slots, group.front());
    for (const SlotFeature* one : group) {
      const double way = glm::dot(span_of(*one), view->projection.u + view->projection.v);
      const auto& [low, high] = std::pair(one->centres[way > 0 ? 0 : 1], one->centres[way > 0 ? 1 : 0]);
      planned.append(positions_of(plan, std::array{low}, slot.axis, view, number));
      if (axis >= 0)
        planned.places.emplace_back(KnownPlace{axis, high[axis]});
      else
        planned.append(positions_of(plan, std::array{high}, slot.axis, view, number));
    }
  }
  return planned;
}

}  // namespace epura::sheet
