// Small meshes with known geometry, and ways to view and measure them without plugins or files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drawing/make_drawing.hpp"
#include "edges/drawn_edges.hpp"
#include "mesh/build.hpp"
#include "scene/scene.hpp"
#include "view/view.hpp"
#include "visibility/visibility.hpp"

namespace epura::test {

using Point = std::array<double, 3>;

/// Points and polygons, before they become a Mesh.
struct Shape {
  std::vector<Point> points;
  std::vector<std::vector<int>> faces;
  std::vector<int> bodies;  ///< of the faces; empty: one body

  void add(const Shape& other);
  [[nodiscard]] Shape moved(double x, double y, double z) const;
  [[nodiscard]] Shape scaled(double factor) const;
};

/// The box from `least` to `most`: 6 quadrilaterals, outward.
Shape box(const Point& least, const Point& most);
/// The unit cube of 12 triangles; `other` takes the other diagonal of every face.
Shape triangulated_cube(bool other = false);
/// A rectangle in the plane z = `height`.
Shape plate(double x0, double y0, double x1, double y1, double height);

/// The strip with one side and one border, of `quads` quadrilaterals, each in two triangles.
Shape moebius(int quads);

Mesh mesh_of(const Shape& shape);
World world_of(const std::vector<Shape>& shapes);
inline World world_of(const Shape& shape) { return world_of(std::vector<Shape>{shape}); }

/// Orthographic projection seen from `towards_viewer`; the plane passes through the origin.
Projection orthographic(const Vec3& towards_viewer, const Vec3& up = {0, 0, 1});
/// Seen from above: x right, y up, larger z nearer.
Projection from_above();
/// Central projection from `eye` onto the plane through `point` with `normal`; u, v from `up`.
Projection perspective(const Vec3& eye, const Vec3& point, const Vec3& normal, const Vec3& up);

/// Everything that was computed on the way to a drawing, in model units: page = plane coordinates.
struct Result {
  World world;
  View view;
  DrawnEdges drawn;
  HiddenSpans hidden;
  Drawing drawing;
  double unit;  ///< model length of a unit on the page

  [[nodiscard]] double visible() const { return length(true); }
  [[nodiscard]] double hidden_length() const { return length(false); }
  [[nodiscard]] int pieces(bool visible) const;

 private:
  [[nodiscard]] double length(bool visible) const;
};

Result draw(World world, const Projection& projection, const EdgeWishes& wishes = {}, const ViewLimits& limits = {});

/// Hidden spans of a straight line that belongs to no mesh.
std::vector<std::array<double, 2>> hidden_of_line(const World& world, const Projection& projection, const Vec3& from,
                                                  const Vec3& to);

}  // namespace epura::test
