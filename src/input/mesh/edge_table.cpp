// SPDX-License-Identifier: Apache-2.0
#include "mesh/edge_table.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "base/unset_vector.hpp"

namespace epura::mesh {

namespace {

/// A half-edge in the list of its lower vertex: the other vertex in the upper 32 bits, the half-edge in the lower ones,
/// so that one comparison sorts by both.
using Outgoing = std::uint64_t;

Outgoing make_entry(int other, int halfedge) { return Outgoing(other) << 32 | Outgoing(halfedge); }
int other_of(Outgoing entry) { return static_cast<int>(entry >> 32); }
int halfedge_of(Outgoing entry) { return static_cast<int>(entry & 0xFFFFFFFF); }

struct Buckets {
  std::vector<int> ends;  ///< end of the entries of each vertex
  UnsetVector<Outgoing> entries;

  [[nodiscard]] int begin_of(std::size_t vertex) const { return vertex == 0 ? 0 : ends[vertex - 1]; }
  [[nodiscard]] std::span<Outgoing> of(std::size_t vertex) {
    return {entries.data() + begin_of(vertex), entries.data() + ends[vertex]};
  }
};

/// Counting sort by the lower vertex, then a sort within each of these short buckets.
Buckets sorted_buckets(std::span<const int> corners, std::size_t vertex_count) {
  Buckets buckets{.ends = std::vector<int>(vertex_count + 1, 0), .entries = UnsetVector<Outgoing>(corners.size())};
  const int count = static_cast<int>(corners.size());
  for (int h = 0; h < count; ++h) ++buckets.ends[std::min(corners[h], corners[next_in_triangle(h)]) + 1];
  std::partial_sum(buckets.ends.begin(), buckets.ends.end(), buckets.ends.begin());
  for (int h = 0; h < count; ++h) {
    const auto [low, high] = std::minmax({corners[h], corners[next_in_triangle(h)]});
    buckets.entries[buckets.ends[low]++] = make_entry(high, h);
  }
  parallel_for(vertex_count, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) std::sort(buckets.of(v).begin(), buckets.of(v).end());
  });
  return buckets;
}

int count_edges(std::span<const Outgoing> entries) {
  int count = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
    count += i == 0 || other_of(entries[i]) != other_of(entries[i - 1]) ? 1 : 0;
  return count;
}

}  // namespace

EdgeTable make_edge_table(std::span<const int> corners, std::span<const int> polygon, int vertex_count) {
  const auto vertices = static_cast<std::size_t>(vertex_count);
  Buckets buckets = sorted_buckets(corners, vertices);
  std::vector<int> first(vertices + 1, 0);  // number of the first edge of each vertex
  parallel_for(vertices, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) first[v + 1] = count_edges(buckets.of(v));
  });
  std::partial_sum(first.begin(), first.end(), first.begin());

  EdgeTable table{UnsetVector<MeshEdge>(static_cast<std::size_t>(first.back())), UnsetVector<int>(corners.size())};
  parallel_for(vertices, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      int number = first[v] - 1;
      int last = -1;
      int at = buckets.begin_of(v);
      for (const Outgoing entry : buckets.of(v)) {
        const int other = other_of(entry), halfedge = halfedge_of(entry);
        if (std::exchange(last, other) != other)
          table.edges[++number] = {
              {static_cast<int>(v), other}, at, 0, /*diagonal=*/true, CutEdge::none, /*wire=*/false};
        MeshEdge& edge = table.edges[number];
        table.halfedges[at++] = halfedge;
        ++edge.count;
        edge.diagonal = edge.diagonal && polygon[halfedge / 3] == polygon[table.halfedges[edge.first] / 3];
      }
    }
  });
  for (MeshEdge& edge : table.edges) edge.diagonal = edge.diagonal && edge.count > 1;
  return table;
}

void add_wires(EdgeTable& table, std::span<const std::array<int, 2>> wires) {
  std::vector<MeshEdge> added;
  for (const auto& [a, b] : wires)
    if (a != b) added.push_back({{std::min(a, b), std::max(a, b)}, 0, 0, false, CutEdge::none, /*wire=*/true});
  std::sort(added.begin(), added.end(), [](const MeshEdge& a, const MeshEdge& b) { return a.vertex < b.vertex; });
  UnsetVector<MeshEdge> all;
  all.reserve(table.edges.size() + added.size());
  std::size_t next = 0;
  const auto add_before = [&](const auto& is_before) {
    for (; next < added.size() && is_before(added[next]); ++next)
      if (all.empty() || all.back().vertex != added[next].vertex) all.push_back(added[next]);
  };
  for (const MeshEdge& edge : table.edges) {
    add_before([&](const MeshEdge& wire) { return wire.vertex < edge.vertex; });
    all.push_back(edge);
    for (; next < added.size() && added[next].vertex == edge.vertex; ++next) all.back().wire = true;
  }
  add_before([](const MeshEdge&) { return true; });
  table.edges = std::move(all);
}

void set_edges(Mesh& mesh, EdgeTable table) {
  for (int& halfedge : table.halfedges) halfedge /= 3;
  mesh.edges = std::move(table.edges);
  mesh.edge_triangles = std::move(table.halfedges);
}

void make_edges(Mesh& mesh, std::span<const std::array<int, 2>> wires) {
  EdgeTable table = make_edge_table(mesh.corners, mesh.polygon, static_cast<int>(mesh.points.size()));
  if (!wires.empty()) add_wires(table, wires);
  set_edges(mesh, std::move(table));
}

std::vector<std::array<int, 2>> wires_of(const Mesh& mesh) {
  std::vector<std::array<int, 2>> wires;
  for (const MeshEdge& edge : mesh.edges)
    if (edge.wire) wires.push_back(edge.vertex);
  return wires;
}

bool has_equal_triangles(const EdgeTable& table, std::span<const int> corners) {
  const auto apex = [&](int halfedge) { return corners[next_in_triangle(next_in_triangle(halfedge))]; };
  std::atomic<bool> found = false;
  parallel_for(table.edges.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    std::vector<int> apexes;
    for (std::size_t e = begin; e < end; ++e) {
      if (table.edges[e].count == 1) continue;
      apexes.clear();
      for (const int halfedge : table.halfedges_of(table.edges[e])) apexes.push_back(apex(halfedge));
      if (apexes.size() > 2) std::sort(apexes.begin(), apexes.end());
      if (std::adjacent_find(apexes.begin(), apexes.end()) != apexes.end()) found = true;
    }
  });
  return found;
}

}  // namespace epura::mesh
