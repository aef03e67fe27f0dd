// SPDX-License-Identifier: Apache-2.0
#include "explain/reason.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "explain/find_subjects.hpp"
#include "studied.hpp"

namespace epura::test::reason_test {
namespace {

std::string reason(const Studied& studied, const explain::ByVertices& edge) {
  return explain::reason_of(studied.view(), explain::find_subjects(studied.view(), edge).at(0));
}

// Two squares that meet in the edge 0-1 and turn by `degrees` there, seen from above.
Shape folded(double degrees) {
  const double angle = degrees * M_PI / 180;
  const double x = std::cos(angle), z = std::sin(angle);
  return {{{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {x, 0, z}, {x, 1, z}}, {{0, 1, 2, 3}, {1, 0, 4, 5}}, {}};
}

TEST(Reason, OfADrawnEdgeIsItsKind) {
  EXPECT_EQ(reason(study(world_of(folded(60)), from_above()), {0, {0, 1}}),
            "drawn as crease: faces 0:0 and 0:1 turn by 60 degrees; a crease turns by 30 or more");
  EXPECT_EQ(reason(study(world_of(folded(60)), from_above()), {0, {2, 3}}),
            "drawn as boundary: no face continues face 0:0");
  EXPECT_TRUE(reason(study(world_of(folded(120)), from_above()), {0, {0, 1}}).starts_with("drawn as contour: "));
}

TEST(Reason, OfAnEdgeThatIsNotDrawn) {
  EXPECT_EQ(reason(study(world_of(folded(3)), from_above()), {0, {0, 1}}),
            "not drawn: faces 0:0 and 0:1 turn by 3 degrees; a crease turns by 30 or more");
  EXPECT_EQ(reason(study(world_of(plate(0, 0, 1, 1, 0)), from_above()), {0, {0, 2}}),
            "not drawn: a diagonal of face 0:0");
  edges::EdgeOptions no_creases;
  no_creases.crease = false;
  EXPECT_EQ(reason(study(world_of(folded(60)), from_above(), no_creases), {0, {0, 1}}),
            "not drawn: crease edges are not selected; "
            "faces 0:0 and 0:1 turn by 60 degrees; a crease turns by 30 or more");
}

TEST(Reason, TellsWhenAnEdgeIsClippedAway) {
  // Seen from above, depth is measured down from the plane z = 0 through the middle of the box.
  view::ViewLimits limits;
  limits.far = 0.2;
  const Studied studied = study(world_of(box({0, 0, -1}, {1, 1, 1})), from_above(), {}, limits);
  EXPECT_EQ(reason(studied, {0, {0, 1}}), "not drawn: a contour, but outside the drawn region");
  EXPECT_TRUE(reason(studied, {0, {4, 5}}).starts_with("drawn as contour"));
}

TEST(Reason, AngleIsThatOfTwoTriangles) {
  const Studied studied = study(world_of(folded(42)), from_above());
  const explain::ExplainInput view = studied.view();
  EXPECT_NEAR(explain::angle_at(view, explain::find_subjects(view, explain::ByVertices{0, {0, 1}})[0]).value(), 42,
              1e-9);
  EXPECT_FALSE(explain::angle_at(view, explain::find_subjects(view, explain::ByVertices{0, {2, 3}})[0]).has_value());
}

TEST(Reason, OfAnIntersectionLineIsTheAngleOfThePlanes) {
  const Shape wall{{{1, -1, -1}, {1, 3, -1}, {1, 3, 1}, {1, -1, 1}}, {{0, 1, 2, 3}}, {}};
  const Studied studied = study(world_of({plate(0, 0, 2, 2, 0), wall}), orthographic({1, -1, 1}));
  const std::vector<explain::Subject> lines =
      explain::find_subjects(studied.view(), explain::ByFaces{{explain::FaceName{1, 0}, explain::FaceName{0, 0}}});
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(explain::reason_of(studied.view(), lines[0]),
            "drawn as intersection: faces 0:0 and 1:0 cross, their planes at 90 degrees");
}

}  // namespace
}  // namespace epura::test::reason_test
