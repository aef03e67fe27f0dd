// SPDX-License-Identifier: Apache-2.0
// Facets that have no sides in common with others: faces do not reach across, so each cluster is recognised by itself.
#pragma once

#include <vector>

#include "features/facets.hpp"

namespace epura::features {

struct Cluster {
  std::vector<int> whole;  ///< of each facet its number among all; empty for a cluster that is all there is
  Facets own;              ///< its facets in their order; unset for such a cluster

  [[nodiscard]] const Facets& facets(const Facets& all) const { return whole.empty() ? all : own; }
};

/// Facets that are connected through sides are in one cluster, and small bodies together. Ordered by the first facets
/// of their bodies; whatever the number of threads is.
std::vector<Cluster> clusters_of(const Facets& all);

}  // namespace epura::features
