// SPDX-License-Identifier: Apache-2.0
// Facets for the faces of shapes.
#pragma once

#include <TopoDS_Shape.hxx>

#include "watch.hpp"

namespace epura_occt {

struct Fineness {
  double deflection;  ///< mm that facets may be off their surfaces
  double angle;       ///< radians between neighbouring facets of a round face, at most
  bool parallel;
};

/// The diagonal of the box of a shape, mm; 0 where it has none.
double diagonal_of(const TopoDS_Shape& shape);

/// Whether a distance is what was asked for.
bool keeps(double distance, const Fineness& fineness);

/// Gives every face of the shape a triangulation that keeps the deflection: Open CASCADE promises it for edges alone,
/// so it is measured, and a shape that misses it is done again, once. Returns the largest distance that is left, mm.
double tessellate(const TopoDS_Shape& shape, const Fineness& fineness, Watch& watch);

}  // namespace epura_occt
