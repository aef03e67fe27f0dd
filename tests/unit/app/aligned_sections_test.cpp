// SPDX-License-Identifier: Apache-2.0
// Aligned and revolved sections, from scene files to drawings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_scenes.hpp"
#include "errors.hpp"

namespace epura::test::aligned_sections_test {
namespace {

class AlignedSections : public DrawnScenes {
 protected:
  Json drawing(const std::string& scene, const std::vector<std::string>& options = {}) {
    const Outcome run = draw(scene, options);
    EXPECT_EQ(run.code, 0) << run.err;
    return DrawnScenes::drawing();
  }
};

std::string golden_model(const std::string& name) { return root() / "tests/golden/models" / name; }

Vec2 point_of(const Json& pair) { return {pair.items[0].number(), pair.items[1].number()}; }

Vec2 on_page(const Json& view, const Vec3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = view["world_to_page"].items;
    return m[4 * i].number() * p.x + m[4 * i + 1].number() * p.y + m[4 * i + 2].number() * p.z + m[4 * i + 3].number();
  };
  return Vec2(row(0), row(1)) / row(3);
}

double area_of(const Json& rings) {
  double sum = 0;
  for (const Json& ring : rings.items) {
    double area = 0;
    const Vec2 origin = point_of(ring.items[0]);
    for (std::size_t i = 0; i < ring.items.size(); ++i) {
      const Vec2 p = point_of(ring.items[i]) - origin, q = point_of(ring.items[(i + 1) % ring.items.size()]) - origin;
      area += cross(p, q) / 2;
    }
    sum += std::abs(area);
  }
  return sum;
}

double area_of_cut_faces(const Json& view) {
  double sum = 0;
  for (const Json& face : view["cut_faces"].items) sum += area_of(face["rings"]);
  return sum;
}

// A flange about the y axis with holes at 90, 210 and 330 degrees, seen from the front and cut through two of them.
std::string flange(const std::string& section_view, const std::string& more = "") {
  return "[[model]]\nfile = '" + golden_model("flange-three-holes.obj") +
         "'\n[sheet]\nscale = '1:1'\nsize = 'A3'\n[[section]]\nname = 'A'\nnormal = [-1, 0, 0]\naligned = true\n"
         "path = [[0, 0, 50], [0, 0, 0], [38.97114317029974, 0, -22.5]]\n" +
         more + "[[view]]\nprojection = 'front'\n[[view]]\nprojection = " + section_view;
}

// Heights over the axis of the outlines of the cut that run along the axis.
std::set<double> heights(const Json& view) {
  const double middle = on_page(view, {0, 0, 0}).y;
  std::set<double> found;
  for (const Json& segment : view["segments"].items) {
    if (segment["kind"].text != "section") continue;
    const Vec2 p = point_of(segment["from"]), q = point_of(segment["to"]);
    if (std::abs(p.y - q.y) < 1e-6) found.insert(std::round((p.y - middle) * 1e6) / 1e6);
  }
  return found;
}

// The holes are 29 from the axis with a radius of 5, the bore has one of 10, the hub 18 and the flange 40.
TEST_F(AlignedSections, ShowHolesAtTheirTrueDistances) {
  const Json view = drawing(flange("'left'\nsection = 'A'"))["views"].items.at(1);
  const std::set<double> half{10, 18, 24, 34, 40};
  std::set<double> both;
  for (const double height : half) both.insert({-height, height});
  EXPECT_EQ(heights(view), both);
  // Of each plane: 30 x 10 without the hole, and the hub, 8 x 20.
  EXPECT_NEAR(area_of_cut_faces(view), 2 * (30 * 10 - 10 * 10 + 8 * 20), 1e-9);
  for (const Json& segment : view["segments"].items) EXPECT_EQ(segment["model"].number(), 0);
  for (const Json& face : view["cut_faces"].items) EXPECT_EQ(face["model"].number(), 0);
}

// Nothing but the outlines of the cut and the edges of the file is drawn: no line on the axis.
TEST_F(AlignedSections, HaveNoLineWhereThePlanesMeet) {
  for (const char* hidden : {"none", "dashed"}) {
    const Json view =
        drawing(flange("'left'\nsection = 'A'\nhidden = '" + std::string(hidden) + "'"))["views"].items.at(1);
    const double middle = on_page(view, {0, 0, 0}).y;
    double on_axis = 0;
    for (const Json& segment : view["segments"].items) {
      const Vec2 p = point_of(segment["from"]), q = point_of(segment["to"]);
      if (std::abs(p.y - middle) < 1e-3 && std::abs(q.y - middle) < 1e-3) on_axis += glm::distance(p, q);
    }
    EXPECT_LT(on_axis, 1e-3) << hidden;
  }
}

TEST_F(AlignedSections, AreVerifiedAndExplained) {
  const Outcome run = draw(flange("'left'\nsection = 'A'\nhidden = 'dashed'"), {"--verify", "--centre-lines"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Json view = drawing(flange("'left'\nsection = 'A'"))["views"].items.at(1);
  const Vec2 lower = on_page(view, {0, 5, -40});
  const Outcome why =
      draw(flange("'left'\nsection = 'A'"), {"--why", "@" + format_number(lower.x) + "," + format_number(lower.y)});
  EXPECT_EQ(why.code, 0) << why.err;
  EXPECT_TRUE(contains(why.out + why.err, "section")) << why.out;
}

TEST_F(AlignedSections, HaveTheSameLinesWithAndWithoutShortcuts) {
  const std::string scene = flange("'left'\nsection = 'A'\nhidden = 'dashed'");
  drawing(scene);
  const std::string fast = read_file(folder / "x.svg");
  drawing(scene, {"--plan", "none"});
  EXPECT_EQ(read_file(folder / "x.svg"), fast);
}

// Points are where the section shows them: the holes stand opposite each other.
TEST_F(AlignedSections, AreDimensionedAsTheyAreShown) {
  const auto dimension = [](const std::string& type, const std::string& points) {
    return "[[dimension]]\nview = 'left'\ntype = '" + type + "'\n" + points + "\n";
  };
  const std::string points = "from = {point = [0, 0, 29]}\nto = {point = [25.1147, 0, -14.5]}\n";
  drawing(flange("'left'\nsection = 'A'", dimension("linear", "direction = 'vertical'\n" + points)));
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"58\""));
  drawing(flange("'left'\nsection = 'A'",
                 "[[note]]\nview = 'left'\ntext = 'lower hole'\nto = {point = [25.1147, 5, -14.5]}\n"));
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "lower hole"));
  EXPECT_TRUE(contains(
      error(flange(
          "'left'\nsection = 'A'",
          dimension("linear", "direction = 'vertical'\nfrom = {point = [0, 0, 29]}\nto = {point = [-29, 0, 0]}"))),
      "view 'left' shows an aligned section, which leaves this point of the models out"));
  EXPECT_TRUE(contains(error(flange("'left'\nsection = 'A'", dimension("radius", "at = [0, 128]"))),
                       "measure it in a view along its axis"));
}

