// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/nearest.hpp"
#include "drawing/edge_on.hpp"
#include "drawing/make_drawing.hpp"
#include "mesh/mesh.hpp"
#include "shapes.hpp"

namespace epura::test::circles_edge_on_test {
namespace {

constexpr int sides = 24;
constexpr double radius = 20;

// A cylinder about z whose upper rim is turned by some facets.
Shape twisted_cylinder(double facets = 0.5) {
  Shape shape;
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = (i % sides + (i < sides ? 0 : facets)) * 2 * std::numbers::pi / sides;
    shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), i < sides ? 0.0 : 10.0});
  }
  std::vector<int> below, above;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    below.insert(below.begin(), i);
    above.push_back(sides + i);
    shape.faces.push_back({i, next, sides + i});
    shape.faces.push_back({next, sides + next, sides + i});
  }
  shape.faces.push_back(below);
  shape.faces.push_back(above);
  return shape;
}

// Vertices of declared faces lie beside the surface by as much as their file permits.
world::World with_vertex_moved_outwards(world::World world, int vertex, double by) {
  auto mesh = std::make_shared<mesh::Mesh>(*world.models[0].mesh);
  Vec3& point = world.points[static_cast<std::size_t>(vertex)];
  point += by * glm::normalize(Vec3(point.x, point.y, 0));
  mesh->points[static_cast<std::size_t>(vertex)] = {point.x, point.y, point.z};
  world.models[0].mesh = mesh;
  return world;
}

TEST(CirclesEdgeOn, RemovedLinesHaveInkWithinTheStatedDistance) {
  for (const double moved : {0.0, 0.02}) {
    const world::World world = with_vertex_moved_outwards(recognised(world_of(twisted_cylinder())), 3, moved);
    const Result r = draw(world, from_above());
    drawing::DrawingOptions options{"top", true};
    options.near.distance = 0.01;
    options.near.strength = [](int, int, EdgeKind, bool visible) { return visible ? 2 : 1; };
    const drawing::ViewDrawing drawing =
        drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, options);
    const Vec2 removed = drawing::position_on_paper(
        r.view, {1, Vec2(0)},
        *std::ranges::find_if(r.drawn.edges, [](const edges::FeatureEdge& edge) { return edge.vertex[0] == 3; }), 0);
    double nearest = HUGE_VAL;
    for (const drawing::Segment& s : drawing.segments)
      nearest = std::min(nearest, distance_to_segment(removed, s.from, s.to));
    const double rise = radius * (1 - std::cos(std::numbers::pi / sides));
    EXPECT_NEAR(nearest * r.unit, rise + moved, 1e-6);
    EXPECT_LE(nearest, drawing.distances.joined_within * (1 + 1e-9));
    EXPECT_LT(drawing.distances.joined_within, 1.01 * nearest);
  }
}

// Edges between vertices that lie above each other but for rounding run anywhere on the page, also towards the centre.
TEST(CirclesEdgeOn, EdgesAlongTheAxisDoNotCount) {
  for (const double off : {1e-7, 1e-8, 1e-9, 1e-10}) {
    world::World world = recognised(world_of(twisted_cylinder(off)));
    for (int vertex = sides; vertex < 2 * sides; vertex += 2)
      world = with_vertex_moved_outwards(std::move(world), vertex, vertex % 4 == 0 ? off : -off);
    const Result r = draw(world, from_above());
    drawing::DrawingOptions options{"top", true};
    options.near.distance = 0.01;
    options.near.strength = [](int, int, EdgeKind, bool visible) { return visible ? 2 : 1; };
    const drawing::ViewDrawing drawing =
        drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, options);
    EXPECT_LE(drawing.distances.joined_within * r.unit, 1.01 * radius * (1 - std::cos(std::numbers::pi / sides)))
        << off;
  }
}

}  // namespace
}  // namespace epura::test::circles_edge_on_test
