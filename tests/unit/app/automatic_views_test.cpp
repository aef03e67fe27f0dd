// SPDX-License-Identifier: Apache-2.0
// --views auto: front, top, left, and the views without which requirements and sizes are not shown.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "grooved_parts.hpp"
#include "program.hpp"

namespace epura::test::automatic_views_test {
namespace {

using Corner = std::array<double, 3>;

class AutomaticViews : public testing::Test {
 protected:
  // A block of 60 x 40 x 30 with a pocket from below, 10 x 10 and 20 deep, turned about x by an angle with this sine
  // and cosine.
  AutomaticViews(double sine, double cosine) : sine_(sine), cosine_(cosine) {
    std::string text;
    const auto ring = [&](double z, double from, double to_x, double to_y) {
      for (const Corner& corner :
           {Corner{from, from, z}, Corner{to_x, from, z}, Corner{to_x, to_y, z}, Corner{from, to_y, z}})
        text += corner_of(corner);
    };
    ring(0, 0, 60, 40);    // 1 to 4: below
    ring(30, 0, 60, 40);   // 5 to 8: above
    ring(0, 15, 25, 25);   // 9 to 12: the mouth of the pocket
    ring(20, 15, 25, 25);  // 13 to 16: its floor
    text += "f 5 6 7 8\nf 16 15 14 13\n";
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      text += face({1 + i, 1 + j, 5 + j, 5 + i}) + face({9 + j, 9 + i, 13 + i, 13 + j}) +
              face({1 + j, 1 + i, 9 + i, 9 + j});
    }
    folder_.file("block.obj", text);
  }
  AutomaticViews() : AutomaticViews(0, 1) {}

  Outcome run(const std::string& command, const std::string& views, const std::vector<std::string>& more = {}) {
    folder_.file("a.toml",
                 "views = [" + views + "]\nmodel = {file = \"block.obj\"}\nsheet = {size = \"A3\"}\n" + requirement_);
    std::vector<std::string> words{command, "a.toml", "-o", "a.svg", "-o", "a.json"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }
  void require_flat(const std::string& face) {
    requirement_ += "[[requirement]]\ntype = \"flatness\"\nfeature = \"face " + face + "\"\nzone = \"0.1\"\n";
  }
  // The number of the face with the middle of the floor.
  std::string floor() {
    epura({"info", "block.obj", "--json", "i.json"}, folder_ / "");
    const Json model = JsonReader(read_file(folder_ / "i.json")).read()["models"].items.at(0);
    const Corner middle = turned({20, 20, 20});
    for (const Json& one : model["part_faces"].items) {
      double off = 0;
      for (std::size_t k = 0; k < 3; ++k) off += std::abs(one["middle"].items[k].number() - middle[k]);
      if (off < 1e-6) return one["number"].text;
    }
    return "none";
  }
  [[nodiscard]] std::string views() const {
    std::string names;
    const Json drawing = JsonReader(read_file(folder_ / "a.json")).read();
    for (const Json& view : drawing["views"].items) names += (names.empty() ? "" : " ") + view["name"].text;
    return names;
  }
  [[nodiscard]] Json row() const {
    return JsonReader(read_file(folder_ / "a.json")).read()["report"]["requirements"].items.at(0);
  }

  Folder folder_;

 private:
  [[nodiscard]] Corner turned(const Corner& p) const {
    return {p[0], cosine_ * p[1] - sine_ * p[2], sine_ * p[1] + cosine_ * p[2]};
  }
  [[nodiscard]] std::string corner_of(const Corner& p) const {
    std::string text = "v";
    for (const double x : turned(p)) text += " " + std::to_string(x);
    return text + "\n";
  }
  static std::string face(const std::array<int, 4>& corners) {
    std::string text = "f";
    for (const int corner : corners) text += " " + std::to_string(corner);
    return text + "\n";
  }

  double sine_, cosine_;
  std::string requirement_{};
};

TEST_F(AutomaticViews, AreThreeWhereNothingIsLacking) {
  require_flat("1");
  ASSERT_EQ(run("draw", "\"auto\"").code, 0);
  EXPECT_EQ(views(), "front top left");
}

TEST_F(AutomaticViews, WhatNoViewShowsIsProposedAndDrawnOnRequest) {
  require_flat(floor());
  const Outcome three = run("draw", "\"front\", \"top\", \"left\"");
  EXPECT_EQ(three.code, 1);
  EXPECT_TRUE(contains(three.err, "add the view 'bottom'")) << three.err;
  const Outcome drawn = run("draw", "\"auto\"");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(views(), "front top left bottom");
  EXPECT_EQ(row()["view"].text, "bottom");
  EXPECT_EQ(run("lint", "\"front\", \"top\", \"left\"", {"--json", "l.json"}).code, 1);
  const Json found = JsonReader(read_file(folder_ / "l.json")).read();
  ASSERT_EQ(found["views_to_add"].items.size(), 1U);
  EXPECT_EQ(found["views_to_add"].items[0].text, "bottom");
}

TEST_F(AutomaticViews, ThatAreAddedHaveTheOptionsOfTheOthers) {
  require_flat(floor());
  for (const char* style : {"dashed", "none"}) {
    const Outcome drawn = run("draw", "\"auto\"", {"--hidden", style});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(views(), "front top left bottom");
    EXPECT_EQ(contains(read_file(folder_ / "a.svg"), "bottom-hidden"), std::string(style) == "dashed");
  }
}

// The views of an older version are those of the new one.
TEST_F(AutomaticViews, ARevisionHasTheViewsOfTheNewVersion) {
  require_flat(floor());
  ASSERT_EQ(run("draw", "\"auto\"").code, 0);
  std::filesystem::copy_file(folder_ / "a.toml", folder_ / "old.toml");
  const Outcome drawn = run("draw", "\"auto\"", {"--revise", "old.toml"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "nothing differs")) << drawn.err;
  EXPECT_EQ(views(), "front top left bottom");
}

TEST_F(AutomaticViews, AreTheDefaultOfAutomaticDimensionsAndRequirements) {
  const auto views_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"draw", "block.obj", "-o", "a.json"};
    words.insert(words.end(), more.begin(), more.end());
    epura(words, folder_ / "");
    return views();
  };
  EXPECT_EQ(views_with({"--dimensions", "auto"}).substr(0, 14), "front top left");
  EXPECT_EQ(views_with({"--dimensions", "hole-table"}).substr(0, 14), "front top left");
  EXPECT_EQ(views_with({"--dimensions", "auto", "--projection", "top"}), "top");
  EXPECT_EQ(views_with({"--pmi", "all"}).substr(0, 14), "front top left");
  EXPECT_EQ(views_with({"--pmi", "none"}), "isometric");
  EXPECT_EQ(views_with({"--dimensions", "overall"}), "isometric");
}

