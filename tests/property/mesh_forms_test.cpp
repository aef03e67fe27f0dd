// SPDX-License-Identifier: Apache-2.0
// Meshes that trouble other hidden-line programs: lengths known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measured.hpp"
#include "shapes.hpp"

namespace epura::test::mesh_forms_test {
namespace {

using namespace stability;

const Lab lab;
const double r = std::sqrt(2.0 / 3.0);
const Vec3 diagonal(1, 1, 1);

Shape two_boxes(double gap) {
  Shape both = box({0, 0, 0}, {1, 1, 1});
  both.add(box({1 + gap, 0, 0}, {2 + gap, 1, 1}));
  return both;
}

void expect_cube(const Result& cube) {
  EXPECT_NEAR(cube.visible(), 9 * r, 1e-8);
  EXPECT_NEAR(cube.hidden_length(), 3 * r, 1e-8);
}

TEST(Meshes, BoxesInContact) {
  const Result result = draw(world_of(two_boxes(0)), orthographic(diagonal));
  EXPECT_NEAR(result.visible(), 14 * r, 1e-8);
  EXPECT_NEAR(result.hidden_length(), 5 * r, 1e-8);
}

TEST(Meshes, BoxesInContactAsTwoModels) {
  const Result result = draw(world_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}), orthographic(diagonal));
  EXPECT_NEAR(result.visible(), 14 * r, 1e-8);
  EXPECT_NEAR(result.hidden_length(), 5 * r, 1e-8);
}

TEST(Meshes, BoxesWithAGap) {
  for (double g = 1e-1; g > 5e-8; g /= 10) {
    const Result result = draw(world_of(two_boxes(g)), orthographic(diagonal));
    EXPECT_NEAR(result.visible(), (16 + 2 * g) * r, 1e-6) << g;
    EXPECT_NEAR(result.hidden_length(), (7 - g) * r, 1e-6) << g;
  }
  for (const double g : {1e-11, 1e-13, 1e-15}) {
    const Result result = draw(world_of(two_boxes(g)), orthographic(diagonal));
    EXPECT_NEAR(result.visible(), 14 * r, 1e-6) << g;
    EXPECT_NEAR(result.hidden_length(), 5 * r, 1e-6) << g;
  }
}

TEST(Meshes, CubeTwiceWithOtherDiagonals) {
  Shape twice = triangulated_cube(false);
  twice.add(triangulated_cube(true));
  expect_cube(draw(world_of(twice), orthographic(diagonal)));
  expect_cube(draw(world_of({triangulated_cube(false), triangulated_cube(true)}), orthographic(diagonal)));
}

TEST(Meshes, OrientationDoesNotMatter) {
  for (unsigned flipped = 0; flipped < 4096; flipped += 117) {
    Shape cube = triangulated_cube();
    for (std::size_t f = 0; f < cube.faces.size(); ++f)
      if ((flipped >> f & 1U) != 0) std::swap(cube.faces[f][0], cube.faces[f][1]);
    expect_cube(draw(world_of(cube), orthographic(diagonal)));
  }
}

TEST(Meshes, CubeWithACavity) {
  for (const bool outward : {false, true}) {
    const Result result = draw(world_of(cube_with_a_cavity(outward)), orthographic(diagonal));
    EXPECT_NEAR(result.visible(), 27 * r, 1e-8);
    EXPECT_NEAR(result.hidden_length(), 15 * r, 1e-8);
  }
}

