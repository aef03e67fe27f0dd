// SPDX-License-Identifier: Apache-2.0
// Needles folded back in flat faces, as exporters leave them where a corner lies beside a side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "edges/feature_edges.hpp"
#include "shapes.hpp"

namespace epura::test::needles_test {
namespace {

using Kinds = std::map<std::string, int>;

// How many edges of each kind there are of the faces that are recognised.
Kinds kinds(const Shape& shape, const projection::Projection& projection) {
  const world::World world = recognised(world_of(shape));
  EXPECT_NE(world.models[0].part, nullptr);
  const view::ProjectedScene view = view::project_scene(world, projection, {});
  Kinds counts;
  for (const auto& kind : edges::feature_edges(world, view, 0, {}))
    if (kind) ++counts[std::string(edges::name_of(*kind))];
  return counts;
}

// A block whose top, from its sixth face on, is a fan of triangles.
Shape block() {
  return {{{0, 0, 0},
           {40, 0, 0},
           {40, 30, 0},
           {0, 30, 0},
           {0, 0, 20},
           {40, 0, 20},
           {40, 30, 20},
           {0, 30, 20},
           {20, 15, 20}},
          {{0, 3, 2, 1},
           {0, 1, 5, 4},
           {1, 2, 6, 5},
           {2, 3, 7, 6},
           {3, 0, 4, 7},
           {4, 5, 8},
           {5, 6, 8},
           {6, 7, 8},
           {7, 4, 8}},
          {}};
}

class Planter {
 public:
  Planter(Shape& block, std::uint32_t seed) : block_(block), random_(seed) {}

  // A new corner, `over` beyond a side of the top and `off` its plane, is one of the triangle on this side of it; what
  // is left to the side is filled by a needle, which lies over the triangle beyond.
  void plant(double over, double off) {
    for (;;) {
      const std::size_t t = any_of_top();
      const std::size_t side = random_() % 3;
      const int a = block_.faces[t][side], b = block_.faces[t][(side + 1) % 3];
      const auto other = beside(b, a);
      const double length = std::hypot(x(b) - x(a), y(b) - y(a));
      if (!other || length < 3 || area(block_.faces[t]) < 1 || area(block_.faces[*other]) < 1) continue;
      const int far = apex(*other, a, b);
      const double at = std::uniform_real_distribution(0.2, 0.8)(random_);
      block_.points.push_back({x(a) + at * (x(b) - x(a)) - over * (y(b) - y(a)) / length,
                               y(a) + at * (y(b) - y(a)) + over * (x(b) - x(a)) / length, 20 + off});
      const int corner = static_cast<int>(block_.points.size()) - 1;
      block_.faces[*other] = {corner, a, far};
      block_.faces.push_back({b, corner, far});
      block_.faces.push_back({b, a, corner});
      return;
    }
  }

 private:
  static constexpr std::size_t first_of_top = 5;

  [[nodiscard]] double x(int v) const { return block_.points[static_cast<std::size_t>(v)][0]; }
  [[nodiscard]] double y(int v) const { return block_.points[static_cast<std::size_t>(v)][1]; }
  std::size_t any_of_top() { return first_of_top + random_() % (block_.faces.size() - first_of_top); }
  // Negative for a needle that is folded over.
  [[nodiscard]] double area(const std::vector<int>& f) const {
    return ((x(f[1]) - x(f[0])) * (y(f[2]) - y(f[0])) - (x(f[2]) - x(f[0])) * (y(f[1]) - y(f[0]))) / 2;
  }
  // The triangle of the top with a side from one corner to another.
  [[nodiscard]] std::optional<std::size_t> beside(int from, int to) const {
    for (std::size_t t = first_of_top; t < block_.faces.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        if (block_.faces[t][i] == from && block_.faces[t][(i + 1) % 3] == to) return t;
    return std::nullopt;
  }
  [[nodiscard]] int apex(std::size_t t, int a, int b) const {
    return *std::ranges::find_if(block_.faces[t], [&](int v) { return v != a && v != b; });
  }

  Shape& block_;
  std::mt19937 random_;
};

TEST(Needles, FoldedBackInARecognisedFaceAreNoLines) {
  for (const projection::Projection& view : {orthographic({1, -1, 1}), orthographic({0.3, 0.5, 2}), from_above()}) {
    const Kinds plain = kinds(block(), view);
    EXPECT_GT(plain.at("contour"), 0);
    for (const double off : {0.0, 1e-7, -1e-6})
      for (std::uint32_t seed = 0; seed < 8; ++seed) {
        Shape shape = block();
        Planter planter(shape, seed);
        for (int needle = 0; needle < 8; ++needle) planter.plant(std::pow(10.0, -1 - needle % 4), off);
        EXPECT_EQ(kinds(shape, view), plain) << "off " << off << ", seed " << seed;
      }
  }
}

// Upright or folded over, as high as wide: neither how wide they are nor how they are turned tells what they are.
TEST(Needles, AsFarOffTheFaceAsTheyAreWideAreNoLines) {
  for (const projection::Projection& view : {orthographic({1, -1, 1}), orthographic({0.3, 0.5, 2}), from_above()}) {
    const Kinds plain = kinds(block(), view);
    for (const double off : {-1e-5, -1e-6, 1e-7, 1e-5})
      for (const double over : {0.0, 1e-7, 1e-6, 1e-5}) {
        Shape shape = block();
        Planter planter(shape, 1);
        for (int needle = 0; needle < 8; ++needle) planter.plant(over, off);
        EXPECT_EQ(kinds(shape, view), plain) << "off " << off << ", over " << over;
      }
  }
}

// What stands farther off the face than its corners may is a fin.
TEST(Needles, ThatStandOffTheFaceHaveContours) {
  Shape shape = block();
  Planter(shape, 1).plant(0.1, 0.05);
  const projection::Projection view = orthographic({1, -1, 1});
  EXPECT_NE(kinds(shape, view), kinds(block(), view));
}

}  // namespace
}  // namespace epura::test::needles_test
