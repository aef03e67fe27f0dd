// SPDX-License-Identifier: Apache-2.0
// Faults planted in the lines of right drawings are found where they are, and as long as they are; right ones have
// none.
#include "verify/ink_judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/format.hpp"
#include "shapes.hpp"
#include "verify/ray_hits.hpp"

namespace epura::test::ink_judge_test {
namespace {

constexpr int samples = 2000;
constexpr double off = 0.12;  // more than the height of facets, units of the model

using Profile = std::vector<std::array<double, 2>>;

Profile arc(double radius, double tube, int bands, double from, double to) {
  Profile profile;
  for (int i = 0; i <= bands; ++i) {
    const double a = from + (to - from) * i / bands;
    profile.push_back({radius + tube * std::cos(a), tube * std::sin(a)});
  }
  return profile;
}

/// A prism over an outline in the plane of x and y, from z = 0 to `height`.
Shape prism(const std::vector<Vec2>& outline, double height) {
  Shape shape;
  const int count = static_cast<int>(outline.size());
  for (const double z : {0.0, height})
    for (const Vec2& p : outline) shape.points.push_back({p.x, p.y, z});
  std::vector<int> bottom, top;
  for (int i = 0; i < count; ++i) {
    shape.faces.push_back({i, (i + 1) % count, count + (i + 1) % count, count + i});
    bottom.insert(bottom.begin(), i);
    top.push_back(count + i);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

/// A bar of 20 by 10 whose corners are rounded with radius 3, 30 high: its walls are tangent to the fillets.
Shape rounded_bar() {
  std::vector<Vec2> outline;
  const std::array<Vec2, 4> centres{Vec2(7, 2), Vec2(-7, 2), Vec2(-7, -2), Vec2(7, -2)};
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k <= 12; ++k) {
      const double a = std::numbers::pi / 2 * (static_cast<double>(i) + k / 12.0);
      outline.push_back(centres[i] + 3.0 * Vec2(std::cos(a), std::sin(a)));
    }
  return prism(outline, 30);
}

Shape pipe() { return revolved({{10, 0}, {10, 20}}, 48); }
Shape screw() { return revolved({{0, 0}, {5, 0}, {5, 20}, {12, 27}, {0, 27}}, 64); }
Shape ball() { return revolved(arc(0, 10, 32, -std::numbers::pi / 2, std::numbers::pi / 2), 64); }
/// Of a ball, what is below z = 6.
Shape bowl() {
  Profile profile = arc(0, 10, 32, -std::numbers::pi / 2, std::asin(0.6));
  profile.push_back({0, 6});
  return revolved(profile, 64);
}
Shape ring() { return revolved(arc(30, 10, 48, -std::numbers::pi, std::numbers::pi), 96); }

/// A hill over a square, as one free form.
world::World hill() {
  Shape shape;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k <= steps; ++k) {
      const double x = i - steps / 2.0, y = k - steps / 2.0;
      shape.points.push_back({x, y, 20 * std::exp(-(x * x + y * y) / 100)});
    }
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const int a = i * (steps + 1) + k;
      shape.faces.push_back({a, a + steps + 1, a + steps + 2});
      shape.faces.push_back({a, a + steps + 2, a + 1});
    }
  world::World world = world_of(shape);
  surfaces::PartFaces part;
  part.faces.push_back({});
  part.face_of_triangle.assign(world.triangles.size(), 0);
  part.border_of_edge.assign(world.models[0].mesh->edges.size(), -1);
  part.declared = true;
  world.models[0].part = std::make_shared<const surfaces::PartFaces>(part);
  return world;
}

report::InkCheck judged(const Result& r, const edges::EdgeOptions& edges = {}) {
  const verify::Tolerance tolerance{r.view.extent, r.view.contact.touching};
  const verify::VerifyInput input{r.world, r.view.projection, {}, r.drawn, r.hidden, r.drawing};
  const verify::OutlineOptions how{edges, samples};
  return verify::judge_ink(input, tolerance, {how, off / r.unit}, verify::scan_outline(input, tolerance, how).needs);
}

std::string told(const report::InkCheck& ink) {
  report::Verification found;
  found.ink = ink;
  return report::format_verification(found);
}

Vec2 on_page(const Result& r, const Vec3& point) {
  const Vec4 page = r.drawing.world_to_page * Vec4(point, 1);
  return Vec2(page) / page.w;
}

void add_line(Result& r, const std::vector<Vec3>& points, bool visible) {
  drawing::Chain chain{{}, false, visible, EdgeKind::contour, {}};
  for (const Vec3& point : points) chain.points.push_back(on_page(r, point));
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    chain.segments.push_back(static_cast<int>(r.drawing.segments.size()));
    r.drawing.segments.push_back(
        {chain.points[i], chain.points[i + 1], visible, EdgeKind::contour, 0, {-1, -1}, -1, {0, 1}});
  }
  r.drawing.chains.push_back(chain);
}

