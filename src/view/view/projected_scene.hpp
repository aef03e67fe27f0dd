// SPDX-License-Identifier: Apache-2.0
// The scene as the viewer sees it: mapped, clipped, and rounded to the page lattice.
//
// Planar decisions use integers: page coordinates are rounded once to a lattice of about 2^30 steps across the window,
// where every cross product of differences fits 64 bits and has an exact sign. Depth remains in doubles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/unset_vector.hpp"
#include "view/clip.hpp"
#include "view/view_map.hpp"
#include "world/world.hpp"

namespace epura::view {

/// A point of the page grid; |x|, |y| < 2^30.
struct GridPoint {
  std::int32_t x, y;
};

/// Returns twice the signed area of the triangle a, b, c on the grid, exactly.
inline std::int64_t cross(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// A vertex on the page: plane coordinates from the middle of the window (y up), depth growing towards the viewer in
/// about the same unit, and the homogeneous divisor, which converts positions on the page to positions on an edge in
/// space.
struct PageVertex {
  double x, y, depth, w;

  [[nodiscard]] Vec2 at() const { return {x, y}; }
};

struct ViewTriangle {
  std::array<int, 3> vertex;
  int source;  ///< the triangle of the world that it is or belongs to
};

struct ViewLimits {
  /// Depth limits: distances in front of the centre (central) or behind the plane's point (parallel), world units.
  std::optional<double> near{}, far{};
  /// World length below which faces touch; by default four cells of the page grid, or the rounding of the input if
  /// models store 32-bit floats.
  std::optional<double> contact{};
};

/// Distances below which a face does not hide what it touches.
struct Contact {
  double touching;  ///< for unrelated faces and edges, if the face is perpendicular to the view; view units
  double joined;    ///< for a face and an edge that starts at one of its corners: only rounding is tolerated; view
                    ///< units
  double in_space;  ///< length in the normalised world (ViewMap::normalisation) below which faces touch instead of
                    ///< crossing
};

struct ProjectedScene {
  projection::Projection projection;
  ViewMap map;
  projection::Window window;  ///< the part of the plane that is drawn, in view units from the image of map.centre
  bool window_given = false;  ///< given by the projection, or limited to a cone of vision because the viewer is in the
                              ///< scene
  Vec2 middle;                ///< of the window: origin of page vertices, view units
  double extent = 0;          ///< longest side of the window, view units
  double cell = 0;            ///< side of a grid cell, view units, a power of two
  Contact contact{};

  Clipper clipper;
  std::vector<int> triangle_planes;  ///< that cut something: at depth limits and at 1.5 times the window
  std::vector<int> edge_planes;      ///< that cut something: at depth limits and at the window itself
  std::vector<int> idle_planes;      ///< that cut nothing; they clip triangles only under Clipping::everywhere

  // By vertex: first those of the world in its numbering, then added points and those made by clipping.
  UnsetVector<PageVertex> vertices;
  UnsetVector<GridPoint> grid;
  UnsetVector<ViewTriangle> triangles;
};

/// Which planes clip triangles. A plane with all vertices of the world inside cuts nothing.
enum class Clipping { where_needed, everywhere };

/// Throws Error{input} if no part of the world lies in front of the viewer and inside the window.
ProjectedScene project_scene(const world::World& world, const projection::Projection& projection,
                             const ViewLimits& limits, Clipping clipping = Clipping::where_needed);

/// The same with points of the world that the caller has mapped. They must be finite, in the coordinates of
/// make_view_map(projection, world.box).
ProjectedScene project_scene(const world::World& world, const projection::Projection& projection,
                             const ViewLimits& limits, UnsetVector<Mapped> mapped,
                             Clipping clipping = Clipping::where_needed);

/// Adds a point in space as a vertex and returns its number.
int add_point(ProjectedScene& view, const Vec3& point);
int add_mapped_point(ProjectedScene& view, const Mapped& mapped);

/// Returns the part of the edge between two vertices that is drawn.
std::optional<ClippedEdge> clip_edge(ProjectedScene& view, int a, int b);

/// Returns the part of the polygon with these vertices that is drawn; empty if there is none.
std::vector<int> clip_ring(ProjectedScene& view, const std::vector<int>& ring);

}  // namespace epura::view
