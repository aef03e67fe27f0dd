// SPDX-License-Identifier: Apache-2.0
// What files with few digits give: a drawing, a warning that says how many are left, or a refusal.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/file.hpp"
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

std::string json_of(const std::string& obj, const std::string& projection) {
  const Folder folder;
  EXPECT_EQ(epura({"draw", folder.file("m.obj", obj), "--projection", projection, "--hidden", "none", "--scale", "1:1",
                   "--sheet", "A4", "-o", "x.json"},
                  folder / "")
                .code,
            0);
  return read_file(folder / "x.json");
}

// The terms of the error of the only view.
std::map<std::string, double> error_of(const std::string& json) {
  std::map<std::string, double> terms;
  const std::string name = "{\"term\": \"", value = "\", \"mm\": ";
  for (std::size_t at = json.find(name); at != std::string::npos; at = json.find(name, at + 1)) {
    const std::size_t begin = at + name.size(), end = json.find('"', begin), number = end + value.size();
    terms[json.substr(begin, end - begin)] =
        parse_number(json.substr(number, json.find(',', number) - number)).value_or(HUGE_VAL);
  }
  EXPECT_FALSE(terms.empty()) << json;
  return terms;
}

// Two outlines 0.02 mm apart are drawn as one: this is off by 0.02 mm, not by what might have been left out.
TEST(Precision, MergingIsOffByAsMuchAsLinesWereApart) {
  const std::string sheet_metal =
      "v 0 0 0\nv 100 0 0\nv 100 80 0\nv 0 80 0\nv 0 0 0.02\nv 100 0 0.02\nv 100 80 0.02\nv 0 80 0.02\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  EXPECT_NEAR(error_of(json_of(sheet_metal, "front"))["merging"], 0.02, 0.002);
  EXPECT_EQ(error_of(json_of(sheet_metal, "top"))["merging"], 0);
}

std::string torus(double radius, double minor, int around, int across) {
  std::string text;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across, r = radius + minor * std::cos(v);
      text += "v";
      for (const double x : {r * std::cos(u), r * std::sin(u), minor * std::sin(v)}) text += " " + format_number(x);
      text += "\n";
    }
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const int k = (i + 1) % around, l = (j + 1) % across;
      text += "f";
      for (const int corner : {i * across + j, k * across + j, k * across + l, i * across + l})
        text += " " + std::to_string(corner + 1);
      text += "\n";
    }
  return text;
}

std::vector<double> numbers_after(const std::string& json, const std::string& key, std::size_t from) {
  const std::size_t begin = json.find(key, from) + key.size();
  std::string list = json.substr(begin, json.find(']', begin) - begin);
  std::erase(list, ' ');
  return parse_numbers(list).value();
}

// How far the contours of a torus with radii 30 and 12, seen along (0, -1, 0.3), end from the upper one of its two
// right cusps, mm. There, the tangent of the contour is along the sight: places on paper of equal steps around the axis
// are nearest.
double off_at_cusp(const std::string& json) {
  const std::vector<double> map = numbers_after(json, "\"world_to_page\": [", 0);
  const auto on_page = [&](int i) {
    const double u = -M_PI * i / 20000, v = M_PI + std::atan(std::sin(u) / 0.3), r = 30 + 12 * std::cos(v);
    const auto row = [&](std::size_t k) {
      return map[k] * r * std::cos(u) + map[k + 1] * r * std::sin(u) + map[k + 2] * 12 * std::sin(v) + map[k + 3];
    };
    return std::array{row(0), row(4)};
  };
  const auto apart = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  std::array<double, 2> cusp{};
  double least = HUGE_VAL;
  for (int i = 0; i < 10000; ++i)
    if (const double step = apart(on_page(i), on_page(i + 1)); step < least) {
      least = step;
      cusp = on_page(i);
    }
  double off = HUGE_VAL;
  for (std::size_t at = json.find("{\"from\""); at != std::string::npos; at = json.find("{\"from\"", at + 1))
    for (const char* key : {"\"from\": [", "\"to\": ["}) {
      const std::vector<double> end = numbers_after(json, key, at);
      off = std::min(off, apart({end[0], end[1]}, cusp));
    }
  return off;
}

