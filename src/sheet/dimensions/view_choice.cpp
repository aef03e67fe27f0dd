// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/view_choice.hpp"

#include <cmath>

#include "design/tolerances.hpp"
#include "sheet/dimensions/stations.hpp"

namespace epura::sheet {

using design::are_parallel;

ViewChoice::ViewChoice(const scene::DimensionDescription& wanted, std::span<const NamedProjection> views) {
  for (const NamedProjection& view : views)
    if (wanted.view.value_or(view.name) == view.name && is_plain(view.projection)) views_.push_back(&view);
}

const NamedProjection* ViewChoice::along(const Vec3& axis, bool towards) const {
  const NamedProjection* best = nullptr;
  for (const NamedProjection* view : views_) {
    if (!are_parallel(view->projection.n, axis)) continue;
    if (!towards || glm::dot(view->projection.n, axis) > 0) return view;
    if (best == nullptr) best = view;
  }
  return best;
}

const NamedProjection* ViewChoice::across(const Vec3& axis) const {
  for (const NamedProjection* view : views_)
    if (are_parallel(view->projection.u, axis) || are_parallel(view->projection.v, axis)) return view;
  return nullptr;
}

const NamedProjection* ViewChoice::beside(const Vec3& axis) const {
  for (const NamedProjection* view : views_)
    if (std::abs(glm::dot(view->projection.n, axis)) <= design::parallel) return view;
  return nullptr;
}

}  // namespace epura::sheet
