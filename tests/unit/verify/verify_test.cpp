// SPDX-License-Identifier: Apache-2.0
// Drawings that are right are found right; drawings made wrong on purpose are found wrong.
#include "verify/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "report/format.hpp"
#include "shapes.hpp"

namespace epura::test::verify_test {
namespace {

verify::Tolerance tolerance_of(const Result& r) { return {r.view.extent, r.view.contact.touching}; }

report::Verification verified(const Result& r, const view::ViewLimits& limits = {}) {
  return verify::verify({r.world, r.view.projection, limits, r.drawn, r.hidden, r.drawing}, tolerance_of(r), 1000,
                        true);
}

std::vector<projection::Projection> views() {
  return {orthographic({1, -1, 1}), orthographic({0.31, -0.62, 0.41}), orthographic({0, -1, 0}),
          perspective({4, -3, 3.5}, {0.5, 0.5, 0.5}, {4, -3, 3}, {0, 0, 1})};
}

// An edge with a hidden span that begins and ends on it.
std::size_t edge_with_inner_span(const Result& r) {
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e)
    for (std::size_t i = r.hidden.first[e]; i < r.hidden.first[e + 1]; ++i)
      if (r.hidden.spans[i][0] > 0.01 && r.hidden.spans[i][1] < 0.99) return e;
  ADD_FAILURE() << "the scene has no such edge";
  return 0;
}

double page_length(const Result& r, std::size_t edge) {
  const auto& [a, b] = r.drawn.edges[edge].vertex;
  return std::hypot(r.view.vertices[a].x - r.view.vertices[b].x, r.view.vertices[a].y - r.view.vertices[b].y);
}

bool names(const report::Verification& found, const Result& r, std::size_t edge) {
  const auto& ends = r.world.models[0].mesh->edges[r.drawn.edges[edge].mesh_edge].vertex;
  return std::ranges::any_of(found.worst, [&](const report::Mismatch& offence) { return offence.edge == ends; });
}

TEST(Verify, RightDrawingsAreRight) {
  for (const projection::Projection& view : views()) {
    const report::Verification found = verified(draw(world_of(four_boxes()), view));
    EXPECT_EQ(found.wrong, 0) << report::format_verification(found);
    EXPECT_EQ(found.misclassified, 0);
    EXPECT_LT(found.at_most, 0.02);
    EXPECT_GT(found.decided, found.points / 3);
    EXPECT_GE(found.samples, 1000);
  }
}

TEST(Verify, GeneralViewsAreDecided) {
  const report::Verification found = verified(draw(world_of(four_boxes()), orthographic({0.31, -0.62, 0.41})));
  EXPECT_EQ(found.decided, found.points);
}

TEST(Verify, AFlippedSpanIsFound) {
  Result r = draw(world_of(four_boxes()), orthographic({1, -1.1, 0.9}));
  const std::size_t edge = edge_with_inner_span(r);
  auto& span = r.hidden.spans[r.hidden.first[edge]];
  const double share = (span[1] - span[0]) * page_length(r, edge);
  span = {0.5 * (span[0] + span[1]), 0.5 * (span[0] + span[1])};
  const report::Verification found = verified(r);
  EXPECT_GT(found.wrong, 0);
  EXPECT_TRUE(names(found, r, edge));
  EXPECT_EQ(found.worst[0].what, "drawn visible");
  EXPECT_TRUE(found.worst[0].hider);
  EXPECT_NEAR(found.misclassified * found.length, share, 0.5 * share);
  EXPECT_GT(found.at_most, found.misclassified);
}

TEST(Verify, AnEdgeSwappedToHiddenIsFound) {
  Result r = draw(world_of(four_boxes()), orthographic({1, -1.1, 0.9}));
  std::size_t edge = 0;
  while (r.hidden.first[edge] != r.hidden.first[edge + 1]) ++edge;
  r.hidden.spans.insert(r.hidden.spans.begin() + static_cast<std::ptrdiff_t>(r.hidden.first[edge]), {0.0, 1.0});
  for (std::size_t e = edge + 1; e < r.hidden.first.size(); ++e) ++r.hidden.first[e];
  const report::Verification found = verified(r);
  EXPECT_GT(found.wrong, 0);
  EXPECT_TRUE(names(found, r, edge));
  EXPECT_EQ(found.worst[0].what, "drawn hidden");
  EXPECT_FALSE(found.worst[0].hider);
}

// A hundred thousandth of the drawing is found, a tenth of the guarantee is none of our business.
TEST(Verify, AShiftedEndIsFound) {
  for (const projection::Projection& view : {orthographic({1, -1.1, 0.9}), views().back()})
    for (const int end : {0, 1})
      for (const double shift : {1e-5, -1e-5, 1e-7}) {
        Result r = draw(world_of(four_boxes()), view);
        const std::size_t edge = edge_with_inner_span(r);
        r.hidden.spans[r.hidden.first[edge]][end] += shift * r.view.extent / page_length(r, edge);
        const report::Verification found = verified(r);
        EXPECT_EQ(found.wrong > 0, std::abs(shift) > 1e-6) << end << ' ' << shift << '\n'
                                                           << report::format_verification(found);
        EXPECT_EQ(names(found, r, edge), found.wrong > 0);
      }
}

// A sheet above a plate by a little more than contact hides it; how much is too little to say is left open.
TEST(Verify, ContactIsDoubtful) {
  constexpr double contact = 0.01;
  const view::ViewLimits limits{.contact = contact};
  for (const double above : {0.8, 1.2, 1.9}) {
    const double z = above * contact;
    const Shape sheet{{{-1, -1, z}, {2, -1, z}, {2, 2, z}, {-1, 2, z}}, {{0, 1, 2, 3}}, {}};
    const Shape plate{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}, {}};
    const Result r = draw(world_of(std::vector<Shape>{sheet, plate}), from_above(), {}, limits);
    EXPECT_EQ(r.hidden.spans.size(), above > 1 ? 4U : 0U) << above;
    const report::Verification found = verified(r, limits);
    EXPECT_EQ(found.wrong, 0) << above << '\n' << report::format_verification(found);
    EXPECT_NEAR(found.undecided, 1.0 / 4, 0.02) << above;  // a plate of 4, a sheet of 12
  }
}

