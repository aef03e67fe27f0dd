// SPDX-License-Identifier: Apache-2.0
// Sections of coarse models are those of the surfaces that they represent.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "program.hpp"

namespace epura::test::section_surfaces_test {
namespace {

constexpr double radius = 45.83;

std::string vertex(double x, double y, double z) {
  return "v " + format_number(x) + " " + format_number(y) + " " + format_number(z) + "\n";
}

std::string coarse_ball() {
  constexpr int bands = 12, around = 24;
  std::string text = vertex(0, 0, -radius);
  for (int i = 1; i < bands; ++i)
    for (int k = 0; k < around; ++k) {
      const double a = std::numbers::pi * i / bands, b = 2 * std::numbers::pi * k / around;
      text += vertex(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b), -radius * std::cos(a));
    }
  text += vertex(0, 0, radius);
  const auto number = [](int band, int k) {
    const int place = band == 0 ? 0 : band == bands ? (bands - 1) * around + 1 : (band - 1) * around + k % around + 1;
    return " " + std::to_string(place + 1);
  };
  for (int i = 0; i < bands; ++i)
    for (int k = 0; k < around; ++k) {
      if (i > 0) text += "f" + number(i, k) + number(i, k + 1) + number(i + 1, k + 1) + "\n";
      if (i + 1 < bands) text += "f" + number(i, k) + number(i + 1, k + 1) + number(i + 1, k) + "\n";
    }
  return text;
}

class SectionSurfaces : public testing::Test {
 protected:
  SectionSurfaces() : ball_(folder_ / "ball.obj") { write_file(ball_, coarse_ball()); }

  Outcome draw(std::vector<std::string> more, const std::string& output) {
    std::vector<std::string> words{"draw", ball_.string(), "--scale", "1:1", "-o", (folder_ / output).string()};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, ball_.parent_path());
  }

  Folder folder_;
  std::filesystem::path ball_;
};

TEST_F(SectionSurfaces, HaveTheRadiusOfThePart) {
  const Outcome run = draw({"--views", "top", "--section", "0,0,3:0,0,1", "--arcs"}, "ball.dxf");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string dxf = read_file(folder_ / "ball.dxf");
  const std::size_t circle = dxf.find("AcDbCircle"), value = dxf.find("\n40\n", circle);
  ASSERT_NE(value, std::string::npos);
  EXPECT_NEAR(parse_number(dxf.substr(value + 4, dxf.find('\n', value + 4) - value - 4)).value_or(0),
              std::sqrt(radius * radius - 9), 1e-9);
}

// Remains of facets along the outline face elsewhere than the facets did: contours must still end at the outline.
TEST_F(SectionSurfaces, AreFoundRight) {
  for (const char* plane : {"3,2,5:0.3,-1,0.2", "0,0,3:0,0,1", "1,-20,2:0.1,-1,0.5"})
    for (const char* view : {"isometric", "front", "left"}) {
      const Outcome run = draw({"--views", view, "--section", plane, "--verify"}, "ball.svg");
      EXPECT_EQ(run.code, 0) << plane << " " << view << run.err;
    }
}

// A tube that leans in y and z, between two planes z; its first side begins `turn` of a side after x.
std::string leaning_tube(double turn) {
  constexpr int sides = 24;
  std::string text;
  for (const double r : {3.0, 9.0})
    for (const double z : {0.0, 30.0})
      for (int k = 0; k < sides; ++k) {
        const double a = 2 * std::numbers::pi * (k + turn) / sides, along = (z - 15 + 0.6 * r * std::sin(a)) / 0.8;
        text += vertex(15 + r * std::cos(a), 20 + 0.8 * r * std::sin(a) + 0.6 * along, z);
      }
  const auto corner = [](int ring, int k) { return " " + std::to_string(ring * sides + k % sides + 1); };
  for (int k = 0; k < sides; ++k)
    for (const auto& [low, high] : {std::pair(0, 1), {3, 2}, {2, 0}, {1, 3}})
      text += "f" + corner(low, k) + corner(low, k + 1) + corner(high, k + 1) + corner(high, k) + "\n";
  return text;
}

// Contours of a bore end at the cut between corners of it, and fold a triangle of the cut over.
TEST_F(SectionSurfaces, EndContoursThatLean) {
  for (const double turn : {0.37, 0.5})
    for (const char* y : {"15", "18", "22"}) {
      write_file(ball_, leaning_tube(turn));
      const Outcome run = draw({"--views", std::string("front:section=y@") + y, "--verify"}, "tube.svg");
      EXPECT_EQ(run.code, 0) << turn << " " << y << run.err;
    }
}

}  // namespace
}  // namespace epura::test::section_surfaces_test
