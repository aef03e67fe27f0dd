// SPDX-License-Identifier: Apache-2.0
// The views in which automatic dimensions may stand.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "scene/description.hpp"
#include "sizes/overall.hpp"

namespace epura::sheet {

class ViewChoice {
 public:
  /// Views that show lengths parallel to their plane in true length; of these the one that the dimension names, if any.
  ViewChoice(const scene::DimensionDescription& wanted, std::span<const NamedProjection> views);

  /// Without aligned sections.
  [[nodiscard]] const std::vector<const NamedProjection*>& all() const { return views_; }
  /// Aligned sections that are seen along the normal of their plane. They count where no other view does.
  [[nodiscard]] const std::vector<const NamedProjection*>& aligned() const { return aligned_; }
  /// The first view along an axis; null if there is none. `towards`: if possible one that sees the axis come nearer.
  [[nodiscard]] const NamedProjection* along(const Vec3& axis, bool towards = false) const;
  /// The first view along the axis of circles or arcs that shows a part of one of them, or else the first one along it;
  /// null if there is none. The circles are of one axis.
  [[nodiscard]] const NamedProjection* showing(std::span<const scene::FeatureCircle> circles) const;
  /// The first view in which the axis of what is at a point is horizontal or vertical; null if there is none.
  [[nodiscard]] const NamedProjection* across(const Vec3& axis, const Vec3& at) const;
  /// The first view to which it is parallel, in whatever direction on paper; null if there is none. `inside`: the axis
  /// is of what is inside of the models.
  [[nodiscard]] const NamedProjection* beside(const Vec3& axis, const Vec3& at, bool inside = false) const;

 private:
  std::vector<const NamedProjection*> views_, aligned_;
};

/// Whether nothing hides some point of a circle or an arc in a view.
bool shows_part(const scene::FeatureCircle& circle, const std::function<bool(const Vec3&)>& shows);

}  // namespace epura::sheet
