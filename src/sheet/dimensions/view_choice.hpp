// SPDX-License-Identifier: Apache-2.0
// The views in which automatic dimensions may stand.
#pragma once

#include <span>
#include <vector>

#include "scene/description.hpp"
#include "sheet/dimensions/overall.hpp"

namespace epura::sheet {

class ViewChoice {
 public:
  /// Views that show lengths parallel to their plane in true length; of these the one that the dimension names, if any.
  ViewChoice(const scene::DimensionDescription& wanted, std::span<const NamedProjection> views);

  [[nodiscard]] const std::vector<const NamedProjection*>& all() const { return views_; }
  /// The first view along an axis; null if there is none. `towards`: if possible one that sees the axis come nearer.
  [[nodiscard]] const NamedProjection* along(const Vec3& axis, bool towards = false) const;
  /// The first view in which an axis is horizontal or vertical; null if there is none.
  [[nodiscard]] const NamedProjection* across(const Vec3& axis) const;
  /// The first view to which an axis is parallel, in whatever direction on paper; null if there is none.
  [[nodiscard]] const NamedProjection* beside(const Vec3& axis) const;

 private:
  std::vector<const NamedProjection*> views_;
};

}  // namespace epura::sheet
