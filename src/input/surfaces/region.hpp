// SPDX-License-Identifier: Apache-2.0
// Facets that lie on one surface: how such a region grows, and how to prove that the surface is intended.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "surfaces/facets.hpp"
#include "surfaces/limits.hpp"
#include "surfaces/part_surface.hpp"

namespace epura::surfaces {

struct Region {
  PartSurface surface;
  std::vector<int> facets;
  double residual = 0;  ///< largest distance of a vertex from the surface
  double sagitta = 0;   ///< mean distance of the surface from the middles of facets
  bool chosen = false;  ///< whether facets that lie off the surface were left out
  /// Number of facets, the first ones, that lie on the surface; the others have a vertex off it.
  std::size_t exact = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::span<const int> exact_facets() const {
    return std::span(facets).first(std::min(exact, facets.size()));
  }
};

/// The regions of a mesh.
struct Regions {
  std::vector<Region> regions;
  std::vector<int> region_of;  ///< by facet; -1 for none
};

/// Returns how far vertices may lie from a surface whose facets have the given sagitta. Files of low precision are
/// accepted as long as the residual of the fit is much smaller than the sagitta.
double allowance_of(const Facets& facets, double sagitta);

/// The same for vertices on a border that was trimmed along an inexact curve.
double trimmed_allowance_of(const Facets& facets, double sagitta);

/// Whether a facet approximates the surface near it: its vertices lie on the surface, and its normal differs from that
/// of the surface by no more than half a step of a coarse tessellation. The normals of very thin facets are ignored.
bool approximates(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta);

/// Whether a facet represents a piece of the surface although it may face elsewhere: its vertices lie on the surface,
/// and its sides are not much farther below it than those of other facets. Along the border of a face, where there are
/// few vertices, facets tilt because they extend from a long chord to a vertex close to it.
bool is_chord(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta);

/// Positions of vertices on the arc of a surface, by their angles around its axis or around the tube of a torus.
struct Places {
  int count = 0;        ///< distinct positions
  double from = 0;      ///< start of the arc, radians
  double sweep = 0;     ///< of the arc, radians; 2 pi for a full turn
  double step = 0;      ///< largest one between adjacent positions, radians
  bool closed = false;  ///< whether no gap is larger than a step
};
Places places_of(const PartSurface& surface, std::span<const Vec3> points, bool around_tube, double allowance);

/// The extent of points along the axis of a surface and around it.
struct Reach {
  double from = HUGE_VAL, to = -HUGE_VAL;
  double sweep = 0;   ///< degrees; 360 if no gap is larger than a step
  double middle = 0;  ///< of the gap, radians
};

Reach reach_of(const PartSurface& surface, std::span<const Vec3> points, double allowance);

/// Whether a triangle of a surface passes over an angle around its axis.
bool passes_over(const PartSurface& surface, const std::array<Vec3, 3>& triangle, double angle);

/// The sweep of a face, degrees: 360 if triangles pass over the gap between its vertices. Where these lie at random, as
/// those of meshes for computations, or inside the face, the largest gap is many times the usual one.
/// `any_triangle(is_over)` returns whether is_over(corners) holds for a triangle of the face.
template <class AnyTriangle>
double sweep_around(const PartSurface& surface, const Reach& reach, const AnyTriangle& any_triangle) {
  const auto is_over = [&](const std::array<Vec3, 3>& corners) { return passes_over(surface, corners, reach.middle); };
  return reach.sweep > 360 - widest_chord && any_triangle(is_over) ? 360 : reach.sweep;
}

class RegionGrower {
 public:
  /// Facets that already have a region are not taken: `region_of` is by facet, -1 for none, and `regions` contains
  /// these regions. Both must outlive the grower.
  RegionGrower(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions);

  /// Returns the region around the seeds, fitted again as it grows; nothing if the seeds do not lie on one surface of
  /// that kind.
  std::optional<Region> grow(const PartSurface& beginning, std::span<const int> seeds);

  /// Whether a region determines its surface beyond coincidence. Any two adjacent polygons lie on some round surface.
  /// So the steps must be small, as in a tessellation; there must be more positions around the surface than determine
  /// it; and where they are few, neighbours must be tangent to it.
  bool is_evident(const Region& region);

  /// Returns the cylinder or cone on which the region of a sphere lies, too, as the vertices of any two coaxial circles
  /// do.
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
  [[nodiscard]] std::optional<std::size_t> few_beside_arc(const Region& region);
  [[nodiscard]] bool is_beyond_chance(const Region& region);
  [[nodiscard]] bool fits_exactly(const Region& region);
  [[nodiscard]] bool is_evident_sphere(const Region& region);

  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
  std::vector<int> stamp_, vertex_stamp_;
  int number_ = 0, vertex_number_ = 0;
  double sagittas_ = 0;
};

}  // namespace epura::surfaces
