// SPDX-License-Identifier: Apache-2.0
// Lines that are missing, that nothing asks for or that are drawn twice are found; right drawings have none.
#include "verify/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "drawing/make_drawing.hpp"
#include "report/format.hpp"
#include "shapes.hpp"
#include "verify/verify.hpp"

namespace epura::test::outline_test {
namespace {

constexpr int samples = 2000;

report::OutlineCheck checked(const Result& r, const verify::OutlineOptions& options = {{}, samples},
                             const view::ViewLimits& limits = {}) {
  const verify::Tolerance tolerance{r.view.extent, r.view.contact.touching};
  return verify::scan_outline({r.world, r.view.projection, limits, r.drawn, r.hidden, r.drawing}, tolerance, options)
      .check;
}

std::string told(const report::OutlineCheck& outline) {
  report::Verification found;
  found.outline = outline;
  return report::format_verification(found);
}

// A cone of 24 sides, its apex a ring of needles with this radius.
Shape cone(double ring) {
  constexpr int sides = 24;
  Shape shape;
  for (const double radius : {1.0, ring})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), radius == 1 ? 0.0 : 3.0});
    }
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    shape.faces.push_back({i, next, sides + next});
    shape.faces.push_back({i, sides + next, sides + i});
  }
  std::vector<int> base;
  for (int i = sides - 1; i >= 0; --i) base.push_back(i);
  shape.faces.push_back(base);
  return shape;
}

// The same with one vertex for an apex.
Shape pointed_cone() {
  Shape shape = cone(0.5);
  shape.points.resize(24);
  shape.points.push_back({0, 0, 3});
  std::vector<std::vector<int>> faces{shape.faces.back()};
  for (int i = 0; i < 24; ++i) faces.push_back({i, (i + 1) % 24, 24});
  shape.faces = faces;
  return shape;
}

std::vector<projection::Projection> views() {
  return {orthographic({0.31, -0.62, 0.41}), orthographic({1, -1, 1}), orthographic({0, -1, 0}),
          perspective({4, -3, 3.5}, {0.5, 0.5, 0.5}, {4, -3, 3}, {0, 0, 1})};
}

double length_of(const drawing::Segment& s) { return glm::distance(s.from, s.to); }

double visible_ink(const drawing::ViewDrawing& drawing) {
  double length = 0;
  for (const drawing::Segment& s : drawing.segments) length += s.visible ? length_of(s) : 0;
  return length;
}

double distance(const Vec2& place, const drawing::Segment& s) {
  const Vec2 way = s.to - s.from;
  return glm::distance(place, s.from + std::clamp(glm::dot(place - s.from, way) / glm::dot(way, way), 0.0, 1.0) * way);
}

// One fault of this kind on the segment, and none elsewhere.
void expect_fault(const report::OutlineCheck& found, const std::string& what, const drawing::Segment& at, double near) {
  ASSERT_FALSE(found.worst.empty()) << what << " of " << length_of(at);
  EXPECT_GT(found.wrong(), 0);
  EXPECT_GT(found.at_most, 0);
  for (const report::OutlineFault& fault : found.worst) {
    EXPECT_EQ(fault.what, what) << told(found);
    EXPECT_LT(distance(fault.page, at), near) << told(found);
  }
  EXPECT_NEAR(found.worst[0].length, length_of(at), 0.02 * length_of(at)) << told(found);
}

TEST(Outline, RightDrawingsAreRight) {
  const std::vector<Shape> zoo{four_boxes(),        fan(24),      moebius(40),       pointed_cone(),
                               triangulated_cube(), fine_cube(6), uv_sphere(40, 20), klein_bottle(24, 16),
                               sombrero(3, 24)};
  for (std::size_t i = 0; i < zoo.size(); ++i)
    for (const projection::Projection& view : views()) {
      const report::OutlineCheck found = checked(draw(world_of(zoo[i]), view));
      EXPECT_EQ(found.wrong(), 0) << i << '\n' << told(found);
      EXPECT_GT(found.asked, samples / 4) << i;
      EXPECT_GT(found.ink, samples / 2) << i;
      EXPECT_LT(found.at_most, 0.005);
    }
}