double length_of(const std::vector<Vec3>& points, const Result& r) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    length += glm::distance(on_page(r, points[i]), on_page(r, points[i + 1]));
  return length;
}

/// Faults of one kind beside the line of these points, as long as the line in all, but for both of its ends.
void expect_fault(const Result& r, const std::string& what, const std::vector<Vec3>& points) {
  const report::InkCheck found = judged(r);
  const double length = what == "missing" ? found.missing : found.unfounded, all = length_of(points, r);
  EXPECT_NEAR(length, all, 0.03 * all + 10 * off / r.unit) << told(found);
  EXPECT_EQ(found.missing + found.unfounded, length) << told(found);
  ASSERT_FALSE(found.worst.empty());
  for (const report::OutlineFault& fault : found.worst) {
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (int k = 0; k <= 100; ++k)
        nearest = std::min(nearest,
                           glm::distance(fault.page, on_page(r, points[i] + k / 100.0 * (points[i + 1] - points[i]))));
    EXPECT_LT(nearest, 0.02 * all + off / r.unit) << told(found);
    EXPECT_EQ(fault.what, what);
  }
}

/// Without the lines of which every point is such a one.
template <class Is>
void remove_lines(Result& r, const Is& is) {
  std::vector<drawing::Chain> left;
  for (const drawing::Chain& chain : r.drawing.chains) {
    drawing::Chain part = chain;
    part.closed = false;
    part.points.clear();
    const auto keep = [&] {
      if (part.points.size() > 1) left.push_back(part);
      part.points.clear();
    };
    const std::size_t count = chain.points.size() + (chain.closed ? 1 : 0);
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const Vec2 from = chain.points[i], to = chain.points[(i + 1) % chain.points.size()];
      if (is(from) && is(to)) {
        keep();
        continue;
      }
      if (part.points.empty()) part.points.push_back(from);
      part.points.push_back(to);
    }
    keep();
  }
  r.drawing.chains = left;
}

const Vec3 from_the_front(0, -1, 0), obliquely(0.3, -1, 0.6);

TEST(InkJudge, RightDrawingsAreRight) {
  for (const Shape& shape : {pipe(), screw(), ball(), bowl(), rounded_bar(), four_boxes(), fine_cube(3)})
    for (const Vec3& view : {from_the_front, obliquely, Vec3(1, -1, 1), Vec3(0.1, -0.2, 1)}) {
      const Result r = draw(recognised(world_of(shape)), orthographic(view));
      const report::InkCheck found = judged(r);
      EXPECT_EQ(found.faults, 0) << told(found);
      EXPECT_NEAR(found.judged, found.length, 1e-9 * found.length) << told(found);
      EXPECT_TRUE(found.unjudged.empty());
    }
}

TEST(InkJudge, SurfacesJudgeWhereTheyAreKnown) {
  const report::InkCheck known = judged(draw(recognised(world_of(ring())), orthographic(obliquely)));
  EXPECT_NEAR(known.by_surfaces, known.length, 1e-9 * known.length);
  const report::InkCheck unknown = judged(draw(world_of(ring()), orthographic(obliquely)));
  EXPECT_EQ(unknown.by_surfaces, 0);
  EXPECT_NEAR(unknown.judged, unknown.length, 1e-9 * unknown.length);
}

TEST(InkJudge, WhatIsNotJudgedHasAReason) {
  edges::EdgeOptions options;
  options.tangent = true;
  const report::InkCheck found =
      judged(draw(recognised(world_of(rounded_bar())), orthographic(obliquely), options), options);
  ASSERT_EQ(found.unjudged.size(), 1U);
  EXPECT_NE(found.unjudged[0].reason.find("within surfaces"), std::string::npos);
  EXPECT_GT(found.unjudged[0].length, 0);
  EXPECT_NEAR(found.judged + found.unjudged[0].length, found.length, 1e-9 * found.length);
}

TEST(InkJudge, AConeDrawnToItsApexBeyondItsFace) {
  Result r = draw(recognised(world_of(screw())), orthographic(from_the_front));
  const std::vector<Vec3> beyond{{5, 0, 20}, {0, 0, 15}};
  add_line(r, beyond, true);
  expect_fault(r, "unfounded", beyond);
}

