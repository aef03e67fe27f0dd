// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/hole_angles.hpp"
#include "sizes/thread_notes.hpp"

namespace epura::sheet {

namespace {

using features::HoleFeature;
using HoleGroup = std::vector<const HoleFeature*>;

Vec3 mouth_of(const HoleFeature& hole) { return hole.mouth; }

const FeatureSize& size_of(const Planning& plan, const HoleFeature* hole) {
  return plan.table.size_of(SizeKind::hole, static_cast<std::size_t>(hole - plan.subject.features.holes.data()));
}

int number_of(const Planning& plan, const HoleFeature* first) {
  return plan.group_of(SizeKind::hole, plan.subject.features.holes, first);
}

// The note of equal holes at one that a view shows.
scene::DimensionDescription note_of(const Planning& plan, const NamedProjection& view, const HoleGroup& group,
                                    const HoleFeature* shown) {
  const FeatureSize& size = size_of(plan, shown);
  check(size.value > 0, "a hole has a diameter");
  return plan.dimension(DimensionType::diameter, view, times(group.size()) + size_of(plan, group.front()).text,
                        {size.centre, size.axis, size.value, {}});
}

// Whether holes of one group are behind those of the other, and look the same from the other side.
bool are_opposite(const HoleGroup& group, const HoleGroup& other) {
  HoleFeature turned = *other.front();
  turned.axis = -turned.axis;
  const auto is_behind = [&](const HoleFeature* hole) {
    return std::any_of(group.begin(), group.end(), [&](const HoleFeature* one) {
      return features::distance_from_line(hole->mouth, one->mouth, one->axis) <= features::same_size * one->called();
    });
  };
  return group.size() == other.size() && !turned.through && features::are_equal(*group.front(), turned) &&
         std::all_of(other.begin(), other.end(), is_behind);
}

bool has_table(const Planning& plan) {
  return plan.wanted.holes.value_or(HoleDimensions::notes) == HoleDimensions::table;
}

bool can_have_table(const NamedProjection& view) {
  return world_axis(view.projection.u) >= 0 && world_axis(view.projection.v) >= 0;
}

// Groups of equal holes; those behind others that only one view shows have one note with them. Rows of a table name
// the side by their letters.
std::vector<HoleGroup> groups_of_holes(const Planning& plan) {
  std::vector<HoleGroup> groups = equal_features(plan.table, SizeKind::hole, plan.subject.features.holes);
  for (HoleGroup& group : groups) {
    std::erase_if(group, [&](const HoleFeature* hole) { return plan.table.is_radial(*hole); });
    if (group.empty()) continue;
    const Vec3 axis = group.front()->axis;
    const NamedProjection* view = plan.views.along(axis, true);
    if (view == nullptr || glm::dot(view->projection.n, axis) <= 0 || plan.views.along(-axis, true) != view) continue;
    if (has_table(plan) && can_have_table(*view)) continue;
    const auto other = std::find_if(groups.begin(), groups.end(), [&](const HoleGroup& one) {
      return &one != &group && !one.empty() && are_opposite(group, one);
    });
    if (other == groups.end()) continue;
    group.insert(group.end(), other->begin(), other->end());
    other->clear();
  }
  std::erase_if(groups, [](const HoleGroup& group) { return group.empty(); });
  for (const HoleGroup& group : groups) check(!group.empty(), "a group of holes has one");
  return groups;
}

// What is chosen, or the left or lower end of the models in a view along one of its directions; the axis of a round
// part.
double origin_along(const Planning& plan, const Vec3& direction) {
  const int axis = world_axis(direction);
  if (const auto& datum = plan.datums[static_cast<std::size_t>(axis)]) return datum->at;
  const features::Extent& extent = plan.extent(axis);
  if (extent.form != features::ExtentForm::length) return (extent.from + extent.to) / 2;
  return direction[axis] > 0 ? extent.from : extent.to;
}

HoleTable empty_table(const Planning& plan, const NamedProjection& view) {
  HoleTable table{view.name, plan.box.max, {}};
  for (const Vec3& along : {view.projection.u, view.projection.v})
    table.origin[world_axis(along)] = origin_along(plan, along);
  return table;
}

/// A group in a table: its rows, and a label for each of its holes.
struct TableGroup {
  std::vector<HoleRow> rows;
  Planned labels{};
};

// Numbered from left to right, then upwards; those on one axis are one row.
TableGroup rows_of(const Planning& plan, HoleGroup group, const NamedProjection& view, const Vec3& origin,
                   const std::string& letters) {
  const Vec3 u = view.projection.u, v = view.projection.v;
  const auto place = [&](const HoleFeature* hole) {
    return std::pair(glm::dot(hole->mouth - origin, u), glm::dot(hole->mouth - origin, v));
  };
  const double same = features::same_size * glm::length(plan.box.size());
  std::sort(group.begin(), group.end(), [&](const auto* a, const auto* b) {
    const auto [ax, ay] = place(a);
    const auto [bx, by] = place(b);
    return std::pair(std::round(ax / same), ay) < std::pair(std::round(bx / same), by);
  });
  const auto is_behind = [&](const HoleFeature* a, const HoleFeature* b) {
    return std::abs(place(a).first - place(b).first) <= same && std::abs(place(a).second - place(b).second) <= same;
  };
  TableGroup found;
  for (std::size_t i = 0, next = 0; i < group.size(); i = next) {
    const HoleFeature& hole = *group[i];
    check(hole.called() > 0, "a hole has a diameter");
    while (next < group.size() && is_behind(group[next], &hole)) ++next;
    const auto [x, y] = place(&hole);
    const std::string label = letters + std::to_string(found.rows.size() + 1);
    const std::string size = times(next - i) + size_in_words(hole.thread, hole.diameter, plan.notation);
    found.rows.push_back({label, plan.length(x), plan.length(y), size + recesses_of(hole, plan.notation)});
    found.labels.dimensions.push_back(
        plan.dimension(DimensionType::diameter, view, label, {hole.mouth, hole.axis, hole.called() / 2, {}}));
    found.labels.dimensions.back().is_label = true;
    for (const Vec3& along : {u, v})
      found.labels.places.emplace_back(KnownPlace{world_axis(along), hole.mouth[world_axis(along)]});
  }
  return found;
}

// Whether they are on the axis of a round part, so that a table has no places to give.
bool are_on_axis(const Planning& plan, const HoleGroup& group) {
  return std::ranges::all_of(group, [&](const HoleFeature* hole) {
    const int along = world_axis(hole->axis);
    for (int axis = 0; axis < 3; ++axis) {
      const features::Extent& extent = plan.extent(axis);
      if (axis != along && (extent.form == features::ExtentForm::length ||
                            std::abs(hole->mouth[axis] - extent.centre[axis]) > features::same_size * extent.size()))
        return false;
    }
    return along >= 0;
  });
}

// The view that looks into one of the holes, and the hole; otherwise one beside them.
std::pair<const NamedProjection*, const HoleFeature*> view_of_radial(const Planning& plan, const HoleGroup& holes) {
  for (const HoleFeature* hole : holes)
    if (const NamedProjection* along = plan.views.along(hole->axis, true)) return {along, hole};
  return {view_beside<HoleFeature>(plan.views, holes, mouth_of, true), holes.front()};
}

// The angle between the axes of slanted holes and that of the part, in a view that shows both.
Planned slant_of(const Planning& plan, const RadialPattern& pattern) {
  Planned planned;
  for (const HoleFeature* hole : pattern.holes) {
    const std::array<Vec3, 2> legs = pattern.legs(*hole);
    const NamedProjection* view = plan.views.along(glm::normalize(glm::cross(legs[0], legs[1])));
    if (view == nullptr) continue;
    planned.dimensions.push_back(plan.dimension(DimensionType::angular, *view, times(pattern.holes.size()) + "<>"));
    planned.dimensions.back().anchors = {pattern.centre, pattern.centre + legs[0], pattern.centre + legs[1]};
    break;
  }
  return planned;
}

// Whether a section has left nothing of any hole.
bool is_removed(const HoleGroup& group, const NamedProjection& view) {
  return std::none_of(group.begin(), group.end(), [&](const HoleFeature* hole) {
    return keeps(view, hole->mouth) || keeps(view, hole->mouth - hole->reach * hole->axis);
  });
}

}  // namespace

Planned radial_hole_dimensions(const Planning& plan) {
  Planned planned;
  for (const RadialPattern& pattern : plan.table.radial) {
    check(!pattern.holes.empty(), "a radial pattern has holes");
    const auto [view, shown] = view_of_radial(plan, pattern.holes);
    if (view == nullptr) continue;
    planned.dimensions.push_back(note_of(plan, *view, pattern.holes, shown));
    planned.append({angles_of(plan, directions_of(pattern, plan.table.own_directions(pattern.axis)), true)});
    const int axis = world_axis(pattern.axis);
    const NamedProjection* across = plan.views.across(pattern.axis, shown->mouth);
    if (axis < 0 || across == nullptr) continue;
    const int group = number_of(plan, pattern.holes.front());
    if (pattern.is_slanted) {
      planned.append(slant_of(plan, pattern));
      planned.places.emplace_back(Coordinate{across, axis, pattern.centre[axis], pattern.centre, group});
      continue;
    }
    planned.places.emplace_back(Coordinate{across, axis, shown->mouth[axis], shown->mouth, group, shown->mouth});
    for (const HoleFeature* hole : pattern.holes)
      if (std::abs(hole->mouth[axis] - shown->mouth[axis]) > features::same_size * glm::length(plan.box.size()))
        planned.places.emplace_back(Coordinate{across, axis, hole->mouth[axis], hole->mouth, group, hole->mouth});
  }
  return planned;
}

Planned hole_dimensions(const Planning& plan) {
  Planned planned;
  std::size_t labelled = 0;
  for (const HoleGroup& group : groups_of_holes(plan)) {
    const NamedProjection* along = plan.views.along(group.front()->axis, !group.front()->through);
    if (along != nullptr && is_removed(group, *along)) along = nullptr;
    const NamedProjection* view =
        along != nullptr ? along : view_beside<HoleFeature>(plan.views, group, mouth_of, true);
    if (view == nullptr) {
      planned.omitted.askew[size_of(plan, group.front()).name] += group.size();
      continue;
    }
    if (along != nullptr && has_table(plan) && can_have_table(*view) && !are_on_axis(plan, group)) {
      auto table = std::find_if(planned.tables.begin(), planned.tables.end(),
                                [&](const HoleTable& one) { return one.view == view->name; });
      if (table == planned.tables.end()) table = planned.tables.insert(table, empty_table(plan, *view));
      TableGroup rows = rows_of(plan, group, *view, table->origin, letters_of(labelled++));
      std::move(rows.rows.begin(), rows.rows.end(), std::back_inserter(table->rows));
      planned.append(std::move(rows.labels));
      continue;
    }
    const auto* shown = uppermost<HoleFeature>(group, *view, mouth_of);
    planned.dimensions.push_back(note_of(plan, *view, group, shown));
    std::vector<Vec3> centres;
    for (const HoleFeature* hole : group)
      if (hole->pitch_circle < 0) centres.push_back(hole->mouth);
    if (!centres.empty())
      planned.append(positions_of(plan, centres, group.front()->axis, along, number_of(plan, group.front())));
  }
  return planned;
}

Planned holes_left_out(const Planning& plan) {
  Planned planned;
  for (const auto& group : equal_features(plan.table, SizeKind::hole, plan.subject.features.holes)) {
    check(!group.empty(), "a group of holes has one");
    const NamedProjection* along = plan.views.along(group.front()->axis);
    const NamedProjection* view =
        along != nullptr ? along : plan.views.beside(group.front()->axis, group.front()->mouth);
    if (view != nullptr) ++planned.omitted.too_many[view->name];
  }
  return planned;
}

Planned pitch_circle_dimensions(const Planning& plan) {
  Planned planned;
  if (has_table(plan)) return planned;
  const std::vector<features::PitchCircleFeature>& circles = plan.subject.features.pitch_circles;
  for (const features::PitchCircleFeature& circle : circles) {
    const NamedProjection* view = plan.views.along(circle.axis);
    if (view == nullptr) continue;
    planned.dimensions.push_back(
        plan.dimension(DimensionType::diameter, *view, "<>", {circle.centre, circle.axis, circle.radius, {}}));
    const auto number = static_cast<int>(&circle - circles.data());
    planned.append(
        {angles_of(plan, directions_of(plan.subject.features, number, plan.table.own_directions(circle.axis)), false)});
    planned.append(positions_of(plan, std::array{circle.centre}, circle.axis, view,
                                plan.group_of(SizeKind::pitch_circle, circles, &circle)));
  }
  return planned;
}

}  // namespace epura::sheet
