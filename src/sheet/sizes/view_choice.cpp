// SPDX-License-Identifier: Apache-2.0
#include "sizes/view_choice.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

using features::are_parallel;

ViewChoice::ViewChoice(const scene::DimensionDescription& wanted, std::span<const NamedProjection> views) {
  for (const NamedProjection& view : views) {
    if (wanted.view.value_or(view.name) != view.name || !is_orthographic(view.projection)) continue;
    if (!view.aligned())
      views_.push_back(&view);
    else if (are_parallel(view.projection.n, view.section->plane.normal))
      aligned_.push_back(&view);
  }
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

bool shows_part(const scene::FeatureCircle& circle, const std::function<bool(const Vec3&)>& shows) {
  if (!shows) return true;
  if (!circle.arc.empty()) return std::ranges::any_of(circle.arc, shows);
  constexpr int points = 12;
  const auto [u, v] = surfaces::square_to(circle.axis);
  for (int i = 0; i < points; ++i) {
    const double angle = full_turn * i / points;
    if (shows(circle.centre + circle.radius * (portable_cos(angle) * u + portable_sin(angle) * v))) return true;
  }
  return false;
}

const NamedProjection* ViewChoice::showing(std::span<const scene::FeatureCircle> circles) const {
  const NamedProjection* first = nullptr;
  for (const NamedProjection* view : views_) {
    if (circles.empty() || !are_parallel(view->projection.n, circles.front().axis)) continue;
    if (std::ranges::any_of(circles, [&](const auto& circle) { return shows_part(circle, view->shows); })) return view;
    if (first == nullptr) first = view;
  }
  return first;
}

const NamedProjection* ViewChoice::across(const Vec3& axis, const Vec3& at) const {
  const auto is_across = [&](const NamedProjection* view) {
    return are_parallel(view->projection.u, axis) || are_parallel(view->projection.v, axis);
  };
  for (const NamedProjection* view : views_)
    if (is_across(view)) return view;
  for (const NamedProjection* view : aligned_)
    if (is_across(view) && shows_in_place(*view, at, axis)) return view;
  return nullptr;
}

const NamedProjection* ViewChoice::beside(const Vec3& axis, const Vec3& at, bool inside) const {
  const auto is_beside = [inside](const NamedProjection* view, const Vec3& direction) {
    return (view->shows_inside || !inside) && std::abs(glm::dot(view->projection.n, direction)) <= features::parallel;
  };
  for (const NamedProjection* view : views_)
    if (is_beside(view, axis)) return view;
  for (const NamedProjection* view : aligned_)
    if (const auto turn = cut::turn_at(*view->section, at, view->slack))
      if (is_beside(view, Vec3(*turn * Vec4(axis, 0)))) return view;
  return nullptr;
}

}  // namespace epura::sheet
