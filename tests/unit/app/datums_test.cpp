// SPDX-License-Identifier: Apache-2.0
// What the positions among automatic dimensions are measured from: --datum, and `from` of [[dimension]].
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"
#include "sloped_parts.hpp"

namespace epura::test::datums_test {
namespace {

/// A plate of 80 x 60 x 10 with holes ⌀8 at 20, 15; 60, 15; 20, 45 and ⌀12 at 60, 45.
class Datums : public testing::Test {
 protected:
  Datums() {
    const auto hole = [](const Vec2& centre) {
      const double radius = centre.x > 40 && centre.y > 30 ? 6 : 4;
      return stepped_hole({{radius, 10}, {radius, 0}})(centre);
    };
    folder_.file("part.obj", plate({40, 30}, 2, 2, 10, hole));
  }
  /// The texts that are drawn, of a sheet that lint finds complete.
  std::vector<std::string> texts(const Words& more) {
    Words words{"lint",    "part.obj", "--views", "front,top,left", "--dimensions", "auto",
                "--sheet", "A3",       "-o",      "x.svg"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = epura(words, folder_ / "");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    return sorted(dimensions_in(read_file(folder_ / "x.svg")));
  }
  Outcome refused(const Words& more) {
    Words words{"draw", "part.obj", "-o", "x.svg"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }

  Folder folder_;
};

/// The plate with four holes ⌀8 at 22, 18 and beyond.
std::string off_centre() {
  return plate({40, 30}, 2, 2, 10, [](const Vec2& centre) {
    const Vec2 off(centre.x + 2, centre.y + 3);
    return stepped_hole({{4, 10}, {4, 0}})(off);
  });
}

const std::vector<std::string> sizes{"80", "60", "10", "3× ⌀8", "⌀12"};

std::vector<std::string> with_sizes(std::vector<std::string> places) {
  places.insert(places.end(), sizes.begin(), sizes.end());
  return sorted(places);
}

TEST_F(Datums, AreTheLeftAndLowerEndsUnlessTheyAreChosen) {
  EXPECT_EQ(texts({}), with_sizes({"20", "60", "15", "45"}));
  EXPECT_EQ(texts({"--datum", "0,0,10"}), texts({}));
}

// All from the right and upper corner: 20 and 60 change places along x, 15 and 45 along y.
TEST_F(Datums, MayBeACorner) {
  folder_.file("part.obj", off_centre());
  const std::vector<std::string> rest{"80", "60", "10", "4× ⌀8"};
  const auto places = [&](std::vector<std::string> all) {
    all.insert(all.end(), rest.begin(), rest.end());
    return sorted(all);
  };
  EXPECT_EQ(texts({}), places({"22", "62", "18", "48"}));
  EXPECT_EQ(texts({"--datum", "80,60,10"}), places({"18", "58", "12", "42"}));
  EXPECT_EQ(texts({"--datum", "80,0,0"}), places({"18", "58", "18", "48"}));
}

// The hole has its own place, from the ends of the plate; the others are 40 and 30 from there.
TEST_F(Datums, MayBeTheAxisOfAHole) {
  const std::vector<std::string> expected = with_sizes({"60", "45", "40", "30"});
  EXPECT_EQ(texts({"--datum", "hole 4"}), expected);
  folder_.file("scene.toml",
               "views = ['front', 'top', 'left']\nmodel = [{file = 'part.obj'}]\nsheet = {size = 'A3'}\n"
               "dimension = [{type = 'auto', from = 'hole 4'}]\n");
  const Outcome run = epura({"lint", "scene.toml", "-o", "y.svg"}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(sorted(dimensions_in(read_file(folder_ / "y.svg"))), expected);
}

TEST_F(Datums, AreThereInEveryArrangement) {
  for (const char* arrangement : {"baseline", "chain"})
    EXPECT_EQ(texts({"--datum", "hole 4", "--arrangement", arrangement}), with_sizes({"60", "45", "40", "30"}))
        << arrangement;
}

// The part is turned to its own axes, and its datum with it: a point of its file.
TEST_F(Datums, AreTurnedWithPartsThatLieAskew) {
  const std::string straight = off_centre();
  for (const double angle : {13.0, -27.0}) {
    const Vec2 corner(cosine(angle) * 80 - sine(angle) * 60, sine(angle) * 80 + cosine(angle) * 60);
    const std::string point = format_rounded(corner.x, 5) + "," + format_rounded(corner.y, 5) + ",10";
    const auto lint = [&](const std::string& obj, const std::string& from) {
      folder_.file("part.obj", obj);
      const Outcome run =
          epura({"lint", "part.obj", "--dimensions", "auto", "--datum", from, "-o", "x.svg"}, folder_ / "");
      EXPECT_EQ(run.code, 0) << run.out << run.err;
      EXPECT_EQ(contains(run.err, "lies askew"), obj != straight) << run.err;
      return sorted(dimensions_in(read_file(folder_ / "x.svg")));
    };
    EXPECT_EQ(lint(turned_about_z(straight, angle), point), lint(straight, "80,60,10"));
    EXPECT_NE(lint(straight, "80,60,10"), lint(straight, "0,0,0"));
    lint(turned_about_z(straight, angle), "hole 4");
  }
}

// In coordinates of the file, whatever its unit and the axis that is upright in it.
TEST_F(Datums, ArePointsOfTheFile) {
  for (const Words& as : {Words{"--unit", "in"}, Words{"--up", "y"}}) {
    Words words{"lint", "part.obj", "--dimensions", "auto", "--datum", "80,60,10", "-o", "x.svg"};
    words.insert(words.end(), as.begin(), as.end());
    const Outcome run = epura(words, folder_ / "");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
  EXPECT_EQ(refused({"--dimensions", "auto", "--unit", "in", "--datum", "2032,1524,254"}).code, 2);
}

// Where its sides would meet.
TEST_F(Datums, MayBeACornerThatIsRoundedOff) {
  const Loop corners{{0, 0}, {60, 0}, {60, 40}, {0, 40}};
  folder_.file("part.obj", block(rounded(corners, {5, 5, 5, 5}), 8));
  const Outcome run =
      epura({"draw", "part.obj", "--dimensions", "auto", "--datum", "60,0,40", "-o", "x.svg"}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(Datums, NameTheirFaults) {
  // Inside the plate; beside it, in one or two of its planes.
  for (const char* point : {"37,22,3", "90,70,10", "80,70,3", "-5,60,10"}) {
    const Outcome nowhere = refused({"--dimensions", "auto", "--datum", point});
    EXPECT_EQ(nowhere.code, 2) << point;
    EXPECT_TRUE(contains(nowhere.err, "--datum: " + std::string(point) + " is not on part")) << nowhere.err;
    EXPECT_TRUE(contains(nowhere.err, "the nearest vertex is ")) << nowhere.err;
  }
  EXPECT_TRUE(contains(refused({"--dimensions", "auto", "--datum", "-5,60,10"}).err, "the nearest vertex is 0,60,10"));
  folder_.file("scene.toml",
               "model = [{file = 'part.obj'}]\ndimension = [{type = 'auto', from = {point = [90, 70, 10]}}]\n");
  const Outcome scene = epura({"draw", "scene.toml", "-o", "y.svg"}, folder_ / "");
  EXPECT_EQ(scene.code, 2);
  EXPECT_TRUE(contains(scene.err, "90,70,10 is not on part")) << scene.err;
  const Outcome unknown = refused({"--dimensions", "auto", "--datum", "hole 9"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(contains(unknown.err, "has no hole 9")) << unknown.err;
  const Outcome alone = refused({"--dimensions", "overall", "--datum", "0,0,0"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_TRUE(contains(alone.err, "needs automatic dimensions")) << alone.err;
  EXPECT_EQ(refused({"--dimensions", "auto", "--datum", "corner"}).code, 2);
}

}  // namespace
}  // namespace epura::test::datums_test
