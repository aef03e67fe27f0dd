// SPDX-License-Identifier: Apache-2.0
#include "study/stability/exact_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "verify/numbers.hpp"

namespace epura::stability {

namespace {

constexpr std::size_t most_corners = 64;

std::vector<int> corners_before_the_viewer(const Result& result) {
  std::vector<int> corners;
  for (const auto& triangle : result.world.triangles)
    for (const int v : triangle)
      if (result.view.clipper.vertices[v].w > 0) corners.push_back(v);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > most_corners) corners.resize(most_corners);
  return corners;
}

using ExactPlace = std::array<Exact, 2>;

// On the plane, but for a shift that is the same for all points; in units of the view.
ExactPlace exact_place(const ProjectedScene& view, const Vec3& point) {
  const Projection& p = view.projection;
  const Triple<Exact> x = triple<Exact>(point), q = triple<Exact>(p.projector), n = triple<Exact>(p.n);
  const Exact unit = Exact(p.scale) * Exact(view.map.normalisation);
  ExactPlace place;
  for (int i = 0; i < 2; ++i) {
    const Triple<Exact> axis = triple<Exact>(i == 0 ? p.u : p.v);
    if (p.central)
      place[i] = unit * dot(axis, x - q) * dot(n, q - triple<Exact>(p.point)) / dot(n, q - x);
    else
      place[i] = unit * (dot(axis, x) - dot(axis, q) / dot(n, q) * dot(n, x));
  }
  return place;
}

}  // namespace

Quantity places(const Result& result, double allowed) {
  const ProjectedScene& view = result.view;
  const std::vector<int> corners = corners_before_the_viewer(result);
  double worst = 0;
  if (!corners.empty()) {
    const ExactPlace first = exact_place(view, result.world.points[corners.front()]);
    for (const int v : corners) {
      const ExactPlace place = exact_place(view, result.world.points[v]);
      const Exact x = place[0] - first[0], y = place[1] - first[1];
      const PageVertex& from = view.vertices[corners.front()];
      const PageVertex& to = view.vertices[v];
      worst = std::max(worst, std::hypot(to.x - from.x - value_of(x), to.y - from.y - value_of(y)));
    }
  }
  return {"places", 0, worst * result.unit, result.extent(), allowed};
}

}  // namespace epura::stability
