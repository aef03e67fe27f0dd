// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: parts from programs that cut meshes, not surfaces, are drawn with rings and
// stars of false creases, and pipes that end at other pipes are drawn facet by facet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "shapes.hpp"

namespace epura::cut_facets_test {
namespace {

using namespace test;
using surfaces::BorderKind;
using surfaces::SurfaceKind;

/// What of a convex part lies below a plane.
Part cut(const Part& part, const Vec3& normal, double height) {
  Part kept;
  std::map<int, int> number;
  std::map<std::pair<int, int>, int> between;
  const auto above = [&](int v) { return glm::dot(part.points[v], normal) - height; };
  const auto point = [&](int v) {
    if (!number.contains(v)) number[v] = kept.add(part.points[v]);
    return number[v];
  };
  for (const std::vector<int>& face : part.faces) {
    std::vector<int> left;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (above(a) < 0) left.push_back(point(a));
      if ((above(a) < 0) == (above(b) < 0)) continue;
      const auto [low, high] = std::minmax(a, b);
      const auto [at, is_new] = between.try_emplace({low, high}, 0);
      if (is_new)
        at->second = kept.add(part.points[low] +
                              above(low) / (above(low) - above(high)) * (part.points[high] - part.points[low]));
      left.push_back(at->second);
    }
    if (!left.empty()) kept.faces.push_back(left);
  }
  const Vec3 u = glm::normalize(glm::cross(normal, Vec3(0.3, 0.5, 0.8))), v = glm::cross(normal, u);
  Vec3 middle(0);
  std::vector<int> rim;
  for (const auto& [ends, vertex] : between) rim.push_back(vertex);
  for (const int at : rim) middle += kept.points[at] / double(rim.size());
  const auto turn = [&](int at) {
    const Vec3 from = kept.points[at] - middle;
    return std::atan2(glm::dot(from, v), glm::dot(from, u));
  };
  std::sort(rim.begin(), rim.end(), [&](int a, int b) { return turn(a) < turn(b); });
  kept.faces.push_back(rim);
  return kept;
}

/// As OpenSCAD makes it: so many meridians, half as many parallels, none at a pole.
Part ball(double radius, int meridians) {
  std::vector<Vec2> profile;
  const int rings = meridians / 2;
  for (int i = 0; i < rings; ++i) {
    const double angle = (i + 0.5) * pi / rings;
    profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  Part part = revolved(profile, meridians);
  std::vector<int> low, high;
  for (int i = 0; i < meridians; ++i) {
    low.insert(low.begin(), i);
    high.push_back((rings - 1) * meridians + i);
  }
  part.faces.push_back(low);
  part.faces.push_back(high);
  return part;
}

/// Six digits, as OpenSCAD prints them.
surfaces::PartFaces recognised_when_printed(Part part) {
  part.move([](const Vec3& p) {
    const auto digits = [](double x) {
      const double unit = x == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(x))) - 5);
      return std::round(x / unit) * unit;
    };
    return Vec3(digits(p.x), digits(p.y), digits(p.z));
  });
  return surfaces::recognise_faces(part.triangulate().round_to_float().mesh());
}

TEST(CutFacets, OfASphereBetweenWallsAreNoCylinders) {
  struct Dome {
    double radius;
    int meridians;
    double half_width, turn;
  };
  for (const Dome& d : {Dome{15, 48, 12, 0}, {20, 64, 15, 0}, {10, 36, 7.5, 20}}) {
    SCOPED_TRACE(std::to_string(d.radius) + " " + std::to_string(d.turn));
    Part part = ball(d.radius, d.meridians);
    for (int side = 0; side < 4; ++side) {
      const double angle = (d.turn + 90 * side) * pi / 180;
      part = cut(part, {std::cos(angle), std::sin(angle), 0}, d.half_width);
    }
    const surfaces::PartFaces found = recognised_when_printed(part);
    EXPECT_EQ(found.faces.size(), 5U);
    EXPECT_EQ(count(found, SurfaceKind::plane), 4);
    if (count(found, SurfaceKind::sphere) != 1) continue;
    EXPECT_NEAR(only(found, SurfaceKind::sphere).surface.radius, d.radius, 1e-3);
    EXPECT_EQ(count(found, BorderKind::tangent), 0);
  }
}

