#include "mesh/edge_table.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

/// A half-edge as its lower vertex sees it: the other vertex in the upper half, the half-edge in the lower one, so that
/// one comparison sorts by both.
using Entry = std::uint64_t;

Entry make_entry(int other, int halfedge) { return Entry(other) << 32 | Entry(halfedge); }
int other_of(Entry entry) { return static_cast<int>(entry >> 32); }
int halfedge_of(Entry entry) { return static_cast<int>(entry & 0xFFFFFFFF); }

struct Buckets {
  std::vector<int> ends;  ///< of each vertex
  std::vector<Entry> entries;

  [[nodiscard]] std::span<Entry> of(std::size_t vertex) {
    return {entries.data() + (vertex == 0 ? 0 : ends[vertex - 1]), entries.data() + ends[vertex]};
  }
};

/// Counting sort by the lower vertex, then a sort within each of these short buckets.
Buckets sorted_buckets(std::span<const int> corners, int vertex_count) {
  Buckets buckets{.ends = std::vector<int>(static_cast<std::size_t>(vertex_count) + 1, 0),
                  .entries = std::vector<Entry>(corners.size())};
  const int count = static_cast<int>(corners.size());
  for (int h = 0; h < count; ++h) ++buckets.ends[std::min(corners[h], corners[next_in_triangle(h)]) + 1];
  for (int v = 0; v < vertex_count; ++v) buckets.ends[v + 1] += buckets.ends[v];
  for (int h = 0; h < count; ++h) {
    const auto [low, high] = std::minmax({corners[h], corners[next_in_triangle(h)]});
    buckets.entries[buckets.ends[low]++] = make_entry(high, h);
  }
  parallel_for(static_cast<std::size_t>(vertex_count), 4096, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) std::sort(buckets.of(v).begin(), buckets.of(v).end());
  });
  return buckets;
}

}  // namespace

EdgeTable make_edge_table(std::span<const int> corners, std::span<const int> polygon, int vertex_count) {
  Buckets buckets = sorted_buckets(corners, vertex_count);
  EdgeTable table;
  table.edges.reserve(corners.size());  // twice what a closed surface needs, but pages are used as they are written
  table.halfedges.reserve(corners.size());
  for (int v = 0; v < vertex_count; ++v) {
    int last = -1;
    for (const Entry entry : buckets.of(static_cast<std::size_t>(v))) {
      const int other = other_of(entry), halfedge = halfedge_of(entry);
      if (std::exchange(last, other) != other)
        table.edges.push_back({{v, other}, static_cast<int>(table.halfedges.size()), 0, /*diagonal=*/true});
      MeshEdge& edge = table.edges.back();
      table.halfedges.push_back(halfedge);
      ++edge.count;
      edge.diagonal = edge.diagonal && polygon[halfedge / 3] == polygon[table.halfedges[edge.first] / 3];
    }
  }
  for (MeshEdge& edge : table.edges) edge.diagonal = edge.diagonal && edge.count > 1;
  return table;
}

}  // namespace epura
