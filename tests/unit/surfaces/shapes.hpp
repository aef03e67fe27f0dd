// SPDX-License-Identifier: Apache-2.0
// Tessellated parts whose faces are known.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "base/vec.hpp"
#include "mesh/read.hpp"
#include "surfaces/recognise.hpp"

namespace epura::test {

inline constexpr double pi = std::numbers::pi;

/// Points and polygons; the outside is where corners are seen counterclockwise.
struct Part {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;

  int add(const Vec3& p) {
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  }
  Part& move(const std::function<Vec3(const Vec3&)>& where) {
    for (Vec3& p : points) p = where(p);
    return *this;
  }
  Part& turn_inside_out() {
    for (auto& face : faces) face = {face.rbegin(), face.rend()};
    return *this;
  }
  /// What a binary STL keeps.
  Part& round_to_float() {
    is_float = true;
    return move([](const Vec3& p) { return Vec3(float(p.x), float(p.y), float(p.z)); });
  }
  Part& triangulate() {
    std::vector<std::vector<int>> triangles;
    for (const auto& f : faces)
      for (std::size_t i = 2; i < f.size(); ++i) triangles.push_back({f[0], f[i - 1], f[i]});
    faces = triangles;
    return *this;
  }
  Part& shuffle(unsigned seed) {
    std::mt19937 random(seed);
    std::shuffle(faces.begin(), faces.end(), random);
    for (auto& f : faces) std::rotate(f.begin(), f.begin() + int(random() % f.size()), f.end());
    return *this;
  }

  [[nodiscard]] mesh::Mesh mesh() const {
    mesh::Soup soup;
    for (const Vec3& p : points) soup.points.push_back({p.x, p.y, p.z});
    for (const auto& f : faces) {
      soup.corners.insert(soup.corners.end(), f.begin(), f.end());
      soup.end_face();
    }
    soup.single_precision = is_float;
    soup.printed = is_printed;
    return mesh::make_mesh(soup, "part");
  }

  bool is_float = false, is_printed = false;
};

/// A turn of (radius, height) about z; points of radius 0 are poles. Outside is right of the profile.
inline Part revolved(const std::vector<Vec2>& profile, int segments, double sweep = 2 * pi) {
  Part part;
  const bool whole = sweep > 6.28;
  const int columns = whole ? segments : segments + 1;
  std::vector<std::vector<int>> rings;
  for (const Vec2& p : profile) {
    std::vector<int> ring;
    for (int i = 0; i < columns; ++i) {
      if (p.x == 0 && i > 0) {
        ring.push_back(ring[0]);
        continue;
      }
      const double a = sweep * i / segments;
      ring.push_back(part.add({p.x * std::cos(a), p.x * std::sin(a), p.y}));
    }
    rings.push_back(ring);
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    for (int i = 0; i < segments; ++i) {
      const int j = (i + 1) % columns;
      std::vector<int> face{rings[r][i], rings[r][j], rings[r + 1][j], rings[r + 1][i]};
      if (face[0] == face[1]) face.erase(face.begin());
      if (face[face.size() - 1] == face[face.size() - 2]) face.pop_back();
      part.faces.push_back(face);
    }
  return part;
}

/// Points of an arc in the plane of a profile, both ends included.
inline std::vector<Vec2> arc(Vec2 centre, double radius, double from, double to, int steps) {
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double a = (from + (to - from) * i / steps) * pi / 180;
    points.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return points;
}

/// Joins profiles; points that stand twice in succession are one.
inline std::vector<Vec2> joined(const std::vector<std::vector<Vec2>>& parts) {
  std::vector<Vec2> all;
  for (const auto& part : parts)
    for (const Vec2& p : part)
      if (all.empty() || glm::distance(all.back(), p) > 1e-12) all.push_back(p);
  return all;
}

/// A prism over an outline that runs counterclockwise.
inline Part prism(const std::vector<Vec2>& outline, double height) {
  Part part;
  const int n = static_cast<int>(outline.size());
  for (const double z : {0.0, height})
    for (const Vec2& p : outline) part.add({p.x, p.y, z});
  std::vector<int> top, bottom;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    part.faces.push_back({i, j, n + j, n + i});
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
  }
  part.faces.push_back(bottom);
  part.faces.push_back(top);
  return part;
}

inline std::vector<Vec2> regular_polygon(int corners, double radius) {
  std::vector<Vec2> all = arc({0, 0}, radius, 0, 360, corners);
  all.pop_back();
  return all;
}

/// A plate with a hole through its middle, which is the origin; each side of its outline has so many steps.
inline Part plate_with_hole(const std::vector<Vec2>& outline, double height, double radius, int steps) {
  Part part;
  const int n = static_cast<int>(outline.size()) * steps;
  std::vector<std::vector<int>> rings(4);
  for (int i = 0; i < n; ++i) {
    const Vec2 &from = outline[i / steps], &to = outline[(i / steps + 1) % outline.size()];
    const Vec2 out = from + (to - from) * (double(i % steps) / steps);
    const double angle = 2 * pi * i / n;
    const Vec2 in = radius * Vec2(std::cos(angle), std::sin(angle));
    rings[0].push_back(part.add({in.x, in.y, 0}));
    rings[1].push_back(part.add({out.x, out.y, 0}));
    rings[2].push_back(part.add({out.x, out.y, height}));
    rings[3].push_back(part.add({in.x, in.y, height}));
  }
  for (int r = 0; r < 4; ++r)
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n, q = (r + 1) % 4;
      part.faces.push_back({rings[r][i], rings[r][j], rings[q][j], rings[q][i]});
    }
  return part;
}

