// SPDX-License-Identifier: Apache-2.0
// Finds the lattice on which a quantised mesh lies, whatever its step and its place: that of KHR_mesh_quantization or
// Draco, also after a program has turned it into ordinary numbers.
#pragma once

#include "mesh/soup.hpp"

namespace epura::mesh {

/// The distance between neighbouring values of coordinates.
struct LatticeStep {
  double length = 0;  ///< 0: there is no lattice
  double doubt = 0;   ///< of the length
};

/// The widest lattice, the same along all axes, on which these points lie within `noise`, the error of a coordinate. It
/// is as little due to chance as a recognised surface, and has a thousand steps at least.
LatticeStep lattice_of(const Points& points, double noise);

}  // namespace epura::mesh
