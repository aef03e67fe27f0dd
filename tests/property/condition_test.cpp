// SPDX-License-Identifier: Apache-2.0
// The condition of a map against what a change of its input does, measured in rational numbers.
#include "view/condition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "laboratory/lab.hpp"
#include "verify/numbers.hpp"

namespace epura::condition_test {
namespace {

using laboratory::orthographic;
using laboratory::perspective;

using Place = std::array<verify::Exact, 2>;

// Numbers changed by the part `e` of themselves, up or down by lot; e = 0: as they are.
struct Changer {
  std::mt19937 random;
  double e;

  verify::Exact operator()(double number) {
    return verify::Exact(number) * (verify::Exact(1) + (random() % 2 == 0 ? verify::Exact(e) : verify::Exact(-e)));
  }
  verify::Triple<verify::Exact> operator()(const Vec3& v) { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }
};

// Corners of the box on the page, from the window's corner if there is one.
std::vector<Place> places_of(const projection::Projection& p, const Box& box, Changer change) {
  const verify::Triple<verify::Exact> n = change(p.n), q = change(p.projector), point = change(p.point);
  const std::array<verify::Triple<verify::Exact>, 2> axes{change(p.u), change(p.v)};
  Place from{0, 0};
  if (p.window) from = {change(p.window->min.x), change(p.window->min.y)};
  std::vector<Place> places;
  for (int i = 0; i < 8; ++i) {
    const verify::Triple<verify::Exact> x =
        change(Vec3((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                    (i & 4) != 0 ? box.max.z : box.min.z));
    const verify::Triple<verify::Exact> ray = p.central ? q - x : q;
    const verify::Exact way = verify::dot(n, point - x) / verify::dot(n, ray);
    const verify::Triple<verify::Exact> on_plane = verify::along(x, way, ray) - point;
    places.push_back({verify::dot(axes[0], on_plane) - from[0], verify::dot(axes[1], on_plane) - from[1]});
  }
  return places;
}

// The most by which a place moves, in parts of the drawing, when each coordinate is changed by up to `amount`.
double measured_change(const projection::Projection& p, const Box& box, double amount) {
  const auto place = [&](const Vec3& x) {
    const Vec3 ray = p.central ? p.projector - x : p.projector;
    const Vec3 on_plane = x - p.point + glm::dot(p.n, p.point - x) / glm::dot(p.n, ray) * ray;
    return Vec2(glm::dot(p.u, on_plane), glm::dot(p.v, on_plane));
  };
  double moved = 0;
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (int i = 0; i < 64; ++i) {
    const auto bit = [&](int k) { return (i >> k & 1) != 0; };
    const Vec3 corner(bit(0) ? box.max.x : box.min.x, bit(1) ? box.max.y : box.min.y, bit(2) ? box.max.z : box.min.z);
    const Vec3 change(bit(3) ? amount : -amount, bit(4) ? amount : -amount, bit(5) ? amount : -amount);
    const Vec2 before = place(corner), after = place(corner + change);
    min = glm::min(min, before);
    max = glm::max(max, before);
    moved = std::max({moved, std::abs(after.x - before.x), std::abs(after.y - before.y)});
  }
  return moved / std::max(max.x - min.x, max.y - min.y);
}

double measured_condition(const projection::Projection& p, const Box& box) {
  constexpr double e = 0x1p-60;
  const std::vector<Place> plain = places_of(p, box, {std::mt19937(), 0});
  double worst = 0;
  std::array<verify::Exact, 2> min = plain[0], max = plain[0];
  for (const Place& place : plain)
    for (int i = 0; i < 2; ++i) {
      min[i] = std::min(min[i], place[i]);
      max[i] = std::max(max[i], place[i]);
    }
  const double size = p.window ? std::max(p.window->max.x - p.window->min.x, p.window->max.y - p.window->min.y)
                               : std::max(verify::value_of(max[0] - min[0]), verify::value_of(max[1] - min[1]));
  for (unsigned seed = 0; seed < 60; ++seed) {
    const std::vector<Place> changed = places_of(p, box, {std::mt19937(seed), e});
    for (int i = 0; i < 2; ++i) {
      // Without a window, what moves the drawing as a whole does not count.
      verify::Exact shift = 0;
      if (!p.window)
        for (std::size_t k = 0; k < plain.size(); ++k) shift += (changed[k][i] - plain[k][i]) / 8;
      for (std::size_t k = 0; k < plain.size(); ++k)
        worst = std::max(worst, std::abs(verify::value_of(changed[k][i] - plain[k][i] - shift)));
    }
  }
  return worst / size / e;
}

Box cube_at(double d) { return {Vec3(d), Vec3(d + 1)}; }

projection::Projection over_the_cube(double h) {
  return perspective({0.5, 0.5, h}, {0.5, 0.5, 1}, {0, 0, 1}, {0, 1, 0});
}

// A step of a sweep: a projection of a box.
struct Step {
  const char* sweep;
  double parameter;
  projection::Projection projection;
  Box box;
};

std::vector<Step> sweeps() {
  std::vector<Step> steps;
  for (double d = 1; d > 1e-13; d /= 10) steps.push_back({"eye over the plane", d, over_the_cube(1 + d), cube_at(0)});
  for (double h = 10; h < 1e17; h *= 100) steps.push_back({"distance of the eye", h, over_the_cube(h), cube_at(0)});
  for (double l = 0.5; l < 1e7; l *= 10) {
    projection::Projection p = orthographic({0, -1, 0});
    p.projector = {l * std::cos(0.4), -1, l * std::sin(0.4)};
    steps.push_back({"depth ratio", l, p, cube_at(0)});
  }
  for (double l = 1; l < 1e12; l *= 10) {
    projection::Projection p = orthographic({1, -2, 0.5});
    p.projector = p.n + l * p.u;
    steps.push_back({"oblique to an oblique plane", l, p, cube_at(0)});
  }
  for (double d = 1; d < 1e15; d *= 10) {
    steps.push_back({"offset", d, orthographic({1, 2, 3}), cube_at(d)});
    const projection::Projection p = perspective(Vec3(3, -4, 2) + d, Vec3(d), {1, -2, 0.5}, {0, 0, 1});
    steps.push_back({"offset with the eye", d, p, cube_at(d)});
  }
  for (double d = 1; d < 1e13; d *= 10) {
    projection::Projection p = perspective({3, -4, 2}, {d, 0, 0}, {0, -1, 0}, {0, 0, 1});
    steps.push_back({"principal point", d, p, cube_at(0)});
    p.window = projection::Window{{-d - 1, -1}, {-d + 1, 1}};
    steps.push_back({"principal point and window", d, p, cube_at(0)});
  }
  return steps;
}

TEST(Condition, TellsWhatAChangeOfTheInputDoes) {
  for (const Step& step : sweeps()) {
    const double measured = measured_condition(step.projection, step.box);
    const double told = view::condition_of(step.projection, step.box).number;
    EXPECT_GE(told, measured / 2) << step.sweep << " " << step.parameter;
    EXPECT_LE(told, 30 * std::max(measured, 1.0)) << step.sweep << " " << step.parameter;
  }
}

// Every sweep is one in decades: where the measured loss passes eight digits, the warning begins within one step.
TEST(Condition, LosesEightDigitsWhereAMeasurementDoes) {
  int warned = 0;
  for (const Step& step : sweeps()) {
    const double measured = measured_condition(step.projection, step.box);
    const bool warns = view::condition_of(step.projection, step.box).digits_lost() >= view::too_many_lost_digits;
    EXPECT_TRUE(warns || measured <= 2e8) << step.sweep << " " << step.parameter;
    EXPECT_TRUE(!warns || measured >= 1e8 / 30) << step.sweep << " " << step.parameter;
    warned += warns ? 1 : 0;
  }
  EXPECT_GT(warned, 10);
}

TEST(Condition, OfUsualViewsIsSmallAndHasAReason) {
  for (const projection::Projection& p : {orthographic({1, -1, 1}), orthographic({0, 0, 1}, {0, 1, 0}),
                                          perspective({3, -4, 2}, {0, 0, 0}, {3, -4, 2}, {0, 0, 1})}) {
    const view::Condition condition = view::condition_of(p, cube_at(0));
    EXPECT_LT(condition.number, 100);
    EXPECT_FALSE(condition.why.empty());
  }
  EXPECT_EQ(view::condition_of(over_the_cube(1 + 1e-11), cube_at(0)).why,
            "the centre of projection is close to the plane of projection");
}

TEST(Condition, IsTheSameForScenesOfAnySizeAndDefinedForAPoint) {
  const view::Condition plain = view::condition_of(orthographic({1, 2, 3}), cube_at(1));
  for (const int k : {-1000, -60, 60, 1000}) {
    const double s = std::ldexp(1.0, k);
    EXPECT_EQ(view::condition_of(orthographic({1, 2, 3}), {Vec3(s), Vec3(2 * s)}).number, plain.number) << k;
  }
  EXPECT_EQ(view::condition_of(orthographic({1, 2, 3}), {Vec3(5), Vec3(5)}).number, 1);
}

// What rounding to 32-bit floats does, against the most that is told: both are of the order of the last place.
TEST(Condition, KnowsThePrecisionOfTheFiles) {
  for (const double offset : {0.0, 1e2, 1e4, 1e6})
    for (const projection::Projection& p :
         {orthographic({1, -1, 1}), perspective(Vec3(3, -4, 2) + offset, Vec3(offset), {3, -4, 2}, {0, 0, 1})}) {
      const Box box{Vec3(offset + 0.1), Vec3(offset + 1.1)};
      const Vec3 one_rounding = glm::abs(box.max) * 0x1p-24;
      const view::Condition condition = view::condition_of(p, box, one_rounding);
      EXPECT_EQ(condition.number, view::condition_of(p, box).number);
      EXPECT_EQ(view::condition_of(p, box).moved_by_files, 0);
      const double moved = measured_change(p, box, one_rounding.x);
      EXPECT_GE(condition.moved_by_files, moved / 2) << offset;
      EXPECT_LE(condition.moved_by_files, 30 * moved) << offset;
      EXPECT_NEAR(condition.digits_left(), -std::log10(condition.moved_by_files), 1e-12);
    }
}

}  // namespace
}  // namespace epura::condition_test
