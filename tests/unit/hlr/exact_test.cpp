// SPDX-License-Identifier: Apache-2.0
// Facets follow surfaces that call-backs evaluate, and call-backs that answer wrongly are refused by name.
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include "shapes.hpp"

namespace epura::test::exact_test {
namespace {

constexpr double radius = 5, height = 12;

// The side of the cylinder is face 2; its rims are edges 0 and 1.
void put_on_circle(const double* point, double* nearest) {
  const double length = std::hypot(point[0], point[1]);
  nearest[0] = point[0] * radius / length;
  nearest[1] = point[1] * radius / length;
  nearest[2] = point[2];
}

int near_cylinder(void*, std::uint32_t, std::uint32_t, std::uint64_t count, const double* points, double* nearest) {
  for (std::uint64_t i = 0; i < count; ++i) put_on_circle(points + 3 * i, nearest + 3 * i);
  return 0;
}

bool is_visible(const epura_hlr_curve& curve) { return curve.visible != 0; }

epura_hlr_exact exact_cylinder(double tolerance = 1e-3) {
  return {sizeof(epura_hlr_exact), 0, nullptr, near_cylinder, near_cylinder, tolerance};
}

/// A cylinder of six sides.
struct Coarse : HlrModel {
  Coarse() { add_cylinder(*this, radius, height, 6); }

  int finish_with(const epura_hlr_exact& exact, epura_hlr_error* error) const {
    const epura_hlr_settings settings{sizeof(epura_hlr_settings), 0, 0, 0, &exact};
    return epura_hlr_finish(model.get(), &settings, error);
  }