TEST(InkJudge, AContourThatLeavesThePart) {
  Result r = draw(recognised(world_of(screw())), orthographic(from_the_front));
  const std::vector<Vec3> beyond{{12, 0, 27}, {22, 0, 37}};
  add_line(r, beyond, true);
  expect_fault(r, "unfounded", beyond);
}

TEST(InkJudge, TheContourOfABallBeyondItsRim) {
  Result r = draw(recognised(world_of(bowl())), orthographic(from_the_front));
  std::vector<Vec3> beyond;
  for (int i = 0; i <= 8; ++i) {
    const double a = std::asin(0.6) + i * 0.05;
    beyond.push_back({10 * std::cos(a), 0, 10 * std::sin(a)});
  }
  add_line(r, beyond, true);
  expect_fault(r, "unfounded", beyond);
}

TEST(InkJudge, AWallSeenEdgeOnWithoutItsOutline) {
  Result r = draw(recognised(world_of(rounded_bar())), orthographic(from_the_front));
  const double wall = on_page(r, {10, 0, 0}).x;
  remove_lines(r, [&](const Vec2& p) { return std::abs(p.x - wall) < 0.5 * off / r.unit; });
  expect_fault(r, "missing", {{10, 0, 0}, {10, 0, 30}});
}

TEST(InkJudge, AGapInAContour) {
  Result r = draw(recognised(world_of(ring())), orthographic(Vec3(0, -0.2, 1)));
  const Vec2 gap = on_page(r, {40, 0, 0});
  const auto is_near = [&](const Vec2& p) { return glm::distance(p, gap) < 6 / r.unit; };
  remove_lines(r, is_near);
  const report::InkCheck found = judged(r);
  EXPECT_EQ(found.faults, 1) << told(found);
  EXPECT_NEAR(found.missing, 10 / r.unit, 3 / r.unit) << "two facets at both ends";
  ASSERT_FALSE(found.worst.empty());
  EXPECT_TRUE(is_near(found.worst[0].page)) << told(found);
}

TEST(InkJudge, ABorderInASmoothRegion) {
  Result r = draw(recognised(world_of(ball())), orthographic(obliquely));
  std::vector<Vec3> border;
  for (int i = 0; i <= 40; ++i) {
    const double a = -2.4 + i * 0.04;
    border.push_back({8 * std::cos(a), 8 * std::sin(a), 6});
  }
  add_line(r, border, true);
  expect_fault(r, "unfounded", border);
}

// A recogniser takes half of a ball for another one, which meets it at 5.7 degrees.
TEST(InkJudge, ABorderThatOnlyARecogniserSees) {
  for (const bool declared : {false, true}) {
    world::World world = recognised(world_of(ball()));
    surfaces::PartFaces part = *world.models[0].part;
    ASSERT_EQ(part.faces.size(), 1U);
    part.faces.push_back(part.faces[0]);
    part.faces[1].surface.origin = {0, 0, -1};
    part.faces[1].surface.radius = std::sqrt(101);
    const mesh::Mesh& mesh = *world.models[0].mesh;
    surfaces::PartBorder border{{0, 1}, surfaces::BorderKind::sharp, 5.7, {}, true};
    for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t) {
      double z = 0;
      for (const int v : mesh.triangle(static_cast<int>(t))) z += mesh.points[static_cast<std::size_t>(v)][2];
      part.face_of_triangle[t] = z > 0 ? 1 : 0;
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto at = [&](int i) { return mesh.points[static_cast<std::size_t>(mesh.edges[e].vertex[i])][2]; };
      if (std::abs(at(0)) > 1e-9 || std::abs(at(1)) > 1e-9) continue;
      border.edges.push_back(static_cast<int>(e));
      part.border_of_edge[e] = 0;
    }
    part.borders = {border};
    part.declared = declared;
    world.models[0].part = std::make_shared<const surfaces::PartFaces>(part);
    const Result r = draw(std::move(world), orthographic(obliquely));
    const report::InkCheck found = judged(r);
    // The equator's ellipse, whose visible half is drawn solid and whose other half dashed; but for what it gives away
    // of the contour of the wrong ball.
    double on_border = 0;
    for (const report::OutlineFault& fault : found.worst)
      for (int i = 0; i < 1000; ++i) {
        const double a = i * std::numbers::pi / 500;
        if (glm::distance(fault.page, on_page(r, {10 * std::cos(a), 10 * std::sin(a), 0})) > off / r.unit) continue;
        on_border += fault.length;
        break;
      }
    EXPECT_EQ(on_border > 30 / r.unit, !declared) << told(found);
  }
}

