// SPDX-License-Identifier: Apache-2.0
// What counts as near and solved where meshes are refined: the limits of this stage.
#pragma once

namespace epura::refine {

/// Part of a facet: a contour that passes a corner more closely passes through it. It is off by a part of the sagitta
/// that is the square of twice this.
inline constexpr double at_corner = 0.01;
inline constexpr double along_axis = 1e-5;    ///< sine: a cylinder seen so closely along its axis has no contour
inline constexpr double least_volume = 0.02;  ///< of three unit normals: surfaces that meet at less nearly touch
inline constexpr double told_from = 8;        ///< tolerances of the part: lower polygons turn as their face does
/// Of lengths, parameters and sines, relative, and of radians; here of a reach, within which a point is found, and of a
/// facet's area, less of which is on a line. One for all stages of a view.
inline constexpr double rounding_part = 1e-9;
inline constexpr int newton_steps = 8;  ///< enough for points within a facet of the surface

}  // namespace epura::refine