// A cube with wires behind it, through it and across its faces.
Shape wired_cube() {
  Shape shape = triangulated_cube();
  shape.points.insert(shape.points.end(),
                      {{-1, 3, 0.5}, {2, 3, 0.4}, {0.4, -1, 0.3}, {0.6, 2, 0.8}, {0.2, 0, 0.2}, {0.9, 0, 0.7}});
  shape.wires = {{8, 9}, {10, 11}, {12, 13}, {0, 6}, {1, 13}};
  return shape;
}

TEST(Outline, WiresNeedInkAndNothingElseMayLookLikeThem) {
  const Shape lines{{{0, 0, 0}, {1, 0.2, 0.1}, {0.3, 1, 0.7}}, {}, {}, {{0, 1}, {1, 2}}};
  for (const Shape& shape : {wired_cube(), lines})
    for (const projection::Projection& view : views()) {
      const Result right = draw(world_of(shape), view);
      const report::OutlineCheck found = checked(right);
      EXPECT_EQ(found.wrong(), 0) << told(found);
      EXPECT_GT(found.asked, samples / 4);
      const report::OutlineCheck unasked = checked(right, {{.wire = false}, samples});
      EXPECT_GT(unasked.unfounded, 0);
      EXPECT_EQ(unasked.missing + unasked.doubled, 0) << told(unasked);
      for (std::size_t i = 0; i < right.drawing.segments.size(); ++i) {
        const drawing::Segment removed = right.drawing.segments[i];
        const bool is_clear = removed.kind == EdgeKind::wire && removed.visible && removed.edge[0] >= 8;
        if (!(is_clear || shape.faces.empty()) || length_of(removed) < 0.01 * visible_ink(right.drawing)) continue;
        Result wrong = right;
        wrong.drawing.segments.erase(wrong.drawing.segments.begin() + static_cast<std::ptrdiff_t>(i));
        expect_fault(checked(wrong), "missing", removed, 1e-6 * right.view.extent);
      }
    }
}

// The lines across the page measure the ink: by Crofton's formula, and by adding it up.
TEST(Outline, PlacesStandForLengths) {
  const Result r = draw(world_of(four_boxes()), views()[0]);
  const report::OutlineCheck found = checked(r);
  EXPECT_NEAR(found.ink * found.length, visible_ink(r.drawing), 0.05 * visible_ink(r.drawing));
  EXPECT_NEAR(found.asked * found.length, visible_ink(r.drawing), 0.05 * visible_ink(r.drawing));
}

// Each line of at least one part in a hundred, in turn.
TEST(Outline, ARemovedLineIsFound) {
  for (const Shape& shape : {four_boxes(), uv_sphere(16, 8), pointed_cone()})
    for (const projection::Projection& view : {views()[0], views()[3]}) {
      const Result right = draw(world_of(shape), view);
      for (std::size_t i = 0; i < right.drawing.segments.size(); ++i) {
        const drawing::Segment removed = right.drawing.segments[i];
        if (!removed.visible || length_of(removed) < 0.01 * visible_ink(right.drawing)) continue;
        Result wrong = right;
        wrong.drawing.segments.erase(wrong.drawing.segments.begin() + static_cast<std::ptrdiff_t>(i));
        const report::OutlineCheck found = checked(wrong);
        expect_fault(found, "missing", removed, 1e-6 * right.view.extent);
        if (!found.worst.empty() && removed.edge[0] >= 0) {
          EXPECT_EQ(found.worst[0].edge, removed.edge);
        }
        EXPECT_EQ(found.unfounded + found.doubled, 0);
      }
    }
}

TEST(Outline, AnOutlineDrawnHiddenIsFound) {
  Result r = draw(world_of(pointed_cone()), orthographic({0, -1, 0}));
  const auto longest = std::ranges::max_element(r.drawing.segments, {},
                                                [](const drawing::Segment& s) { return s.visible ? length_of(s) : 0; });
  longest->visible = false;
  expect_fault(checked(r), "missing", *longest, 1e-6 * r.view.extent);
}