TEST(Meshes, CrossingPlates) {
  // Two 2 x 1 plates that cross at a right angle in their middle line. Seen from above at 60 degrees along it, the
  // front half of the upright one hides part of the lying one's rear.
  Shape plates{{{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}, {}};
  plates.add({{{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}}, {{0, 1, 2, 3}}, {}});
  const Vec3 towards(1, -1, 1);
  const Result without = draw(world_of(plates), orthographic(towards), {.intersection = false});
  const Result with = draw(world_of(plates), orthographic(towards), {.intersection = true});
  EXPECT_NEAR(with.visible() - without.visible(), r, 1e-9);
  EXPECT_NEAR(with.hidden_length(), without.hidden_length(), 1e-9);
  EXPECT_NEAR(without.visible() + without.hidden_length(), 12 * r, 1e-9);
  // Hidden: of the lying plate x < 0 behind the upright upper half, of the upright plate z < 0 below the lying front.
  EXPECT_GT(without.hidden_length(), 1);
  double length = 0;
  for (const drawing::CrossingSegment& s : with.drawing.crossings) length += glm::length(s.world[1] - s.world[0]);
  EXPECT_NEAR(length, 1, 1e-12);
}

TEST(Meshes, CrossingAlongAnEdgeOfATriangulation) {
  // The lying plate is split exactly where the upright one passes through it: both halves only touch its plane.
  Shape plates{{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}}, {}};
  plates.add({{{0, -0.5, -1}, {0, 1.5, -1}, {0, 1.5, 1}, {0, -0.5, 1}}, {{0, 1, 2, 3}}, {}});
  const Result result = draw(world_of(plates), orthographic({1, -1, 1}));
  double length = 0;
  for (const edges::FaceCrossing& c : result.drawn.crossings) length += glm::length(c.ends[1] - c.ends[0]);
  EXPECT_NEAR(length, 1, 1e-12);
}

TEST(Meshes, TouchingFacesDoNotCross) {
  // A box standing on a table, a box hanging below it, and a box beside the first one.
  Shape scene = plate(-5, -5, 5, 5, 0);
  scene.add(box({0, 0, 0}, {1, 1, 1}));
  scene.add(box({2, 2, -1}, {3, 3, 0}));
  scene.add(box({1, 0, 0}, {2, 1, 1}));
  EXPECT_TRUE(draw(world_of(scene), orthographic({1, -2, 1})).drawn.crossings.empty());
}

TEST(Meshes, InterpenetratingBoxes) {
  // A bar through a cube: it enters and leaves in squares of side 1.
  Shape scene = box({0, 0, 0}, {3, 3, 3});
  scene.add(box({-1, 1, 1}, {4, 2, 2}));
  const Result result = draw(world_of(scene), orthographic({1, -2, 1.5}));
  double length = 0;
  for (const edges::FaceCrossing& c : result.drawn.crossings) length += glm::length(c.ends[1] - c.ends[0]);
  EXPECT_NEAR(length, 8, 1e-9);
}

TEST(Meshes, CyclicOverlap) {
  // Four bars, each over the next and under the one before; every crossing hides 2 lengths of 1 of the lower bar.
  const double w = 1, l = 7;
  const auto bar = [&](double x, double y, bool along_x, double from, double to) {
    Shape s;
    if (along_x)
      s.points = {{x, y, from}, {x + l, y, to}, {x + l, y + w, to}, {x, y + w, from}};
    else
      s.points = {{x, y, from}, {x + w, y, from}, {x + w, y + l, to}, {x, y + l, to}};
    s.faces = {{0, 1, 2, 3}};
    return s;
  };
  Shape weave = bar(0, 1, true, 0, 1);
  weave.add(bar(5, 0, false, 0, 1));
  weave.add(bar(0, 5, true, 1, 0));
  weave.add(bar(1, 0, false, 1, 0));
  const Result result = draw(world_of(weave), from_above());
  EXPECT_NEAR(result.hidden_length(), 8, 1e-7);
  EXPECT_NEAR(result.visible() + result.hidden_length(), 64, 1e-7);
}

TEST(Meshes, StripsOverStrips) { expect_right(strips_over_strips(lab, 20, 15, 0.3)); }

TEST(Meshes, StackOfPlates) { expect_right(stack_of_plates(lab, 300, 1e-3)); }

TEST(Meshes, PlatesAlongALine) {
  for (const double shift : {1e-6, 1e-3}) expect_right(plates_along_a_line(lab, 300, shift));
}

TEST(Meshes, LineThroughATJunction) {
  // Three triangles, one side of the first split by a vertex of the others.
  const Shape junction{
      {{0.5, -1, 1}, {0.5, 1, 1}, {-1, 0, 1}, {0.5, 0, 1}, {2, 0, 1}}, {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}}, {}};
  const auto spans =
      hidden_of_line(world_of({junction, plate(-4, -4, 4, 4, -1)}), from_above(), {-2.5, 0, 0}, {3.5, 0, 0});
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_NEAR(spans[0][0], 0.25, 1e-9);
  EXPECT_NEAR(spans[0][1], 0.75, 1e-9);
}

TEST(Meshes, ManySlivers) { expect_right(sliver_plate(lab, 20000)); }

