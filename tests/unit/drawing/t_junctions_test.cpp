// SPDX-License-Identifier: Apache-2.0
#include "drawing/t_junctions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "shapes.hpp"

namespace epura::test::t_junctions_test {
namespace {

using drawing::Piece;

constexpr double behind = 0, in_front = 1;

/// A contour along the x axis of three edges, as drawn; that of the mesh is half a millimetre above it.
struct Contours {
  world::World world = world_of(Shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}});
  view::ProjectedScene view;
  edges::FeatureEdges drawn;
  std::vector<Piece> pieces;

  Contours() {
    for (const double x : {0.0, 1.0, 2.0, 3.0}) view.vertices.push_back({x, 0.5, behind, 1});
    for (const double x : {0.0, 1.0, 2.0, 3.0}) view.vertices.push_back({x, 0, behind, 1});
    for (const int i : {0, 1, 2})
      drawn.edges.push_back({{i, i + 1}, {0, 1}, EdgeKind::contour, 0, -1, -1, {4 + i, 5 + i}});
  }

  // The left edge, at x, of a triangle in front whose third corner is at `other`.
  void add_triangle(double x, double other) {
    world.first_vertex[0] = static_cast<int>(view.vertices.size());
    add_upright(x, in_front);
    view.vertices.push_back({other, 0, in_front, 1});
    const mesh::Mesh& mesh = *world.models[0].mesh;
    const auto is_upright = [](const mesh::MeshEdge& edge) { return edge.vertex == std::array{0, 1}; };
    drawn.edges.back().mesh_edge =
        static_cast<int>(std::find_if(mesh.edges.begin(), mesh.edges.end(), is_upright) - mesh.edges.begin());
  }

  // A line upwards at x, as drawn.
  void add_upright(double x, double depth, EdgeKind kind = EdgeKind::contour) {
    const int first = static_cast<int>(view.vertices.size());
    for (const double y : {-1.0, 1.0}) view.vertices.push_back({x, y, depth, 1});
    const int edge = static_cast<int>(drawn.edges.size());
    drawn.edges.push_back({{first, first + 1}, {0, 1}, kind, 0, -1, -1, {-1, -1}});
    add(edge, true, 0, 1);
  }

  void add(int edge, bool visible, double from, double to) {
    const auto at = [&](double s) {
      const edges::FeatureEdge& one = drawn.edges[edge];
      const auto place = [&](std::size_t end) {
        return view.vertices[one.shown[end] < 0 ? one.vertex[end] : one.shown[end]].at();
      };
      return place(0) + s * (place(1) - place(0));
    };
    pieces.push_back({at(from), at(to), visible, true, EdgeKind::contour, edge, {from, to}});
  }

  // Facets hide all but the first quarter of a millimetre.
  void add_first_quarter() {
    add(0, true, 0, 0.25);
    add(0, false, 0.25, 1);
    add(1, false, 0, 1);
    add(2, false, 0, 1);
  }

  std::vector<drawing::SettledEnds> move() {
    return drawing::move_t_junctions({world, view, drawn, visibility::nothing_hidden(drawn)}, {1, Vec2(0)}, pieces);
  }

  // The contour is in one piece after the other, of which those from `x` on are visible.
  void expect_visible_from(double x) const {
    double at = 0;
    for (const Piece& piece : pieces) {
      if (piece.edge > 2) continue;
      EXPECT_EQ(piece.from.x, at);
      at = piece.to.x;
      EXPECT_EQ(piece.visible, piece.from.x >= x) << piece.from.x;
    }
    EXPECT_EQ(at, 3);
  }

  // Up to where the contour is visible from its start, and the length of what is visible.
  [[nodiscard]] std::array<double, 2> visible() const {
    std::array<double, 2> seen{0, 0};
    for (const Piece& piece : pieces) {
      if (piece.edge > 2 || !piece.visible) continue;
      EXPECT_LT(piece.from.x, piece.to.x);
      if (piece.from.x == seen[0]) seen[0] = piece.to.x;
      seen[1] += drawing::length_of(piece);
    }
    return seen;
  }
};

TEST(TJunctions, ContoursGoOnToWhatHidesThemAsDrawn) {
  Contours contours;
  contours.add_first_quarter();
  contours.add_upright(1.5, in_front);
  const auto settled = contours.move();
  EXPECT_EQ(contours.visible(), (std::array{1.5, 1.5}));
  ASSERT_EQ(settled.size(), contours.pieces.size());
  // Nothing else may move the ends where the change was, and where it is.
  for (std::size_t i = 0; i < settled.size(); ++i)
    for (const std::size_t end : {0, 1})
      if (const double s = contours.pieces[i].s[end]; contours.pieces[i].edge <= 2 && s > 0 && s < 1) {
        EXPECT_TRUE(settled[i][end]) << i;
      }
  double at = 0;  // in order, without gaps
  for (const Piece& piece : contours.pieces) {
    if (piece.edge > 2) continue;
    EXPECT_EQ(piece.from.x, at);
    at = piece.to.x;
  }
  EXPECT_EQ(at, 3);
}