TEST(Outline, ASecondLineIsFound) {
  for (const projection::Projection& view : {views()[0], views()[3]})
    for (const double aside : {0.0, 1e-8, 1e-4, 1e-2}) {
      Result r = draw(world_of(four_boxes()), view);
      const drawing::Segment longest = *std::ranges::max_element(
          r.drawing.segments, {}, [](const drawing::Segment& s) { return s.visible ? length_of(s) : 0; });
      const Vec2 way = (longest.to - longest.from) / length_of(longest);
      drawing::Segment second = longest;
      second.from += aside * r.view.extent * Vec2(-way.y, way.x);
      second.to += aside * r.view.extent * Vec2(-way.y, way.x);
      r.drawing.segments.push_back(second);
      const report::OutlineCheck found = checked(r);
      expect_fault(found, "doubled", longest, (aside + 1e-6) * r.view.extent);
      EXPECT_EQ(found.missing, 0);
    }
}

TEST(Outline, ALineThatNothingAsksForIsFound) {
  for (const projection::Projection& view : {views()[0], views()[3]}) {
    Result r = draw(world_of(box({0, 0, 0}, {1, 1, 1})), view);
    // Between the middles of two lines.
    const auto visible = [](const drawing::Segment& s) { return s.visible; };
    const auto first = std::ranges::find_if(r.drawing.segments, visible);
    const auto second = std::find_if(first + 1, r.drawing.segments.end(), visible);
    const drawing::Segment spoke{0.5 * (first->from + first->to),
                                 0.5 * (second->from + second->to),
                                 true,
                                 EdgeKind::crease,
                                 0,
                                 {-1, -1},
                                 -1,
                                 {0, 1}};
    r.drawing.segments.push_back(spoke);
    const report::OutlineCheck found = checked(r);
    expect_fault(found, "unfounded", spoke, 1e-6 * r.view.extent);
    EXPECT_EQ(found.missing + found.doubled, 0);
  }
}

// The drawing of a pointed cone is right for one whose apex is a ring of needles, and stays so without the needles.
TEST(Outline, NeedlesHaveNoLinesOfTheirOwn) {
  for (const double ring : {1e-16, 1e-10, 1e-8})
    for (const projection::Projection& view :
         {orthographic({0.2, -1, 0.3}), perspective({1, -9, 3}, {0, 0, 1}, {1, -9, 2}, {0, 0, 1})}) {
      Result r = draw(world_of(pointed_cone()), view);
      const drawing::ViewDrawing right = r.drawing;
      r.world = world_of(cone(ring));
      EXPECT_EQ(checked(r).wrong(), 0) << ring << '\n' << told(checked(r));
      const auto longest = std::ranges::max_element(
          r.drawing.segments, {}, [](const drawing::Segment& s) { return s.visible ? length_of(s) : 0; });
      const drawing::Segment removed = *longest;
      r.drawing.segments.erase(longest);
      expect_fault(checked(r), "missing", removed, 1e-6 * r.view.extent);
      // A spoke from each corner of the base to the apex.
      r.drawing = right;
      const Vec4 apex = r.drawing.world_to_page * Vec4(0, 0, 3, 1),
                 corner = r.drawing.world_to_page * Vec4(0, -1, 0, 1);
      const drawing::Segment spoke{
          Vec2(corner) / corner.w, Vec2(apex) / apex.w, true, EdgeKind::contour, 0, {-1, -1}, -1, {0, 1}};
      r.drawing.segments.push_back(spoke);
      expect_fault(checked(r), "unfounded", spoke, 1e-6 * r.view.extent);
    }
}