// Drawn without the body in front, tested with it.
TEST(Verify, AForgottenOccluderIsFound) {
  const Shape back = box({0, 0, 0}, {1, 1, 1}), front = box({0.2, -2, 0.3}, {0.6, -1, 0.5});
  Result r = draw(world_of(back), orthographic({0.1, -1, 0.2}));
  ASSERT_EQ(verified(r).wrong, 0);
  r.world = world_of({back, front});
  const report::Verification found = verified(r);
  EXPECT_GT(found.wrong, 0);
  for (const report::Mismatch& offence : found.worst) {
    EXPECT_EQ(offence.what, "drawn visible");
    ASSERT_TRUE(offence.hider);
    EXPECT_EQ(offence.hider->model, 1);
  }
}

// A plate above a box reaches over one of its edges by less than files are rounded, or by more.
TEST(Verify, WhatDependsOnTheRoundingOfFilesIsUndecided) {
  constexpr double reach = 4e-6;
  const Shape back = box({0, 0, 0}, {1, 1, 1}), front = box({-1, 1 - reach, 2}, {2, 2, 3});
  for (const double rounding : {0.0, reach / 4, reach}) {
    Result r = draw(world_of(back), from_above());
    r.world = world_of({back, front});
    r.world.rounding = rounding;
    EXPECT_EQ(verified(r).misclassified > 0, rounding < reach) << rounding;
  }
}

TEST(Verify, AMissingLineIsFound) {
  Result r = draw(world_of(four_boxes()), orthographic({1, -1.1, 0.9}));
  const auto longest = std::ranges::max_element(
      r.drawing.segments, {}, [](const drawing::Segment& s) { return s.visible ? glm::distance(s.from, s.to) : 0; });
  r.drawing.segments.erase(longest);
  const report::Verification found = verified(r);
  EXPECT_GT(found.wrong, 0);
  for (const report::Mismatch& offence : found.worst) EXPECT_EQ(offence.what, "not drawn");
}

