// SPDX-License-Identifier: Apache-2.0
// What files with few digits give: a drawing, a warning that says how many are left, or a refusal.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/text.hpp"
#include "errors.hpp"
#include "program.hpp"

namespace epura::test::precision_test {
namespace {

constexpr int sides = 48;

using Corner = std::array<double, 3>;

// A drum of radius 5 and height 5, all of triangles, cut off aslant.
std::vector<std::array<Corner, 3>> drum(double offset) {
  std::vector<std::array<Corner, 3>> triangles;
  const auto corner = [&](int i, double radius, double z) {
    const double a = 2 * M_PI * i / sides;
    return Corner{offset + radius * std::cos(a), offset + radius * std::sin(a), z + std::cos(a) / 7};
  };
  for (int i = 0; i < sides; ++i) {
    const Corner a = corner(i, 5, 0), b = corner(i + 1, 5, 0), c = corner(i + 1, 5, 5), d = corner(i, 5, 5);
    triangles.insert(triangles.end(), {{{a, b, c}}, {{a, c, d}}});
    triangles.insert(triangles.end(), {{{corner(0, 0, 0), b, a}}, {{corner(0, 0, 5), d, c}}});
  }
  return triangles;
}

std::string binary_stl(double offset) {
  const auto triangles = drum(offset);
  std::string bytes(80, ' ');
  const auto append = [&](std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
  };
  append(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    for (int i = 0; i < 3; ++i) append(0);
    for (const Corner& corner : triangle)
      for (const double x : corner) append(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

// With so many significant digits.
std::string obj(double offset, int digits) {
  std::string vertices, faces;
  int count = 0;
  for (const auto& triangle : drum(offset)) {
    faces += "f";
    for (const Corner& corner : triangle) {
      vertices += "v";
      for (const double x : corner) vertices += " " + format_rounded(x, digits);
      vertices += "\n";
      faces += " " + std::to_string(++count);
    }
    faces += "\n";
  }
  return vertices + faces;
}

Outcome draw(const std::string& name, const std::string& bytes) {
  const Folder folder;
  return epura({"draw", folder.file(name, bytes), "-o", "x.svg"}, folder / "");
}

TEST(Precision, FloatsFarFromTheOriginAreWarnedOf) {
  const Outcome far = draw("far.stl", binary_stl(5e5));
  EXPECT_EQ(far.code, 0);
  EXPECT_TRUE(contains(far.err, "(2 digits left): lines may be off by 0.00")) << far.err;
  EXPECT_TRUE(contains(far.err, "hint: export the model nearer to the origin")) << far.err;
  for (const double offset : {0.0, 10.0, 100.0, 1000.0})
    EXPECT_EQ(draw("near.stl", binary_stl(offset)).err, "") << offset;
}

TEST(Precision, FewDigitsFarFromTheOriginAreWarnedOf) {
  EXPECT_TRUE(contains(draw("far.obj", obj(5e4, 6)).err, " left): lines may be off by "));
  EXPECT_EQ(draw("far.obj", obj(5e3, 17)).err, "");
  EXPECT_EQ(draw("near.obj", obj(0, 6)).err, "");
}

TEST(Precision, DoublesFarFromTheOriginAreNot) { EXPECT_EQ(draw("far.obj", obj(1e7, 17)).err, ""); }

// A box of size 1 as floats have it at 1e7: one triangle is left, smaller than their rounding.
TEST(Precision, AModelLostInRoundingIsRefused) {
  const std::string stl =
      "solid x\nfacet normal 0 0 0\nouter loop\nvertex 1e7 1e7 10000001\nvertex 10000001 1e7 1e7\n"
      "vertex 10000001 1e7 10000001\nendloop\nendfacet\nendsolid\n";
  const Folder folder;
  const Outcome run = epura({"draw", folder.file("m.stl", stl), "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "nothing is drawn: no face is larger than the rounding")) << run.err;
  EXPECT_TRUE(contains(run.err, "hint: export the model nearer to the origin")) << run.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"m.stl"});
}

}  // namespace
}  // namespace epura::test::precision_test
