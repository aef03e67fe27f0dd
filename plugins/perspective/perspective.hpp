// SPDX-License-Identifier: Apache-2.0
// Common parts of the perspectives: default positions of the eye, and rotated planes.
#pragma once

#include <epura/projection_plugin.hpp>

namespace perspective {

using namespace epura::plugin;

/// Distance of the eye in diagonals of the box, which then lies in a cone of 23 degrees around its centre. An eye up to
/// 0.64 diagonals off the centre keeps it in the cone of 60 degrees around the normal that ISO 5456-4 requires.
inline constexpr double calm_distance = 2.5;

inline constexpr epura_parameter distance_parameter = number(
    "distance", "diagonals", "distance of the eye from the model's centre, along the normal", calm_distance, 0.6, 1e6);

inline constexpr epura_parameter eye_height_parameter =
    number("eye-height", "model units", "z of the eye, instead of 'above'", from_box, -1e9, 1e9);

/// The given value, or its default.
inline double given_or(double given, double otherwise) { return std::isnan(given) ? otherwise : given; }
inline Vec3 given_or(Vec3 given, Vec3 otherwise) { return std::isnan(given.x) ? otherwise : given; }

/// The eye at its height above z = 0, if that is given.
inline Vec3 at_height(Vec3 eye, double height) { return {eye.x, eye.y, given_or(height, eye.z)}; }

/// An eye that sees the whole model from the right, the front and above while looking at `reference`.
inline Vec3 calm_eye(const Scene& scene, Vec3 reference) {
  return reference + calm_distance * scene.diagonal() * unit({1, -1, 1});
}

/// The vector from `eye` to `reference`, the viewing direction.
inline Vec3 sight(Vec3 eye, Vec3 reference) {
  const Vec3 line = reference - eye;
  if (!(length(line) > 0)) throw std::invalid_argument("the eye and the point it looks at are the same");
  return line;
}

/// At multiples of a quarter turn, a model axis would be parallel to the plane and lose its vanishing point.
inline void require_turned(double azimuth) {
  if (std::abs(portable_sin(radians(2 * azimuth))) < portable_sin(radians(2)))
    throw std::invalid_argument(
        "azimuth must keep 1 deg away from 0, 90, 180 and 270 deg: there an axis lies in the plane");
}

}  // namespace perspective
