// SPDX-License-Identifier: Apache-2.0
#include "view/condition.hpp"

#include <array>
#include <vector>

#include "view/view_map.hpp"

namespace epura::view {

namespace {

// The greatest change of a dot product per relative change of the components of one factor.
double reach(const Vec3& a, const Vec3& b) { return glm::dot(glm::abs(a), glm::abs(b)); }

// A box and its projection in units near 1, so that nothing over- or underflows.
struct Setting {
  projection::Projection p;
  Vec3 size;                    // of the box
  Vec3 max;                     // largest absolute coordinates in it
  std::array<Vec3, 8> corners;  // of the box
};

Setting setting_of(const projection::Projection& projection, const Box& scene) {
  const double k = make_view_map(projection, scene).normalisation;
  Setting s{projection, scene.max * k - scene.min * k, glm::max(glm::abs(scene.min), glm::abs(scene.max)) * k, {}};
  s.p.point = projection.point * k;
  if (projection.central) s.p.projector = projection.projector * k;
  if (s.p.window) s.p.window = projection::Window{s.p.window->min * k, s.p.window->max * k};
  for (int i = 0; i < 8; ++i)
    s.corners[i] = Vec3((i & 1) != 0 ? scene.max.x : scene.min.x, (i & 2) != 0 ? scene.max.y : scene.min.y,
                        (i & 4) != 0 ? scene.max.z : scene.min.z) *
                   k;
  return s;
}

// The contribution of one cause to the condition number.
struct Share {
  double number;
  const char* why;
};

double larger_side(const projection::Window& window) {
  const Vec2 size = window.max - window.min;
  return std::max(size.x, size.y);
}

// A window has its own position, so the position of the whole drawing counts, too.
void add_window(const Setting& s, double size, std::vector<Share>& shares) {
  if (!s.p.window) return;
  const Vec2 far = glm::max(glm::abs(s.p.window->min), glm::abs(s.p.window->max));
  const double point = std::max(reach(s.p.u, s.p.point), reach(s.p.v, s.p.point));
  shares.push_back(
      {(std::max(far.x, far.y) + point) / size, "the window is small for its distance from the plane's point"});
}

std::vector<Share> parallel_shares(const Setting& s) {
  const projection::Projection& p = s.p;
  const double slope = glm::dot(p.n, p.projector);
  double size = 0, coordinates = 0, direction = 0;
  for (const Vec3& axis : {p.u, p.v}) {
    const double tangent = glm::dot(axis, p.projector) / slope;
    const Vec3 row = axis - tangent * p.n;
    size = std::max(size, reach(row, s.size));
    coordinates = std::max(coordinates, reach(row, s.max));
    const double turned = (reach(axis, p.projector) + std::abs(tangent) * reach(p.n, p.projector)) / slope;
    direction = std::max(direction, 2 * turned * reach(p.n, s.size) + reach(axis, s.size));
  }
  if (p.window) size = larger_side(*p.window);
  std::vector<Share> shares{{coordinates / size, "the model is small for its distance from the origin"},
                            {direction / size, "projectors are nearly parallel to the plane of projection"}};
  add_window(s, size, shares);
  return shares;
}

// Distances along the normal from the centre of projection to the scene.
struct Depths {
  double nearest = HUGE_VAL, farthest = 0;
};

// If the viewer is inside the scene, distances begin at a sixteenth of the scene's depth.
Depths depths_of(const Setting& s) {
  Depths depths;
  for (const Vec3& corner : s.corners) {
    const double w = glm::dot(s.p.n, s.p.projector - corner);
    depths.nearest = std::min(depths.nearest, w);
    depths.farthest = std::max(depths.farthest, w);
  }
  depths.farthest = std::max(depths.farthest, reach(s.p.n, s.size));
  if (!(depths.nearest > 0)) depths.nearest = depths.farthest / 16;
  return depths;
}

std::vector<Share> central_shares(const Setting& s) {
  const projection::Projection& p = s.p;
  const Depths w = depths_of(s);
  const double d = glm::dot(p.n, p.projector - p.point);
  const Vec3 from_centre = glm::max(glm::abs(s.corners[0] - p.projector), glm::abs(s.corners[7] - p.projector));
  double size = 0, beside = 0, coordinates = 0, centre = 0;
  for (const Vec3& axis : {p.u, p.v}) {
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const Vec3& corner : s.corners) {
      const double distance = std::max(glm::dot(p.n, p.projector - corner), w.nearest);
      const double place = glm::dot(axis, corner - p.projector) / distance;
      min = std::min(min, place);
      max = std::max(max, place);
    }
    size = std::max(size, max - min);
    beside = std::max({beside, std::abs(min), std::abs(max)});
    coordinates = std::max(coordinates, reach(axis, s.max) / w.nearest);
    centre = std::max(centre, reach(axis, p.projector) * (1 / w.nearest - 1 / w.farthest));
  }
  if (p.window) size = larger_side(*p.window) / d;
  std::vector<Share> shares{{(coordinates + beside * reach(p.n, s.max) / w.nearest) / size,
                             "the model is small for its distance from the origin"},
                            {(centre + beside * reach(p.n, p.projector) / w.nearest) / size,
                             "the centre of projection is close to the model"},
                            {beside * (reach(p.n, p.projector) + reach(p.n, p.point)) / d / size,
                             "the centre of projection is close to the plane of projection"},
                            {beside * reach(p.n, from_centre) / w.nearest / size,
                             "projectors are nearly parallel to the plane of projection"}};
  add_window(s, size * d, shares);
  return shares;
}

// The share of the coordinates, which is proportional to Setting::max, comes first.
std::vector<Share> shares_of(const Setting& s) { return s.p.central ? central_shares(s) : parallel_shares(s); }

}  // namespace

Condition condition_of(const projection::Projection& projection, const Box& scene, const Vec3& one_rounding) {
  Setting setting = setting_of(projection, scene);
  const std::vector<Share> shares = shares_of(setting);
  Condition condition{0, {}, 0};
  double largest = 0;
  for (const Share& share : shares) {
    if (!std::isfinite(share.number)) continue;  // a single point has no size to compare with
    condition.number += share.number;
    if (share.number <= largest) continue;
    largest = share.number;
    condition.why = share.why;
  }
  condition.number = std::max(condition.number, 1.0);
  setting.max = one_rounding * make_view_map(projection, scene).normalisation;
  const double moved = shares_of(setting).front().number;
  if (std::isfinite(moved)) condition.moved_by_files = moved;
  return condition;
}

}  // namespace epura::view
