// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: radii that no designer chose, and fillets in pieces.
#include <gtest/gtest.h>

#include "features/recognise.hpp"
#include "shapes.hpp"

namespace epura {
namespace {

using namespace test;

features::PartFaces recognise(const Part& part) { return features::recognise_faces(part.mesh()); }

TEST(Evidence, VerticesAtTheEndOfATorusNeedNotBeExact) {
  Part part = revolved(arc({10, 0}, 3, 0, 360, 24), 48).triangulate();
  int moved = 0;
  part.move([&](const Vec3& p) {
    if (p.x < 0 || std::abs(p.y) > 1) return p;
    const Vec3 ring = 10.0 * glm::normalize(Vec3(p.x, p.y, 0));
    return p + (++moved % 3 == 0 ? 3e-5 : -1e-5) * (p - ring);
  });
  const features::PartFaces faces = recognise(part.round_to_float());
  ASSERT_GE(moved, 30);
  ASSERT_EQ(faces.faces.size(), 1U);
  EXPECT_EQ(faces.faces[0].surface.kind, features::SurfaceKind::torus);
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
  EXPECT_EQ(count(recognise(edge_with_one_arc(10).round_to_float()), features::SurfaceKind::cylinder), 1);
  EXPECT_EQ(count(recognise(edge_with_one_arc(500).round_to_float()), features::SurfaceKind::cylinder), 0);
}

}  // namespace
}  // namespace epura
