// SPDX-License-Identifier: Apache-2.0
// Auxiliary views beside their parents: folded about a line perpendicular to the direction of sight.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "../output/json_reader.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::arrow_views_test {
namespace {

class ArrowViews : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(const std::string& views, std::vector<std::string> options = {}) {
    const std::string scene = "[[model]]\nfile = '" + sample("bracket.obj") + "'\n" + views;
    options.insert(options.begin(), {"draw", "--allow-outside", folder.file("scene.toml", scene), "-o", "x.json", "-o",
                                     "x.svg", "--svg-text", "text"});
    return epura(options, folder / "");
  }
  Json drawing() const { return JsonReader(read_file(folder / "x.json")).read(); }
};

Vec2 image(const Json& view, const Vec4& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = view["world_to_page"].items;
    return m[4 * i].number() * p.x + m[4 * i + 1].number() * p.y + m[4 * i + 2].number() * p.z +
           m[4 * i + 3].number() * p.w;
  };
  return {row(0), row(1)};
}

// Lines of the world perpendicular to the sight and in the plane of the parent have the same image in both views, and
// the middle of the models lies on the arrow's line in both.
TEST_F(ArrowViews, AreFoldedAndAligned) {
  struct Case {
    const char *from, *parent, *angle;
    Vec3 direction, kept;
  };
  const std::array cases{Case{"[1, 0, 1]", "front", "--third-angle", {1, 0, 1}, {1, 0, -1}},
                         Case{"[1, 0, 1]", "front", "--first-angle", {1, 0, 1}, {1, 0, -1}},
                         Case{"[0, -1, 2]", "left", "--third-angle", {0, -1, 2}, {0, 2, 1}},
                         Case{"[0, 0, 1]", "front", "--first-angle", {0, 0, 1}, {1, 0, 0}}};
  for (const Case& one : cases) {
    const Outcome run = draw(std::string("[sheet]\nsize = 'A1'\nscale = '1:1'\n[[view]]\nprojection = '") + one.parent +
                                 "'\n[[view]]\nfrom = " + one.from + "\nof = '" + one.parent + "'\n",
                             {one.angle});
    ASSERT_EQ(run.code, 0) << run.err;
    const Json json = drawing();
    const Json &parent = json["views"].items[0], &child = json["views"].items[1];
    EXPECT_LT(glm::distance(image(parent, Vec4(one.kept, 0)), image(child, Vec4(one.kept, 0))), 1e-9);
    EXPECT_LT(glm::length(image(child, Vec4(one.direction, 0))), 1e-9);
    const Vec4 middle(40, 35, 37.5, 1);
    const Vec2 apart = image(child, middle) - image(parent, middle);
    const Vec2 towards = image(parent, Vec4(one.direction, 0));
    EXPECT_NEAR(cross(apart, towards), 0, 1e-6) << one.from;
    const double side = std::string(one.angle) == "--third-angle" ? 1 : -1;
    EXPECT_GT(side * glm::dot(apart, towards), 0) << one.from;
    const std::string svg = read_file(folder / "x.svg");
    EXPECT_TRUE(contains(svg, std::string(one.parent) + "-arrows\""));
    EXPECT_TRUE(contains(svg, ">A<"));
  }
}

TEST_F(ArrowViews, HaveTheNextFreeLetter) {
  const Outcome run = draw(
      "[[section]]\nname = 'A'\npoint = [0, 30, 0]\n[[view]]\nprojection = 'front'\n[[view]]\n"
      "projection = 'front'\nsection = 'A'\n[[view]]\nfrom = [1, 0, 1]\nof = 'front'\n[[view]]\n"
      "from = [-1, 0, 1]\nof = 'front'\nlabel = 'E'\n");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, "text-arrow\""));
  EXPECT_TRUE(contains(svg, ">B<"));
  EXPECT_TRUE(contains(svg, ">E<"));
}

TEST_F(ArrowViews, ThatMakeNoSenseAreRefused) {
  const auto expect = [&](const std::string& view, const std::string& what) {
    const Outcome run = draw("[[view]]\nprojection = 'front'\n[[view]]\n" + view);
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, what)) << run.err;
  };
  expect("from = [0, 1, 1]\n", "'from' needs the view beside which this one is");
  expect("of = 'front'\n", "'of' needs the direction");
  expect("of = 'frnt'\nfrom = [1, 0, 1]\n", "there is no view 'frnt'");
  expect("of = 'front'\nfrom = [1, 1, 0]\n", "view 'front' does not show the direction 1,1,0 in true length");
  expect("of = 'front'\nfrom = [1, 0, 1]\nprojection = 'top'\n", "has no projection and no detail");
}

// An inclined section beside its parent has the letters of its plane, whose line says where it is seen from.
TEST_F(ArrowViews, OfSectionsHaveTheLettersOfTheirPlanes) {
  const std::string sheet = "[sheet]\nsize = 'A1'\nscale = '1:1'\nframe = 'none'\n";
  const std::string section = "[[section]]\nname = 'D'\npoint = [40, 0, 40]\nnormal = [1, 0, 1]\n";
  const std::string views = "[[view]]\nprojection = 'front'\n[[view]]\nfrom = [1, 0, 1]\nof = 'front'\nsection = 'D'\n";
  const Outcome run = draw(sheet + section + views);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, ">D-D<"));
  EXPECT_TRUE(contains(svg, "front-cutting-plane\""));
  EXPECT_FALSE(contains(svg, "front-arrows\""));
  EXPECT_FALSE(contains(svg, ">A<"));
}

// A plane that no whole view sees edge-on is marked in a section that does.
TEST_F(ArrowViews, PlanesAreMarkedInSectionsWhereNoOtherViewCan) {
  const Outcome run = draw(
      "[sheet]\nsize = 'A1'\nscale = '1:1'\n[[section]]\nname = 'A'\npoint = [0, 30, 0]\n[[section]]\nname = 'B'\n"
      "point = [0, 0, 20]\nnormal = [0, 0, 1]\n[[view]]\nprojection = 'top'\n[[view]]\nprojection = 'front'\n"
      "section = 'A'\n[[view]]\nprojection = 'top'\nname = 'BB'\nsection = 'B'\n");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, "top-cutting-plane\"")) << "A, in the view from above";
  EXPECT_TRUE(contains(svg, "front-cutting-plane\"")) << "B, in section A-A";
}

}  // namespace
}  // namespace epura::test::arrow_views_test
