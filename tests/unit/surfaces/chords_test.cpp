// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: single facets between fillets drawn as flats with sharp edges, or flats lost.
#include "surfaces/chords.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shapes.hpp"
#include "surfaces/free_form.hpp"

namespace epura::chords_test {
namespace {

using namespace test;
using surfaces::SurfaceKind;

constexpr double sagitta = 0.04;

surfaces::PartSurface ball(const Vec3& centre, double radius) {
  return {.kind = SurfaceKind::sphere, .origin = centre, .radius = radius};
}

/// A triangle with three neighbours that rise from its sides or fall.
struct Star {
  surfaces::Facets facets;
  std::vector<int> region_of;
  std::vector<surfaces::Region> regions{3};

  explicit Star(double fall) {
    const double side = std::sqrt(0.75);
    const Part part{{{1, 0, 0}, {-0.5, side, 0}, {-0.5, -side, 0}, {1, 1.7, -fall}, {-2, 0, -fall}, {1, -1.7, -fall}},
                    {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}};
    facets = surfaces::make_facets(part.mesh());
    for (surfaces::Region& region : regions) region.sagitta = sagitta;
    region_of.assign(4, -1);
    for (int i = 0; i < 3; ++i) {
      regions[i].facets = {facets.facet_of[i + 1]};
      region_of[facets.facet_of[i + 1]] = i;
    }
  }

  /// A ball that passes each corner of the triangle `apart` above.
  void set_ball(int region, double apart) {
    const Vec3 corner = facets.points[facets.corners[0][0]], normal = facets.facets[facets.facet_of[0]].normal;
    Vec3 middle(0);
    for (const int v : facets.vertices_of(facets.facet_of[0])) middle += facets.points[v] / 3.0;
    const Vec3 centre = middle - 2.0 * normal;
    regions[region].surface = ball(centre, glm::distance(centre, corner) + apart);
  }
  [[nodiscard]] int around() const { return surfaces::region_around(facets, facets.facet_of[0], region_of, regions); }
};

Star star(double first, double second, double third, double fall = 0.5) {
  Star star(fall);
  star.set_ball(0, first);
  star.set_ball(1, second);
  star.set_ball(2, third);
  return star;
}

TEST(FacetsBetween, BelongToTheNearestRoundFace) {
  EXPECT_EQ(star(0.3, 0.3, 0.3).around(), -1);
  EXPECT_EQ(star(0.015, 0.01, 0.3).around(), 1);
  EXPECT_EQ(star(0.3, 0.3, 0.015).around(), 2);
}

TEST(FacetsBetween, MayBeFlatsBesidePlanesAndFreeForms) {
  for (const SurfaceKind kind : {SurfaceKind::plane, SurfaceKind::free_form}) {
    Star flat = star(0, 0, 0);
    flat.regions[2].surface.kind = kind;
    EXPECT_EQ(flat.around(), -1);
  }
  Star open = star(0, 0, 0);
  EXPECT_NE(open.around(), -1);
  open.region_of[open.facets.facet_of[3]] = -1;
  EXPECT_EQ(open.around(), -1);
}

TEST(FacetsBetween, AreNoEndsOfRoundFaces) {
  Star end = star(0, 0, 0);
  // The corners lie on a ball around the middle of the triangle, which is a flat cut through it.
  Vec3 middle(0);
  for (const int v : end.facets.vertices_of(end.facets.facet_of[0])) middle += end.facets.points[v] / 3.0;
  for (surfaces::Region& region : end.regions)
    region.surface = ball(middle, glm::distance(middle, end.facets.points[end.facets.corners[0][0]]));
  EXPECT_EQ(end.around(), -1);
}

/// A pentagon whose corners lie on a torus, in a plane parallel to its axis, and triangles around it.
struct FlatOnTorus {
  Part part;
  surfaces::Facets facets;
  std::vector<surfaces::Region> regions;
  std::vector<int> region_of;