TEST(Outline, BothSidesOfANeedleAreOneLine) {
  Result r = draw(world_of(pointed_cone()), orthographic({0.2, -1, 0.3}));
  r.world = world_of(cone(1e-16));
  const auto side = std::ranges::find_if(
      r.drawing.segments, [](const drawing::Segment& s) { return s.visible && s.edge[0] < 23 && s.edge[1] == 24; });
  ASSERT_NE(side, r.drawing.segments.end());
  const int corner = side->edge[0];
  side->edge = {corner, 24 + corner};
  const drawing::Segment first = *side;
  ASSERT_EQ(checked(r).wrong(), 0);
  drawing::Segment second = first;
  second.edge = {corner, 25 + corner};
  second.from += 1e-7 * r.view.extent;
  second.to += 1e-7 * r.view.extent;
  r.drawing.segments.push_back(second);
  expect_fault(checked(r), "doubled", first, 2e-6 * r.view.extent);
}

TEST(Outline, OnlyWhatWasWantedIsAskedFor) {
  std::vector<edges::EdgeOptions> options(5);
  options[0].crease = false;
  options[1].contour = options[1].intersection = false;
  options[2].crease_angle = 100;
  options[3].smooth = options[3].tangent = true;
  options[4].weak_angle = 5;  // sides of the frustum continue its rims
  for (const Shape& shape : {four_boxes(), uv_sphere(24, 12), moebius(40), frustum(2, 1, 3, 24)})
    for (const edges::EdgeOptions& edges : options) {
      const Result r = draw(world_of(shape), views()[0], edges);
      EXPECT_EQ(checked(r, {edges, samples}).wrong(), 0) << told(checked(r, {edges, samples}));
    }
  edges::EdgeOptions few;
  few.crease = false;
  EXPECT_GT(checked(draw(world_of(four_boxes()), views()[0], few)).missing, 0);
  edges::EdgeOptions all;
  all.smooth = true;
  Result edges = draw(world_of(uv_sphere(24, 12)), views()[0], all);
  for (drawing::Segment& s : edges.drawing.segments) s.kind = EdgeKind::contour;
  EXPECT_GT(checked(edges).unfounded, 0);
}

TEST(Outline, WhatTimeLeftOutIsNotMissed) {
  Result r = draw(world_of(four_boxes()), views()[0]);
  r.drawing.segments.resize(r.drawing.segments.size() / 2);
  EXPECT_GT(checked(r).missing, 0);
  const report::OutlineCheck partial = checked(r, {{}, samples, false});
  EXPECT_EQ(partial.wrong(), 0);
  EXPECT_EQ(partial.asked, 0);
  EXPECT_GT(partial.ink, 0);
}

TEST(Outline, AnEmptyDrawingLacksEverything) {
  Result r = draw(world_of(four_boxes()), views()[0]);
  r.drawing.segments.clear();
  const report::OutlineCheck found = checked(r);
  EXPECT_GT(found.asked, 500);
  EXPECT_EQ(found.missing + found.undecided, found.asked);
  EXPECT_GT(found.missing, 0.99 * found.asked);
}

// Limits of depth end surfaces without a line.
TEST(Outline, LimitsOfDepthAreRespected) {
  for (const auto& [view, near] : {std::pair{orthographic({0.1, -1, 0.2}), -0.3}, std::pair{views().back(), 4.6}}) {
    const view::ViewLimits limits{near, {}};
    const Result r = draw(world_of(four_boxes()), view, {}, limits);
    EXPECT_EQ(checked(r, {{}, samples}, limits).wrong(), 0) << told(checked(r, {{}, samples}, limits));
    EXPECT_GT(checked(r).wrong(), 0);
  }
}

// A wall seen edge-on that a limit cuts above the slope through which it stands: all of it is one line.
TEST(Outline, WallsThatLimitsOfDepthCutAreLines) {
  const Shape wall_in_slope{
      {{2, 1.5, 0}, {2, 1, 3}, {2, 1.5, 3}, {3, 0, 0}, {1, 0, 2}, {3, 3, 1}}, {{0, 1, 2}, {4, 5, 3}}, {}};
  for (const double height : {1.45, 1.5, 2.0}) {
    const view::ViewLimits limits{-height, {}};
    const Result r = draw(world_of(wall_in_slope), from_above(), {}, limits);
    const auto is_of_wall = [](const drawing::Segment& s) { return s.kind == EdgeKind::intersection; };
    EXPECT_TRUE(std::ranges::any_of(r.drawing.segments, is_of_wall)) << height;
    const report::OutlineCheck found = checked(r, {{}, samples}, limits);
    EXPECT_EQ(found.wrong(), 0) << height << ": " << told(found);
  }
}

