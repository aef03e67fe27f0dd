// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of assemblies: overall sizes, and where the parts are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::assembly_dimensions_test {
namespace {

// A box from one corner to another, as a closed body; `first` is the number of its first corner.
std::string box(const Vec3& low, const Vec3& high, int first) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + format_number(((i & 1) != 0 ? high : low).x) + " " + format_number(((i & 2) != 0 ? high : low).y) +
            " " + format_number(((i & 4) != 0 ? high : low).z) + "\n";
  for (const auto& face :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    text += "f";
    for (const int corner : face) text += " " + std::to_string(first + corner);
    text += "\n";
  }
  return text;
}

// A crumb on a plate of 100 m is within the precision of the view: no line shows it.
TEST(AssemblyDimensions, OverAllIncludeWhatIsTooSmallToSee) {
  const Folder folder;
  folder.file("two.obj",
              box({0, 0, 0}, {100000, 60000, 100}, 1) + box({50000, 30000, 100}, {50000.01, 30000.01, 100.01}, 9));
  const Outcome run =
      epura({"draw", "two.obj", "--unit", "mm", "--views", "front,top", "--dimensions", "overall", "-o", "x.svg"},
            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted({"100.01", "100000", "60000"}));
}

// A part has its place where it begins, once; its size is for its own drawing.
TEST(AssemblyDimensions, AreOverallSizesAndPlacesOfParts) {
  const Folder folder;
  folder.file("two.obj", box({0, 0, 0}, {40, 20, 10}, 1) + box({12, 5, 10}, {21, 14, 26}, 9));
  for (const char* command : {"draw", "lint"}) {
    std::vector<std::string> words{command, "two.obj", "--views", "front,top,left", "--dimensions", "auto"};
    if (words.front() == "draw") words.insert(words.end(), {"-o", "x.svg"});
    const Outcome run = epura(words, folder / "");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted({"40", "20", "26", "12", "5", "10"}));
}

// A small box is behind a large one.
TEST(AssemblyDimensions, TheirViewsHaveHiddenLinesOnRequest) {
  const Folder folder;
  folder.file("two.obj", box({0, 0, 0}, {40, 20, 10}, 1) + box({12, 30, 0}, {21, 44, 6}, 9));
  std::vector<std::string> words{"draw", "two.obj", "--dimensions", "auto", "-o", "x.svg"};
  EXPECT_EQ(epura(words, folder / "").code, 0);
  EXPECT_FALSE(contains(read_file(folder / "x.svg"), "front-hidden"));
  words.insert(words.end(), {"--hidden", "dashed"});
  EXPECT_EQ(epura(words, folder / "").code, 0);
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "front-hidden"));
}

// What of an assembly is counted, and what is not: the view from the front shows no place along y.
TEST(AssemblyDimensions, AreCountedByPlaces) {
  const Folder folder;
  folder.file("three.obj", box({0, 0, 0}, {40, 20, 10}, 1) + box({12, 5, 10}, {21, 14, 26}, 9) +
                               box({30, 7, 10}, {30.1, 7.1, 10.1}, 17));
  for (const auto& [views, count] : {std::pair("front,top,left", "3 of 3"), std::pair("front", "2 of 3")}) {
    const Outcome run = epura({"lint", "three.obj", "--views", views, "--dimensions", "auto"}, folder / "");
    EXPECT_TRUE(contains(run.out, std::string(count) + " places of parts, the faces of parts are not counted"))
        << run.out;
    EXPECT_TRUE(contains(run.out, "where parts are that are smaller than a hundredth of the assembly: 1")) << run.out;
  }
}

