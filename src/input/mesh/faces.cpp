// SPDX-License-Identifier: Apache-2.0
#include "mesh/faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace epura::mesh {

namespace {

/// `keep(face, ring)` may change the ring and returns the number of corners to keep, 0 to drop the face.
template <class Keep>
int keep_faces(Faces& faces, const Keep& keep) {
  std::size_t kept = 0;
  int begin = 0;      // of the original ring
  int write_end = 0;  // of the kept rings
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const int end = faces.ends[face];
    const std::span<int> ring(faces.corners.data() + begin, static_cast<std::size_t>(end - begin));
    begin = end;
    const std::size_t length = keep(face, ring);
    if (length == 0) continue;
    std::copy_n(ring.begin(), length, faces.corners.begin() + write_end);
    write_end += static_cast<int>(length);
    faces.ends[kept] = write_end;
    faces.number[kept++] = faces.number[face];
  }
  const int dropped = static_cast<int>(faces.size() - kept);
  faces.corners.resize(write_end);
  faces.ends.resize(kept);
  faces.number.resize(kept);
  return dropped;
}

std::size_t without_repetitions(std::span<int> ring) {
  const auto length = static_cast<std::size_t>(std::unique(ring.begin(), ring.end()) - ring.begin());
  return length > 1 && ring[0] == ring[length - 1] ? length - 1 : length;
}

bool has_three_corners(std::span<const int> ring) {
  return ring.size() > 2 &&
         std::any_of(ring.begin() + 2, ring.end(), [&](int c) { return c != ring[0] && c != ring[1]; });
}

/// A face represented by the two neighbours of its lowest vertex, the lower one first.
struct Entry {
  int low, high, face;
  bool is_reversed;  ///< the higher neighbour follows the lowest vertex
};

std::vector<int> canonical_ring(std::span<const int> ring) {
  std::vector<int> turned(ring.begin(), ring.end());
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  if (turned[1] > turned.back()) std::reverse(turned.begin() + 1, turned.end());
  return turned;
}

/// Negative, zero or positive if the canonical ring of one face is less than, equal to or greater than that of the
/// other.
int compare(const Faces& faces, const Entry& a, const Entry& b) {
  if (a.low != b.low) return a.low < b.low ? -1 : 1;
  if (a.high != b.high) return a.high < b.high ? -1 : 1;
  const auto ring_a = faces.ring(a.face), ring_b = faces.ring(b.face);
  if (ring_a.size() == 3 && ring_b.size() == 3) return 0;
  const auto canonical_a = canonical_ring(ring_a), canonical_b = canonical_ring(ring_b);
  return canonical_a == canonical_b ? 0 : canonical_a < canonical_b ? -1 : 1;
}

Entry entry_of(const Faces& faces, std::size_t face) {
  const auto ring = faces.ring(face);
  const auto lowest = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
  const int next = ring[lowest + 1 == ring.size() ? 0 : lowest + 1];
  const int previous = ring[lowest == 0 ? ring.size() - 1 : lowest - 1];
  return {std::min(next, previous), std::max(next, previous), static_cast<int>(face), next > previous};
}

// How often all that is connected with a face through vertices is there.
std::vector<int> copies_of(const Faces& faces, const std::vector<int>& count, int vertex_count) {
  DisjointSets parts(static_cast<std::size_t>(vertex_count));
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (const int corner : faces.ring(face)) parts.join(faces.ring(face)[0], corner);
  std::vector<int> least(static_cast<std::size_t>(vertex_count), std::numeric_limits<int>::max());
  std::vector<int> part(faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    part[face] = parts.root(faces.ring(face)[0]);
    if (count[face] > 0) least[part[face]] = std::min(least[part[face]], count[face]);
  }
  for (int& of_face : part) of_face = least[of_face];
  return part;
}

}  // namespace

int drop_faces_without_three_corners(Faces& faces) {
  return keep_faces(faces, [](std::size_t, std::span<int> ring) {
    const std::size_t length = without_repetitions(ring);
    return has_three_corners(ring.first(length)) ? length : 0;
  });
}

int drop_faces_with_non_finite_corners(Faces& faces, const Points& points) {
  const auto finite = [&](int corner) {
    return std::all_of(points[corner].begin(), points[corner].end(), [](double x) { return std::isfinite(x); });
  };
  return keep_faces(faces, [&](std::size_t, std::span<const int> ring) {
    return std::all_of(ring.begin(), ring.end(), finite) ? ring.size() : 0;
  });
}

int drop_duplicate_faces(Faces& faces, int vertex_count, std::vector<TwinFaces>& twins) {
  // Counting sort by the lowest vertex: equal faces are in one short bucket.
  std::vector<int> bucket_end(static_cast<std::size_t>(vertex_count) + 1, 0);
  for (std::size_t f = 0; f < faces.size(); ++f) ++bucket_end[std::ranges::min(faces.ring(f)) + 1];
  for (int v = 0; v < vertex_count; ++v) bucket_end[v + 1] += bucket_end[v];
  std::vector<Entry> entries(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    entries[bucket_end[std::ranges::min(faces.ring(f))]++] = entry_of(faces, f);

  std::vector<int> count(faces.size(), 1);  // of the faces that equal the first one of them; 0 for the others
  std::vector<int> next(faces.size(), -1);  // the second one, if possible of the opposite order
  parallel_for(static_cast<std::size_t>(vertex_count), grain::light, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const std::span<Entry> bucket(entries.data() + (v == 0 ? 0 : bucket_end[v - 1]), entries.data() + bucket_end[v]);
      std::sort(bucket.begin(), bucket.end(), [&](const Entry& a, const Entry& b) {
        const int order = compare(faces, a, b);
        return order != 0 ? order < 0 : a.face < b.face;
      });
      for (std::size_t begin = 0, end = 1; begin < bucket.size(); begin = end++) {
        const Entry& one = bucket[begin];
        bool is_opposite = false;
        for (; end < bucket.size() && compare(faces, one, bucket[end]) == 0; ++end) {
          ++count[one.face];
          count[bucket[end].face] = 0;
          if (is_opposite || (next[one.face] >= 0 && bucket[end].is_reversed == one.is_reversed)) continue;
          next[one.face] = bucket[end].face;
          is_opposite = bucket[end].is_reversed != one.is_reversed;
        }
      }
    }
  });
  if (std::find(count.begin(), count.end(), 0) == count.end()) return 0;
  const std::vector<int> copies = copies_of(faces, count, vertex_count);
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (count[face] > 0 && count[face] == 2 * copies[face]) {
      count[next[face]] = 1;
      twins.push_back({faces.number[face], faces.number[next[face]]});
    }
  return keep_faces(faces,
                    [&](std::size_t face, std::span<const int> ring) { return count[face] > 0 ? ring.size() : 0; });
}

void drop_numbered_faces(Faces& faces, const std::vector<int>& numbers) {
  keep_faces(faces, [&](std::size_t face, std::span<const int> ring) {
    return std::binary_search(numbers.begin(), numbers.end(), faces.number[face]) ? 0 : ring.size();
  });
}

}  // namespace epura::mesh