TEST(Meshes, TrianglesWithoutAreaChangeNothing) {
  for (const int parts : {2, 3, 4}) {
    expect_right(triangles_without_area(lab, 1, parts));
    expect_right(triangles_without_area(lab, 5, parts));
  }
}

TEST(Meshes, RowsOfTrianglesWithoutAreaChangeNothing) {
  for (const int parts : {9, 10, 12, 16}) expect_right(triangles_without_area(lab, 1, parts));
}

TEST(Meshes, LongRowsOfTrianglesWithoutAreaChangeNothing) { expect_right(triangles_without_area(lab, 1, 64)); }

TEST(Meshes, FanWithAManyValentHub) { expect_right(fan_over_chords(lab, 20000)); }

TEST(Meshes, BookOfPages) {
  // Three square pages on one spine along y: at 45, 90 and 135 degrees, seen from above.
  Shape book;
  for (const double angle : {45.0, 90.0, 135.0}) {
    const double a = angle * M_PI / 180;
    Shape page{
        {{0, 0, 0}, {std::cos(a), 0, std::sin(a)}, {std::cos(a), 1, std::sin(a)}, {0, 1, 0}}, {{0, 1, 2, 3}}, {}};
    if (angle == 90) page.points[1][0] = page.points[2][0] = 0;
    book.add(page);
  }
  const Result result = draw(world_of(book), from_above());
  EXPECT_NEAR(result.visible(), 3 + 4 * std::cos(M_PI / 4), 1e-8);
  EXPECT_NEAR(result.hidden_length(), 0, 1e-8);
}

TEST(Meshes, MoebiusStrip) {
  const int n = 40;
  const Shape strip = moebius(n);
  const Result first = draw(world_of(strip), orthographic({1, -2, 3}));
  EXPECT_EQ(first.world.models[0].mesh->report.open_edges, 80);
  EXPECT_EQ(first.world.models[0].mesh->report.non_manifold_edges, 0);
  for (const int start : {7, 23}) {
    // The same surface with other numbers and orientations.
    Shape turned = strip;
    std::rotate(turned.points.begin(), turned.points.begin() + 2 * start, turned.points.end());
    for (auto& face : turned.faces) {
      for (int& v : face) v = (v - 2 * start + 2 * n) % (2 * n);
      if (face[0] % 3 == 0) std::swap(face[1], face[2]);
    }
    std::rotate(turned.faces.begin(), turned.faces.begin() + start, turned.faces.end());
    const Result result = draw(world_of(turned), orthographic({1, -2, 3}));
    EXPECT_NEAR(result.visible(), first.visible(), 1e-9);
    EXPECT_NEAR(result.hidden_length(), first.hidden_length(), 1e-9);
  }
}

TEST(Meshes, SphereAlongItsAxis) { expect_right(sphere_along_its_axis(lab, 64, 32)); }

TEST(Meshes, SphereFromAnywhere) {
  for (const double distance : {1.5, 10.0, HUGE_VAL}) expect_right(sphere_from_anywhere(lab, 64, 32, distance));
}

TEST(Meshes, Zonotope) { expect_right(zonotope(lab, 24)); }

TEST(Meshes, StackedCopiesAreOneLine) { expect_right(stacked_copies(lab, 300)); }

TEST(Meshes, SphereInAStadium) { expect_right(sphere_in_a_stadium(lab, 64, 32, 1000)); }

TEST(Meshes, Needles) { expect_right(needles(lab, 200), 1); }

TEST(Meshes, PrismAtTheCreaseThreshold) {
  for (const int n : {12, 36}) {
    Shape prism;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * i / n;
      prism.points.push_back({std::cos(a), std::sin(a), 0});
      prism.points.push_back({std::cos(a), std::sin(a), 1});
    }
    for (int i = 0; i < n; ++i) prism.faces.push_back({2 * i, (2 * i + 2) % (2 * n), (2 * i + 3) % (2 * n), 2 * i + 1});
    const edges::EdgeOptions creases{
        .contour = false, .boundary = false, .intersection = false, .crease_angle = 360.0 / n};
    EXPECT_EQ(draw(world_of(prism), orthographic({1, 0.3, 0.2}), creases).drawn.edges.size(), n);
  }
}

}  // namespace
}  // namespace epura::test::mesh_forms_test