// An upright pin of 48 sides, as a closed body.
std::string pin(const Vec3& foot, double radius, double height, int first) {
  constexpr int sides = 48;
  std::string text, bottom = "f", top = "f";
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    text += "v " + format_number(foot.x + radius * std::cos(angle)) + " " +
            format_number(foot.y + radius * std::sin(angle)) + " " + format_number(foot.z + (i < sides ? 0 : height)) +
            "\n";
  }
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    text += "f";
    for (const int corner : {i, next, sides + next, sides + i}) text += " " + std::to_string(first + corner);
    text += "\n";
    bottom += " " + std::to_string(first + sides - 1 - i);
    top += " " + std::to_string(first + sides + i);
  }
  return text + bottom + "\n" + top + "\n";
}

// Round parts are where their axes are: two pins, of which one is on the other, have one place.
TEST(AssemblyDimensions, RoundPartsHaveThePlacesOfTheirAxes) {
  const Folder folder;
  folder.file("pins.obj", box({0, 0, 0}, {40, 20, 10}, 1) + pin({13, 8, 10}, 4, 5, 9) + pin({13, 8, 15}, 2.5, 9, 105));
  const Outcome run =
      epura({"draw", "pins.obj", "--views", "front,top,left", "--dimensions", "auto", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted({"40", "20", "24", "13", "8", "10", "15"}));
}

// As many places as both sides of a view have room for are given; of more, nobody finds the part that a number is of.
TEST(AssemblyDimensions, ManyPartsHaveNoPlaces) {
  for (const int count : {24, 25}) {
    const Folder folder;
    std::string parts = box({0, 0, 0}, {500, 20, 10}, 1);
    for (int i = 0; i < count; ++i) {
      const double at = 10 + 14.5 * i + 0.1 * i * i;
      parts += box({at, 5, 10}, {at + 6, 14, 26}, 9 + 8 * i);
    }
    folder.file("many.obj", parts);
    std::vector<std::string> words{"lint",         "many.obj", "--views", "front,top,left",
                                   "--dimensions", "auto",     "--sheet", "A1"};
    const Outcome judged = epura(words, folder / "");
    words.front() = "draw";
    words.insert(words.end(), {"-o", "x.svg"});
    const Outcome drawn = epura(words, folder / "");
    const std::vector<std::string> texts = dimensions_in(read_file(folder / "x.svg"));
    const bool has_all = count == 24;
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(contains(drawn.err, "25 places of parts along x"), !has_all) << drawn.err;
    EXPECT_EQ(contains(judged.out, "25 places of parts along x"), !has_all) << judged.out;
    EXPECT_EQ(judged.code, has_all ? 0 : 1) << judged.out << judged.err;
    EXPECT_EQ(std::count(texts.begin(), texts.end(), "24.6"), has_all ? 1 : 0);
    for (const char* size : {"500", "20", "26", "5", "10"})
      EXPECT_GE(std::count(texts.begin(), texts.end(), size), 1) << size << " of " << count;
  }
}

// A bore in a plate that leans needs a view of its own, where it is one of few parts. Of many its size is left out.
TEST(AssemblyDimensions, HolesOfManyPartsAddNoViews) {
  for (const int count : {2, 25}) {
    const Folder folder;
    folder.file("plate.obj", plate({20, 20}, 1, 1, 5, stepped_hole({{4, 5}, {4, 0}})));
    std::string parts;
    for (int i = 0; i < count; ++i) {
      const double at = 30 + 9.5 * i + 0.1 * i * i;
      parts += box({at, at, at}, {at + 6, at + 5, at + 4}, 1 + 8 * i);
    }
    folder.file("boxes.obj", parts);
    folder.file("all.toml",
                "views = [\"auto\"]\nmodel = [{file = \"plate.obj\", transform = \"rotate:x,30\"}, {file = "
                "\"boxes.obj\"}]\ndimension = [{type = \"auto\"}]\n");
    const Outcome drawn = epura({"draw", "all.toml", "-o", "x.svg"}, folder / "");
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(contains(read_file(folder / "x.svg"), "auxiliary"), count == 2) << drawn.err;
  }
}

}  // namespace
}  // namespace epura::test::assembly_dimensions_test
