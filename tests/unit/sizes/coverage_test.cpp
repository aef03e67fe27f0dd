// SPDX-License-Identifier: Apache-2.0
// What dimensions give of the sizes of features.
#include "sizes/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "dimensions_support.hpp"
#include "shapes.hpp"
#include "sizes/place_chain.hpp"
#include "sizes/slope_dimensions.hpp"
#include "sizes/turned_prisms.hpp"

namespace epura::test::coverage_test {
namespace {

// A slope in a box of 20: without a view, all places of its ends are missing, and nothing ends the run.
TEST(Coverage, OfSlopesWithoutViews) {
  const world::World world = world_of({box({0, 0, 0}, {20, 20, 20})});
  features::PartFeatures features;
  features.bevels.push_back(
      {0, 1, {Vec3(20, 0, 5), Vec3(15, 0, 20)}, {0, 2}, 300, false, {}, glm::normalize(Vec3(3, 0, 1))});
  const std::array<features::Extent, 3> extents{features::Extent{0, 20}, features::Extent{0, 20},
                                                features::Extent{0, 20}};
  const sheet::Coverage coverage = sheet::find_coverage({}, {world, features, extents}, {});
  const std::vector<std::string> missing{"overall size along x", "slope: position along x (15)", "overall size along y",
                                         "overall size along z", "slope: position along z (5)"};
  for (const std::string& what : missing)
    EXPECT_NE(std::find(coverage.undimensioned.begin(), coverage.undimensioned.end(), what),
              coverage.undimensioned.end())
        << what;
  EXPECT_TRUE(coverage.repeated.empty());
}

// 0 to 10 and 10 to 30 give 0 to 30: a third length says it again. What follows from a rule repeats nothing.
TEST(Coverage, ALengthBetweenPlacesThatAreJoinedRepeats) {
  const std::vector<sheet::FeaturePlace> places{{0, 10, "step"}, {0, 20, "step"}, {1, 5, "step"}};
  sheet::PlaceChain chain(0, {0, 30}, places, 1e-6);
  EXPECT_TRUE(chain.join({0, 0, 10, 1, ""}));
  EXPECT_TRUE(chain.join({0, 10, 30, 1, ""}));
  EXPECT_FALSE(chain.join({0, 0, 30, 1, ""}));
  EXPECT_TRUE(chain.join({0, 0, 30}));
  EXPECT_TRUE(chain.join({0, 0, 7, 1, ""})) << "7 is no place";
  EXPECT_EQ(chain.joined(), (std::vector<double>{0, 30, 10}));
  EXPECT_EQ(chain.open({}), (std::vector<std::string>{"step: position along x (20)"}));
}

TEST(Coverage, ARowJoinsThePlacesThatDivideIt) {
  const std::vector<sheet::FeaturePlace> places{{2, 10, "hole"}, {2, 20, "hole"}};
  sheet::PlaceChain chain(2, {0, 30}, places, 1e-6);
  EXPECT_TRUE(chain.join({2, 0, 30, 3, ""}));
  EXPECT_EQ(chain.joined().size(), 4U);
}

// A rectangle of 12 and 8 about (5, 6), turned by 30 degrees about z; its material is outside.
TEST(Coverage, TurnedPrismsAreTwoPairsOfFacesAboutOneMiddle) {
  const Vec3 u(std::sqrt(3) / 2, 0.5, 0), v(-0.5, std::sqrt(3) / 2, 0), middle(5, 6, 0), up(0, 0, 10);
  features::PartFeatures features;
  const auto add = [&](const Vec3& normal, double off, const Vec3& across, double half, double inwards) {
    const Vec3 at = middle + off * normal;
    features.inclined.push_back(
        {0,
         -inwards * normal,
         {at - half * across, at + half * across, at + half * across + up, at - half * across + up}});
  };
  for (const double side : {-1.0, 1.0}) {
    add(side * u, 6, v, 4, 1);
    add(side * v, 4, u, 6, 1);
  }
  const auto prisms = sheet::find_turned_prisms(features);
  ASSERT_EQ(prisms.size(), 1U);
  EXPECT_TRUE(prisms[0].inwards);
  EXPECT_NEAR(prisms[0].widths[0], 12, 1e-12);
  EXPECT_NEAR(prisms[0].widths[1], 8, 1e-12);
  EXPECT_NEAR(prisms[0].centre.x, 5, 1e-12);
  EXPECT_NEAR(prisms[0].centre.y, 6, 1e-12);
  EXPECT_NEAR(prisms[0].reach({1, 0, 0}), 6 * std::sqrt(3) / 2 + 4 * 0.5, 1e-12);
  features.inclined.pop_back();
  EXPECT_TRUE(sheet::find_turned_prisms(features).empty()) << "three sides are no prism";
}

// An angle counts for what it measures: a leg is in a side, or in the middle between two, and reaches the prism. Of
// slopes, it is in their plane.
TEST(Coverage, AnAngleIsThatOfWhatItTouches) {
  const Vec3 u(std::sqrt(3) / 2, 0.5, 0), v(-0.5, std::sqrt(3) / 2, 0), x(1, 0, 0), middle(5, 6, 0);
  const sheet::TurnedPrism prism{0, middle, {0, 0, 1}, {u, v}, {12, 8}, true};
  const auto angle = [](const Vec3& corner, const Vec3& one, const Vec3& other) {
    sheet::AnchoredDimension dimension{};
    dimension.type = DimensionType::angular;
    dimension.points = {corner, corner + 5.0 * one, corner + 5.0 * other};
    return dimension;
  };
  EXPECT_TRUE(sheet::is_angle_of(angle(middle, x, u), prism));
  EXPECT_TRUE(sheet::is_angle_of(angle(middle + 4.0 * v, u, x), prism)) << "in a side";
  EXPECT_FALSE(sheet::is_angle_of(angle(middle + 2.0 * v, u, x), prism)) << "in no side";
  EXPECT_FALSE(sheet::is_angle_of(angle(middle + Vec3(0, 30, 0), x, u), prism)) << "of another thing";
  EXPECT_FALSE(sheet::is_angle_of(angle(middle + 20.0 * u, x, u), prism)) << "beyond it";
  EXPECT_FALSE(sheet::is_angle_of(angle(middle, v, u), prism)) << "not from the axes";
  const features::BevelFeature slope{0,     1,  {Vec3(20, 0, 5), Vec3(15, 0, 20)}, {0, 2}, 300,
                                     false, {}, glm::normalize(Vec3(3, 0, 1))};
  const Vec3 side = glm::normalize(slope.ends[1] - slope.ends[0]);
  EXPECT_TRUE(sheet::is_angle_of(angle(slope.ends[0], {0, 0, 1}, side), slope));
  EXPECT_FALSE(sheet::is_angle_of(angle(slope.ends[0] + Vec3(9, 0, 0), {0, 0, 1}, side), slope));
}

}  // namespace
}  // namespace epura::test::coverage_test
