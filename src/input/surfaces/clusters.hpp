// SPDX-License-Identifier: Apache-2.0
// Groups of facets that have no sides in common with other groups. Faces do not extend across groups, so each cluster
// is recognised by itself.
#pragma once

#include <vector>

#include "surfaces/facets.hpp"

namespace epura::surfaces {

struct Cluster {
  std::vector<int> whole;  ///< the number of each facet in the whole mesh; empty for a cluster that is the whole mesh
  Facets own;              ///< its facets in order; unset for such a cluster

  [[nodiscard]] const Facets& facets(const Facets& all) const { return whole.empty() ? all : own; }
};

/// Returns some facets of a mesh, given in ascending order, as a mesh of their own.
Facets part_of(const Facets& all, const std::vector<int>& facets);

/// Facets that are connected through sides are in one cluster; small bodies share one. The clusters are ordered by the
/// first facets of their bodies, whatever the number of threads.
std::vector<Cluster> clusters_of(const Facets& all);

}  // namespace epura::surfaces
