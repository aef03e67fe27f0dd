// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: single facets between fillets drawn as flats with sharp edges, or flats lost.
#include "features/chords.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shapes.hpp"

namespace epura {
namespace {

using namespace test;
using features::SurfaceKind;

constexpr double sagitta = 0.04;

features::PartSurface ball(const Vec3& centre, double radius) {
  return {.kind = SurfaceKind::sphere, .origin = centre, .radius = radius};
}

/// A triangle with three neighbours that rise from its sides or fall.
struct Star {
  features::Facets facets;
  std::vector<int> region_of;
  std::vector<features::Region> regions{3};

  explicit Star(double fall) {
    const double side = std::sqrt(0.75);
    const Part part{{{1, 0, 0}, {-0.5, side, 0}, {-0.5, -side, 0}, {1, 1.7, -fall}, {-2, 0, -fall}, {1, -1.7, -fall}},
                    {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}};
    facets = features::make_facets(part.mesh());
    for (features::Region& region : regions) region.sagitta = sagitta;
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
  [[nodiscard]] int around() const { return features::region_around(facets, facets.facet_of[0], region_of, regions); }
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
  for (features::Region& region : end.regions)
    region.surface = ball(middle, glm::distance(middle, end.facets.points[end.facets.corners[0][0]]));
  EXPECT_EQ(end.around(), -1);
}

}  // namespace
}  // namespace epura
