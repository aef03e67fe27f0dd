// SPDX-License-Identifier: Apache-2.0
// Small meshes with known geometry.
#pragma once

#include <array>
#include <vector>

#include "world/world.hpp"

namespace epura::laboratory {

using Point = std::array<double, 3>;

/// Points and polygons, before they become a Mesh.
struct Shape {
  std::vector<Point> points;
  std::vector<std::vector<int>> faces;
  std::vector<int> bodies;  ///< by face; empty: one body
  std::vector<std::array<int, 2>> wires{};

  void add(const Shape& other);
  [[nodiscard]] Shape moved(double x, double y, double z) const;
  [[nodiscard]] Shape scaled(double factor) const;
};

/// The box from `min` to `max`: 6 quadrilaterals, facing outward.
Shape box(const Point& min, const Point& max);
/// The unit cube and boxes in front of, inside and beside it; an upright one hides the middle of edges.
Shape four_boxes();
/// Two unit cubes with a common face, and a box that stands on both.
Shape touching_boxes();
/// A cube of side 3 with a cavity of side 1 in its middle. The faces of the cavity face out of the solid, or into it.
Shape cube_with_a_cavity(bool out_of_solid);
/// The unit cube of 12 triangles; `other` takes the other diagonal of every face.
Shape triangulated_cube(bool other = false);
/// The unit cube of 12 `cells` cells triangles; `other` takes the other diagonals.
Shape fine_cube(int cells, bool other = false);
/// A rectangle in the plane z = `height`.
Shape plate(double x0, double y0, double x1, double y1, double height);
/// A disk of `blades` triangles around its middle in the plane z = 1, a regular polygon with a corner at (1, 0).
Shape fan(int blades);
/// The Moebius strip, with one side and one border, of `quads` quadrilaterals, each in two triangles.
Shape moebius(int quads);
/// The Klein bottle in the shape of a figure eight, of `around` times `across` quadrilaterals, each in two triangles.
Shape klein_bottle(int around, int across);
/// The surface z = sin(pi r) / (pi r) over the square from -half to half, of `cells` cells quadrilaterals.
Shape sombrero(double half, int cells);
/// A sphere of `meridians` and `bands` with its poles on the z axis: quadrilaterals, except for triangles at the poles.
Shape uv_sphere(int meridians, int bands);

/// A profile of radius and z, revolved around the z axis in `sides` steps. Every radius becomes a ring of points from
/// cos and sin, even at a pole; with `seam`, the points after a full turn are separate from the first ones.
Shape revolved(const std::vector<std::array<double, 2>>& profile, int sides, bool seam = false);

/// A frustum of `sides` sides with its axis along z, from z = 0 to `height`; both ends are closed by polygons.
Shape frustum(double radius, double top, double height, int sides);

/// The body over an outline that runs counterclockwise, from z = 0 to `height`.
Shape prism(const std::vector<Vec2>& outline, double height);

/// `digits`: for a file that writes coordinates as text with this number of digits; 0: unchanged.
mesh::Mesh mesh_of(const Shape& shape, int digits = 0);
/// For a file of 32-bit coordinates.
mesh::Mesh mesh_of_floats(Shape shape);
world::World world_of(const std::vector<Shape>& shapes);
/// The same world with the faces of its parts, if they can be recognised.
world::World recognised(world::World world);
inline world::World world_of(const Shape& shape) { return world_of(std::vector<Shape>{shape}); }

}  // namespace epura::laboratory
