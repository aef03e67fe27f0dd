// SPDX-License-Identifier: Apache-2.0
// Edges that are B-splines come out as such: their pictures, and what is seen of them; wrong ones are refused by name.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "shapes.hpp"

namespace epura::test::splines_test {
namespace {

using Point = std::array<double, 3>;

epura_hlr_request request_for_all(const std::array<double, 16>& matrix) {
  epura_hlr_request request = request_for(matrix);
  request.all_types = 1;
  return request;
}

std::vector<epura_hlr_curve> splines_of(const Drawing& drawing) {
  std::vector<epura_hlr_curve> found;
  for (const epura_hlr_curve& curve : curves_of(drawing))
    if (curve.type == EPURA_HLR_SPLINE) found.push_back(curve);
  return found;
}

/// Of a quadratic spline with three poles.
std::array<double, 2> point_on(const epura_hlr_spline& spline, double t) {
  EXPECT_EQ(spline.size, sizeof spline);
  EXPECT_EQ(spline.degree, 2U);
  EXPECT_EQ(spline.pole_count, 3U);
  const std::array shares{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  double x = 0, y = 0, w = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = shares[i] * (spline.weights == nullptr ? 1 : spline.weights[i]);
    x += share * spline.poles[2 * i];
    y += share * spline.poles[2 * i + 1];
    w += share;
  }
  return {x / w, y / w};
}

std::array<double, 2> seen(const epura_hlr_result& result, const Point& p) {
  const auto row = [&](std::size_t r) {
    const double* m = result.matrix + 4 * r;
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  };
  return {row(0) / row(3), row(1) / row(3)};
}

TEST(HlrSplines, AreThePicturesOfThoseOfEdges) {
  const HlrModel model;
  add_parabola(model, 3);
  model.finish();
  const Drawing drawing = model.draw(request_for_all(isometric));
  ASSERT_EQ(curves_of(drawing).size(), 1U);
  const std::vector<epura_hlr_curve> splines = splines_of(drawing);
  ASSERT_EQ(splines.size(), 1U);
  const epura_hlr_spline& spline = *splines.front().spline;
  EXPECT_EQ(spline.weights, nullptr);
  EXPECT_TRUE(std::equal(bezier_knots.begin(), bezier_knots.end(), spline.knots));
  for (const double t : {0.0, 0.3, 1.0}) {
    const auto place = point_on(spline, t), expected = seen(*epura_hlr_result_of(drawing.get()), {t, t * (1 - t), 3});
    EXPECT_NEAR(place[0], expected[0], 1e-12);
    EXPECT_NEAR(place[1], expected[1], 1e-12);
  }
  EXPECT_NEAR(std::abs(splines.front().to - splines.front().from), 1, 1e-12);
  EXPECT_EQ(splines.front().count, pieces + 1U) << "its points are those of the edge";
}

TEST(HlrSplines, ArePolylinesForThoseWhoDoNotAsk) {
  const HlrModel model;
  add_parabola(model, 0);
  model.finish();
  const Drawing drawing = model.draw(request_for(isometric));
  for (const epura_hlr_curve& curve : curves_of(drawing)) {
    EXPECT_EQ(curve.type, std::uint32_t{EPURA_HLR_POLYLINE});
    EXPECT_EQ(curve.spline, nullptr);
  }
}

// A box over x from 0.25 to 0.75 hides what lies below it.
TEST(HlrSplines, TellWhichPartIsSeen) {
  for (const bool backwards : {false, true}) {
    const HlrModel model;
    add_box(model, {0.5, 1, 1});
    add_parabola(model, -1, backwards);
    model.node(0, {0.25, -0.1, 0});
    model.node(1, {0, 0, 0});
    model.finish();
    const Drawing drawing = model.draw(request_for_all(top));
    double shown = 0, hidden = 0;
    for (const epura_hlr_curve& curve : splines_of(drawing)) {
      EXPECT_EQ(curve.faces[0].node, 1U);
      const double* points = epura_hlr_result_of(drawing.get())->points + 2 * curve.first;
      EXPECT_NEAR(curve.from, points[0], 1e-5) << "x is the parameter; chords are off by a 4000th";
      EXPECT_NEAR(curve.to, points[2 * (curve.count - 1)], 1e-5);
      (curve.visible != 0 ? shown : hidden) += std::abs(curve.to - curve.from);
      const double middle = (curve.from + curve.to) / 2;
      EXPECT_EQ(curve.visible == 0, middle > 0.25 && middle < 0.75);
    }
    EXPECT_NEAR(shown, 0.5, 1e-5);
    EXPECT_NEAR(hidden, 0.5, 1e-5);
  }
}

TEST(HlrSplines, HaveWeightsInPerspective) {
  // From (0, 0, 5) downwards: what lies z above the plane is 5 / (5 - z) as large.
  std::array matrix{1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -0.2, 1.0};
  const HlrModel model;
  std::vector<double> points, parameters;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    points.insert(points.end(), {t, t * (1 - t), 2 * t});
    parameters.push_back(t);
    vertices.push_back(i);
  }
  const std::vector<double> poles{0, 0, 0, 0.5, 0.5, 1, 1, 0, 2};
  model.shape("slanted");
  model.points(points);
  model.edge(EPURA_WIRE, vertices);
  const epura_spline spline{sizeof spline, 2, 3, poles.data(), nullptr, bezier_knots.data(), parameters.data()};
  ASSERT_EQ(model.sink->spline(model.sink->host, &spline), 0);
  model.finish();
  const Drawing drawing = model.draw(request_for_all(matrix));
  ASSERT_EQ(splines_of(drawing).size(), 1U);
  const epura_hlr_spline& picture = *splines_of(drawing).front().spline;
  ASSERT_NE(picture.weights, nullptr);
  for (const double t : {0.0, 0.25, 0.8, 1.0}) {
    const double closer = 5 / (5 - 2 * t);
    EXPECT_NEAR(point_on(picture, t)[0], closer * t, 1e-12);
    EXPECT_NEAR(point_on(picture, t)[1], closer * t * (1 - t), 1e-12);
  }
}

TEST(HlrSplines, WithPolesBehindTheViewerStayPolylines) {
  std::array matrix{1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -0.2, 1.0};
  const HlrModel model;
  const double z = 6;  // of the middle pole; the curve itself is at 3 at most
  std::vector<double> points, parameters;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    points.insert(points.end(), {t, t * (1 - t), 2 * t * (1 - t) * z});
    parameters.push_back(t);
    vertices.push_back(i);
  }
  const std::vector<double> poles{0, 0, 0, 0.5, 0.5, z, 1, 0, 0};
  model.shape("raised");
  model.points(points);
  model.edge(EPURA_WIRE, vertices);
  const epura_spline spline{sizeof spline, 2, 3, poles.data(), nullptr, bezier_knots.data(), parameters.data()};
  ASSERT_EQ(model.sink->spline(model.sink->host, &spline), 0);
  model.finish();
  const Drawing drawing = model.draw(request_for_all(matrix));
  EXPECT_TRUE(splines_of(drawing).empty());
  EXPECT_FALSE(curves_of(drawing).empty());
}