TEST(CutFacets, OfASphereInAZoneAreNoCones) {
  for (const int meridians : {24, 40, 48, 100, 160})
    for (const double height : {3.1, 6.0, 9.0}) {
      SCOPED_TRACE(std::to_string(meridians) + " " + std::to_string(height));
      const Part part = cut(cut(ball(12, meridians), {0, 0, 1}, height), {0, 0, -1}, 5.5);
      const surfaces::PartFaces found = recognised_when_printed(part);
      EXPECT_EQ(found.faces.size(), 3U);
      if (count(found, SurfaceKind::sphere) != 1) continue;
      EXPECT_NEAR(only(found, SurfaceKind::sphere).surface.radius, 12, 1e-3);
    }
}

// A cone that touches the sphere rises from it.
TEST(CutFacets, AreToldFromATangentCone) {
  for (const int steps : {24, 60, 120})
    for (const double length : {0.2, 0.5, 2.0}) {
      SCOPED_TRACE(std::to_string(steps) + " " + std::to_string(length));
      const double slope = 40 * pi / 180;
      const Vec2 end = 10.0 * Vec2(std::cos(slope), std::sin(slope)), along(-std::sin(slope), std::cos(slope));
      const Vec2 tip = end + length * along;
      const Part part = revolved(joined({{{0, -10}}, arc({0, 0}, 10, -90, 40, steps / 2), {tip, {0, tip.y}}}), steps);
      const surfaces::PartFaces found = surfaces::recognise_faces(Part(part).triangulate().round_to_float().mesh());
      EXPECT_EQ(found.faces.size(), 3U);
      EXPECT_EQ(count(found, SurfaceKind::cone), 1);
      EXPECT_EQ(count(found, BorderKind::tangent), 1);
    }
}

// So is a narrow chamfer.
TEST(CutFacets, AreToldFromAChamfer) {
  for (const int steps : {24, 60}) {
    for (const double width : {0.05, 0.2, 0.6}) {
      SCOPED_TRACE(std::to_string(steps) + " " + std::to_string(width));
      const Vec2 end(8, 6);
      const Part part = revolved(joined({{{0, -10}},
                                         arc({0, 0}, 10, -90, 36.869897645844, steps / 2),
                                         {end + width * Vec2(-1, 0.2), {0, 6 + 0.2 * width}}}),
                                 steps);
      const surfaces::PartFaces found = surfaces::recognise_faces(Part(part).triangulate().round_to_float().mesh());
      EXPECT_EQ(found.faces.size(), 3U);
      EXPECT_EQ(count(found, SurfaceKind::cone), 1);
    }
  }
}

