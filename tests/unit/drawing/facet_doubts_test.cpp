// SPDX-License-Identifier: Apache-2.0
#include "drawing/facet_doubts.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <utility>

#include "shapes.hpp"

namespace epura::test::facet_doubts_test {
namespace {

using drawing::Piece;

// A piece of an edge along y = `height`.
Piece piece(int edge, double from, double to, double height, bool by_facets = false) {
  Piece p{{from, height}, {to, height}, true, true, EdgeKind::contour, edge, {from / 10, to / 10}};
  p.by_facets = by_facets;
  return p;
}

std::vector<Piece> settled(std::vector<Piece> pieces, double distance = 0.1) {
  pieces = drawing::settle_doubts(std::move(pieces), distance, {});
  for (const Piece& p : pieces) EXPECT_FALSE(p.by_facets);
  return pieces;
}

TEST(FacetDoubts, CloseGaps) {
  // On one edge, and across three.
  const std::vector<Piece> one = settled({piece(0, 0, 4, 0), piece(0, 4, 6, 0, true), piece(0, 6, 10, 0)});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(one[0].visible);
  EXPECT_EQ(one[0].to, Vec2(10, 0));
  EXPECT_EQ(one[0].s, (std::array<double, 2>{0, 1}));
  for (const Piece& p :
       settled({piece(0, 0, 4, 0), piece(1, 4, 5, 0, true), piece(2, 5, 6, 0, true), piece(3, 6, 9, 0)}))
    EXPECT_TRUE(p.visible);
}

TEST(FacetDoubts, AreHiddenBesideTheOutlineOfFacets) {
  // The outline runs along both pieces, along most of both, along the first only, or along less than half of it.
  for (const double end : {6.0, 5.6, 5.1, 4.4}) {
    const std::vector<Piece> all = settled({piece(0, 0, 4, 0), piece(1, 4, 5, 0, true), piece(2, 5, 6, 0, true),
                                            piece(3, 6, 9, 0), piece(4, 3, end, 0.09)});
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(all[1].visible, end < 5.3);
    EXPECT_EQ(all[2].visible, end < 5.3);
  }
}

TEST(FacetDoubts, AreHiddenWhereNoLinesAreJoined) {
  const std::vector<Piece> all = settled({piece(0, 0, 4, 0), piece(0, 4, 6, 0, true), piece(0, 6, 10, 0)}, 0);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FALSE(all[1].visible);
}

TEST(FacetDoubts, ContinueWhatIsHiddenAnyway) {
  Piece hidden = piece(0, 6, 10, 0);
  hidden.visible = false;
  const std::vector<Piece> all = settled({piece(0, 0, 4, 0), piece(0, 4, 6, 0, true), hidden, piece(1, 3, 7, 0.05)});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FALSE(all[1].visible);
  EXPECT_EQ(all[1].to, Vec2(10, 0));
}

// The contour of a ball of skewed facets is drawn once: nothing is added beside what is there.
TEST(FacetDoubts, AddNothingBesideOutlines) {
  Shape ball = uv_sphere(48, 24);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> aside(-0.02, 0.02);
  for (auto& p : ball.points) {
    const Vec3 skewed = glm::normalize(Vec3(p[0] + aside(random), p[1] + aside(random), p[2] + aside(random)));
    p = {skewed.x, skewed.y, skewed.z};
  }
  const Result r = draw(recognised(world_of(ball)), orthographic({1, -1, 1}));
  EXPECT_FALSE(r.hidden.by_facets.empty());
  drawing::DrawingOptions options{"ball", true};
  options.near.distance = 0.1;
  options.near.strength = [](int, int, EdgeKind, bool visible) { return visible ? 2 : 1; };
  const view::PaperMap paper{100 * r.view.map.normalisation, Vec2(0)};
  const double per_unit = 100 * r.view.map.normalisation * r.unit;
  double length = 0;
  for (const drawing::Segment& s :
       drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, paper, options, {}).segments)
    if (s.visible) length += glm::distance(s.from, s.to);
  EXPECT_NEAR(length / per_unit, 2 * std::numbers::pi, 0.05);
}

}  // namespace
}  // namespace epura::test::facet_doubts_test