TEST(HlrSplines, AreNotTheOnlyTypesThatAreNamed) {
  const HlrModel model;
  add_cylinder(model, 5, 12);
  model.finish();
  const auto count = [&](const std::array<double, 16>& matrix, std::uint32_t type) {
    epura_hlr_request request = request_for_all(matrix);
    request.arcs = 0.01;
    const Drawing drawing = model.draw(request);
    return std::ranges::count(curves_of(drawing), type, &epura_hlr_curve::type);
  };
  EXPECT_GE(count(top, EPURA_HLR_CIRCLE), 1);
  EXPECT_EQ(count(top, EPURA_HLR_ELLIPSE), 0);
  EXPECT_GE(count(isometric, EPURA_HLR_ELLIPSE), 2);
  EXPECT_EQ(count(isometric, EPURA_HLR_CIRCLE), 0);
  EXPECT_EQ(count(isometric, EPURA_HLR_LINE), 2) << "both generators";
}

// Half a tube of four sides; its lower rim is a spline, which has to have parameters for the points that division adds.
TEST(HlrSplines, FollowTheDivisionOfEdges) {
  const double s = std::sqrt(0.5);
  const HlrModel model;
  std::vector<double> points, parameters{0, 0.25, 0.5, 0.75, 1};
  const std::vector<double> poles{1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0, -1, 0, 0}, weights{1, s, 1, s, 1},
      knots{0, 0, 0, 0.5, 0.5, 1, 1, 1};
  for (const double z : {0.0, 3.0})
    for (int i = 0; i <= 4; ++i) {
      const double angle = std::numbers::pi * i / 4;
      points.insert(points.end(), {std::cos(angle), std::sin(angle), z});
    }
  model.shape("tube");
  model.points(points);
  model.face(EPURA_FREE_FORM);
  for (std::uint32_t i = 0; i < 4; ++i) model.polygon({i, i + 1, i + 6, i + 5});
  model.edge(EPURA_SHARP, {0, 1, 2, 3, 4});
  const epura_spline spline{sizeof spline, 2, 5, poles.data(), weights.data(), knots.data(), parameters.data()};
  ASSERT_EQ(model.sink->spline(model.sink->host, &spline), 0);
  const auto nearest = [](void*, std::uint32_t, std::uint32_t, std::uint64_t count, const double* from, double* to) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const double length = std::hypot(from[3 * i], from[3 * i + 1]);
      to[3 * i] = from[3 * i] / length;
      to[3 * i + 1] = from[3 * i + 1] / length;
      to[3 * i + 2] = from[3 * i + 2];
    }
    return 0;
  };
  const epura_hlr_exact exact{sizeof exact, 0, nullptr, nearest, nearest, 1e-4};
  const epura_hlr_settings settings{sizeof settings, 0, 1, 0, &exact};
  epura_hlr_error error = no_error();
  ASSERT_EQ(epura_hlr_finish(model.model.get(), &settings, &error), EPURA_HLR_DONE) << error.reason;
  const Drawing drawing = model.draw(request_for_all(isometric));
  double parts = 0;
  std::uint64_t count = 0;
  for (const epura_hlr_curve& curve : splines_of(drawing)) {
    parts += std::abs(curve.to - curve.from);
    count += curve.count;
  }
  EXPECT_NEAR(parts, 1, 1e-3);
  EXPECT_GT(count, 30U);
}