// A note about a bore from below stands where the bore is seen.
TEST_F(AutomaticViews, LookIntoBores) {
  folder_.file("bored.obj", bosses_over_bores().front().obj);
  const Outcome drawn =
      epura({"draw", "bored.obj", "--dimensions", "auto", "-o", "a.json", "-o", "a.svg"}, folder_ / "");
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(views(), "front top left bottom");
  const std::string svg = read_file(folder_ / "a.svg");
  const std::size_t note = svg.find("⌀40"), bottom = svg.find("inkscape:label=\"bottom\"");
  ASSERT_NE(note, std::string::npos);
  ASSERT_NE(bottom, std::string::npos);
  EXPECT_GT(note, bottom);
}

// Of a disc that the flange hides below, not even a bore on its axis shows the size.
TEST_F(AutomaticViews, LeaveOutWhatAnAxonometricViewHides) {
  const Outcome drawn = epura({"draw", EPURA_TEST_SAMPLES "/models/flange.obj", "--projection", "isometric",
                               "--dimensions", "auto", "-o", "a.svg"},
                              folder_ / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "left out: '⌀138'")) << drawn.err;
}

// A template has a size of its own.
TEST_F(AutomaticViews, AreOnThePaperOfATemplate) {
  const Outcome drawn = epura({"draw", "block.obj", "--dimensions", "auto", "--template",
                               EPURA_TEST_SAMPLES "/frames/frame.svg", "-o", "a.json"},
                              folder_ / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  const Json drawing = JsonReader(read_file(folder_ / "a.json")).read();
  EXPECT_EQ(drawing["sheet"]["size"].items.at(0).number(), 420);
}

class SkewViews : public AutomaticViews {
 protected:
  SkewViews() : AutomaticViews(0.6, 0.8) {}
};

TEST_F(SkewViews, LookAtSkewFaces) {
  require_flat(floor());
  const Outcome three = run("draw", "\"front\", \"top\", \"left\"");
  EXPECT_EQ(three.code, 1);
  EXPECT_TRUE(contains(three.err, "add the view 'auxiliary:direction=0,0.6,-0.8'")) << three.err;
  const Outcome drawn = run("draw", "\"auto\"");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(views(), "front top left auxiliary");
  EXPECT_EQ(row()["view"].text, "auxiliary");
}

}  // namespace
}  // namespace epura::test::automatic_views_test