// What the near limit cuts away hides nothing.
TEST(Verify, LimitsOfDepthAreRespected) {
  const world::World world = world_of(four_boxes());
  for (const auto& [view, near] : {std::pair{orthographic({0.1, -1, 0.2}), -0.3}, std::pair{views().back(), 4.6}}) {
    const view::ViewLimits limits{near, {}};
    const Result r = draw(world, view, {}, limits);
    EXPECT_EQ(verified(r, limits).wrong, 0) << report::format_verification(verified(r, limits));
    EXPECT_GT(verified(r).wrong, 0);
  }
}

TEST(Verify, TouchingAndCoplanarFacesAreNotWrong) {
  for (const projection::Projection& view : views())
    EXPECT_EQ(verified(draw(world_of(touching_boxes()), view)).wrong, 0);
}

TEST(Verify, IntersectionLinesAreTested) {
  const report::Verification found = verified(draw(world_of(four_boxes()), orthographic({0.31, -0.62, 0.41})));
  EXPECT_TRUE(
      std::ranges::any_of(found.strata, [](const report::Stratum& s) { return s.kind == EdgeKind::intersection; }));
}

// Of a part that was offset: faces lower than the page's grid is fine, edge to edge. On the grid one of them hides an
// edge of the other, by next to nothing and right behind an outline.
TEST(Verify, FacesLowerThanTheGridAreUndecided) {
  Shape shape;
  shape.points = {{4713.0378336873946, -20170.322832525089, 1785.1139170375754},
                  {4729.3444743123946, -20170.322832525089, 1853.9479014125754},
                  {4686.6095203273471, -19960.415935618701, 1502.1200885154587},
                  {4688.5301281101529, -19960.763751881299, 1501.6838665626663},
                  {4713.2814326205526, -19989.619513355032, 1642.8368983928633},
                  {4715.2005382664029, -19989.974689381299, 1642.3999310157913},
                  {4764.9807047811446, -20043.576738775089, 1902.4873301235129},
                  {4797.0978594473399, -19696.260310546153, 1777.9593510640666},
                  {4799.0203624851529, -19696.603595631299, 1777.5278607032913},
                  {5332.6253365876155, -20170.236263638184, 5215.6644051301046},
                  {5347.8978736875633, -20169.433518218815, 5349.21484375},
                  {5348.60498046875, -20169.140625, 5349.21484375},
                  {5348.60498046875, -20169.433518218815, 5349.9219505311867},
                  {5347.9925240876155, -20110.341732388184, 5291.7625496613546},
                  {5347.9918413788973, -20110.344369677317, 5291.759198907067},
                  {5347.9921274251419, -20110.343274086503, 5291.7605908813957}};
  shape.faces = {{7, 2, 4}, {5, 3, 8}, {1, 0, 6}, {9, 13, 15}, {9, 15, 14}, {11, 10, 12}};
  const report::Verification found = verified(draw(world_of(shape), orthographic({1, -1, 1})));
  EXPECT_EQ(found.wrong, 0) << report::format_verification(found);
}

// Far from the origin doubles cannot tell where the rays pass, and rationals must.
TEST(Verify, FarFromTheOriginRationalsDecide) {
  const Shape far = four_boxes().scaled(1024).moved(0x1p+30, -0x1p+31, 0x1p+30);
  projection::Projection view = orthographic({0.31, -0.62, 0.41});
  Result r = draw(world_of(far), view);
  const report::Verification found = verified(r);
  EXPECT_EQ(found.wrong, 0) << report::format_verification(found);
  EXPECT_GT(found.decided, 9 * found.points / 10);
  const std::size_t edge = edge_with_inner_span(r);
  r.hidden.spans[r.hidden.first[edge]][0] += 1e-5 * r.view.extent / page_length(r, edge);
  EXPECT_GT(verified(r).wrong, 0);
}

TEST(Verify, TheSameForAnyNumberOfThreads) {
  const Result r = draw(world_of(four_boxes()), orthographic({1, -1, 1}));
  const auto words = [&](int threads) {
    const ThreadLimit limit(threads);
    return report::format_verification(verified(r));
  };
  EXPECT_EQ(words(1), words(2));
}

}  // namespace
}  // namespace epura::test::verify_test