// The hole of radius 5 at 330 degrees, 29 from the axis, is seen 29 below it.
TEST_F(AlignedSections, ShowDiametersWhereTheyAreTurned) {
  const Json view = drawing(flange("'left'\nsection = 'A'",
                                   "[[dimension]]\nview = 'left'\ntype = 'diameter'\nat = [0, 128]\noffset = 20\n"),
                            {"--svg-text", "text"})["views"]
                        .items.at(1);
  const std::string svg = read_file(folder / "x.svg");
  const std::size_t label = svg.rfind("<text", svg.find(">⌀10</text>"));
  ASSERT_LT(label, svg.size());
  const std::size_t y = svg.find(" y=\"", label) + 4;
  const double from_below = 297 - *parse_number(svg.substr(y, svg.find('"', y) - y));
  EXPECT_NEAR(from_below, on_page(view, {0, 5, -29}).y, 6);
}

// The sizes of the outline, and of the bore and the holes if no other view shows them. The whole flange is 80 wide and
// 30 long, the hub has a diameter of 36.
TEST_F(AlignedSections, HaveAutomaticDimensions) {
  const std::string wanted = "[[dimension]]\ntype = 'auto'\n", section = "'left'\nsection = 'A'\n";
  const auto texts = [&](const std::string& scene) {
    drawing(scene, {"--svg-text", "text"});
    std::multiset<std::string> found;
    const std::string svg = read_file(folder / "x.svg");
    for (const char* text : {"10", "20", "30", "⌀10", "3× ⌀10", "⌀20", "⌀36", "⌀58", "⌀80", "80"})
      for (std::size_t at = 0; (at = svg.find(">" + std::string(text) + "</text>", at)) != std::string::npos; ++at)
        found.insert(text);
    return found;
  };
  const std::string both = flange(section, wanted),
                    alone = both.substr(0, both.find("[[view]]")) + "[[view]]\nprojection = " + section;
  drawing(both, {"--svg-text", "text"});
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_GT(svg.find(">⌀36</text>"), svg.find("left-dimensions")) << "across its axis";
  EXPECT_LT(svg.find(">⌀20</text>"), svg.find("left-dimensions")) << "along its axis";
  EXPECT_EQ(texts(both), (std::multiset<std::string>{"10", "30", "3× ⌀10", "⌀20", "⌀36", "⌀58", "⌀80"}));
  EXPECT_EQ(texts(alone), (std::multiset<std::string>{"10", "30", "3× ⌀10", "⌀20", "⌀36", "⌀80"}));
  EXPECT_EQ(epura({"lint", "--allow-outside", folder.file("both.toml", both)}, folder / "").code, 0);
  const Outcome left = epura({"lint", "--allow-outside", folder.file("alone.toml", alone)}, folder / "");
  EXPECT_TRUE(contains(left.out, "pitch circle ⌀58, which no view shows in its true form: add the view front"))
      << left.out;
  EXPECT_FALSE(contains(left.out, "along y")) << left.out;
}

