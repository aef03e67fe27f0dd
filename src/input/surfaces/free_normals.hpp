// SPDX-License-Identifier: Apache-2.0
// The direction in which a free-form face faces at its vertices.
//
// Vertices lie on the face, facets only near it: along its border they tilt. So the normal is that of the paraboloid
// through the vertex which fits the surrounding vertices best (Cazals, Pouget: Estimating differential quantities using
// polynomial fitting of osculating jets, 2005).
#pragma once

#include <optional>
#include <vector>

#include "base/groups.hpp"
#include "surfaces/facets.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

class FreeNormals {
 public:
  /// The arguments must outlive the object.
  FreeNormals(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions);

  struct Normal {
    Vec3 direction;  ///< unit; on the side to which the facet faces
    double doubt;    ///< approximate error of the paraboloid's normal, radians
  };

  /// Returns the normal of the face that a facet belongs to, at a vertex of the facet, or nothing if too few vertices
  /// are near.
  [[nodiscard]] std::optional<Normal> at(int facet, int vertex) const;

 private:
  struct Patch {
    std::vector<int> facets, vertices;
  };
  [[nodiscard]] Patch patch_around(int facet, int vertex) const;

  const Facets& facets_;
  const std::vector<int>& region_of_;
  Groups<int> at_vertex_;  ///< facets of free-form faces
};

}  // namespace epura::surfaces
