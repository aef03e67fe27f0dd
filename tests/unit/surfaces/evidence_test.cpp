// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: radii that no designer chose, and fillets in pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapes.hpp"
#include "surfaces/chords.hpp"
#include "surfaces/recognise.hpp"
#include "surfaces/round_regions.hpp"

namespace epura::evidence_test {
namespace {

using namespace test;

surfaces::PartFaces recognise(const Part& part) { return surfaces::recognise_faces(part.mesh()); }

TEST(Evidence, VerticesAtTheEndOfATorusNeedNotBeExact) {
  Part part = revolved(arc({10, 0}, 3, 0, 360, 24), 48).triangulate();
  int moved = 0;
  part.move([&](const Vec3& p) {
    if (p.x < 0 || std::abs(p.y) > 1) return p;
    const Vec3 ring = 10.0 * glm::normalize(Vec3(p.x, p.y, 0));
    return p + (++moved % 3 == 0 ? 3e-5 : -1e-5) * (p - ring);
  });
  const surfaces::PartFaces faces = recognise(part.round_to_float());
  ASSERT_GE(moved, 30);
  ASSERT_EQ(faces.faces.size(), 1U);
  EXPECT_EQ(faces.faces[0].surface.kind, surfaces::SurfaceKind::torus);
  EXPECT_NEAR(faces.faces[0].surface.radius, 10, 1e-5);
  EXPECT_NEAR(faces.faces[0].surface.minor, 3, 1e-5);
}

/// A block of a size with a rounded edge: an arc of many vertices at one end, and three vertices at the other.
Part edge_with_one_arc(double size) {
  constexpr int steps = 12;
  Part part;
  std::vector<int> lower, upper;
  for (const Vec2& p : {Vec2(0, 0), Vec2(size, 0), Vec2(size, size)}) {
    lower.push_back(part.add({p, 0.0}));
    upper.push_back(part.add({p, 4.0}));
  }
  std::vector<int> rim, tips;
  for (const Vec2& p : arc({3, size - 3}, 3, 90, 180, steps)) rim.push_back(part.add({p, 0.0}));
  for (const Vec2& p : arc({3, size - 3}, 3, 90, 180, 2)) tips.push_back(part.add({p, 4.0}));
  std::vector<int> bottom = lower, top = upper;
  bottom.insert(bottom.end(), rim.begin(), rim.end());
  top.insert(top.end(), tips.begin(), tips.end());
  part.faces = {{bottom.rbegin(), bottom.rend()},
                top,
                {lower[0], lower[1], upper[1], upper[0]},
                {lower[1], lower[2], upper[2], upper[1]},
                {lower[2], rim.front(), tips.front(), upper[2]},
                {rim.back(), lower[0], upper[0], tips.back()}};
  for (int i = 0; i < steps; ++i) part.faces.push_back({rim[i], rim[i + 1], tips[(i + 3) / 6]});
  for (int i = 0; i < 2; ++i) part.faces.push_back({tips[i], rim[6 * i + 3], tips[i + 1]});
  return part;
}

TEST(Evidence, AnArcAndThreeVerticesAreACylinderOnlyIfTheyLieOnItExactly) {
  EXPECT_EQ(count(recognise(edge_with_one_arc(10).round_to_float()), surfaces::SurfaceKind::cylinder), 1);
  EXPECT_EQ(count(recognise(edge_with_one_arc(500).round_to_float()), surfaces::SurfaceKind::cylinder), 0);
}

/// A shaft of fine facets, but for a spot of sixteen by sixteen of them with two triangles in the middle as wide as
/// half of it.
Part shaft_with_coarse_spot() {
  constexpr int sides = 192, rows = 30, half = 8;
  Part part;
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < sides; ++i) {
      // Triangles of other rows lie in other planes.
      const double a = 2 * std::numbers::pi * (i + 0.1 * ((3 * row + i) % 5)) / sides;
      part.add({31 * std::cos(a), 31 * std::sin(a), double(row)});
    }
  const auto at = [&](int row, int i) { return row * sides + (i + sides) % sides; };
  constexpr int middle = 15;  // the row; the spot is around i = 0
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < sides; ++i) {
      const bool in_spot = row >= middle - half && row < middle + half && (i < half || i >= sides - half);
      if (in_spot) continue;
      part.faces.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      part.faces.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
  // Strips across the corners of the spot, each longer than the one before.
  for (const int up : {-1, 1})
    for (const int right : {-1, 1}) {
      const auto on_side = [&](int k) { return at(middle + up * (half - k), right * half); };
      const auto on_end = [&](int k) { return at(middle + up * half, right * (half - k)); };
      const auto add = [&](int a, int b, int c) {
        part.faces.push_back(up * right > 0 ? std::vector{a, b, c} : std::vector{a, c, b});
      };
      add(on_side(0), on_end(1), on_side(1));
      for (int k = 1; k < half; ++k) {
        add(on_side(k), on_end(k), on_end(k + 1));
        add(on_side(k), on_end(k + 1), on_side(k + 1));
      }
    }
  const int left = at(middle, -half), right = at(middle, half), low = at(middle - half, 0), high = at(middle + half, 0);
  part.faces.push_back({low, right, high});
  part.faces.push_back({low, high, left});
  std::vector<int> bottom, top;
  for (int i = 0; i < sides; ++i) {
    bottom.insert(bottom.begin(), at(0, i));
    top.push_back(at(rows, i));
  }
  part.faces.push_back(bottom);
  part.faces.push_back(top);
  return part;
}

TEST(Evidence, TrianglesManyTimesAsLargeAsThoseAroundThemAreNoFlats) {
  const mesh::Mesh mesh = shaft_with_coarse_spot().mesh();
  const surfaces::Facets facets = surfaces::make_facets(mesh);
  auto [regions, region_of] = surfaces::find_round_regions(facets, {});
  ASSERT_GT(regions.front().facets.size(), facets.facets.size() / 2);
  // In most meshes, the spot is too small to prove its surface.
  regions.resize(1);
  for (int& region : region_of) region = region == 0 ? 0 : -1;
  const std::vector<int> with_spot = surfaces::take_chords(facets, {regions, region_of}).region_of;
  EXPECT_EQ(std::count(with_spot.begin(), with_spot.end(), -1), 2) << "the ends";
}

}  // namespace
}  // namespace epura::evidence_test
