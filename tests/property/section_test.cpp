// Sections: what is left of a part is drawn like a part of that shape; cut faces hide what lies behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing/cut_faces.hpp"
#include "shapes.hpp"

namespace epura::test {
namespace {

CuttingPlane plane_at(const Vec3& point, const Vec3& normal) {
  return make_cutting_plane({{"A", "--section"}, point, normal});
}

Result draw_cut(const World& world, const CuttingPlane& plane, const Projection& projection,
                const ViewLimits& limits = {}) {
  return draw(cut_world(world, plane).world, projection, {}, limits);
}

// A tube of square section along y, closed by a wall at each end.
Shape hollow(double from, double to) {
  Shape shape = box({0, from, 0}, {4, to, 4});
  Shape inside = box({1, from + 1, 1}, {3, to - 1, 3});
  for (auto& face : inside.faces) std::reverse(face.begin(), face.end());
  shape.add(inside);
  return shape;
}

// The same, open at y = from: a cup.
Shape cup(double from, double to) {
  Shape shape = box({0, from, 0}, {4, to, 4});
  shape.add(box({1, from, 1}, {3, to - 1, 3}));
  const auto lies_at = [&](const std::vector<int>& face) {
    return std::all_of(face.begin(), face.end(), [&](int v) { return shape.points[v][1] == from; });
  };
  std::erase_if(shape.faces, lies_at);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 5), std::pair(5, 4), std::pair(4, 0)})
    shape.faces.push_back({a, b, 8 + b, 8 + a});
  return shape;
}

const std::vector<Vec3> directions = {{1, -1, 1}, {-1, -2, 0.5}, {0.3, -1, -0.7}, {1, 1, 1}, {0, -1, 0}, {0, 0, 1}};

TEST(Section, OfABoxLooksLikeTheShorterBox) {
  const World whole = world_of(box({0, 0, 0}, {4, 6, 4})), half = world_of(box({0, 2.5, 0}, {4, 6, 4}));
  for (const Vec3& direction : directions) {
    const Vec3 up = direction.z == 1 && direction.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Result cut = draw_cut(whole, plane_at({1, 2.5, 1}, {0, -1, 0}), orthographic(direction, up));
    const Result expected = draw(half, orthographic(direction, up));
    EXPECT_NEAR(cut.visible(), expected.visible(), 1e-8);
    EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-8);
  }
}

TEST(Section, OfAHollowBoxLooksLikeACup) {
  const World whole = world_of(hollow(-6, 6)), half = world_of(cup(0, 6));
  for (const Vec3& direction : directions) {
    const Vec3 up = direction.z == 1 && direction.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Result cut = draw_cut(whole, plane_at({0, 0, 0}, {0, -1, 0}), orthographic(direction, up));
    const Result expected = draw(half, orthographic(direction, up));
    EXPECT_NEAR(cut.visible(), expected.visible(), 1e-8);
    EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-8);
  }
  const Projection eye = perspective({2, -12, 9}, {0, 0, 0}, {0, -1, 0.3}, {0, 0, 1});
  const Result cut = draw_cut(whole, plane_at({0, 0, 0}, {0, -1, 0}), eye), expected = draw(half, eye);
  EXPECT_NEAR(cut.visible(), expected.visible(), 1e-7);
  EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-7);
}

TEST(Section, CutFacesHideWhatLiesBehind) {
  const World world = world_of({box({0, 0, 0}, {4, 4, 4}), box({1, 5, 1}, {3, 6, 3})});
  const Result cut = draw_cut(world, plane_at({0, 2, 0}, {0, -1, 0}), orthographic({0, -1, 0}));
  EXPECT_NEAR(cut.visible(), 16, 1e-8);
  EXPECT_NEAR(cut.hidden_length(), 8, 1e-8);
  for (const Segment& segment : cut.drawing.segments)
    if (segment.model == 0) {
      EXPECT_TRUE(segment.visible);
    }
}

