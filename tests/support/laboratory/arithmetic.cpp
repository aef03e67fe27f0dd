// SPDX-License-Identifier: Apache-2.0
#include "laboratory/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <utility>

#include "base/error.hpp"

namespace epura::laboratory {

namespace {

template <class F>
using Vector = glm::vec<3, F>;
template <class F>
using Row = glm::vec<4, F>;
template <class F>
using Matrix = glm::mat<4, 4, F>;

template <class F>
Matrix<F> of_rows(const Row<F>& r0, const Row<F>& r1, const Row<F>& r2, const Row<F>& r3) {
  return glm::transpose(Matrix<F>(r0, r1, r2, r3));
}

// M_per (3.10) and M_par (3.20) as printed: d = d0 - d1 is a difference of two products.
template <class F>
Matrix<F> printed_matrix(const projection::Projection& p, F factor) {
  const Vector<F> n(factor * Vector<F>(p.n)), point(p.point), q(p.projector);
  const F d0 = glm::dot(point, n), d1 = glm::dot(q, n), d = p.central ? d0 - d1 : d1;
  const auto row = [&](int i) {
    Row<F> r(p.central ? q[i] * n : -q[i] * n, p.central ? -q[i] * d0 : q[i] * d0);
    r[i] += d;
    return r;
  };
  return of_rows<F>(row(0), row(1), row(2), p.central ? Row<F>(n, -d1) : Row<F>(0, 0, 0, d1));
}

template <class F>
Row<F> orientation_row(const Vec3& axis, const Vec3& from) {
  return {Vector<F>(axis), -glm::dot(Vector<F>(axis), Vector<F>(from))};
}

// VOM, the projection, the depth row, and the window-to-viewport step to the coordinates of `map`, in one matrix.
template <class F>
Matrix<F> composed_matrix(const Camera& camera, const view::ViewMap& map) {
  const projection::Projection& p = camera.projection;
  const Matrix<F> orientation = of_rows<F>(orientation_row<F>(p.u, p.point), orientation_row<F>(p.v, p.point),
                                           orientation_row<F>(p.n, p.point), {0, 0, 0, 1});
  const auto factor = static_cast<F>(camera.factor);
  const Matrix<F> flat = orientation * printed_matrix<F>(p, factor);
  // The homogeneous coordinate is 1 at the middle of the scene, and positive in front of the viewer.
  const F distance = p.central ? glm::dot(Vector<F>(p.n), Vector<F>(p.projector) - Vector<F>(map.centre)) : F(1);
  const F at_centre = p.central ? -factor * distance : factor * glm::dot(Vector<F>(p.n), Vector<F>(p.projector));
  const auto unit = static_cast<F>(p.scale * map.normalisation);
  const Row<F> w = glm::row(flat, 3) / at_centre;
  const Row<F> x = glm::row(flat, 0) / at_centre * unit - static_cast<F>(map.image.x) * w;
  const Row<F> y = glm::row(flat, 1) / at_centre * unit - static_cast<F>(map.image.y) * w;
  const Row<F> z = orientation_row<F>(p.n, map.centre) * static_cast<F>(map.depth_of_n * map.normalisation);
  return of_rows<F>(x, y, z, w);
}

template <class F>
UnsetVector<view::Mapped> map_by_matrix(std::span<const Vec3> points, const Camera& camera, const view::ViewMap& map) {
  const Matrix<F> matrix = composed_matrix<F>(camera, map);
  UnsetVector<view::Mapped> mapped;
  mapped.reserve(points.size());
  for (const Vec3& point : points) {
    const Row<F> p = matrix * Row<F>(Vector<F>(point), F(1));
    mapped.push_back({p.x, p.y, p.z, p.w});
  }
  return mapped;
}

UnsetVector<view::Mapped> map_by_own(std::span<const Vec3> points, const view::ViewMap& map) {
  UnsetVector<view::Mapped> mapped;
  mapped.reserve(points.size());
  for (const Vec3& point : points) mapped.push_back(map(point));
  return mapped;
}

// Whether the quotients of homogeneous coordinates remain in the range of doubles.
bool is_sound(const view::Mapped& p) {
  constexpr double max = 1e150;
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!std::isfinite(largest) || !std::isfinite(p.w) || largest > max) return false;
  return !(p.w > 0) || largest / p.w < max;
}

}  // namespace

UnsetVector<view::Mapped> map_points(std::span<const Vec3> points, const Camera& camera, const Box& scene,
                                     Arithmetic arithmetic) {
  const view::ViewMap map = view::make_view_map(camera.projection, scene);
  switch (arithmetic) {
    case Arithmetic::single:
      return map_by_matrix<float>(points, camera, map);
    case Arithmetic::composed:
      return map_by_matrix<double>(points, camera, map);
    case Arithmetic::own:
      break;
  }
  return map_by_own(points, map);
}

view::ProjectedScene view_by(const world::World& world, const Camera& camera, Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::own) return view::project_scene(world, camera.projection, camera.limits);
  UnsetVector<view::Mapped> mapped = map_points(world.points, camera, world.box, arithmetic);
  if (!std::all_of(mapped.begin(), mapped.end(), is_sound))
    throw Error(ErrorKind::input, "map", "a point leaves the range of numbers");
  return view::project_scene(world, camera.projection, camera.limits, std::move(mapped));
}

}  // namespace epura::laboratory
