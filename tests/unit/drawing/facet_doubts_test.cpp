// SPDX-License-Identifier: Apache-2.0
#include "drawing/facet_doubts.hpp"

#include <gtest/gtest.h>

namespace epura::test {
namespace {

using drawing::Piece;

// A piece of an edge along y = `height`.
Piece piece(int edge, double from, double to, double height, bool by_facets = false) {
  Piece p{{from, height}, {to, height}, true, true, EdgeKind::contour, edge, {from / 10, to / 10}};
  p.by_facets = by_facets;
  return p;
}

std::vector<Piece> settled(std::vector<Piece> pieces, double distance = 0.1) {
  drawing::settle_doubts(pieces, distance, {});
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

}  // namespace
}  // namespace epura::test
