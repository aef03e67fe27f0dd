// SPDX-License-Identifier: Apache-2.0
// Finds intersection lines of faces. These are not mesh edges, but are drawn like creases.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "world/world.hpp"

namespace epura::edges {

struct FaceCrossing {
  std::array<Vec3, 2> ends;      ///< in the world
  std::array<int, 2> triangles;  ///< of the world, first < second
  double angle;                  ///< angle between their planes, 0 to 90 degrees

  bool operator<(const FaceCrossing& other) const { return triangles < other.triangles; }
  bool operator==(const FaceCrossing&) const = default;
};

struct FaceCrossings {
  std::vector<FaceCrossing> found;
  double searched = 1;    ///< fraction of the search that was completed; 1: all of it
  bool too_many = false;  ///< whether it ended for their number, not for lack of time
};

/// Crossings that are found already.
struct KnownCrossings {
  std::vector<FaceCrossing> found;
  std::vector<char>
      is_settled;  ///< by triangle of the world: no others are between two of these; empty: there are none

  bool operator==(const KnownCrossings&) const = default;
};

/// The triangles that may cross others.
struct CrossingCandidates {
  std::vector<int> triangles;  ///< of the world, in ascending order
  bool in_patches = false;     ///< whether triangles of one patch (graph_patches.hpp) are not compared
  KnownCrossings known{};

  bool operator==(const CrossingCandidates&) const = default;
};

/// Returns all crossings longer than `contact` of two triangles without a common edge, sorted by their triangles. Faces
/// that only touch (a corner or an edge within `contact` of the other's plane) do not cross; an edge that lies in the
/// other plane counts if its surface continues on the other side. `normalisation` is a power of two that scales the
/// size of the world to about 1; `contact` is a normalised length. Only the candidates are searched, but for what is
/// known, and only until there are too many (`most_crossings`): then what is found does not depend on threads either.
FaceCrossings find_intersections(const world::World& world, double normalisation, double contact,
                                 const CrossingCandidates& candidates, Progress progress = {});

/// Returns what is known of triangles that have other numbers now, up to `count`: -1 for those that are gone.
KnownCrossings renumbered(const KnownCrossings& known, std::span<const int> numbers, std::size_t count);

/// Returns the points of the world as used by the search: normalised, with the middle of their box at the origin.
UnsetVector<Vec3> normalised_points(const world::World& world, double normalisation);

/// Whether a triangle with normalised corners is so low that its normal has no reliable direction. Such a triangle
/// crosses nothing.
bool is_low(const Vec3& a, const Vec3& b, const Vec3& c, double contact);

/// Whether two boxes have a common point; touching counts.
bool boxes_overlap(const Box& a, const Box& b);

}  // namespace epura::edges