/// Of a square.
inline Part plate_with_hole(double half_width, double height, double radius, int steps) {
  return plate_with_hole(regular_polygon(4, half_width * std::sqrt(2)), height, radius, steps);
}

/// A sheet over the plane with half as many vertices on its first side, the x axis, as in the row close beside it.
inline Part coarsely_bordered(const std::function<double(double, double)>& height) {
  constexpr int n = 12;
  Part part;
  std::vector<std::vector<int>> rows;
  for (const double y : {0.0, 0.02, 0.3, 0.6, 0.9}) {
    rows.emplace_back();
    for (int i = 0; i <= n; i += y == 0 ? 2 : 1) rows.back().push_back(part.add({0.2 * i, y, height(0.2 * i, y)}));
  }
  for (int i = 0; i < n; i += 2) {
    const int a = rows[0][i / 2], b = rows[0][i / 2 + 1];
    part.faces.push_back({a, b, rows[1][i + 1]});
    part.faces.push_back({a, rows[1][i + 1], rows[1][i]});
    part.faces.push_back({b, rows[1][i + 2], rows[1][i + 1]});
  }
  for (std::size_t r = 1; r + 1 < rows.size(); ++r)
    for (int i = 0; i < n; ++i) {
      part.faces.push_back({rows[r][i], rows[r][i + 1], rows[r + 1][i]});
      part.faces.push_back({rows[r][i + 1], rows[r + 1][i + 1], rows[r + 1][i]});
    }
  return part;
}

/// Walls and a floor below a sheet whose rim runs through these points, counterclockwise from above.
inline void close_below(Part& part, const std::vector<int>& rim, double floor) {
  std::vector<int> foot;
  for (const int v : rim) foot.push_back(part.add({part.points[v].x, part.points[v].y, floor}));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t j = (i + 1) % rim.size();
    part.faces.push_back({foot[i], foot[j], rim[j], rim[i]});
  }
  part.faces.push_back({foot.rbegin(), foot.rend()});
}

/// A sheet of triangles between the points (i, j), i up to `columns` and j up to `rows`, with walls and a floor below
/// it.
inline Part closed_sheet(int columns, int rows, const std::function<Vec3(int, int)>& point, double floor) {
  Part part;
  std::vector<std::vector<int>> grid(columns + 1);
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) grid[i].push_back(part.add(point(i, j)));
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      part.faces.push_back({grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]});
      part.faces.push_back({grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]});
    }
  std::vector<int> rim;
  for (int i = 0; i < columns; ++i) rim.push_back(grid[i][0]);
  for (int j = 0; j < rows; ++j) rim.push_back(grid[columns][j]);
  for (int i = columns; i > 0; --i) rim.push_back(grid[i][rows]);
  for (int j = rows; j > 0; --j) rim.push_back(grid[0][j]);
  close_below(part, rim, floor);
  return part;
}

inline int count(const surfaces::PartFaces& part, surfaces::SurfaceKind kind) {
  int count = 0;
  for (const surfaces::PartFace& face : part.faces) count += face.surface.kind == kind ? 1 : 0;
  return count;
}

inline int count(const surfaces::PartFaces& part, surfaces::BorderKind kind) {
  int count = 0;
  for (const surfaces::PartBorder& border : part.borders) count += border.kind == kind ? 1 : 0;
  return count;
}

/// The only face of a kind.
inline const surfaces::PartFace& only(const surfaces::PartFaces& part, surfaces::SurfaceKind kind) {
  for (const surfaces::PartFace& face : part.faces)
    if (face.surface.kind == kind) return face;
  throw std::logic_error("no such face");
}

/// Rings about z with their own number of vertices, the next one turned by half a step, and triangles between them.
struct Ring {
  double radius, height;
  int count;
};

inline Part stitched(const std::vector<Ring>& rings) {
  Part part;
  std::vector<std::vector<int>> vertices;
  const auto angle = [&](std::size_t ring, int i) { return 2 * pi * (i + 0.5 * double(ring % 2)) / rings[ring].count; };
  for (std::size_t r = 0; r < rings.size(); ++r) {
    vertices.emplace_back();
    for (int i = 0; i < rings[r].count; ++i)
      vertices[r].push_back(part.add(
          {rings[r].radius * std::cos(angle(r, i)), rings[r].radius * std::sin(angle(r, i)), rings[r].height}));
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    const int n = rings[r].count, m = rings[r + 1].count;
    for (int i = 0, j = 0; i < n || j < m;) {
      const bool below = j == m || (i < n && angle(r, i + 1) <= angle(r + 1, j + 1));
      const int a = vertices[r][i % n], b = vertices[r + 1][j % m];
      part.faces.push_back(below ? std::vector{a, vertices[r][(i + 1) % n], b}
                                 : std::vector{a, vertices[r + 1][(j + 1) % m], b});
      ++(below ? i : j);
    }
  }
  part.faces.push_back({vertices.front().rbegin(), vertices.front().rend()});
  part.faces.push_back(vertices.back());
  return part;
}

}  // namespace epura::test
