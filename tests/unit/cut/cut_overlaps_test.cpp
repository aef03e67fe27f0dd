// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_overlaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cut/cut_world.hpp"
#include "shapes.hpp"

namespace epura::test::cut_overlaps_test {
namespace {

mesh::Outlines ring(const std::vector<Vec2>& corners) {
  mesh::Outlines outlines{corners, {}};
  const int count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) outlines.segments.push_back({i, (i + 1) % count});
  return outlines;
}

mesh::Outlines rectangle(const Vec2& min, const Vec2& max) { return ring({min, {max.x, min.y}, max, {min.x, max.y}}); }

mesh::Outlines polygon(const Vec2& centre, double radius, int count, double turn) {
  std::vector<Vec2> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / count;
    corners.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring(corners);
}

double area_outside(const mesh::Outlines& under, const mesh::Outlines& over) {
  const auto rest = cut::part_outside(under, over);
  EXPECT_TRUE(rest.has_value());
  return rest && !rest->outlines.segments.empty() ? cut::area_of(rest->outlines).size : 0;
}

TEST(CutOverlaps, HaveAreasInCommon) {
  const mesh::Outlines square = rectangle({0, 0}, {4, 4});
  EXPECT_NEAR(cut::area_of(square).size, 16, 1e-12);
  const cut::FlatArea common = cut::common_area(square, rectangle({3, 1}, {9, 3}));
  EXPECT_NEAR(common.size, 2, 1e-12);
  EXPECT_NEAR(common.middle.x, 3.5, 1e-12);
  EXPECT_NEAR(common.middle.y, 2, 1e-12);
  EXPECT_NEAR(cut::common_area(square, rectangle({4, 0}, {8, 4})).size, 0, 1e-12) << "they touch";
  EXPECT_NEAR(cut::common_area(square, rectangle({1, 1}, {2, 2})).size, 1, 1e-12) << "one is inside";
}

TEST(CutOverlaps, LeaveWhatIsOutside) {
  const mesh::Outlines square = rectangle({0, 0}, {4, 4});
  EXPECT_NEAR(area_outside(square, rectangle({3, 1}, {9, 3})), 14, 1e-12);
  EXPECT_NEAR(area_outside(square, rectangle({-1, 1}, {9, 3})), 8, 1e-12) << "in two parts";
  EXPECT_NEAR(area_outside(square, rectangle({1, 1}, {2, 3})), 14, 1e-12) << "with a hole";
  EXPECT_NEAR(area_outside(square, rectangle({4, 1}, {9, 3})), 16, 1e-12) << "they touch";
  EXPECT_NEAR(area_outside(square, rectangle({1, 0}, {3, 2})), 12, 1e-12) << "with a side in common";
  EXPECT_NEAR(area_outside(square, rectangle({0, 0}, {4, 2})), 8, 1e-12) << "with three";
  EXPECT_NEAR(area_outside(square, square), 0, 1e-12);
  EXPECT_NEAR(area_outside(square, rectangle({-1, -1}, {9, 9})), 0, 1e-12);
}

// The closed form of areas is an oracle: what is left and what is in common are the whole.
TEST(CutOverlaps, OfRandomPolygonsAddUp) {
  std::mt19937 random(3);
  const auto uniform = [&](double from, double to) { return from + (to - from) * double(random()) / 4294967296.0; };
  for (int i = 0; i < 200; ++i) {
    const mesh::Outlines under = polygon({uniform(-2, 2), uniform(-2, 2)}, uniform(1, 4), 3 + i % 9, uniform(0, 6)),
                         over = polygon({uniform(-2, 2), uniform(-2, 2)}, uniform(0.5, 3), 3 + i % 7, uniform(0, 6));
    const double common = cut::common_area(under, over).size, whole = cut::area_of(under).size;
    EXPECT_NEAR(area_outside(under, over), whole - common, 1e-9) << i;
    EXPECT_NEAR(area_outside(over, under), cut::area_of(over).size - common, 1e-9) << i;
  }
}

// A profile in the x, z plane, counterclockwise from the front, from y = 0 to y = 4, with edges along it in between.
Shape prism(const std::vector<Vec2>& profile, const std::vector<double>& places = {0, 4}) {
  Shape shape;
  const int n = static_cast<int>(profile.size()), last = n * (static_cast<int>(places.size()) - 1);
  for (const double y : places)
    for (const Vec2& p : profile) shape.points.push_back({p.x, y, p.y});
  std::vector<int> front, back;
  for (int i = 0; i < n; ++i) {
    front.push_back(i);
    back.push_back(last + n - 1 - i);
    for (int from = 0; from < last; from += n)
      shape.faces.push_back({from + (i + 1) % n, from + i, from + n + i, from + n + (i + 1) % n});
  }
  shape.faces.push_back(front);
  shape.faces.push_back(back);
  return shape;
}

cut::CutWorld cut_in_the_middle(const std::vector<Shape>& models) {
  return cut::cut_world(world_of(models), scene::make_cutting_plane({{"A", "--section"}, {0, 2, 0}, {0, -1, 0}}));
}

double area_of_faces(const cut::CutWorld& result) {
  double area = 0;
  for (const cut::WorldCutFace& face : result.faces) {
    mesh::Outlines outlines;
    for (const std::vector<int>& corners : face.rings) {
      const int first = static_cast<int>(outlines.places.size()), count = static_cast<int>(corners.size());
      for (int i = 0; i < count; ++i) {
        const Vec3& p = result.world.points[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
        outlines.places.emplace_back(p.x, p.z);
        outlines.segments.push_back({first + i, first + (i + 1) % count});
      }
    }
    area += cut::area_of(outlines).size;
  }
  return area;
}

// Screws with the outer diameter of their thread in a hole with the core diameter: in a block, and in a nut that is
// smaller than they are.
TEST(CutOverlaps, AScrewCoversTheCoreOfItsThread) {
  const Shape screw = prism({{-5, 10}, {5, 10}, {5, 40}, {9, 40}, {9, 46}, {-9, 46}, {-9, 40}, {-5, 40}});
  for (const auto& [half, low, high] : {std::array{25.0, 0.0, 40.0}, std::array{8.0, 20.0, 28.0}}) {
    Shape block = prism({{-half, low}, {-4.25, low}, {-4.25, high}, {-half, high}});
    block.add(prism({{4.25, low}, {half, low}, {half, high}, {4.25, high}}));
    const double depth = high - std::max(low, 10.0), own = 10 * 30 + 18 * 6, around = 2 * (half - 4.25) * (high - low);
    for (const bool is_first : {true, false}) {
      const std::vector<Shape> models = is_first ? std::vector{screw, block} : std::vector{block, screw};
      const cut::CutWorld result = cut_in_the_middle(models);
      EXPECT_NEAR(area_of_faces(result), own + around - 2 * 0.75 * depth, 1e-9);
      ASSERT_EQ(result.overlaps.size(), 2U) << "with both sides of the hole, which are bodies here";
      for (const cut::OverlappingBodies& overlap : result.overlaps) EXPECT_NEAR(overlap.area, 0.75 * depth, 1e-9);
    }
  }
}

// The same as one body: the middle of both strips is in the screw, which covers even a smaller nut.
TEST(CutOverlaps, TheInnerBodyCoversTheOuterOne) {
  const Shape screw = prism({{-5, 0}, {5, 0}, {5, 60}, {-5, 60}});
  const Shape nut = prism({{-8, 20}, {8, 20}, {8, 28}, {4.25, 28}, {4.25, 20.5}, {-4.25, 20.5}, {-4.25, 28}, {-8, 28}});
  for (const bool is_first : {true, false}) {
    const cut::CutWorld result = cut_in_the_middle(is_first ? std::vector{screw, nut} : std::vector{nut, screw});
    ASSERT_EQ(result.overlaps.size(), 1U);
    EXPECT_EQ(result.overlaps[0].model, is_first ? 0 : 1);
    EXPECT_EQ(result.overlaps[0].under_model, is_first ? 1 : 0);
    EXPECT_NEAR(area_of_faces(result), 10 * 60 + 2 * 3 * 8, 1e-9);
  }
}

// A pin that fills its hole in a plate stays whole whatever the section shows more of.
TEST(CutOverlaps, TheSmallerBodyCoversTheLargerOne) {
  const Shape pin = prism({{-6, -20}, {6, -20}, {6, 25}, {-6, 25}}),
              plate = prism({{-30, 0}, {30, 0}, {30, 8}, {-30, 8}}, {-20, 24});
  for (const bool is_first : {true, false}) {
    const cut::CutWorld result = cut_in_the_middle(is_first ? std::vector{pin, plate} : std::vector{plate, pin});
    ASSERT_EQ(result.overlaps.size(), 1U);
    EXPECT_EQ(result.overlaps[0].model, is_first ? 0 : 1);
    EXPECT_NEAR(result.overlaps[0].area, 12 * 8, 1e-9);
    EXPECT_NEAR(area_of_faces(result), 12 * 45 + 48 * 8, 1e-9);
  }
}

// Also where the walls of the hole have edges of the file in the plane, as facets of round holes do: below the screw
// they are outlines, and along it nothing is drawn.
TEST(CutOverlaps, WallsInThePlaneEndAtTheScrew) {
  const Shape screw = prism({{-5, 10}, {5, 10}, {5, 40}, {-5, 40}}, {0, 2, 4});
  const Shape block =
      prism({{-25, -5}, {25, -5}, {25, 40}, {4.25, 40}, {4.25, 0}, {-4.25, 0}, {-4.25, 40}, {-25, 40}}, {0, 2, 4});
  const cut::CutWorld result = cut_in_the_middle({screw, block});
  ASSERT_EQ(result.overlaps.size(), 1U);
  for (const double wall : {-4.25, 4.25}) {
    double outline = 0;
    for (const mesh::MeshEdge& edge : result.world.models[1].mesh->edges) {
      const Vec3 p = result.world.models[1].mesh->point(edge.vertex[0]),
                 q = result.world.models[1].mesh->point(edge.vertex[1]);
      const bool is_in_wall = p.x == wall && q.x == wall && p.z >= 0 && q.z >= 0;  // the rest divides the cut face
      if (edge.count == 0 || p.y != 2 || q.y != 2 || !is_in_wall) continue;
      const bool is_below = (p.z + q.z) / 2 < 10;
      EXPECT_EQ(edge.cut, is_below ? mesh::CutEdge::outline : mesh::CutEdge::inside) << p.z << " to " << q.z;
      if (is_below) outline += std::abs(q.z - p.z);
    }
    EXPECT_NEAR(outline, 10, 1e-9);
  }
}

// Facets of a shaft and of its bore overlap a little; bodies with faces in common do not.
TEST(CutOverlaps, BodiesThatTouchDoNotOverlap) {
  const auto arc = [](double radius, int parts, double from, double to) {
    std::vector<Vec2> corners;
    for (int i = 0; i <= parts; ++i) {
      const double angle = from + (to - from) * i / parts;
      corners.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
  };
  const double half_turn = std::numbers::pi;
  std::vector<Vec2> shaft = arc(8, 64, 0, 2 * half_turn);
  shaft.pop_back();
  std::vector<Shape> models{prism(shaft)};
  for (const double from : {0.0, half_turn}) {
    std::vector<Vec2> around = arc(20, 24, from, from + half_turn), bore = arc(8, 31, from + half_turn, from);
    around.insert(around.end(), bore.begin(), bore.end());
    models.push_back(prism(around));
  }
  EXPECT_TRUE(cut_in_the_middle(models).overlaps.empty());
  EXPECT_TRUE(cut_in_the_middle({prism({{0, 0}, {5, 0}, {5, 5}, {0, 5}}), prism({{5, 0}, {9, 0}, {9, 9}, {5, 9}}),
                                 prism({{0, 5}, {5, 5}, {5, 8}, {0, 8}})})
                  .overlaps.empty());
}

}  // namespace
}  // namespace epura::test::cut_overlaps_test