// Seen along its axis, its contours are two circles without ends. Aslant, the one around the hole ends in cusps, which
// facets tell too early.
TEST(Precision, ContoursAreOffWhereTheyBeginToBeSeen) {
  const std::string ring = torus(30, 12, 96, 48);
  EXPECT_LT(error_of(json_of(ring, "top"))["contours"], 1e-9);
  const std::string aslant = json_of(ring, "auxiliary:direction=0,-1,0.3");
  const double off = off_at_cusp(aslant), stated = error_of(aslant)["contours"];
  EXPECT_GT(off, 0.02);
  EXPECT_LE(off, stated);
  EXPECT_LE(stated, 5 * off);
}

using Place = std::array<double, 2>;
using Lines = std::vector<std::array<Place, 2>>;

double distance_to(const Place& at, const std::array<Place, 2>& line) {
  const double x = line[1][0] - line[0][0], y = line[1][1] - line[0][1], square = x * x + y * y;
  const double along = (at[0] - line[0][0]) * x + (at[1] - line[0][1]) * y;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  return std::hypot(at[0] - line[0][0] - t * x, at[1] - line[0][1] - t * y);
}

double farthest(const Lines& from, const Lines& others) {
  double largest = 0;
  for (const auto& [begin, end] : from)
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Place at{begin[0] + t * (end[0] - begin[0]), begin[1] + t * (end[1] - begin[1])};
      double nearest = HUGE_VAL;
      for (const auto& line : others) nearest = std::min(nearest, distance_to(at, line));
      largest = std::max(largest, nearest);
    }
  return largest;
}

// The visible contours of a torus, seen from (0, -1, rise) far away, on paper. For each angle u around the axis, n . w
// = 0 has two solutions. From p on, the projector p + t w meets the torus where t^2 (t^2 + 4 s t + c) = 0 with s = p .
// w and c = 4 s^2 + 2 (p^2 + R^2 - r^2) - 4 R^2 (1 - w_z^2): p is hidden if that has a positive solution.
Lines visible_contours(double radius, double minor, double rise, const std::vector<double>& map) {
  constexpr int steps = 4000;
  const double length = std::hypot(1, rise), wy = -1 / length, wz = rise / length;
  Lines visible;
  for (const double half : {0.0, M_PI}) {
    Place last{};
    bool was_seen = false;
    for (int i = 0; i <= steps; ++i) {
      const double u = 2 * M_PI * i / steps, v = std::atan2(-std::sin(u) * wy, wz) + half;
      const double out = radius + minor * std::cos(v);
      const Corner p{out * std::cos(u), out * std::sin(u), minor * std::sin(v)};
      const double s = p[1] * wy + p[2] * wz, square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      const double under_root = 4 * radius * radius * (1 - wz * wz) - 2 * (square + radius * radius - minor * minor);
      const bool is_seen = under_root < 0 || -2 * s + std::sqrt(under_root) <= 1e-9;
      const auto row = [&](std::size_t k) {
        return map[k] * p[0] + map[k + 1] * p[1] + map[k + 2] * p[2] + map[k + 3];
      };
      const Place at{row(0), row(4)};
      if (i > 0 && was_seen && is_seen) visible.push_back({last, at});
      last = at;
      was_seen = is_seen;
    }
  }
  return visible;
}

// What is stated is not less than what is measured on ink, nor much more, also where a contour ends in a cusp.
TEST(Precision, ContoursOfTorusesAreOffAsStated) {
  struct Seen {
    int around;
    double rise;
  };
  for (const auto& [around, rise] : {Seen{48, 0.6}, Seen{96, 0.3}, Seen{96, 0.5}, Seen{96, 0.6}}) {
    SCOPED_TRACE(testing::Message() << around << " facets around, rise " << rise);
    const std::string json =
        json_of(torus(20, 8, around, around / 2), "auxiliary:direction=0,-1," + format_number(rise));
    const Lines truth = visible_contours(20, 8, rise, numbers_after(json, "\"world_to_page\": [", 0));
    Lines ink;
    for (std::size_t at = json.find("{\"from\""); at != std::string::npos; at = json.find("{\"from\"", at + 1)) {
      const std::vector<double> from = numbers_after(json, "\"from\": [", at),
                                to = numbers_after(json, "\"to\": [", at);
      ink.push_back({Place{from[0], from[1]}, Place{to[0], to[1]}});
    }
    double stated = 0;
    for (const auto& [term, mm] : error_of(json)) stated += mm;
    const double off = std::max(farthest(truth, ink), farthest(ink, truth));
    EXPECT_GT(off, 0.005);
    EXPECT_LE(off, stated);
    EXPECT_LE(stated, 4 * off);
  }
}

}  // namespace
}  // namespace epura::test::precision_test
