// SPDX-License-Identifier: Apache-2.0
#include "laboratory/shapes.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "base/text.hpp"
#include "mesh/build.hpp"

namespace epura::laboratory {

void Shape::add(const Shape& other) {
  const int first = static_cast<int>(points.size());
  points.insert(points.end(), other.points.begin(), other.points.end());
  for (std::vector<int> face : other.faces) {
    for (int& v : face) v += first;
    faces.push_back(face);
  }
  bodies.insert(bodies.end(), other.bodies.begin(), other.bodies.end());
  for (const auto& [a, b] : other.wires) wires.push_back({first + a, first + b});
}

Shape Shape::moved(double x, double y, double z) const {
  Shape result = *this;
  for (Point& p : result.points) p = {p[0] + x, p[1] + y, p[2] + z};
  return result;
}

Shape Shape::scaled(double factor) const {
  Shape result = *this;
  for (Point& p : result.points)
    for (double& c : p) c *= factor;
  return result;
}

Shape box(const Point& a, const Point& b) {
  Shape shape;
  for (int i = 0; i < 8; ++i)
    shape.points.push_back({(i & 1) ? b[0] : a[0], (i & 2) ? b[1] : a[1], (i & 4) ? b[2] : a[2]});
  shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

Shape four_boxes() {
  Shape shape = box({0, 0, 0}, {1, 1, 1});
  shape.add(box({0.3, -0.9, 0.2}, {0.8, -0.5, 0.7}));
  shape.add(box({0.7, 0.6, 0.5}, {1.4, 1.3, 1.6}));
  shape.add(box({0.9, -0.6, -0.5}, {1.1, -0.5, 1.5}));
  return shape;
}

Shape touching_boxes() {
  Shape shape = box({0, 0, 0}, {1, 1, 1});
  shape.add(box({1, 0, 0}, {2, 1, 1}));
  shape.add(box({0.5, 0.2, 1}, {1.5, 0.8, 1.5}));
  return shape;
}

Shape cube_with_a_cavity(bool out_of_solid) {
  Shape cube = box({0, 0, 0}, {3, 3, 3});
  Shape cavity = box({1, 1, 1}, {2, 2, 2});
  if (out_of_solid)
    for (auto& face : cavity.faces) std::swap(face[1], face[3]);
  cube.add(cavity);
  return cube;
}

Shape triangulated_cube(bool other) {
  Shape cube = box({0, 0, 0}, {1, 1, 1});
  std::vector<std::vector<int>> triangles;
  for (const auto& f : cube.faces) {
    const int k = other ? 1 : 0;
    triangles.push_back({f[k], f[k + 1], f[k + 2]});
    triangles.push_back({f[k], f[k + 2], f[(k + 3) % 4]});
  }
  cube.faces = triangles;
  return cube;
}

Shape plate(double x0, double y0, double x1, double y1, double height) {
  return {{{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}}, {{0, 1, 2, 3}}, {}};
}

Shape fine_cube(int cells, bool other) {
  Shape cube;
  std::map<Point, int> places;
  const auto corner = [&](const Point& p) {
    const auto [place, made] = places.try_emplace(p, static_cast<int>(cube.points.size()));
    if (made) cube.points.push_back(p);
    return place->second;
  };
  const int diagonal = other ? 1 : 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double height : {0.0, 1.0})
      for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
          const auto at = [&](int di, int dj) {
            Point p{};
            p[axis] = height;
            p[(axis + 1) % 3] = static_cast<double>(i + di) / cells;
            p[(axis + 2) % 3] = static_cast<double>(j + dj) / cells;
            return corner(p);
          };
          const std::array<int, 4> ring{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
          cube.faces.push_back({ring[diagonal], ring[diagonal + 1], ring[diagonal + 2]});
          cube.faces.push_back({ring[diagonal], ring[diagonal + 2], ring[(diagonal + 3) % 4]});
        }
  return cube;
}

Shape fan(int blades) {
  Shape disk{{{0, 0, 1}}, {}, {}};
  for (int i = 0; i < blades; ++i) {
    const double a = 2 * M_PI * i / blades;
    disk.points.push_back({std::cos(a), std::sin(a), 1});
    disk.faces.push_back({0, i + 1, (i + 1) % blades + 1});
  }
  return disk;
}

Shape moebius(int n) {
  Shape strip;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    for (const double s : {-0.3, 0.3}) {
      const double radius = 1 + s * std::cos(a / 2);
      strip.points.push_back({radius * std::cos(a), radius * std::sin(a), s * std::sin(a / 2)});
    }
    // After a full turn, the sides are swapped.
    const int c = i == n - 1 ? 1 : 2 * i + 2, d = i == n - 1 ? 0 : 2 * i + 3;
    strip.faces.push_back({2 * i, c, d});
    strip.faces.push_back({2 * i, d, 2 * i + 1});
  }
  return strip;
}

