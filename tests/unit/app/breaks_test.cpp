// SPDX-License-Identifier: Apache-2.0
// Interrupted, partial and half views: what remains of the whole view, and where.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_scenes.hpp"
#include "errors.hpp"

namespace epura::test::breaks_test {
namespace {

class Breaks : public DrawnScenes {
 protected:
  Json view(const std::string& scene, const std::vector<std::string>& options = {"--join-within", "0"}) {
    const Outcome run = draw(scene, options);
    EXPECT_EQ(run.code, 0) << run.err;
    return drawing()["views"].items.at(0);
  }
};

std::string scene_of(const std::string& model, const std::string& view) {
  return "[[model]]\nfile = '" + sample(model) +
         "'\n[sheet]\nscale = '1:1'\nsize = 'A3'\n[[view]]\nprojection = " + view;
}

Vec2 point_of(const Json& pair) { return {pair.items[0].number(), pair.items[1].number()}; }

Vec2 on_page(const Json& view, const Vec3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = view["world_to_page"].items;
    return m[4 * i].number() * p.x + m[4 * i + 1].number() * p.y + m[4 * i + 2].number() * p.z + m[4 * i + 3].number();
  };
  return Vec2(row(0), row(1)) / row(3);
}

bool is_broken(const Json& view) { return contains(view.keys(), "breaks"); }

/// Lengths of the hidden and the visible lines between two places on an axis of the page.
std::array<double, 2> lengths(const Json& view, int axis, double min, double max) {
  std::array<double, 2> sums{};
  for (const Json& segment : view["segments"].items) {
    const Vec2 p = point_of(segment["from"]), q = point_of(segment["to"]);
    const double a = std::min(p[axis], q[axis]), b = std::max(p[axis], q[axis]);
    const double part = b > a ? std::max(0.0, std::min(b, max) - std::max(a, min)) / (b - a) : a >= min && a <= max;
    sums[segment["visible"].type == 't' ? 1 : 0] += part * glm::distance(p, q);
  }
  return sums;
}

struct Case {
  const char *model, *projection, *axis;
  int page_axis;
  double from, to;
  Vec3 at_from, at_to;  // points of the world on the planes
};

// At 1:1, the parts have the lines of the whole view, and what is left out is gone but for the gap of 6 mm.
TEST_F(Breaks, KeepTheLinesOnBothSidesAndMoveThemTogether) {
  const std::array cases{Case{"shaft.obj", "'front'", "x", 0, 70.25, 110.5, {70.25, 0, 0}, {110.5, 0, 0}},
                         Case{"bracket.obj", "'front'", "x", 0, 20.5, 60, {20.5, 0, 0}, {60, 0, 0}},
                         Case{"bracket.obj", "'left'", "z", 1, 15, 55.5, {0, 0, 15}, {0, 0, 55.5}},
                         Case{"bracket.obj", "'back'", "x", 0, 20.5, 60, {60, 0, 0}, {20.5, 0, 0}},
                         Case{"flange.obj", "'top'", "y", 1, -33.3, 21, {0, -33.3, 0}, {0, 21, 0}}};
  for (const Case& one : cases) {
    const std::string scene = scene_of(one.model, std::string(one.projection) + "\nhidden = 'dashed'\n");
    const Json whole = view(scene);
    const Json broken =
        view(scene + "break = '" + one.axis + ":" + format_number(one.from) + ":" + format_number(one.to) + "'\n");
    const int axis = one.page_axis;
    const auto places = [&](const Json& drawn) {
      return std::array{on_page(drawn, one.at_from)[axis], on_page(drawn, one.at_to)[axis]};
    };
    const auto [from, to] = places(whole);
    const auto [low, high] = places(broken);
    const Json& part = broken["breaks"]["parts"].items.at(0);
    EXPECT_EQ(part["along"].text, axis == 0 ? "x" : "y");
    EXPECT_NEAR(part["from"].number(), low, 1e-9);
    EXPECT_NEAR(part["to"].number(), high, 1e-9);
    EXPECT_EQ(broken["breaks"]["gap"].number(), 6);
    const double tiny = 1e-6;
    const auto before = lengths(whole, axis, -1e9, from + tiny), after = lengths(whole, axis, to - tiny, 1e9);
    const auto left = lengths(broken, axis, -1e9, low + tiny), right = lengths(broken, axis, low + 6 - tiny, 1e9);
    for (const std::size_t visible : {0U, 1U}) {
      EXPECT_NEAR(left[visible], before[visible], 1e-4) << one.model << one.projection;
      EXPECT_NEAR(right[visible], after[visible], 1e-4) << one.model << one.projection;
    }
    EXPECT_GT(left[1] * right[1], 0);
    const auto between = lengths(broken, axis, low + tiny, low + 6 - tiny);
    EXPECT_EQ(between[0] + between[1], 0);
  }
}

// The parameters of a line still give its place on the edge of the model.
// Both sides have the same waves, so lines along the axis lose what is between the places, no more and no less.
TEST_F(Breaks, MayEndAtFreehandLines) {
  const auto lengths_by_height = [](const Json& view) {
    std::map<double, double> lengths;
    const double middle = on_page(view, {0, 0, 0}).y;
    for (const Json& segment : view["segments"].items) {
      const Vec2 p = point_of(segment["from"]), q = point_of(segment["to"]);
      if (segment["visible"].type == 't' && std::abs(p.y - q.y) < 1e-9)
        lengths[std::round((p.y - middle) * 1e6) / 1e6] += glm::distance(p, q);
    }
    return lengths;
  };
  const std::string scene = scene_of("shaft.obj", "'front'\nbreak_line = 'freehand'\nhidden = 'none'\n");
  const auto whole = lengths_by_height(view(scene)), broken = lengths_by_height(view(scene + "break = 'x:80:100'\n"));
  ASSERT_EQ(whole.size(), broken.size());
  int shorter = 0;
  for (const auto& [height, length] : whole) {
    const double lost = length - broken.at(height);
    EXPECT_TRUE(std::abs(lost) < 1e-6 || std::abs(lost - 20) < 1e-6) << height << ": " << lost;
    shorter += lost > 1 ? 1 : 0;
  }
  EXPECT_GE(shorter, 2);
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "-limit\" inkscape:groupmode"));
  EXPECT_TRUE(
      contains(error(scene_of("shaft.obj", "'front'\nbreak = ['x:80:100', 'z:0:5']\nbreak_line = 'freehand'\n")),
               "view 'front' is broken in two directions, where freehand lines would meet"));
}