/// A pin of so many facets about the y axis, which come first, whose end fits the facets of a shaft about z, as
/// programs cut it that know no surfaces.
Part pin_on_shaft(double radius, int facets, double shaft, int of_shaft) {
  std::vector<double> breaks;  // of the shaft's facets, across
  std::vector<Vec2> rim;
  for (int i = 0; i <= of_shaft; ++i) {
    const double angle = pi * i * 2 / of_shaft;
    if (angle > pi) break;
    rim.push_back(shaft * Vec2(-std::cos(angle), std::sin(angle)));
    breaks.push_back(rim.back().x);
  }
  if (rim.back().x < shaft) rim.push_back({shaft, 0});
  const auto depth = [&](double x) {
    for (std::size_t i = 0; i + 1 < rim.size(); ++i)
      if (x >= rim[i].x && x <= rim[i + 1].x)
        return rim[i].y + (x - rim[i].x) / (rim[i + 1].x - rim[i].x) * (rim[i + 1].y - rim[i].y);
    return 0.0;
  };
  const std::vector<Vec2> round = regular_polygon(facets, radius);
  Part part;
  std::vector<int> far;
  std::vector<std::vector<int>> near(facets);  // by facet, from its first corner on
  for (int i = 0; i < facets; ++i) {
    const Vec2 a = round[i], b = round[(i + 1) % facets];
    far.push_back(part.add({a.x, 30, a.y}));
    std::vector<double> at{0};
    for (const double x : breaks)
      if (std::abs(x - (a.x + b.x) / 2) < std::abs(a.x - b.x) / 2 - 1e-9) at.push_back((x - a.x) / (b.x - a.x));
    std::sort(at.begin(), at.end());
    for (const double t : at) {
      const Vec2 p = a + t * (b - a);
      near[i].push_back(part.add({p.x, depth(p.x), p.y}));
    }
  }
  for (int i = 0; i < facets; ++i) {
    const int j = (i + 1) % facets;
    std::vector<int> face = near[i];
    face.insert(face.end(), {near[j].front(), far[j], far[i]});
    part.faces.push_back(face);
  }
  part.faces.push_back({far.rbegin(), far.rend()});
  // The end, facet by facet of the shaft: the upper half of the outline in it, and then the lower one.
  std::vector<int> all;
  for (const std::vector<int>& one : near) all.insert(all.end(), one.begin(), one.end());
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
    std::vector<int> face;
    for (const bool upper : {true, false}) {
      std::vector<int> half;
      for (const int v : all)
        if (part.points[v].x > rim[i].x - 1e-9 && part.points[v].x < rim[i + 1].x + 1e-9 &&
            (upper ? part.points[v].z > 1e-9 : part.points[v].z <= 1e-9))
          half.push_back(v);
      std::sort(half.begin(), half.end(), [&](int v, int w) { return part.points[v].x < part.points[w].x; });
      if (upper) std::reverse(half.begin(), half.end());
      face.insert(face.end(), half.begin(), half.end());
    }
    if (face.size() >= 3) part.faces.push_back({face.rbegin(), face.rend()});
  }
  return part;
}

TEST(CutFacets, OfAPipeThatEndsAtFinerFacetsAreOneCylinder) {
  struct Pipe {
    double radius;
    int facets;
    double shaft;
    int of_shaft;
  };
  for (const Pipe& p : {Pipe{8, 200, 12, 200},
                        {5, 200, 9, 200},
                        {8, 160, 12, 160},
                        {8, 32, 12, 256},
                        {8, 24, 12, 90},
                        {5, 180, 9, 60}}) {
    SCOPED_TRACE(std::to_string(p.facets) + " " + std::to_string(p.of_shaft));
    const Part part = pin_on_shaft(p.radius, p.facets, p.shaft, p.of_shaft);
    double area = 0;  // around the pin
    for (int i = 0; i < p.facets; ++i) {
      const std::vector<int>& face = part.faces[i];
      Vec3 twice(0);
      for (std::size_t k = 1; k < face.size(); ++k)
        twice +=
            glm::cross(part.points[face[k - 1]] - part.points[face[0]], part.points[face[k]] - part.points[face[0]]);
      area += glm::length(twice) / 2;
    }
    const surfaces::PartFaces found = recognised_when_printed(part);
    const auto is_pin = [&](const surfaces::PartFace& face) {
      return face.surface.kind == SurfaceKind::cylinder && std::abs(face.surface.radius - p.radius) < 1e-3;
    };
    const auto pin = std::find_if(found.faces.begin(), found.faces.end(), is_pin);
    ASSERT_NE(pin, found.faces.end());
    EXPECT_EQ(std::count_if(found.faces.begin(), found.faces.end(), is_pin), 1);
    // The tips of its end, which are narrow, may be taken for pieces of it.
    EXPECT_GT(pin->area, (1 - 1e-6) * area);
    EXPECT_NEAR(pin->sweep, 360, 1e-6);
  }
}

}  // namespace
}  // namespace epura::cut_facets_test
