// SPDX-License-Identifier: Apache-2.0
#include "sizes/ring_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using features::RoundFeature;
using RingGroup = std::vector<const FeatureSize*>;

const RoundFeature& round_of(const Planning& plan, const FeatureSize& size) {
  return plan.subject.features.rounds[static_cast<std::size_t>(size.feature)];
}

// Whether the diameter of a cylinder, or of the models, is that of a ring.
bool is_known(const Planning& plan, const FeatureSize& ring) {
  return is_overall(plan.subject, {ring.model, ring.centre, ring.centre, ring.axis, ring.value, false}) ||
         std::any_of(plan.table.sizes.begin(), plan.table.sizes.end(), [&](const FeatureSize& other) {
           return other.kind != SizeKind::ring && other.is_at(ring.circle());
         });
}

// Along its axis, at the end of a radius.
Coordinate height_of(const RoundFeature& ring, const NamedProjection& view) {
  const int axis = world_axis(ring.axis);
  check(axis >= 0 && ring.ring > 0, "a ring is about an axis of the world");
  const bool horizontal = std::abs(view.projection.u[axis]) > 0.5;
  const Vec3 out = ring.ring * (horizontal ? -view.projection.v : view.projection.u);
  return {&view, axis, ring.centre[axis], ring.centre + out, -1, ring.centre - out};
}

}  // namespace

std::vector<int> find_rings(const features::PartFeatures& features) {
  std::vector<int> rings;
  for (std::size_t i = 0; i < features.rounds.size(); ++i)
    if (features.rounds[i].has_edge && world_axis(features.rounds[i].axis) >= 0) rings.push_back(static_cast<int>(i));
  return rings;
}

Planned ring_dimensions(const Planning& plan) {
  const std::span<const FeatureSize> all = plan.table.of_kind(SizeKind::ring);
  const std::vector<FeatureSize> rings(all.begin(), all.end());
  const std::vector<RingGroup> groups = groups_of<FeatureSize>(
      rings, [](const FeatureSize& one, const FeatureSize& other) { return one.equal_to == other.equal_to; });
  Planned planned;
  for (const RingGroup& group : groups) {
    const RoundFeature& first = round_of(plan, *group.front());
    const NamedProjection* across = plan.views.across(first.axis, first.centre);
    check(!group.empty() && first.has_edge, "a ring is a groove or a bead");
    if (across == nullptr) continue;
    RingGroup unknown = group;
    std::erase_if(unknown, [&](const FeatureSize* one) { return is_known(plan, *one); });
    if (!unknown.empty()) {
      const RoundFeature& shown = round_of(plan, *unknown.front());
      const NamedProjection* view = plan.views.across(shown.axis, shown.centre);
      planned.dimensions.push_back(plan.dimension(DimensionType::diameter, view != nullptr ? *view : *across,
                                                  times(unknown.size()) + "<>",
                                                  {shown.centre, shown.axis, shown.ring, {}}));
    }
    for (const FeatureSize* size : group) {
      const RoundFeature& ring = round_of(plan, *size);
      planned.places.emplace_back(height_of(ring, *across));
      planned.append(
          positions_of(plan, std::array{ring.centre}, ring.axis, plan.views.along(ring.axis), group.front()->equal_to));
    }
  }
  return planned;
}

}  // namespace epura::sheet