TEST(HlrSplines, ThatAreWrongAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](const std::function<void(epura_spline&, std::vector<double>&)>& spoil, bool has_edge = true) {
    const HlrModel model;
    model.shape("parabola");
    model.points({0, 0, 0, 0.5, 0.25, 0, 1, 0, 0});
    if (has_edge) model.edge(EPURA_WIRE, {0, 1, 2});
    // Poles, weights, knots and parameters, one after the other.
    std::vector<double> numbers{0, 0, 0, 0.5, 0.5, 0, 1, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0.5, 1};
    epura_spline spline{sizeof spline,      2, 3, numbers.data(), numbers.data() + 9, numbers.data() + 12,
                        numbers.data() + 18};
    spoil(spline, numbers);
    const int code = model.sink->spline(model.sink->host, &spline);
    epura_hlr_error error = no_error();
    const int end = epura_hlr_finish(model.model.get(), nullptr, &error);
    EXPECT_EQ(code == 0, end == EPURA_HLR_DONE);
    EXPECT_TRUE(code == 0 || std::string(error.place) == "sink");
    return std::string(error.reason);
  };
  const auto number = [](std::size_t i, double value) {
    return [=](epura_spline&, std::vector<double>& numbers) { numbers[i] = value; };
  };
  EXPECT_EQ(refusal([](epura_spline&, std::vector<double>&) {}), "");
  EXPECT_EQ(refusal([](epura_spline&, std::vector<double>&) {}, false), "a call hands over a spline of no edge");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.size = 8; }), "a call hands over no spline where it says so");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.degree = 0; }), "a call hands over a spline of unknown degree");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.degree = 26; }), "a call hands over a spline of unknown degree");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.pole_count = 2; }),
            "a call hands over a spline of no more poles than its degree, or of more than can be numbered");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.pole_count = std::uint64_t{1} << 60; }),
            "a call hands over a spline of no more poles than its degree, or of more than can be numbered");
  for (const auto member : {&epura_spline::poles, &epura_spline::knots, &epura_spline::parameters})
    EXPECT_EQ(refusal([=](epura_spline& s, auto&) { s.*member = nullptr; }),
              "a call hands over a spline without poles, knots or parameters");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.weights = nullptr; }), "");
  EXPECT_EQ(refusal(number(4, nan)), "a call hands over a spline with a pole that is not finite");
  for (const double weight : {0.0, -1.0, nan})
    EXPECT_EQ(refusal(number(10, weight)), "a call hands over a spline with a weight that is not positive");
  for (const double knot : {2.0, nan})
    EXPECT_EQ(refusal(number(13, knot)), "a call hands over a spline whose knots do not rise");
  for (const double parameter : {0.0, 1.0, 2.0, nan})
    EXPECT_EQ(refusal(number(19, parameter)),
              "a call hands over a spline with parameters that neither all rise nor all fall between its ends");
  EXPECT_EQ(refusal(number(4, 9)), "a call hands over a spline that does not run through the points of its edge");
  EXPECT_EQ(refusal([](epura_spline& s, auto&) { s.degree = 1; }).substr(0, 27), "a call hands over a spline ");
  const HlrModel model;
  model.shape("parabola");
  EXPECT_NE(model.sink->spline(model.sink->host, nullptr), 0);
}

}  // namespace
}  // namespace epura::test::splines_test
