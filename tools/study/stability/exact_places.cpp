// SPDX-License-Identifier: Apache-2.0
#include "study/stability/exact_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "verify/numbers.hpp"

namespace epura::stability {

namespace {

constexpr std::size_t max_corners = 64;

std::vector<int> corners_before_the_viewer(const Result& result) {
  std::vector<int> corners;
  for (const auto& triangle : result.world.triangles)
    for (const int v : triangle)
      if (result.view.clipper.vertices[v].w > 0) corners.push_back(v);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > max_corners) corners.resize(max_corners);
  return corners;
}

using ExactPlace = std::array<verify::Exact, 2>;

// On the plane, up to a shift that is the same for all points; in units of the view.
ExactPlace exact_place(const view::ProjectedScene& view, const Vec3& point) {
  const projection::Projection& p = view.projection;
  const verify::Triple<verify::Exact> x = verify::triple<verify::Exact>(point),
                                      q = verify::triple<verify::Exact>(p.projector),
                                      n = verify::triple<verify::Exact>(p.n);
  const verify::Exact unit = verify::Exact(p.scale) * verify::Exact(view.map.normalisation);
  ExactPlace place;
  for (int i = 0; i < 2; ++i) {
    const verify::Triple<verify::Exact> axis = verify::triple<verify::Exact>(i == 0 ? p.u : p.v);
    if (p.central)
      place[i] = unit * verify::dot(axis, x - q) * verify::dot(n, q - verify::triple<verify::Exact>(p.point)) /
                 verify::dot(n, q - x);
    else
      place[i] = unit * (verify::dot(axis, x) - verify::dot(axis, q) / verify::dot(n, q) * verify::dot(n, x));
  }
  return place;
}

}  // namespace

Quantity places(const Result& result, double allowed) {
  const view::ProjectedScene& view = result.view;
  const std::vector<int> corners = corners_before_the_viewer(result);
  double worst = 0;
  if (!corners.empty()) {
    const ExactPlace first = exact_place(view, result.world.points[corners.front()]);
    for (const int v : corners) {
      const ExactPlace place = exact_place(view, result.world.points[v]);
      const verify::Exact x = place[0] - first[0], y = place[1] - first[1];
      const view::PageVertex& from = view.vertices[corners.front()];
      const view::PageVertex& to = view.vertices[v];
      worst = std::max(worst, std::hypot(to.x - from.x - verify::value_of(x), to.y - from.y - verify::value_of(y)));
    }
  }
  return {"places", 0, worst * result.unit, result.extent(), allowed};
}

}  // namespace epura::stability