// Edges inside flat faces, in the plane of the limit.
TEST(Outline, LimitsOfDepthMayRunAlongEdges) {
  projection::Projection oblique = orthographic({0, -1, 0});
  oblique.projector = oblique.n + 0.3 * oblique.u + 0.2 * oblique.v;
  for (const view::ViewLimits& limits : {view::ViewLimits{0.5, {}}, view::ViewLimits{{}, 0.5}}) {
    const Result r = draw(world_of(fine_cube(2)), oblique, {}, limits);
    const report::OutlineCheck found = checked(r, {{}, samples}, limits);
    EXPECT_EQ(found.wrong(), 0) << told(found);
    EXPECT_GT(found.asked, 500);
  }
}

TEST(Outline, TouchingAndCoplanarFacesAreRight) {
  const Shape shape = touching_boxes();
  for (const projection::Projection& view : views()) {
    const report::OutlineCheck found = checked(draw(world_of({shape, shape.moved(0, 0.3, 0)}), view));
    EXPECT_EQ(found.wrong(), 0) << told(found);
  }
}

TEST(Outline, AnySizeAndPlace) {
  for (const Shape& shape :
       {four_boxes().scaled(0x1p+300), four_boxes().scaled(0x1p-300), four_boxes().moved(0x1p+20, 0x1p+21, 0)}) {
    Result r = draw(world_of(shape), views()[0]);
    EXPECT_EQ(checked(r).wrong(), 0) << told(checked(r));
    EXPECT_GT(checked(r).asked, samples / 2);
    r.drawing.segments.erase(
        std::ranges::find_if(r.drawing.segments, [](const drawing::Segment& s) { return s.visible; }));
    EXPECT_GT(checked(r).missing, 0);
  }
}

// The drawing ends at the cusps of the surface, and where one contour passes behind another: the judge looks at facets.
TEST(Outline, ATorusIsRightAtItsCusps) {
  std::vector<std::array<double, 2>> ring;
  for (int i = 0; i <= 24; ++i) {
    const double angle = 0.3 + 2 * std::numbers::pi * i / 24;
    ring.push_back({20 + 8 * std::cos(angle), 8 * std::sin(angle)});
  }
  const world::World torus = recognised(world_of(revolved(ring, 60)));
  ASSERT_NE(torus.models[0].part, nullptr);
  for (const Vec3& towards : {Vec3(1, -1, 1), Vec3(0.31, -0.62, 0.41), Vec3(0.2, -1, 0.5)}) {
    Result r = draw(torus, orthographic(towards));
    EXPECT_FALSE(r.hidden.by_surface.empty());
    // It judges lines in their places on the mesh.
    for (edges::FeatureEdge& edge : r.drawn.edges) edge.shown = {-1, -1};
    r.drawing = drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, {"torus", false});
    const report::OutlineCheck right = checked(r);
    EXPECT_EQ(right.missing + right.unfounded, 0) << told(right);
    // Lines that are left out are missed.
    for (drawing::Segment& segment : r.drawing.segments) segment.visible = segment.visible && segment.from.y > 0;
    EXPECT_GT(checked(r).missing, 100);
  }
}

TEST(Outline, TheSameForAnyNumberOfThreads) {
  Result r = draw(world_of(four_boxes()), views()[1]);
  r.drawing.segments.resize(r.drawing.segments.size() / 2);
  const auto words = [&](int threads) {
    const ThreadLimit limit(threads);
    return told(checked(r));
  };
  EXPECT_EQ(words(1), words(2));
}

}  // namespace
}  // namespace epura::test::outline_test