TEST_F(Breaks, KeepTheParametersOfTheirLines) {
  const Json broken = view("[[section]]\nname = 'A'\npoint = [40, 0, 0]\nnormal = [-1, 0, 0]\n" +
                           scene_of("bracket.obj", "'left'\nsection = 'A'\nbreak = 'z:15:55'\n"));
  const double low = on_page(broken, {0, 0, 15}).y;
  int cut = 0;
  for (const Json& segment : broken["segments"].items) {
    if (segment["edge"].type != 'n') continue;
    for (const std::size_t end : {0U, 1U}) {
      const auto& p = segment["world"].items[end].items;
      Vec2 page = on_page(broken, {p[0].number(), p[1].number(), p[2].number()});
      EXPECT_TRUE(p[2].number() <= 15 + 1e-9 || p[2].number() >= 55 - 1e-9);
      if (p[2].number() > 30) page.y += 6 - 40;
      EXPECT_LT(glm::distance(page, point_of(segment[end == 0 ? "from" : "to"])), 1e-6);
    }
    ++cut;
  }
  EXPECT_GT(cut, 4);
  for (const Json& face : broken["cut_faces"].items)
    for (const Json& ring : face["rings"].items)
      for (const Json& p : ring.items) {
        const double y = point_of(p).y;
        EXPECT_TRUE(y <= low + 1e-9 || y >= low + 6 - 1e-9);
      }
  EXPECT_GE(broken["cut_faces"].items.size(), 2U);
}