TEST(InkJudge, ASeamOfAFreeForm) {
  Result r = draw(hill(), orthographic(Vec3(0.2, -1, 3)));
  ASSERT_EQ(judged(r).faults, 0) << told(judged(r));
  std::vector<Vec3> seam;
  for (int i = 0; i <= 10; ++i) seam.push_back({5, -20.0 + i, 20 * std::exp(-(25 + (i - 20.0) * (i - 20.0)) / 100)});
  add_line(r, seam, true);
  expect_fault(r, "unfounded", seam);
}

TEST(InkJudge, AMarkBehindABall) {
  Result r = draw(recognised(world_of(ball())), orthographic(obliquely));
  const std::vector<Vec3> mark{{-1, 5, -5}, {3, 5, -5}};
  add_line(r, mark, false);
  expect_fault(r, "unfounded", mark);
}

TEST(InkJudge, AHiddenLineDrawnVisible) {
  Result r = draw(recognised(world_of(box({0, 0, 0}, {20, 12, 8}))), orthographic(obliquely));
  const auto hidden =
      std::ranges::find_if(r.drawing.chains, [](const drawing::Chain& chain) { return !chain.visible; });
  ASSERT_NE(hidden, r.drawing.chains.end());
  double length = 0;
  for (std::size_t i = 0; i + 1 < hidden->points.size(); ++i)
    length += glm::distance(hidden->points[i], hidden->points[i + 1]);
  hidden->visible = true;
  const report::InkCheck found = judged(r);
  EXPECT_NEAR(found.unfounded, length, 0.05 * length + 10 * off / r.unit) << told(found);
  EXPECT_EQ(found.missing, 0);
}

TEST(InkJudge, AVisibleLineDrawnHidden) {
  Result r = draw(recognised(world_of(box({0, 0, 0}, {20, 12, 8}))), orthographic(from_the_front));
  ASSERT_FALSE(r.drawing.chains.empty());
  for (drawing::Chain& chain : r.drawing.chains) chain.visible = false;
  const report::InkCheck found = judged(r);
  EXPECT_NEAR(found.missing, 56 / r.unit, 0.05 * 56 / r.unit) << told(found);
  EXPECT_EQ(found.unfounded, 0);
}

TEST(RayHits, AreThoseOfClosedForms) {
  using surfaces::SurfaceKind;
  const auto expect = [](const surfaces::PartSurface& surface, const verify::Ray& ray,
                         const std::vector<double>& right) {
    const std::vector<double> hits = verify::ray_hits(surface, ray);
    ASSERT_EQ(hits.size(), right.size());
    for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_NEAR(hits[i], right[i], 1e-9);
  };
  const Vec3 up(0, 0, 1), along(1, 0, 0), start(-100, 0, 0);
  expect({SurfaceKind::plane, {5, 0, 0}, glm::normalize(Vec3(1, 1, 0)), 0, 0, 0}, {start, along}, {105});
  expect({SurfaceKind::sphere, {1, 0, 0}, Vec3(0), 10, 0, 0}, {start, along}, {91, 111});
  expect({SurfaceKind::cylinder, {1, 6, 4}, up, 10, 0, 0}, {start, along}, {93, 109});
  expect({SurfaceKind::cylinder, {0, 0, 0}, up, 10, 0, 0}, {start + Vec3(0, 11, 0), along}, {});
  expect({SurfaceKind::cone, {0, 0, -4}, up, 2, 0, 0.5}, {start, along}, {96, 104});
  expect({SurfaceKind::cone, {0, 0, 14}, up, 2, 0, 0.5}, {start, along}, {});
  expect({SurfaceKind::torus, {0, 0, 0}, up, 30, 10, 0}, {start, along}, {60, 80, 120, 140});
  expect({SurfaceKind::torus, {0, 0, 6}, up, 30, 10, 0}, {start, along}, {62, 78, 122, 138});
  expect({SurfaceKind::torus, {0, 0, 0}, up, 30, 10, 0}, {{30, 0, 50}, -up}, {40, 60});
  const Vec3 normal = verify::normal_on({SurfaceKind::cone, {0, 0, 0}, up, 2, 0, 0.75}, {2, 0, 0});
  EXPECT_LT(glm::distance(normal, Vec3(0.8, 0, -0.6)), 1e-12);
  const Vec3 tube = verify::normal_on({SurfaceKind::torus, {0, 0, 0}, up, 30, 10, 0}, {0, 36, 8});
  EXPECT_LT(glm::distance(tube, Vec3(0, 0.6, 0.8)), 1e-12);
}

}  // namespace
}  // namespace epura::test::ink_judge_test