TEST_F(AlignedSections, AreRefusedWherePlanesAreNotSideBySide) {
  EXPECT_TRUE(contains(error(flange("'isometric'\nsection = 'A'")),
                       "does not show the planes of aligned section A side by side"));
}

class RevolvedSections : public AlignedSections {};

std::string beam(const std::string& revolved, const std::string& view = "'front'") {
  return "[[model]]\nfile = '" + golden_model("beam.obj") +
         "'\n[sheet]\nscale = '1:1'\nsize = 'A3'\n[[view]]\nprojection = " + view + "\n[[revolved]]\n" + revolved;
}

// The I section of a beam along x: 20 wide, 30 high, web 4, flanges 5.
TEST_F(RevolvedSections, AreTurnedIntoThePicture) {
  const std::string scene = beam("point = [60, 0, 0]\nnormal = [1, 0, 0]\n");
  const Json view = drawing(scene)["views"].items.at(0);
  EXPECT_NEAR(area_of_cut_faces(view), 280, 1e-9);
  const Vec2 middle = on_page(view, {60, 0, 0});
  Vec2 min(1e9), max(-1e9);
  for (const Json& p : view["cut_faces"].items.at(0)["rings"].items.at(0).items) {
    min = glm::min(min, point_of(p));
    max = glm::max(max, point_of(p));
  }
  EXPECT_LT(glm::distance(min, middle - Vec2(10, 15)), 1e-9);
  EXPECT_LT(glm::distance(max, middle + Vec2(10, 15)), 1e-9);
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "front-revolved"));
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "front-hatch"));
}

// All lines of the view itself stay.
TEST_F(RevolvedSections, LeaveTheViewAsItIs) {
  const std::string with = beam("point = [60, 0, 0]\nnormal = [1, 0, 0]\n");
  const auto lines = [&](const std::string& scene) {
    return drawing(scene)["views"].items.at(0)["segments"].items.size();
  };
  EXPECT_EQ(lines(with), lines(with.substr(0, with.find("[[revolved]]"))));
}

// Where the view is broken, the section is moved with the part in which it is.
TEST_F(RevolvedSections, MoveWithPartsOfInterruptedViews) {
  const std::string revolved = "point = [130, 0, 0]\nnormal = [1, 0, 0]\n";
  for (const char* line : {"zigzag", "freehand"}) {
    const Json view =
        drawing(beam(revolved, "'front'\nbreak = 'x:30:100'\nbreak_line = '" + std::string(line) + "'"))["views"]
            .items.at(0);
    const double right = on_page(view, {130, 0, 0}).x - (70 - 6);
    double min = 1e9, max = -1e9;
    for (const Json& p : view["cut_faces"].items.at(0)["rings"].items.at(0).items) {
      min = std::min(min, point_of(p).x);
      max = std::max(max, point_of(p).x);
    }
    EXPECT_NEAR(min, right - 10, 1e-9);
    EXPECT_NEAR(max, right + 10, 1e-9);
  }
  EXPECT_TRUE(contains(error(beam("point = [60, 0, 0]\nnormal = [1, 0, 0]\n", "'front'\nbreak = 'x:30:100'")),
                       "leaves the point of the revolved section out"));
}

TEST_F(RevolvedSections, ThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(contains(error(beam("point = [60, 0, 0]\nnormal = [0, 1, 0]\n")),
                       "view 'front' does not see the plane of the revolved section edge-on"));
  EXPECT_TRUE(contains(error(beam("point = [60, 8, 0]\nnormal = [1, 0, 0]\n")),
                       "there is no material at the point of the revolved section"));
  EXPECT_TRUE(contains(error(beam("point = [160.5, 0, 0]\nnormal = [1, 0, 0]\n")), "the plane cuts nothing"));
  EXPECT_TRUE(
      contains(error(beam("view = 'fron'\npoint = [60, 0, 0]\nnormal = [1, 0, 0]\n")), "there is no view 'fron'"));
  EXPECT_TRUE(contains(error(beam("point = [60, 0, 0]\nnormal = [1, 0, 0]\n", "'one-point'")), "is a perspective"));
}

}  // namespace
}  // namespace epura::test::aligned_sections_test
