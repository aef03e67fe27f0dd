// SPDX-License-Identifier: Apache-2.0
#include "surfaces/clusters.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace epura::surfaces {

namespace {

// With fewer facets, copying a cluster takes longer than searching it.
constexpr std::size_t min_facets = 1024;

// Returns for each facet the first facet of its body.
std::vector<int> bodies_of(const Facets& all) {
  DisjointSets bodies(all.facets.size());
  for (std::size_t t = 0; t < all.sides.size(); ++t)
    for (const Side& side : all.sides[t])
      if (side.neighbour > static_cast<int>(t)) bodies.join(all.facet_of[t], all.facet_of[side.neighbour]);
  return std::move(bodies).roots();
}

// The facets of each cluster, ascending.
std::vector<std::vector<int>> divided(const std::vector<int>& bodies) {
  std::vector<std::size_t> size(bodies.size(), 0);
  for (const int body : bodies) ++size[body];
  std::vector<int> cluster_of(bodies.size(), -1);
  std::vector<std::size_t> held;
  int open = -1;  // the cluster to which small bodies are added
  for (std::size_t f = 0; f < bodies.size(); ++f) {
    if (bodies[f] != static_cast<int>(f)) continue;
    const bool is_small = size[f] < min_facets;
    const int cluster = is_small && open >= 0 ? open : static_cast<int>(held.size());
    if (cluster == static_cast<int>(held.size())) held.push_back(0);
    cluster_of[f] = cluster;
    held[cluster] += size[f];
    if (is_small) open = held[cluster] < min_facets ? cluster : -1;
  }
  std::vector<std::vector<int>> clusters(held.size());
  for (std::size_t c = 0; c < held.size(); ++c) clusters[c].reserve(held[c]);
  for (std::size_t f = 0; f < bodies.size(); ++f) clusters[cluster_of[bodies[f]]].push_back(static_cast<int>(f));
  return clusters;
}

class Copying {
 public:
  explicit Copying(const Facets& all)
      : all_(all), triangle_in_(all.corners.size(), -1), vertex_in_(all.points.size(), -1), owner_(vertex_in_) {}

  // Clusters are numbered one after the other, since bodies may share vertices.
  void number(Cluster& cluster, int owner) {
    Facets& own = cluster.own;
    own.origin = all_.origin;
    own.scale = all_.scale;
    own.tolerance = all_.tolerance;
    own.slack = all_.slack;
    own.first_triangle = own.first_vertex = {0};
    const auto vertex = [&](int v) {
      if (std::exchange(owner_[v], owner) != owner) {
        vertex_in_[v] = static_cast<int>(own.points.size());
        own.points.push_back(all_.points[v]);
      }
      return vertex_in_[v];
    };
    for (const int f : cluster.whole) {
      for (const int t : all_.triangles_of(f)) {
        triangle_in_[t] = static_cast<int>(own.corners.size());
        own.triangles.push_back(triangle_in_[t]);
        const auto& [a, b, c] = all_.corners[t];
        own.corners.push_back({vertex(a), vertex(b), vertex(c)});
      }
      own.end_of_supports.push_back(static_cast<int>(own.vertices.size() + all_.supports_of(f).size()));
      for (const int v : all_.vertices_of(f)) own.vertices.push_back(vertex(v));
      own.first_triangle.push_back(static_cast<int>(own.triangles.size()));
      own.first_vertex.push_back(static_cast<int>(own.vertices.size()));
    }
  }

  void copy(Cluster& cluster) const {
    Facets& own = cluster.own;
    own.facets.reserve(cluster.whole.size());
    own.sides.reserve(own.corners.size());
    own.normals.reserve(own.corners.size());
    own.facet_of.reserve(own.corners.size());
    for (std::size_t i = 0; i < cluster.whole.size(); ++i) {
      own.facets.push_back(all_.facets[cluster.whole[i]]);
      for (const int t : all_.triangles_of(cluster.whole[i])) {
        std::array<Side, 3> sides = all_.sides[t];
        for (Side& side : sides)
          if (side.neighbour >= 0) side.neighbour = triangle_in_[side.neighbour];
        own.sides.push_back(sides);
        own.normals.push_back(all_.normals[t]);
        own.facet_of.push_back(static_cast<int>(i));
      }
    }
  }

 private:
  const Facets& all_;
  std::vector<int> triangle_in_, vertex_in_;  ///< numbers in their clusters
  std::vector<int> owner_;                    ///< the last cluster in which a vertex was found
};

}  // namespace

Facets part_of(const Facets& all, const std::vector<int>& facets) {
  Cluster part{facets, {}};
  Copying copying(all);
  copying.number(part, 0);
  copying.copy(part);
  return std::move(part.own);
}

std::vector<Cluster> clusters_of(const Facets& all) {
  std::vector<std::vector<int>> facets;
  if (all.facets.size() > min_facets) facets = divided(bodies_of(all));
  if (facets.size() < 2) return std::vector<Cluster>(1);
  std::vector<Cluster> clusters(facets.size());
  Copying copying(all);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    clusters[c].whole = std::move(facets[c]);
    copying.number(clusters[c], static_cast<int>(c));
  }
  parallel_for(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) copying.copy(clusters[c]);
  });
  return clusters;
}

}  // namespace epura::surfaces
