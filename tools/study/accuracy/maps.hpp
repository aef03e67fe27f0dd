// SPDX-License-Identifier: Apache-2.0
// Error against run time of the projection maps alone, for a model at increasing distances from the world's origin.
#pragma once

#include <string>
#include <vector>

namespace epura::study {

struct MapMeasurement {
  std::string map;  ///< "M_per" (3.10) or "M_par" (3.20)
  std::string way;  ///< "float matrix", "double matrix", "staged", "re-centred"
  double offset;    ///< of a model of size 1 from the origin
  double error;     ///< of positions on the page relative to each other, against rationals: maximum in model sizes,
                    ///< infinite if a vertex has no position any more
  double seconds;   ///< per vertex, median
};

/// Measures at offsets 1, 10, ... 1e12:
///   float matrix   the composed matrix, point and product in 32 bits
///   double matrix  the composed matrix (view_matrix) in doubles
///   staged         to the plane's point, into its axes, then along the projector
///   re-centred     the map used for drawing (ViewMap): origin near the scene, in space as well as in the plane
std::vector<MapMeasurement> measure_maps(int runs);

}  // namespace epura::study
