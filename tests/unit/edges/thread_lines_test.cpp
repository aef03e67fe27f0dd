// SPDX-License-Identifier: Apache-2.0
// A shaft M20 of 30 mm, whose thread is 10 mm long.
#include "edges/thread_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "edges/material_along.hpp"
#include "shapes.hpp"

namespace epura::test::thread_lines_test {
namespace {

constexpr double crest = 10, length = 10;

struct Shaft {
  world::World world;
  bool up = true;  // whether heights on its cylinder grow with z
  double root = scene::parse_thread("M20", "").minor() / 2;

  explicit Shaft(const std::vector<std::array<double, 2>>& profile = {{0, 0}, {crest, 0}, {crest, 30}, {0, 30}})
      : world(recognised(world_of(revolved(profile, 48)))) {
    world::Placed& placed = world.models[0];
    for (int face = 0; face < static_cast<int>(placed.part->faces.size()); ++face) {
      const surfaces::PartSurface& surface = placed.part->faces[static_cast<std::size_t>(face)].surface;
      if (surface.kind != surfaces::SurfaceKind::cylinder) continue;
      up = surface.axis.z > 0;
      placed.threads.push_back({face, false, !up, length, true, 0, scene::parse_thread("M20", "")});
    }
  }

  // The ends of the lines of a kind.
  [[nodiscard]] std::vector<std::array<Vec3, 2>> lines(EdgeKind kind, const projection::Projection& projection,
                                                       double depth = 0) const {
    view::ProjectedScene view = view::project_scene(world, projection, {});
    edges::FeatureEdges drawn;
    edges::add_thread_lines(world, view, depth, drawn);
    std::vector<std::array<Vec3, 2>> lines;
    for (const edges::FeatureEdge& edge : drawn.edges)
      if (edge.kind == kind) lines.push_back(drawn.crossings[static_cast<std::size_t>(edge.crossing)].ends);
    return lines;
  }
};

const projection::Projection from_the_front = orthographic({0, -1, 0});

TEST(ThreadLines, AlongTheAxisAreThreeQuartersOfACircle) {
  const Shaft shaft;
  const auto lines = shaft.lines(EdgeKind::thread, from_above());
  ASSERT_FALSE(lines.empty());
  double turn = 0;
  for (const auto& [from, to] : lines) {
    EXPECT_NEAR(std::hypot(from.x, from.y), shaft.root, 1e-9);
    EXPECT_NEAR(from.z, length, 1e-9) << "at the end towards the viewer";
    const double angle = std::atan2(from.y + to.y, from.x + to.x) * 180 / std::numbers::pi;
    EXPECT_TRUE(angle < 5 || angle > 95) << "a quarter is open, beside the centre lines";
    turn += 2 * std::asin(glm::distance(from, to) / 2 / shaft.root);
  }
  EXPECT_NEAR(turn, 1.5 * std::numbers::pi, 1e-9);
  EXPECT_TRUE(shaft.lines(EdgeKind::thread_end, from_above()).empty());
}

TEST(ThreadLines, AcrossTheAxisAreTwoOfTheRootAndOneAtTheEnd) {
  const Shaft shaft;
  const auto roots = shaft.lines(EdgeKind::thread, from_the_front);
  ASSERT_EQ(roots.size(), 2U);
  for (const auto& [from, to] : roots) {
    EXPECT_NEAR(std::abs(from.x), shaft.root, 1e-9);
    EXPECT_NEAR(from.x, to.x, 1e-12);
    EXPECT_NEAR(std::min(from.z, to.z), 0, 1e-9);
    EXPECT_NEAR(std::max(from.z, to.z), length, 1e-9);
    EXPECT_NEAR(std::hypot(from.x, from.y), crest, 1e-9) << "on the surface towards the viewer";
  }
  EXPECT_NEAR(std::abs(roots[0][0].x - roots[1][0].x), 2 * shaft.root, 1e-9);
  const auto ends = shaft.lines(EdgeKind::thread_end, from_the_front);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(glm::distance(ends[0][0], ends[0][1]), 2 * crest, 1e-9);
  EXPECT_NEAR(ends[0][0].z, length, 1e-9);
}

TEST(ThreadLines, AreAtLeastTheGivenDepthApartAndNoneWhereThatIsTooMuch) {
  const Shaft shaft;
  const auto lines = shaft.lines(EdgeKind::thread, from_the_front, 3);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(std::abs(lines[0][0].x), crest - 3, 1e-9);
  EXPECT_TRUE(shaft.lines(EdgeKind::thread, from_the_front, 0.51 * crest).empty());
}

// With a chamfer of 1 mm at its end. ISO 6410-1: seen along the axis, its circle is left out.
TEST(ThreadLines, ReachIntoAChamferWhoseCircleIsNotDrawn) {
  const Shaft shaft({{0, 0}, {crest - 1, 0}, {crest, 1}, {crest, 30}, {0, 30}});
  const auto circles = edges::chamfer_circles(shaft.world, from_above(), 0);
  EXPECT_EQ(circles.size(), 48U);
  for (const edges::MeshEdgeOfModel& edge : circles)
    for (const int v : shaft.world.models[0].mesh->edges[static_cast<std::size_t>(edge.mesh_edge)].vertex) {
      const Vec3& p = shaft.world.points[static_cast<std::size_t>(v)];
      EXPECT_NEAR(std::hypot(p.x, p.y), crest - 1, 1e-9);
      EXPECT_EQ(p.z, 0);
    }
  EXPECT_TRUE(edges::chamfer_circles(shaft.world, from_the_front, 0).empty());
  view::ProjectedScene view = view::project_scene(shaft.world, from_above(), {});
  edges::FeatureEdges drawn;
  for (const int edge : {circles[0].mesh_edge, circles[0].mesh_edge + 1})
    drawn.edges.push_back({{0, 1}, {0, 1}, EdgeKind::crease, 0, edge, -1});
  const bool both =
      std::binary_search(circles.begin(), circles.end(), edges::MeshEdgeOfModel{0, circles[0].mesh_edge + 1});
  edges::add_thread_lines(shaft.world, view, 0, drawn);
  EXPECT_EQ(std::count_if(drawn.edges.begin(), drawn.edges.end(),
                          [](const edges::FeatureEdge& edge) { return edge.mesh_edge >= 0; }),
            both ? 0 : 1);
  for (const auto& [from, to] : shaft.lines(EdgeKind::thread, from_the_front)) {
    EXPECT_NEAR(std::min(from.z, to.z), 0, 1e-9);
    EXPECT_NEAR(std::max(from.z, to.z), 1 + length, 1e-9);
  }
}

TEST(ThreadLines, AreNoneInOtherViews) {
  const Shaft shaft;
  EXPECT_TRUE(shaft.lines(EdgeKind::thread, orthographic({1, -1, 1})).empty());
  projection::Projection oblique = from_the_front;
  oblique.projector = glm::normalize(oblique.n + 0.3 * oblique.u);
  EXPECT_TRUE(shaft.lines(EdgeKind::thread, oblique).empty());
  EXPECT_TRUE(shaft.lines(EdgeKind::thread, perspective({0, -90, 5}, Vec3(0), {0, -1, 0}, {0, 0, 1})).empty());
}

// A bar of 20 x 20 x 30 with a slot 4 wide and 6 deep in its left side, over the whole length.
TEST(MaterialAlong, EndsWhereASlotBegins) {
  Shape bar;
  for (const double z : {0.0, 30.0})
    for (const auto& [x, y] : {std::array{-10.0, -10.0},
                               {10.0, -10.0},
                               {10.0, 10.0},
                               {-10.0, 10.0},
                               {-10.0, 2.0},
                               {-4.0, 2.0},
                               {-4.0, -2.0},
                               {-10.0, -2.0}})
      bar.points.push_back({x, y, z});
  bar.faces = {{7, 6, 5, 4, 3, 2, 1, 0}, {8, 9, 10, 11, 12, 13, 14, 15}};
  for (int i = 0; i < 8; ++i) bar.faces.push_back({i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
  const world::World world = world_of(bar);
  const edges::MaterialAlong material(world, 0, 0, {Vec3(0), Vec3(0, 0, 1)}, 1);
  using Spans = std::vector<std::array<double, 2>>;
  EXPECT_EQ(material.at({3, 1, 5}), (Spans{{0, 30}}));
  EXPECT_EQ(material.at({-9, 1, 5}), Spans{});
  EXPECT_EQ(material.at({-9, 3, 5}), (Spans{{0, 30}}));
  EXPECT_EQ(material.at({11, 0, 0}), Spans{});
}

}  // namespace
}  // namespace epura::test::thread_lines_test
