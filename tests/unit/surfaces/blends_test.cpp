// SPDX-License-Identifier: Apache-2.0
#include "surfaces/blends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shapes.hpp"

namespace epura::test::blends_test {
namespace {

constexpr double radius = 4.9568, minor = 0.225;

// As a CAD program tessellates the rounded rim of a countersunk head: many vertices around it, few across, none of them
// in rows.
Part countersunk_head() {
  const double lower = -45 * pi / 180, upper = pi / 2;
  const auto rim = [&](double angle, int count) {
    return Ring{radius + minor * std::cos(angle), minor * std::sin(angle), count};
  };
  const Ring first = rim(lower, 60);
  std::vector<Ring> rings{{first.radius - 2, first.height - 2, 60}, first};
  const std::array counts{76, 40, 16, 100, 24, 80};
  const double step = (upper - lower) / double(counts.size() + 1);
  for (std::size_t i = 0; i < counts.size(); ++i) rings.push_back(rim(lower + double(i + 1) * step, counts[i]));
  rings.push_back(rim(upper, 58));
  Part part = stitched(rings);
  unsigned random = 1;
  for (std::size_t i = 120; i + 58 < part.points.size(); ++i) {
    auto& p = part.points[i];
    random = random * 1664525U + 1013904223U;
    const double turn = 0.8 * step * (double(random >> 16) / 65536 - 0.5);
    const double around = std::atan2(p[1], p[0]), tube = std::atan2(p[2], std::hypot(p[0], p[1]) - radius) + turn;
    const double away = radius + minor * std::cos(tube);
    p = {away * std::cos(around), away * std::sin(around), minor * std::sin(tube)};
  }
  return part.round_to_float();
}

// All facets that lie on a cone of 90 degrees through the lower end of the rim.
surfaces::Region cone_of(const surfaces::Facets& facets) {
  surfaces::Region cone{
      {.kind = surfaces::SurfaceKind::cone, .origin = -facets.origin * facets.scale, .axis = {0, 0, 1}}, {}};
  cone.surface.radius = (radius + minor * std::sqrt(2.0)) * facets.scale;
  cone.surface.slope = 1;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f) {
    const auto vertices = facets.vertices_of(f);
    const bool lies_on = std::all_of(vertices.begin(), vertices.end(), [&](int v) {
      return std::abs(surfaces::signed_distance(cone.surface, facets.points[v])) <= facets.tolerance;
    });
    if (lies_on && !facets.facets[f].is_plane) cone.facets.push_back(f);
  }
  return cone;
}

TEST(Blends, RoundedRimsHaveTheAxisOfTheirCone) {
  const surfaces::Facets facets = surfaces::make_facets(countersunk_head().mesh());
  std::vector<surfaces::Region> regions{cone_of(facets)};
  std::vector<int> region_of(facets.facets.size(), -1);
  for (const int f : regions[0].facets) region_of[f] = 0;
  ASSERT_GE(regions[0].facets.size(), 30U);
  const auto [grown, region_of_facet] = surfaces::grow_blends(facets, {regions, region_of});
  ASSERT_EQ(grown.size(), 2U);
  EXPECT_EQ(grown[1].surface.kind, surfaces::SurfaceKind::torus);
  EXPECT_NEAR(grown[1].surface.radius / facets.scale, radius, 1e-5);
  EXPECT_NEAR(grown[1].surface.minor / facets.scale, minor, 1e-5);
  // Everything else is the two ends of the head.
  EXPECT_EQ(std::count(region_of_facet.begin(), region_of_facet.end(), -1), 2);
}

// A rim that is no torus: an ellipse around the axis, tangent to the cone.
TEST(Blends, OtherRimsStayFreeForms) {
  Part part = countersunk_head();
  for (std::size_t i = 120; i < part.points.size(); ++i) {
    auto& p = part.points[i];
    const double tube = std::atan2(p[2], std::hypot(p[0], p[1]) - radius), along = tube + 45 * pi / 180;
    p[2] += 0.02 * along * along;
  }
  const surfaces::Facets facets = surfaces::make_facets(part.mesh());
  std::vector<surfaces::Region> regions{cone_of(facets)};
  std::vector<int> region_of(facets.facets.size(), -1);
  for (const int f : regions[0].facets) region_of[f] = 0;
  EXPECT_EQ(surfaces::grow_blends(facets, {regions, region_of}).regions.size(), 1U);
}

}  // namespace
}  // namespace epura::test::blends_test
