// SPDX-License-Identifier: Apache-2.0
// Closed forms of central projections, by hand calculation.
#include "construction/perspective.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "projection/matrices.hpp"

namespace epura::construction::perspective_test {
namespace {

using projection::Projection;

const double degree = std::numbers::pi / 180;

Projection central(const Vec3& point, const Vec3& u, const Vec3& v, double eye, double scale = 1) {
  Projection p;
  p.point = point;
  p.u = u;
  p.v = v;
  p.n = glm::cross(u, v);
  p.central = true;
  p.projector = point + eye * p.n;
  p.scale = scale;
  return p;
}

// The plane on a page whose origin is the plane's point, at `scale` mm a unit.
PicturePlane on_page(const Projection& p, double scale) {
  const Mat4 to_plane = projection::view_matrix(p);
  const double s = scale * p.scale;
  return picture_plane(p, rows({s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}) * to_plane, scale);
}

// A vertical picture turned by `degrees`, with the eye at a height above the ground z = 0.
PicturePlane two_point(double degrees, double eye, double height, double scale = 1) {
  const double a = degrees * degree;
  return on_page(central({0, 0, height}, {std::cos(a), std::sin(a), 0}, {0, 0, 1}, eye), scale);
}

Request request(const std::string& text) { return {scene::parse_construction(text, "test"), "test"}; }

Request request(const std::string& text, const std::vector<Vec3>& elements) {
  Request one = request(text);
  one.elements = elements;
  return one;
}

Figure figure(const PicturePlane& plane, const std::vector<Request>& requests) {
  Surroundings around;
  around.box.add({0, 0, 0});
  around.box.add({1, 1, 1});
  around.reach = 3;
  return perspective_figure(plane, requests, around);
}

const Point& find(const Figure& figure, const std::string& symbol) {
  const auto found = std::find_if(figure.points.begin(), figure.points.end(),
                                  [&](const Point& p) { return p.symbol.text() == symbol; });
  if (found == figure.points.end()) throw std::runtime_error("no point " + symbol);
  return *found;
}

void expect_at(const Vec2& p, double x, double y) {
  EXPECT_NEAR(p.x, x, 1e-9);
  EXPECT_NEAR(p.y, y, 1e-9);
}

// A cube seen at 30 degrees from a distance of 10: tan 60 = sqrt 3. SP sees the vanishing points in a right angle.
TEST(Perspective, VanishingAndMeasuringPointsOfACubeByHand) {
  const PicturePlane plane = two_point(30, 10, 1.6, 2);
  const Figure f = figure(
      plane, {request("vp"), request("measuring"), request("distance"), request("station"), request("principal")});
  const double root = std::sqrt(3.0), e = 20;
  expect_at(find(f, "PP").at, 0, 0);
  expect_at(find(f, "VP_x").at, -e * root, 0);
  expect_at(find(f, "VP_y").at, e / root, 0);
  expect_at(find(f, "SP").at, 0, -e);
  expect_at(find(f, "M_x").at, -e * root + 2 * e, 0);
  expect_at(find(f, "M_y").at, e / root - e * 2 / root, 0);
  expect_at(find(f, "D_1").at, -e, 0);
  expect_at(find(f, "D_2").at, e, 0);
  EXPECT_THROW(find(f, "VP_z"), std::runtime_error) << "verticals stay parallel";
  const Vec2 x = find(f, "VP_x").at - find(f, "SP").at, y = find(f, "VP_y").at - find(f, "SP").at;
  EXPECT_NEAR(glm::dot(x, y), 0, 1e-9);
}

// The observer of the second lecture: o = (40, 60, 40), c = (0, 20, 20), d = 0.5; t = (2, 2, 1)/3 is towards the
// observer, s = (-1, -1, 4)/(3 sqrt 2) up and r = (-1, 1, 0)/sqrt 2 to the right.
TEST(Perspective, VanishingPointsOfTheHelicopterByHand) {
  const double root = std::sqrt(2.0);
  const Vec3 o(40, 60, 40), t = Vec3(2, 2, 1) / 3.0, r = Vec3(-1, 1, 0) / root, s = Vec3(-1, -1, 4) / (3 * root);
  const PicturePlane plane = on_page(central(o - 0.5 * t, r, s, 0.5), 1);
  const Figure f = figure(plane, {request("vp"), request("horizon"), request("station")});
  expect_at(find(f, "VP_x").at, 0.75 / root, 0.25 / root);
  expect_at(find(f, "VP_y").at, -0.75 / root, 0.25 / root);
  expect_at(find(f, "VP_z").at, 0, -root);
  // The principal point is the orthocentre; the eye is at sqrt(0.25 + 1/32) from the horizon.
  EXPECT_NEAR(glm::dot(find(f, "VP_x").at, find(f, "VP_y").at), -0.25, 1e-12);
  expect_at(find(f, "SP").at, 0, 0.25 / root - std::sqrt(0.25 + 1.0 / 32));
}

// The camera of the third lecture at (0, 0, 2) looks along -z at a cube turned by 60 degrees about y.
TEST(Perspective, VanishingPointsOfTheTurnedCubeByHand) {
  const PicturePlane plane = on_page(central({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 1), 1);
  const double c = std::cos(60 * degree), s = std::sin(60 * degree);
  expect_at(*vanishing_point(plane, {c, 0, -s}), 1 / std::sqrt(3.0), 0);
  expect_at(*vanishing_point(plane, {s, 0, c}), -std::sqrt(3.0), 0);
  EXPECT_FALSE(vanishing_point(plane, {0, 1, 0}));
}

TEST(Perspective, VanishingPointsAreImagesOfDirectionsByMPer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] { return Vec3(some(random), some(random), some(random)); };
    const Vec3 n = glm::normalize(any()), u = glm::normalize(glm::cross(any(), n));
    const Projection p = central(any(), u, glm::cross(n, u), 1 + some(random) / 2);
    const Vec3 d = glm::normalize(any());
    if (std::abs(glm::dot(d, n)) < 0.05) continue;
    const Vec4 image = projection::m_per(p.point, p.n, p.projector) * Vec4(d, 0);
    const Vec3 at = Vec3(image) / image.w - p.point;
    const Vec2 vp = *vanishing_point(on_page(p, 1), d);
    EXPECT_NEAR(vp.x, glm::dot(at, p.u), 1e-9);
    EXPECT_NEAR(vp.y, glm::dot(at, p.v), 1e-9);
  }
}

TEST(Perspective, TheHorizonPassesThroughVanishingPointsOfHorizontalDirections) {
  const Vec3 n = glm::normalize(Vec3(0.4, -0.8, 0.3)), u = glm::normalize(glm::cross(Vec3(0, 0, 1), n));
  const PicturePlane plane = on_page(central({3, 1, 2}, u, glm::cross(n, u), 4), 7);
  const PictureLine horizon = *vanishing_line(plane, {0, 0, 1});
  for (int a = 0; a < 360; a += 7) {
    const Vec2 vp = *vanishing_point(plane, {std::cos(a * degree), std::sin(a * degree), 0});
    EXPECT_NEAR(glm::dot(vp - horizon.foot, horizon.across()), 0, 1e-9);
  }
}

// Of an edge of the model, the measuring point cuts off scale times its length, wherever the edge lies.
TEST(Perspective, MeasuringPointsCutOffTrueLengths) {
  for (const double turn : {20.0, 45.0, -60.0}) {
    const PicturePlane plane = two_point(turn, 12, 1.6, 3);
    for (const Vec3& to : {Vec3(3, 5, 0.5), Vec3(1, 9, 0.5), Vec3(-2, 3, 0.5)}) {
      const Vec3 from(1, 4, 0.5);
      const Figure f = figure(plane, {request("true-length:0-1", {from, to})});
      EXPECT_NEAR(glm::length(find(f, "a").at - find(f, "b").at), 3 * glm::length(to - from), 1e-9);
      EXPECT_NEAR(find(f, "a").at.y, find(f, "T").at.y, 1e-9) << "on a line parallel to the horizon";
    }
  }
}

TEST(Perspective, TrueLengthsHaveTheirOwnPoints) {
  const PicturePlane plane = two_point(20, 12, 1.6, 3);
  const Vec3 from(1, 4, 0.5), to(3, 5, 0.5), other(0, 9, 0.5);
  const Figure f = figure(plane, {request("true-length:0-1", {from, to}), request("true-length:0-2", {from, other})});
  EXPECT_NEAR(glm::length(find(f, "a").at - find(f, "b").at), 3 * glm::length(to - from), 1e-9);
  EXPECT_NEAR(glm::length(find(f, "a_2").at - find(f, "b_2").at), 3 * glm::length(other - from), 1e-9);
}

TEST(Perspective, TheGroundLineIsWhereThePictureMeetsTheGround) {
  const Figure f = figure(two_point(30, 10, 1.6, 2), {request("ground")});
  ASSERT_EQ(f.lines.size(), 1U);
  EXPECT_NEAR(f.lines[0].from.y, -3.2, 1e-12) << "the ground is 1.6 below the eye";
}

// By hand: the plane x + z = 4, seen in the picture y = 0 from y = -10, cuts it in u + v = 4.
TEST(Perspective, TracesArePlanesInThePicture) {
  const PicturePlane plane = on_page(central({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 10), 2);
  const Figure f = figure(plane, {request("traces:0", {{4, 0, 0}, {0, 0, 4}, {0, 7, 4}, {4, 7, 0}})});
  ASSERT_EQ(f.lines.size(), 1U);
  const Line& trace = f.lines[0];
  EXPECT_EQ(trace.symbol.text(), "α");
  EXPECT_EQ(trace.extent, Extent::line);
  for (const Vec2& p : {trace.from, trace.to}) EXPECT_NEAR(p.x + p.y, 2 * 4, 1e-12) << "at 2:1";
}

// The trace of a plane holds those of all its lines, and is parallel to its vanishing line.
TEST(Perspective, TracesHoldThoseOfTheLinesOfThePlane) {
  const PicturePlane plane = two_point(25, 12, 1.6, 3);
  const std::vector<Vec3> ring{{1, 4, 0.5}, {3, 5, 0.2}, {2, 6, 3}};
  const Figure f = figure(plane, {request("traces:0", ring)});
  ASSERT_EQ(f.lines.size(), 1U);
  const Vec2 along = glm::normalize(f.lines[0].to - f.lines[0].from), across(-along.y, along.x);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = trace_of_line(plane, ring[i], ring[(i + 1) % 3]);
    ASSERT_TRUE(at);
    EXPECT_NEAR(glm::dot(*at - f.lines[0].from, across), 0, 1e-9);
  }
  const auto vanishing = vanishing_line(plane, glm::cross(ring[1] - ring[0], ring[2] - ring[0]));
  ASSERT_TRUE(vanishing);
  EXPECT_NEAR(glm::dot(vanishing->along, across), 0, 1e-12);
}

// One direction has one vanishing point with one name; what coincides is named together.
TEST(Perspective, VanishingPointsHaveOneName) {
  const PicturePlane plane = two_point(30, 10, 1.6);
  const Figure f = figure(plane, {request("vp:10,0,0"), request("vp:-1,0,0"), request("vp"), request("vp:2,2,0"),
                                  request("vp:1,1,0"), request("to-vp:0-1", {{0, 5, 0}, {7, 5, 0}})});
  std::vector<std::string> names;
  for (const Point& point : f.points) names.push_back(point.symbol.text());
  EXPECT_EQ(names, (std::vector<std::string>{"VP_x", "VP_y", "VP_2,2,0"}));
  EXPECT_EQ(f.points.at(2).also.at(0).text(), "VP_1,1,0");
}

TEST(Perspective, TheConeOfVisionHasItsAngle) {
  const Figure f = figure(two_point(30, 10, 1.6), {request("cone:60"), request("cone")});
  ASSERT_EQ(f.curves.size(), 2U);
  EXPECT_NEAR(glm::length(f.curves[0].u), 10 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(glm::length(f.curves[1].u), 3, 1e-12) << "as far as the ink reaches";
}

TEST(Perspective, LinesOfEdgesRunFromTheirNearerEnd) {
  const PicturePlane plane = two_point(30, 10, 1.6);
  const Figure f = figure(plane, {request("to-vp:0-1", {{0, 5, 0}, {2, 5, 0}})});
  ASSERT_EQ(f.lines.size(), 1U);
  const Vec2 vp = *vanishing_point(plane, {1, 0, 0});
  EXPECT_EQ(f.lines[0].to, vp);
  EXPECT_NEAR(glm::length(f.lines[0].from - *image_of(plane, {0, 5, 0})), 0, 1e-12)
      << "x vanishes on the left, and 0 is nearer to it than 2";
}

TEST(Perspective, WhatLiesAtInfinityIsTold) {
  const auto message = [](const PicturePlane& plane, const Request& wanted) {
    try {
      figure(plane, {wanted});
    } catch (const Error& error) {
      EXPECT_FALSE(error.hint().empty());
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const PicturePlane plane = two_point(30, 10, 1.6);
  EXPECT_NE(message(plane, request("vp:0,0,1")).find("parallel to the picture"), std::string::npos);
  EXPECT_NE(message(plane, request("to-vp:0-1", {{0, 0, 0}, {0, 0, 3}})).find("parallel to the picture"),
            std::string::npos);
  EXPECT_NE(message(plane, request("vanishing-line:0.5,-0.8660254037844386,0")).find("parallel to the picture"),
            std::string::npos);
  const PicturePlane from_above = on_page(central({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5), 1);
  EXPECT_NE(message(from_above, request("horizon")).find("at infinity"), std::string::npos);
  EXPECT_EQ(message(from_above, request("vp")), "nothing") << "z vanishes at the principal point";
}

}  // namespace
}  // namespace epura::construction::perspective_test
