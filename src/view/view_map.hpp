// The projective map from the world to the projection plane that keeps depth, written so that it loses no digits.
//
// It is VOM * M_per (3.36, 3.10) or VOM * M_par (3.20) with the depth row of seed 000 [P], re-centred: every
// coordinate is measured from a reference point c in front of the viewer, in space and in the plane alike. With
// l = x - c, the constants of the matrix become 0, 0, 0 and 1, so neither a model far from the origin, nor a centre of
// projection at 1e17, nor one that nearly lies in the plane cancels digits:
//
//   central:  U = (d/w0) (u + (a/w0) n) . l    V alike    Z = (d/w0) n . l    W = 1 - (n . l)/w0
//             w0 = n . (C - c), a = u . (c - C), d = n . (C - P)
//   parallel: U = (u - (u.p / n.p) n) . l      V alike    Z = n . l           W = 1
//
// (U/W, V/W) are plane coordinates from the image of c; Z/W grows towards the viewer and is affine on planes, and a
// unit of it is about as long as a unit of the plane at c. Everything is multiplied by the projection's scale.
#pragma once

#include "base/vec.hpp"
#include "projection/projection.hpp"

namespace epura {

/// A point in homogeneous view coordinates; W > 0 in front of the viewer.
struct Mapped {
  double x, y, z, w;
};

struct ViewMap {
  Vec3 centre;      ///< reference point c in the world
  double shrink;    ///< power of two that brings the scene's size near 1, so that products neither over- nor underflow
  Vec3 u, v, z, w;  ///< rows, applied to shrink * (x - c), that of W to shrink * (x - w_origin)
  Vec3 w_origin;    ///< c, or the centre of projection where that is near: 1 - (n . l)/w0 would cancel there
  double w_constant;    ///< 1, or 0
  Vec2 image;           ///< image of c in the plane's own coordinates (times scale): what a window is relative to
  double depth_of_n;    ///< Z = depth_of_n * shrink * n . (x - c)
  double depth_to_one;  ///< the homogeneous 1 is W + depth_to_one * Z

  [[nodiscard]] Mapped operator()(const Vec3& point) const {
    // Shrinking first: the difference of two large coordinates may be no double.
    const Vec3 l = point * shrink - centre * shrink;
    return {glm::dot(u, l), glm::dot(v, l), glm::dot(z, l),
            w_constant + glm::dot(w, point * shrink - w_origin * shrink)};
  }
};

/// `scene` is the box of everything that is drawn.
ViewMap make_view_map(const Projection& projection, const Box& scene);

}  // namespace epura
