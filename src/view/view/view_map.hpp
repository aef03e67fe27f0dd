// SPDX-License-Identifier: Apache-2.0
// The projective map from the world to the projection plane that preserves depth, in a form that loses no digits.
//
// It is VOM * M_per (3.36, 3.10) or VOM * M_par (3.20) with the depth row of seed 000 [P], re-centred: coordinates are
// measured from an origin o near the scene, in space and in the plane alike, so that neither a model far from the
// world's origin nor a far or near centre of projection cancels digits. With l = x - o, c the middle of the scene,
// w0 = n . (C - c), d = n . (C - P), a = u . (c - C), b = v . (c - C):
//
//   parallel, o = c:            U = (u - (u.p / n.p) n) . l        Z = n . l                  W = 1
//   centre far away, o = c:     U = (d/w0) (u + (a/w0) n) . l      Z = (d/w0) n . l           W = 1 - (n . l)/w0
//   centre near, o = C:         U = (d/w0) u . l                   Z = (d/w0) (w0 + n . l)    W = -(n . l)/w0
//
// V is analogous to U. (U/W, V/W) are plane coordinates from the image of c (from the foot of C if o = C); Z/W grows
// towards the viewer and is affine on planes. The last two are the same map up to a shift in the plane: the first is
// precise near c, the second near C. Everything is multiplied by the projection's scale, and Z also by the secant of
// the angle between normal and projector at c, so that depth is length along projectors, in the unit of the plane at c.
#pragma once

#include "base/vec.hpp"
#include "projection/projection.hpp"

namespace epura::view {

/// A point in homogeneous view coordinates; W > 0 in front of the viewer.
struct Mapped {
  double x, y, z, w;
};

struct ViewMap {
  Vec3 origin;           ///< o in the world
  double normalisation;  ///< power of two that brings the scene's size near 1, so that products neither over- nor
                         ///< underflow
  Vec3 u, v, z, w;       ///< rows, applied to normalisation * (x - o)
  double z_constant, w_constant;
  Vec2 image;           ///< the plane's own coordinates (times scale and normalisation) of the point with U = V = 0
  Vec3 centre;          ///< c in the world
  double unit;          ///< length on the page of a (normalised) unit length at c
  double depth_of_n;    ///< Z = depth_of_n * normalisation * n . (x - c)
  double depth_to_one;  ///< the homogeneous 1 is W + depth_to_one * Z

  [[nodiscard]] Mapped operator()(const Vec3& point) const {
    // Normalised first: the difference of two large coordinates may overflow.
    const Vec3 l = point * normalisation - origin * normalisation;
    return {glm::dot(u, l), glm::dot(v, l), z_constant + glm::dot(z, l), w_constant + glm::dot(w, l)};
  }
};

/// `scene` is the box of everything that is drawn.
ViewMap make_view_map(const projection::Projection& projection, const Box& scene);

}  // namespace epura::view