Shape klein_bottle(int around, int across) {
  Shape bottle;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * (j + 0.5) / across;
      const double out = std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      const double up = std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
      bottle.points.push_back({(2 + out) * std::cos(u), (2 + out) * std::sin(u), up});
    }
  // After a full turn, v becomes -v.
  const auto at = [&](int i, int j) {
    const int place = i == around ? across - 1 - j % across : j % across;
    return (i % around) * across + place;
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      bottle.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      bottle.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return bottle;
}

Shape sombrero(double half, int cells) {
  Shape hat;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double x = half * (2.0 * i / cells - 1), y = half * (2.0 * j / cells - 1);
      const double a = M_PI * std::hypot(x, y);
      hat.points.push_back({x, y, a > 0 ? std::sin(a) / a : 1});
    }
  const int side = cells + 1;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const int at = i * side + j;
      hat.faces.push_back({at, at + side, at + side + 1});
      hat.faces.push_back({at, at + side + 1, at + 1});
    }
  return hat;
}

Shape uv_sphere(int meridians, int bands) {
  Shape sphere{{{0, 0, -1}}, {}, {}};
  for (int j = 1; j < bands; ++j)
    for (int i = 0; i < meridians; ++i) {
      const double b = M_PI * j / bands - M_PI / 2, a = 2 * M_PI * i / meridians;
      sphere.points.push_back({std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)});
    }
  const int top = static_cast<int>(sphere.points.size());
  sphere.points.push_back({0, 0, 1});
  const auto at = [&](int j, int i) { return 1 + (j - 1) * meridians + (i % meridians); };
  for (int i = 0; i < meridians; ++i) {
    sphere.faces.push_back({0, at(1, i + 1), at(1, i)});
    for (int j = 1; j + 1 < bands; ++j)
      sphere.faces.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)});
    sphere.faces.push_back({at(bands - 1, i), at(bands - 1, i + 1), top});
  }
  return sphere;
}

Shape revolved(const std::vector<std::array<double, 2>>& profile, int sides, bool seam) {
  Shape shape;
  const int columns = seam ? sides + 1 : sides;
  for (const auto& [radius, z] : profile)
    for (int i = 0; i < columns; ++i) {
      const double a = 2 * M_PI * i / sides;
      shape.points.push_back({radius * std::cos(a), radius * std::sin(a), z});
    }
  for (int row = 0; row + 1 < static_cast<int>(profile.size()); ++row)
    for (int i = 0; i < sides; ++i) {
      const int a = row * columns + i, b = row * columns + (i + 1) % columns;
      shape.faces.push_back({a, b, b + columns, a + columns});
    }
  return shape;
}

Shape frustum(double radius, double top, double height, int sides) {
  Shape shape = revolved({{radius, 0}, {top, height}}, sides);
  std::vector<int> below, above;
  for (int i = 0; i < sides; ++i) {
    below.push_back(sides - 1 - i);
    above.push_back(sides + i);
  }
  shape.faces.push_back(below);
  shape.faces.push_back(above);
  return shape;
}

Shape prism(const std::vector<Vec2>& outline, double height) {
  const int n = static_cast<int>(outline.size());
  Shape shape;
  for (const double z : {0.0, height})
    for (const Vec2& p : outline) shape.points.push_back({p.x, p.y, z});
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    shape.faces.push_back({i, j, n + j, n + i});
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

namespace {

mesh::Soup soup_of(const Shape& shape) {
  mesh::Soup soup;
  soup.points = shape.points;
  soup.face_body = shape.bodies;
  soup.wires = shape.wires;
  soup.format = "made";
  for (const auto& face : shape.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.face_ends.push_back(static_cast<int>(soup.corners.size()));
  }
  return soup;
}

}  // namespace

mesh::Mesh mesh_of(const Shape& shape, int digits) {
  mesh::Soup soup = soup_of(shape);
  if (digits > 0) {
    soup.printed = true;
    for (Point& p : soup.points)
      for (double& c : p) c = *parse_number(format_rounded(c, digits));
  }
  return mesh::build_mesh(std::move(soup), "shape");
}

mesh::Mesh mesh_of_floats(Shape shape) {
  for (Point& p : shape.points)
    for (double& c : p) c = static_cast<float>(c);
  mesh::Soup soup = soup_of(shape);
  soup.single_precision = true;
  return mesh::build_mesh(std::move(soup), "shape");
}

world::World world_of(const std::vector<Shape>& shapes) {
  std::vector<world::Placed> models;
  for (const Shape& shape : shapes) models.push_back({std::make_shared<const mesh::Mesh>(mesh_of(shape)), Mat4(1.0)});
  return world::make_world(std::move(models));
}

world::World recognised(world::World world) {
  for (world::Placed& placed : world.models) {
    auto part = std::make_shared<const surfaces::PartFaces>(surfaces::recognise_faces(*placed.mesh));
    if (!part->faces.empty()) placed.part = std::move(part);
  }
  return world;
}

}  // namespace epura::laboratory