TEST_F(Breaks, AreFoundInStretchesOfConstantSection) {
  std::string box =
      "v 0 0 0\nv 100 0 0\nv 100 10 0\nv 0 10 0\nv 0 0 10\nv 100 0 10\nv 100 10 10\nv 0 10 10\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const std::string bar = folder.file("bar.obj", box);
  const auto draw_bar = [&](const std::string& views, const std::string& breaks) {
    const Outcome run = epura({"draw", bar, "--views", views, "--sheet", "A3", "--scale", "1:1", "--break", breaks,
                               "-o", "x.json", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
  };
  draw_bar("front,left,isometric", "auto");
  const Json json = drawing();
  const Json& front = json["views"].items[0];
  const Json& part = front["breaks"]["parts"].items.at(0);
  // As much as the bar is wide remains on either side.
  EXPECT_NEAR(part["to"].number() - part["from"].number(), 80, 1e-9);
  EXPECT_NEAR(part["from"].number(), on_page(front, {10, 0, 0}).x, 1e-9);
  for (const std::size_t i : {1U, 2U}) EXPECT_FALSE(is_broken(json["views"].items[i]));
  // A given place breaks the views that show it.
  draw_bar("front,left,isometric", "x:20:30");
  EXPECT_TRUE(is_broken(drawing()["views"].items[0]));
  EXPECT_FALSE(is_broken(drawing()["views"].items[1]));
}

TEST_F(Breaks, HaveBreakLinesAndTrueDimensions) {
  const Outcome run = draw(scene_of("shaft.obj", "'front'\nbreak = 'x:70:110'\n") +
                               "[[dimension]]\ntype = 'overall'\n[[dimension]]\ntype = 'linear'\ndirection = "
                               "'horizontal'\nfrom = {point = [10, 0, 0]}\nto = {point = [150, 0, 0]}\n",
                           {"--svg-text", "text", "--centre-lines", "-o", "x.dxf"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, ">165<"));
  EXPECT_TRUE(contains(svg, ">140<"));
  EXPECT_TRUE(contains(svg, "-limit\" inkscape:groupmode"));
  EXPECT_TRUE(contains(read_file(folder / "x.dxf"), "front-limit"));
  EXPECT_TRUE(contains(error(scene_of("shaft.obj", "'front'\nbreak = 'x:70:110'\n") +
                             "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\nfrom = {point = [10, 0, 0]}\n"
                             "to = {point = [90, 0, 0]}\n"),
                       "the view 'front' leaves out the part that it measures"));
}

TEST_F(Breaks, OfHalfViewsEndAtTheLineOfSymmetry) {
  const std::string scene = scene_of("flange.obj", "'top'\nhidden = 'dashed'\n");
  const Json whole = view(scene);
  const double middle = on_page(whole, {0, 0, 0}).x;
  for (const auto& [half, side] : {std::pair("left", -1.0), std::pair("right", 1.0)}) {
    const Json drawn = view(scene + "half = '" + half + "'\n");
    const double mirror = on_page(drawn, {0, 0, 0}).x;
    const auto expected = side < 0 ? lengths(whole, 0, -1e9, middle) : lengths(whole, 0, middle, 1e9);
    const auto found = lengths(drawn, 0, -1e9, 1e9);
    for (const std::size_t visible : {0U, 1U}) EXPECT_NEAR(found[visible], expected[visible], 1e-4);
    for (const Json& segment : drawn["segments"].items)
      for (const char* end : {"from", "to"}) EXPECT_GE(side * (point_of(segment[end]).x - mirror), -1e-9);
    EXPECT_EQ(drawn["breaks"]["parts"].items.at(0)["symmetric"].type, 't');
  }
  const Json quarter = view(scene + "half = 'top-left'\n");
  EXPECT_EQ(quarter["breaks"]["parts"].items.size(), 2U);
  for (const Json& segment : quarter["segments"].items)
    EXPECT_LE(point_of(segment["from"]).x, on_page(quarter, {0, 0, 0}).x + 1e-9);
}

TEST_F(Breaks, OfHalfViewsHaveWholeDimensions) {
  const Outcome run = draw(scene_of("flange.obj", "'front'\nhalf = 'left'\n") + "[[dimension]]\ntype = 'auto'\n",
                           {"--svg-text", "text"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "200<"));
  EXPECT_FALSE(contains(run.err, "symmetric"));
}

TEST_F(Breaks, OfWhatIsNotSymmetricAreReported) {
  const Outcome run = draw(scene_of("bracket.obj", "'left'\nhalf = 'left'\n"));
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "view 'left' is not symmetric: what it leaves out differs in")) << run.err;
  EXPECT_EQ(draw(scene_of("bracket.obj", "'front'\n")).code, 0);
  EXPECT_EQ(epura({"draw", sample("flange.obj"), "--views", "front,top:half=left", "-o", "y.svg"}, folder / "").code,
            0);
}

TEST_F(Breaks, ThatMakeNoSenseAreRefused) {
  const auto expect = [&](const std::string& view, const std::string& what) {
    const std::string err = error(scene_of("shaft.obj", view));
    EXPECT_TRUE(contains(err, what)) << err;
  };
  expect("'isometric'\nbreak = 'x:10:20'\n", "view 'isometric' is pictorial, and only orthographic views are broken");
  expect("'two-point'\nhalf = 'left'\n", "is pictorial");
  expect("'front'\nbreak = 'y:10:20'\n", "8:9: the view shows the y axis neither horizontally nor vertically");
  expect("'front'\nbreak = 'x:300:400'\n",
         "the break leaves nothing out\n  hint: the models extend from 0 to 165 along x");
  expect("'front'\nbreak = 'x:-10:400'\n", "the break leaves everything out");
  expect("'front'\nbreak = 'x::'\n", "'x::' leaves everything out");
  expect("'front'\nbreak = 'x:20:10'\n", "'x:20:10' leaves nothing out: the second place is not beyond the first");
  expect("'front'\nbreak = '20:10'\n", "'20:10' is not a break");
  expect("'front'\nbreak = 'x:a:10'\n", "'a' is not a number");
  expect("'front'\nhalf = 'lft'\n", "unknown value 'lft'\n  hint: did you mean 'left'?");
}

TEST_F(Breaks, ExplainWhatTheyLeaveOut) {
  // An edge of the bar as a whole, and one that is left out.
  folder.file("bar.obj",
              "v 0 0 0\nv 100 0 0\nv 100 10 0\nv 0 10 0\nv 0 0 10\nv 100 0 10\nv 100 10 10\nv 0 10 10\n"
              "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const auto why = [&](const std::string& breaks) {
    const Outcome run = epura(
        {"draw", "bar.obj", "--projection", "front", "--break", breaks, "-o", "x.svg", "--why", "4-5", "--why", "1-5"},
        folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  EXPECT_FALSE(contains(why("x:20:60"), "no ink")) << why("x:20:60");
  EXPECT_TRUE(contains(why("x:60:"), "no ink: left out by a break"));
}

}  // namespace
}  // namespace epura::test::breaks_test
