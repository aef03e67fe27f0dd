// SPDX-License-Identifier: Apache-2.0
// Facets from which a round surface may grow: their neighbours across smooth edges, and surfaces through them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "surfaces/facets.hpp"
#include "surfaces/part_surface.hpp"
#include "surfaces/round_regions.hpp"

namespace epura::surfaces {

/// The first neighbours of a facet.
struct Few {
  std::array<int, 4> facets{};
  std::size_t count = 0;

  [[nodiscard]] bool empty() const { return count == 0; }
  [[nodiscard]] std::span<const int> all() const { return std::span(facets).first(count); }
};

/// Answers which facets without a region are near a facet, and remembers its neighbours: each list is needed often.
class SmoothNeighbours {
 public:
  /// Both must outlive it; `region_of` is by facet, -1 for none, and may change.
  SmoothNeighbours(const Facets& facets, const std::vector<int>& region_of)
      : facets_(facets), region_of_(region_of), stamp_(facets.facets.size(), 0), first_(facets.facets.size(), -1) {}

  /// Neighbours without a region across smooth edges, those with the longest common edges first.
  [[nodiscard]] Few beside(int facet);

  /// The facet, these neighbours, and their neighbours.
  [[nodiscard]] std::vector<int> around(int facet, const Few& beside);

 private:
  const Facets& facets_;
  const std::vector<int>& region_of_;
  std::vector<int> stamp_;
  int number_ = 0;
  std::vector<int> first_, lists_;  ///< for each facet, where its list begins: the number of neighbours, then these
};

/// A surface on which some facets around a seed lie.
struct Guess {
  PartSurface surface;
  std::vector<int> seeds;
  std::size_t explained;  ///< number of facets nearby that lie on it
};

/// Guesses surfaces from a few facets.
class Guesser {
 public:
  /// The facets must outlive it.
  Guesser(const Facets& facets, Wanted wanted) : facets_(facets), wanted_(wanted), stamp_(facets.points.size(), 0) {}

  /// Those that explain more facets nearby come first; of equals, the simpler ones. At most one of each kind.
  [[nodiscard]] std::vector<Guess> guesses_at(int facet, std::span<const int> beside, std::span<const int> nearby);

  [[nodiscard]] std::optional<PartSurface> cone_through(std::span<const int> facets);

 private:
  [[nodiscard]] std::vector<Vec3> points_of(std::span<const int> facets);

  const Facets& facets_;
  Wanted wanted_;
  std::vector<int> stamp_;
  int number_ = 0;
};

}  // namespace epura::surfaces