TEST(TJunctions, ContoursEndAtWhatHidesThemAsDrawn) {
  Contours contours;
  contours.add(0, true, 0, 1);
  contours.add(1, true, 0, 0.75);
  contours.add(1, false, 0.75, 1);
  contours.add(2, false, 0, 1);
  contours.add_upright(0.5, in_front);
  contours.move();
  EXPECT_EQ(contours.visible(), (std::array{0.5, 0.5}));
}

TEST(TJunctions, NothingHidesAContourThatNothingCrosses) {
  Contours contours;
  contours.add(0, true, 0, 0.5);
  contours.add(0, false, 0.5, 1);
  contours.add(1, false, 0, 0.25);
  contours.add(1, true, 0.25, 1);
  contours.add(2, true, 0, 1);
  const auto settled = contours.move();
  EXPECT_EQ(contours.visible(), (std::array{3.0, 3.0}));
  EXPECT_TRUE(settled[0][1] && settled[1][0] && settled[2][1] && settled[3][0]) << "both ends of the gap";
}

// Nor do lines behind it, and of lines in front, only outlines hide what is beyond them.
TEST(TJunctions, OnlyOutlinesInFrontHideContours) {
  for (const bool is_crease : {false, true}) {
    Contours contours;
    contours.add_first_quarter();
    contours.add_upright(0.75, is_crease ? in_front : behind - 1, is_crease ? EdgeKind::crease : EdgeKind::contour);
    if (is_crease) contours.pieces.back().kind = EdgeKind::crease;
    contours.move();
    EXPECT_EQ(contours.visible(), (std::array{0.25, 0.25}));
  }
}

TEST(TJunctions, ContoursAreFollowedEitherWay) {
  Contours contours;
  contours.add(0, false, 0, 1);
  contours.add(1, false, 0, 1);
  contours.add(2, false, 0, 0.75);
  contours.add(2, true, 0.75, 1);
  contours.add_upright(1.5, in_front);
  contours.move();
  contours.expect_visible_from(1.5);
}

TEST(TJunctions, ContoursGoOnIntoWhatHidesThemOnly) {
  Contours behind_it;
  behind_it.add_first_quarter();
  behind_it.add_triangle(1.5, 3);
  behind_it.move();
  EXPECT_EQ(behind_it.visible(), (std::array{1.5, 1.5}));
  Contours beside_it;
  beside_it.add_first_quarter();
  beside_it.add_triangle(1.5, -3);
  beside_it.move();
  EXPECT_EQ(beside_it.visible(), (std::array{0.25, 0.25}));
}

// Facets let half a millimetre be seen between them.
TEST(TJunctions, NothingIsSeenBehindWhatAContourComesOutOf) {
  Contours contours;
  contours.add(0, false, 0, 0.25);
  contours.add(0, true, 0.25, 0.75);
  contours.add(0, false, 0.75, 1);
  contours.add(1, false, 0, 1);
  contours.add(2, true, 0, 1);
  contours.add_triangle(1.5, -3);
  contours.move();
  contours.expect_visible_from(1.5);
}

// Beyond a cusp, the surface hides its own contour.
TEST(TJunctions, CuspsStay) {
  Contours contours;
  contours.drawn.edges[0].hollow = -0.75F;
  contours.add_first_quarter();
  contours.add_upright(0.5, in_front);
  contours.move();
  EXPECT_EQ(contours.visible(), (std::array{0.25, 0.25}));
}

TEST(TJunctions, ContoursDoNotGoOnBeyondACusp) {
  Contours contours;
  contours.drawn.edges[1].hollow = 1;
  contours.add_first_quarter();
  contours.add_upright(1.5, in_front);
  contours.move();
  EXPECT_EQ(contours.visible(), (std::array{0.25, 0.25}));
}

// However far away: four times as far as the contour of the mesh is from what is drawn.
TEST(TJunctions, ContoursAreMovedNoFartherThanFacets) {
  Contours contours;
  contours.add_first_quarter();
  contours.add_upright(2.5, in_front);
  contours.move();
  EXPECT_EQ(contours.visible(), (std::array{0.25, 0.25}));
}

}  // namespace
}  // namespace epura::test::t_junctions_test
