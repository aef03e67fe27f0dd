// SPDX-License-Identifier: Apache-2.0
// Facets that lie on one surface: how such a region grows, and what proves that the surface is meant.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "features/facets.hpp"
#include "features/part_surface.hpp"

namespace epura::features {

struct Region {
  PartSurface surface;
  std::vector<int> facets;
  double residual = 0;  ///< largest distance of a vertex from the surface
  double sagitta = 0;   ///< mean height of the surface over the middles of facets
  bool chosen = false;  ///< facets that lie beside the surface were left out
  /// So many of the facets, the first ones, lie on the surface; others have a vertex beside it.
  std::size_t exact = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::span<const int> exact_facets() const {
    return std::span(facets).first(std::min(exact, facets.size()));
  }
};

/// How far vertices may lie from a surface whose facets lie `sagitta` below it. Files of little precision are read,
/// too, as long as what the fit leaves is much less than what the facets leave.
double allowance_of(const Facets& facets, double sagitta);

/// Whether a facet approximates the surface beside it: its vertices lie on it, and it faces as the surface does, by no
/// more than half a step of a coarse tessellation. What is too thin to face anywhere has no say.
bool approximates(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta);

/// Whether a facet stands for a piece of the surface though it may face elsewhere: its vertices lie on it, and its
/// sides not much lower than those of other facets. Along the border of a face, where vertices are few, facets reach
/// from a long chord of it to a vertex close by, and tilt.
bool is_chord(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta);

/// Where vertices lie on the arc of a surface, by their angles around its axis or around the tube of a torus.
struct Places {
  int count = 0;        ///< distinct ones
  double from = 0;      ///< where the arc begins, radians
  double sweep = 0;     ///< of the arc; of a whole turn 2 pi
  double step = 0;      ///< largest one between neighbours
  bool closed = false;  ///< no gap is larger than steps are
};
Places places_of(const PartSurface& surface, std::span<const Vec3> points, bool around_tube, double allowance);

/// How far points reach along the axis of a surface, and around it.
struct Reach {
  double from = HUGE_VAL, to = -HUGE_VAL;
  double sweep = 0;  ///< degrees; 360 where no gap is larger than steps are
};
Reach reach_of(const PartSurface& surface, std::span<const Vec3> points, double allowance);

class RegionGrower {
 public:
  /// Facets that have a region already are not taken: `region_of` is by facet, -1 for none, and `regions` are those.
  /// Both are to outlive the grower.
  RegionGrower(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions);

  /// The region around the seeds, fitted anew as it grows; nothing where the seeds do not lie on one surface of that
  /// kind.
  std::optional<Region> grow(const PartSurface& beginning, std::span<const int> seeds);

  /// Whether a region shows more of its surface than chance can. Any two polygons beside each other lie on some round
  /// surface: steps of a tessellation are small, there are more places around than determine the surface, and where
  /// they are few, neighbours touch it without an edge.
  bool is_evident(const Region& region);

  /// The cylinder or cone that a sphere's region lies on, too: vertices of two circles about one axis do.
  std::optional<PartSurface> simpler_than(const Region& region);

 private:
  [[nodiscard]] bool may_cross(int triangle, int side) const;
  void add(Region& region, int facet);
  bool spread(Region& region);
  bool fit_again(Region& region);
  void drop_misfits(Region& region);
  void prefer_cylinder(Region& region);
  void take_enclosed(Region& region);
  [[nodiscard]] std::vector<Vec3> points_of(const Region& region, std::size_t most);
  [[nodiscard]] double mean_turn_of(const Region& region) const;
  [[nodiscard]] Places places_around(const Region& region, bool around_tube);
  [[nodiscard]] int tangent_ends(const Region& region, const Places& places, bool around_tube);
  [[nodiscard]] bool is_evident_arc(const Region& region, bool around_tube, double mean_turn);
  [[nodiscard]] bool is_beyond_chance(const Region& region);
  [[nodiscard]] bool is_evident_sphere(const Region& region);

  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
  std::vector<int> stamp_, vertex_stamp_;
  int number_ = 0, vertex_number_ = 0;
  double sagittas_ = 0;
};

}  // namespace epura::features
