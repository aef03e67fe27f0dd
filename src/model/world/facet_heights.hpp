// SPDX-License-Identifier: Apache-2.0
// How far facets are from the surfaces that they represent.
//
// Where the surface is recognised or declared by the file, the height is that of the surface over the facet, and of the
// vertices beside the surface. Elsewhere it is estimated: over a facet whose neighbour across a side is folded by a
// small angle, a smooth surface rises by an eighth of angle and height over that side, and the three sides add up. For
// nets of right-angled triangles on cylinders and spheres this is exact to first order; for equilateral ones it is an
// eighth too much. Folds sharper than a crease belong to no surface.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "world/world.hpp"

namespace epura::world {

/// In units of the world.
struct FacetHeights {
  std::vector<double> of_triangle;
  std::vector<double> of_model;    ///< the largest of each
  std::vector<char> is_estimated;  ///< by triangle

  /// Whether the largest height of a model is estimated.
  std::vector<char> model_is_estimated;
};

/// Of a world that no plane cuts. Throws OutOfTime.
FacetHeights facet_heights(const World& world, const Progress& progress = {});

/// Returns the largest distance between facets and the surfaces that they represent, in units of the world; 0 if no
/// round face is recognised. Throws OutOfTime.
double tessellation_error(const World& world, const Progress& progress = {});

}  // namespace epura::world
