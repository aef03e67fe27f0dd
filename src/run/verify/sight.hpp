// SPDX-License-Identifier: Apache-2.0
// The view from a point in space: a frame in which the ray from that point to the viewer is an axis.
//
// With p the point, l = x - p, C the centre or d the direction of projection (seed 003, 3.10 and 3.20):
//
//   central:   k = 1 / (n . (C - p))   right = u - k (u . (C - p)) n   up = v - k (v . (C - p)) n
//   parallel:  k = 0                   right = u - (u . d / n . d) n   up = v - (v . d / n . d) n
//
//   a = right . l   b = up . l   c = n . l     page: F (a, b) / (1 - k c)     depth: D c / (1 - k c)
//
// The ray to the viewer is a = b = 0, c > 0. Page and depth are measured from p; F and D are merely units (millimetres
// on paper at p), so they may be rounded. All decisive quantities, a, b, c and k, are exact in exact arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "projection/projection.hpp"
#include "verify/numbers.hpp"

namespace epura::verify {

/// The parameters of a view that are needed to look along its projectors.
struct Viewing {
  projection::Projection projection;
  std::optional<double> front, back;  ///< n . (x - projection.point) at the depth limits, if there are any
  double page;                        ///< mm of paper per unit of length in the plane's directions, times w
  double depth;                       ///< the same for the depth of ViewDrawing::world_to_page, times w squared
  double w;                           ///< central: row 3 of that matrix per unit of distance from the centre; parallel:
                                      ///< row 3

  /// Row 3 of the matrix at distance n . (C - x) from the centre.
  [[nodiscard]] double w_at(double distance) const { return projection.central ? w * distance : w; }
};

template <class N>
struct Sight {
  Triple<N> place, right, up, towards;
  N inverse_distance;         ///< k
  std::optional<N> eye;       ///< c of a plane just in front of the centre: nothing behind it is seen
  std::optional<N> nearest;   ///< c of the front depth limit
  std::optional<N> farthest;  ///< c of the back depth limit
  double page, depth;         ///< F and D

  /// (a, b, c) of a point.
  [[nodiscard]] Triple<N> local(const Triple<N>& x) const {
    const Triple<N> l = x - place;
    return {dot(right, l), dot(up, l), dot(towards, l)};
  }
  [[nodiscard]] Triple<N> local(const Vec3& x) const { return local(triple<N>(x)); }
};

/// Distance from the centre of projection at which sight begins, as a fraction of the point's distance.
inline constexpr double nearest_part = 0x1p-40;

template <class N>
Sight<N> sight_from(const Viewing& viewing, const Triple<N>& place) {
  const projection::Projection& p = viewing.projection;
  const Triple<N> n = triple<N>(p.n), u = triple<N>(p.u), v = triple<N>(p.v), projector = triple<N>(p.projector);
  const Triple<N> ray = p.central ? projector - place : projector;
  const N ahead = dot(n, ray);
  const N zero(0), one(1);
  Sight<N> sight{place,
                 along<N>(u, zero - dot(u, ray) / ahead, n),
                 along<N>(v, zero - dot(v, ray) / ahead, n),
                 n,
                 p.central ? one / ahead : zero,
                 {},
                 {},
                 {},
                 0,
                 0};
  const N from_plane = dot(n, place - triple<N>(p.point));
  if (p.central) sight.eye = ahead * N(1 - nearest_part);
  if (viewing.front) sight.nearest = N(*viewing.front) - from_plane;
  if (viewing.back) sight.farthest = N(*viewing.back) - from_plane;
  const double w = viewing.w_at(value_of(ahead));
  sight.page = viewing.page / w;
  sight.depth = viewing.depth / (w * w);
  return sight;
}

/// Returns the point a + t (b - a).
template <class N>
Triple<N> position_on(const std::array<Vec3, 2>& line, double t) {
  const Triple<N> a = triple<N>(line[0]);
  return along<N>(a, N(t), triple<N>(line[1]) - a);
}

}  // namespace epura::verify