  explicit FlatOnTorus(double apart) {
    constexpr double around = 3, tube = 1, depth = 0.02;  // of the plane below the outermost generator
    part.faces.emplace_back();
    for (int i = 0; i < 5; ++i) {
      // y across the plane and z along it: (sqrt(x^2 + y^2) - around)^2 + z^2 = tube^2.
      const double x = around + tube - depth, angle = 2 * pi * i / 5;
      const auto outside = [&](double s) {
        const double out = std::hypot(x, s * std::cos(angle)) - around;
        return out * out + s * s * std::sin(angle) * std::sin(angle) > tube * tube;
      };
      double inner = 0, outer = 1;
      while (outer - inner > 1e-12) (outside((inner + outer) / 2) ? outer : inner) = (inner + outer) / 2;
      part.faces[0].push_back(part.add({x, inner * std::cos(angle), inner * std::sin(angle)}));
    }
    for (int i = 0; i < 5; ++i) {
      const double middle = 2 * pi * (i + 0.5) / 5;
      const int tip = part.add({around + tube - 0.2, 0.8 * std::cos(middle), 0.8 * std::sin(middle)});
      part.faces.push_back({(i + 1) % 5, i, tip});
    }
    facets = surfaces::make_facets(part.mesh());
    const double scale = facets.scale;
    const surfaces::PartSurface torus{.kind = SurfaceKind::torus,
                                      .origin = -facets.origin * scale,
                                      .axis = {0, 0, 1},
                                      .radius = (around + apart) * scale,
                                      .minor = tube * scale};
    const int flat = facets.facet_of[0];
    regions.resize(2);
    regions[0].surface = {.kind = SurfaceKind::plane, .origin = facets.facets[flat].middle, .axis = {1, 0, 0}};
    regions[0].facets = {flat};
    regions[1].surface = torus;
    regions[1].sagitta = depth * scale / 2;
    region_of.assign(facets.facets.size(), 1);
    region_of[flat] = 0;
    for (int f = 0; f < static_cast<int>(region_of.size()); ++f)
      if (f != flat) regions[1].facets.push_back(f);
  }
};

TEST(FlatsOfTori, ArePartsOfThemIfTheirCornersLieOnThem) {
  FlatOnTorus one(0);
  ASSERT_EQ(one.facets.facets.size(), 6U);
  const auto merged = surfaces::merge_regions(one.facets, {one.regions, one.region_of}).regions;
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_EQ(merged[0].surface.kind, SurfaceKind::torus);
  FlatOnTorus beside(0.05);
  EXPECT_EQ(surfaces::merge_regions(beside.facets, {beside.regions, beside.region_of}).regions.size(), 2U);
}

TEST(FlatsOfTori, DoNotConnectTwoOfThem) {
  FlatOnTorus both(0);
  both.regions.push_back(both.regions[1]);
  both.regions[1].facets.resize(3);
  both.regions[2].facets = {both.regions[2].facets.begin() + 3, both.regions[2].facets.end()};
  // The corners lie on it, too, but it is another torus.
  both.regions[2].surface.axis = glm::normalize(Vec3(0, 1e-4, 1));
  for (const int f : both.regions[2].facets) both.region_of[f] = 2;
  const auto merged = surfaces::merge_regions(both.facets, {both.regions, both.region_of}).regions;
  ASSERT_EQ(merged.size(), 2U);
  for (const surfaces::Region& region : merged) EXPECT_EQ(region.surface.kind, SurfaceKind::torus);
}

/// A shaft of so many facets with a slot across its end, `width` wide, as programs cut it that know no surfaces:
/// corners of the slot lie on chords. Seven faces: the cylinder, one end, two halves of the other one, floor and walls
/// of the slot.
Part slotted_shaft(int facets, double radius, double width) {
  std::vector<Vec2> outline;
  const std::vector<Vec2> round = regular_polygon(facets, radius);
  for (std::size_t i = 0; i < round.size(); ++i) {
    const Vec2 a = round[i], b = round[(i + 1) % round.size()];
    outline.push_back(a);
    for (const double wall : {-width / 2, width / 2})
      if ((a.y - wall) * (b.y - wall) < 0) outline.push_back(a + (wall - a.y) / (b.y - a.y) * (b - a));
  }
  Part part;
  const int n = static_cast<int>(outline.size());
  for (const double z : {0.0, 20.0, 30.0})
    for (const Vec2& p : outline) part.add({p.x, p.y, z});
  std::vector<int> bottom, floor, above, below;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    part.faces.push_back({i, j, n + j, n + i});
    bottom.insert(bottom.begin(), i);
    const double y = outline[i].y, middle = (y + outline[j].y) / 2;
    if (std::abs(middle) > width / 2) part.faces.push_back({n + i, n + j, 2 * n + j, 2 * n + i});
    const double slack = 1e-9;
    if (std::abs(y) <= width / 2 + slack) floor.push_back(n + i);
    if (y >= width / 2 - slack) above.push_back(2 * n + i);
    if (y <= -width / 2 + slack) below.push_back(2 * n + i);
  }
  part.faces.push_back(bottom);
  part.faces.push_back(floor);
  part.faces.push_back(above);
  part.faces.push_back(below);
  part.faces.push_back({above.back() - n, above.back(), above.front(), above.front() - n});
  part.faces.push_back({below.back() - n, below.back(), below.front(), below.front() - n});
  return part;
}

TEST(Chords, AreCutAnywhereByProgramsThatKnowNoSurfaces) {
  for (const int facets : {24, 32, 64, 100}) {
    const surfaces::PartFaces part =
        surfaces::recognise_faces(slotted_shaft(facets, 10, 5.3).triangulate().round_to_float().mesh());
    EXPECT_EQ(part.faces.size(), 7U) << facets;
    EXPECT_NEAR(only(part, surfaces::SurfaceKind::cylinder).surface.radius, 10, 1e-5) << facets;
    EXPECT_NEAR(only(part, surfaces::SurfaceKind::cylinder).sweep, 360, 1e-6) << facets;
    EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), 6) << facets;
    EXPECT_EQ(count(part, surfaces::BorderKind::tangent), 0) << facets;
  }
}

// Programs that cut shapes let them overlap by a little, which leaves ledges far narrower than facets.
TEST(Chords, ANarrowLedgeBesideThemIsAPlane) {
  for (const double width : {0.0025, 0.01, 0.3}) {
    const surfaces::PartFaces part = surfaces::recognise_faces(
        revolved({{0, 6}, {5 - width, 8}, {5, 8}, {5, 20}, {0, 20}}, 64).triangulate().round_to_float().mesh());
    ASSERT_EQ(part.faces.size(), 4U) << width;
    EXPECT_EQ(count(part, SurfaceKind::plane), 2) << width;
    EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 3) << width;
  }
}

}  // namespace
}  // namespace epura::chords_test
