// SPDX-License-Identifier: Apache-2.0
#include "edges/walls.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "edges/find_edges.hpp"
#include "shapes.hpp"
#include "surfaces/declared_part.hpp"

namespace epura::test::walls_test {
namespace {

constexpr double pi = std::numbers::pi;

// A rib on a plate, 60 long, with fillets of 3 below and of 2 above: x and z of its outline, and the number of the face
// that begins there. The ends of its walls are off them by as much as modellers allow.
struct Rib {
  Shape shape;
  surfaces::DeclaredPart declared;
};

Rib rib(double off) {
  using surfaces::SurfaceKind;
  constexpr int steps = 8, rows = 12;
  std::vector<std::pair<std::array<double, 2>, int>> outline{{{20, 0}, 0}};
  const auto at = [](double turn) { return turn * pi / 2 / steps; };
  for (int i = 0; i < steps; ++i) outline.push_back({{8 - 3 * std::sin(at(i)), 3 - 3 * std::cos(at(i))}, 1});
  outline.push_back({{5, 3}, 2});
  for (int i = 0; i < steps; ++i) outline.push_back({{3 + 2 * std::cos(at(i)), 10 + 2 * std::sin(at(i))}, 3});
  outline.push_back({{3, 12}, 4});
  for (std::size_t i = outline.size() - 1; i-- > 0;)
    outline.push_back({{-outline[i + 1].first[0], outline[i + 1].first[1]}, 8 - outline[i].second});
  outline.push_back({{-20, 0}, 8});
  Rib rib;
  std::mt19937 random(5);
  const int count = static_cast<int>(outline.size());
  for (int row = 0; row <= rows; ++row)
    for (const auto& [p, face] : outline) {
      const bool is_at_wall = std::abs(std::abs(p[0]) - 5) < 1e-9;
      rib.shape.points.push_back(
          {p[0] + (is_at_wall ? off * (double(random() % 2001) / 1000 - 1) : 0), 5.0 * row, p[1]});
    }
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i + 1 < count; ++i) {
      const int a = row * count + i;
      rib.shape.faces.push_back({a, a + count, a + count + 1, a + 1});
      rib.declared.face_of_polygon.push_back(outline[static_cast<std::size_t>(i)].second);
    }
  const auto plane = [](double x, double z, const Vec3& axis) {
    return surfaces::PartSurface{SurfaceKind::plane, {x, 0, z}, axis};
  };
  const auto fillet = [](double x, double z, double radius) {
    return surfaces::PartSurface{SurfaceKind::cylinder, {x, 0, z}, {0, 1, 0}, radius};
  };
  rib.declared.faces = {plane(0, 0, {0, 0, 1}),   fillet(8, 3, 3),         plane(5, 0, {1, 0, 0}),
                        fillet(3, 10, 2),         plane(0, 12, {0, 0, 1}), fillet(-3, 10, 2),
                        plane(-5, 0, {-1, 0, 0}), fillet(-8, 3, 3),        plane(0, 0, {0, 0, 1})};
  return rib;
}

// From above, each wall has its outline all along, above and below, though most of its facets face a little up or down.
TEST(PartEdges, AWallSeenEdgeOnHasItsWholeOutline) {
  for (const double off : {0.0, 1e-7, 1e-5}) {
    const Rib part = rib(off);
    world::World world = world_of(part.shape);
    const mesh::Mesh& mesh = *world.models[0].mesh;
    world.models[0].part = std::make_shared<surfaces::PartFaces>(surfaces::part_of(mesh, part.declared, 5));
    view::ProjectedScene view = view::project_scene(world, from_above(), {});
    std::map<std::pair<bool, double>, int> contours;
    int others = 0;
    for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges) {
      if (edge.kind != EdgeKind::contour) continue;
      const Vec3 a = world.points[edge.vertex[0]], b = world.points[edge.vertex[1]];
      if (std::abs(std::abs(a.x) - 5) < 1e-4 && a.z == b.z)
        ++contours[{a.x > 0, a.z}];
      else
        ++others;
    }
    EXPECT_EQ(contours, (std::map<std::pair<bool, double>, int>{
                            {{false, 3}, 12}, {{false, 10}, 12}, {{true, 3}, 12}, {{true, 10}, 12}}))
        << off;
    EXPECT_EQ(others, 0) << off;
  }
}

}  // namespace
}  // namespace epura::test::walls_test