TEST(Section, WhatIsTakenAwayNeitherHidesNorCrosses) {
  // A wall in front of a box, and a bar that runs through the wall only.
  const World world =
      world_of({box({-5, -3, -5}, {5, -2, 5}), box({0, -10, 0}, {1, -1, 1}), box({-1, 0, -1}, {2, 3, 2})});
  const CuttingPlane plane = plane_at({0, 1, 0}, {0, -1, 0});
  const Result cut = draw_cut(world, plane, orthographic({0.1, -1, 0.2}));
  const Result alone = draw_cut(world_of(box({-1, 0, -1}, {2, 3, 2})), plane, orthographic({0.1, -1, 0.2}));
  EXPECT_NEAR(cut.visible(), alone.visible(), 1e-7);
  EXPECT_NEAR(cut.hidden_length(), alone.hidden_length(), 1e-7);
  for (const Segment& segment : cut.drawing.segments) EXPECT_NE(segment.kind, EdgeKind::intersection);
}

TEST(Section, LinesSayWhereTheyAreInTheFile) {
  const World whole = world_of(box({0, 0, 0}, {4, 6, 4}));
  const Result cut = draw_cut(whole, plane_at({1, 2.5, 1}, {0, -1, 0}), orthographic({1, -1, 1}));
  int along_y = 0, outline = 0;
  for (const Segment& segment : cut.drawing.segments) {
    const auto page = [&](const Vec3& p) { return Vec2(cut.drawing.world_to_page * Vec4(p, 1)); };
    std::array<Vec3, 2> ends;
    if (segment.edge[0] < 0) {
      ++outline;
      EXPECT_EQ(segment.kind, EdgeKind::section);
      const CrossingSegment& crossing = cut.drawing.crossings.at(segment.crossing);
      EXPECT_EQ(crossing.faces[1][0], -1);
      EXPECT_LT(crossing.faces[0][1], 6);
      ends = crossing.world;
      EXPECT_NEAR(ends[0].y, 2.5, 1e-15);
    } else {
      const Vec3 p = whole.points[segment.edge[0]], q = whole.points[segment.edge[1]];
      ends = {p + segment.t[0] * (q - p), p + segment.t[1] * (q - p)};
      along_y += p.y != q.y ? 1 : 0;
    }
    EXPECT_LT(glm::distance(page(ends[0]), segment.from), 1e-12);
    EXPECT_LT(glm::distance(page(ends[1]), segment.to), 1e-12);
  }
  EXPECT_EQ(outline, 8);  // two triangles of each face
  EXPECT_EQ(along_y, 4);
}

double ring_area(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return std::abs(sum);
}

TEST(Section, FacesOnPaperAreSeenFromInFrontAndWithinTheWindow) {
  const CuttingPlane plane = plane_at({1, 2.5, 1}, {0, -1, 0});
  const CutWorld cut = cut_world(world_of(box({0, 0, 0}, {4, 6, 4})), plane);
  Projection front = orthographic({0, -1, 0});
  View view = make_view(cut.world, front, {});
  const double unit = 1 / (view.map.shrink * view.map.shrink);
  const auto faces = cut_faces_on_paper(cut.faces, plane, view, {1, Vec2(0)});
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(ring_area(faces[0].rings.at(0)) * unit, 16, 1e-12);
  View behind = make_view(cut.world, orthographic({0, 1, 0.5}), {});
  EXPECT_TRUE(cut_faces_on_paper(cut.faces, plane, behind, {1, Vec2(0)}).empty());
  front.window = Window{{1, 1}, {3, 9}};
  View part = make_view(cut.world, front, {});
  EXPECT_NEAR(ring_area(cut_faces_on_paper(cut.faces, plane, part, {1, Vec2(0)}).at(0).rings.at(0)) * unit, 6, 1e-12);
}

}  // namespace
}  // namespace epura::test