  [[nodiscard]] std::string refusal_of(const epura_hlr_exact& exact) const {
    epura_hlr_error error = no_error();
    EXPECT_EQ(finish_with(exact, &error), EPURA_HLR_INPUT);
    return std::string(error.place) + ": " + error.reason;
  }
};

TEST(HlrExactSurfaces, AreFollowedByRimsAndContours) {
  const Coarse cylinder;
  epura_hlr_error error = no_error();
  ASSERT_EQ(cylinder.finish_with(exact_cylinder(), &error), EPURA_HLR_DONE) << error.reason;
  const Drawing drawing = cylinder.draw(request_for(top));
  EXPECT_NEAR(length_of_all(drawing, is_visible), 2 * std::numbers::pi * radius, 1e-2);
  const epura_hlr_result& result = *epura_hlr_result_of(drawing.get());
  EXPECT_GT(result.point_count, 100U);
  for (std::uint64_t i = 0; i < result.point_count; ++i)
    EXPECT_NEAR(std::hypot(result.points[2 * i], result.points[2 * i + 1]), radius, 1e-9);

  const Drawing seen = cylinder.draw(request_for(isometric));
  for (const epura_hlr_curve& curve : curves_of(seen))
    if (curve.kind == EPURA_HLR_CONTOUR && curve.edge == EPURA_NONE) {
      const double* at = epura_hlr_result_of(seen.get())->points + 2 * curve.first;
      EXPECT_NEAR(std::abs(at[0]), radius, 1e-3);
    }
}

TEST(HlrExactSurfaces, AreFollowedWithinTheTolerance) {
  std::size_t points = 0;
  for (const double tolerance : {1e-1, 3e-2, 3e-3}) {
    const Coarse cylinder;
    ASSERT_EQ(cylinder.finish_with(exact_cylinder(tolerance), nullptr), EPURA_HLR_DONE);
    const Drawing drawing = cylinder.draw(request_for(top));
    const epura_hlr_result& result = *epura_hlr_result_of(drawing.get());
    for (const epura_hlr_curve& curve : curves_of(drawing))
      for (std::uint64_t i = curve.first; i + 1 < curve.first + curve.count; ++i) {
        const double* p = result.points + 2 * i;
        EXPECT_GE(std::hypot(p[0] + p[2], p[1] + p[3]) / 2, radius - tolerance);
      }
    EXPECT_GT(result.point_count, points);
    points = result.point_count;
  }
}

TEST(HlrExactSurfaces, AreFollowedBesidePlanesWithoutEdges) {
  const HlrModel wedge;  // half a cylinder of two sides: a plane below, one behind, and no edge
  wedge.shape("half");
  wedge.points({radius, 0, 0, 0, radius, 0, -radius, 0, 0, radius, 0, height, 0, radius, height, -radius, 0, height});
  wedge.face(EPURA_PLANE, {0, 0, 0}, {0, 0, -1});
  wedge.polygon({2, 1, 0});
  wedge.face(EPURA_PLANE, {0, 0, height});
  wedge.polygon({3, 4, 5});
  wedge.face(EPURA_FREE_FORM);
  wedge.polygon({0, 1, 4, 3});
  wedge.polygon({1, 2, 5, 4});
  wedge.face(EPURA_PLANE, {0, 0, 0}, {0, -1, 0});
  wedge.polygon({0, 3, 5, 2});
  const epura_hlr_exact exact = exact_cylinder();
  const epura_hlr_settings settings{sizeof(epura_hlr_settings), 0, 0, 0, &exact};
  epura_hlr_error error = no_error();
  ASSERT_EQ(epura_hlr_finish(wedge.model.get(), &settings, &error), EPURA_HLR_DONE) << error.reason;
  EXPECT_NEAR(length_of_all(wedge.draw(request_for(top)), is_visible), (std::numbers::pi + 2) * radius, 1e-2);
}

TEST(HlrExactSurfaces, MayBeAbsentFromSettingsOfTheFirstVersion) {
  struct {
    std::uint32_t size, is_mesh, threads, unused;
  } const first{16, 0, 0, 0};
  static_assert(sizeof first == offsetof(epura_hlr_settings, exact));
  const Coarse cylinder;
  EXPECT_EQ(epura_hlr_finish(cylinder.model.get(), reinterpret_cast<const epura_hlr_settings*>(&first), nullptr),
            EPURA_HLR_DONE);
  const Coarse other;
  const epura_hlr_settings wrong{12, 0, 0, 0, nullptr};
  epura_hlr_error error = no_error();
  EXPECT_EQ(epura_hlr_finish(other.model.get(), &wrong, &error), EPURA_HLR_INPUT);
  EXPECT_EQ(std::string(error.place), "settings");
}

TEST(HlrExactSurfaces, OfWrongFunctionsAreRefusedByName) {
  using Call = decltype(epura_hlr_exact::face);
  const auto refusal = [](Call face, Call edge) {
    epura_hlr_exact exact = exact_cylinder();
    exact.face = face;
    exact.edge = edge;
    return Coarse().refusal_of(exact);
  };
  const Call throws = [](void*, std::uint32_t, std::uint32_t, std::uint64_t, const double*, double*) -> int {
    throw std::runtime_error("no");
  };
  const Call fails = [](void*, std::uint32_t, std::uint32_t, std::uint64_t, const double*, double*) { return 7; };
  const Call silent = [](void*, std::uint32_t, std::uint32_t, std::uint64_t, const double*, double*) { return 0; };
  const Call far = [](void*, std::uint32_t, std::uint32_t, std::uint64_t count, const double*, double* nearest) {
    std::fill_n(nearest, 3 * count, 1e3);
    return 0;
  };
  EXPECT_EQ(refusal(throws, near_cylinder), "exact: face 2 of shape 0: throws an exception across the C interface");
  EXPECT_EQ(refusal(near_cylinder, throws), "exact: edge 0 of shape 0: throws an exception across the C interface");
  EXPECT_EQ(refusal(near_cylinder, fails), "exact: edge 0 of shape 0: fails with 7");
  EXPECT_EQ(refusal(silent, near_cylinder), "exact: face 2 of shape 0: answers with a coordinate that is not finite");
  EXPECT_EQ(refusal(far, near_cylinder),
            "exact: face 2 of shape 0: answers with a point that is farther from a facet than this is long");
  EXPECT_EQ(refusal(nullptr, near_cylinder), "exact: lacks a function");
  EXPECT_EQ(refusal(near_cylinder, nullptr), "exact: lacks a function");
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(Coarse().refusal_of(exact_cylinder(tolerance)), "exact: its tolerance is not positive and finite");
  epura_hlr_exact small = exact_cylinder();
  small.size = 8;
  EXPECT_EQ(Coarse().refusal_of(small), "exact: has the size 8");
}

// It is no surface: wherever facets are, it is elsewhere.
TEST(HlrExactSurfaces, AreGivenUpAtTooManyPoints) {
  const epura_hlr_exact evading{
      sizeof(epura_hlr_exact),
      0,
      nullptr,
      [](void*, std::uint32_t, std::uint32_t, std::uint64_t count, const double* points, double* nearest) {
        for (std::uint64_t i = 0; i < 3 * count; ++i) nearest[i] = points[i] + (i % 3 == 2 ? 1e-6 : 0);
        return 0;
      },
      near_cylinder,
      1e-9};
  const HlrModel triangle;
  triangle.shape("triangle");
  triangle.points({0, 0, 0, 1, 0, 0, 0, 1, 0});
  triangle.face(EPURA_FREE_FORM);
  triangle.polygon({0, 1, 2});
  const epura_hlr_settings settings{sizeof(epura_hlr_settings), 0, 0, 0, &evading};
  epura_hlr_error error = no_error();
  EXPECT_EQ(epura_hlr_finish(triangle.model.get(), &settings, &error), EPURA_HLR_INPUT);
  EXPECT_EQ(std::string(error.reason), "face 0 of shape 0: has more than 3000 points and is not near enough");
}

}  // namespace
}  // namespace epura::test::exact_test
