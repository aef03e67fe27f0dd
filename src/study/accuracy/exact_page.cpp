// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/exact_page.hpp"

#include <algorithm>

namespace epura {

namespace {

// As near before the viewer as this part of the distance of the scene, what is seen begins.
constexpr double nearest_seen = 0x1p-44;

Triple<Exact> along_projectors(const Triple<Exact>& axis, const Triple<Exact>& n, const Triple<Exact>& direction) {
  return along<Exact>(axis, Exact(-dot(axis, direction) / dot(n, direction)), n);
}

}  // namespace

Exact cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

ExactPage::ExactPage(const VerifyInput& claim, const ProjectedScene& view)
    : viewing_(viewing_of(claim)),
      point_(triple<Exact>(claim.projection.point)),
      n_(triple<Exact>(claim.projection.n)),
      u_(triple<Exact>(claim.projection.u)),
      v_(triple<Exact>(claim.projection.v)) {
  const Projection& p = claim.projection;
  const ViewMap& map = view.map;
  if (p.central) {
    const double w0 = 1 / (map.depth_to_one * map.depth_of_n);
    centre_ = triple<Exact>(p.projector);
    page_ = p.scale * glm::dot(p.n, p.projector * map.normalisation - p.point * map.normalisation);
    depth_ = map.depth_of_n * w0 * w0 / map.normalisation;
    nearest_ = nearest_seen * w0 / map.normalisation;
  } else {
    u_ = along_projectors(u_, n_, triple<Exact>(p.projector));
    v_ = along_projectors(v_, n_, triple<Exact>(p.projector));
    page_ = p.scale * map.normalisation;
    depth_ = map.depth_of_n * map.normalisation;
  }
}

ExactPoint ExactPage::position(const Triple<Exact>& point) const {
  const Triple<Exact> l = point - (centre_ ? *centre_ : point_);
  const Exact n = dot(n_, l);
  if (!centre_) return {page_ * dot(u_, l), page_ * dot(v_, l), depth_ * n};
  const Exact ahead = std::max(Exact(-n), nearest_);  // ends that were clipped there are rounded
  return {page_ * dot(u_, l) / ahead, page_ * dot(v_, l) / ahead, depth_ / ahead};
}

std::vector<ExactPoint> ExactPage::position(const std::array<Vec3, 3>& corners) const {
  const Polygon<Exact> polygon = clipped(corners);
  std::vector<ExactPoint> places;
  for (std::size_t i = 0; i < polygon.count; ++i) places.push_back(position(polygon.corner[i]));
  return places;
}

Polygon<Exact> ExactPage::clipped(const std::array<Vec3, 3>& corners) const {
  Polygon<Exact> polygon;
  for (const Vec3& corner : corners) polygon.add(triple<Exact>(corner));
  using Point = Triple<Exact>;
  if (centre_) polygon = clip(polygon, [&](const Point& p) { return Exact(dot(n_, *centre_ - p) - nearest_); });
  if (viewing_.front)
    polygon = clip(polygon, [&](const Point& p) { return Exact(Exact(*viewing_.front) - dot(n_, p - point_)); });
  if (viewing_.back)
    polygon = clip(polygon, [&](const Point& p) { return Exact(dot(n_, p - point_) - Exact(*viewing_.back)); });
  return polygon;
}

}  // namespace epura
