// SPDX-License-Identifier: Apache-2.0
// Screw threads in drawings: where their lines are, which are hidden, what stands beside them, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::threads_test {
namespace {

/// A line of a thread in a drawing as JSON.
struct ThreadLine {
  bool visible;
  Vec2 from, to;
};

double number_after(const std::string& text, const std::string& key, std::size_t at) {
  const std::size_t begin = text.find(key, at) + key.size();
  return *parse_number(text.substr(begin, text.find_first_of(",]", begin) - begin));
}

// The segments of one kind, in order of the file.
std::vector<ThreadLine> lines_of(const std::string& json, const std::string& kind) {
  std::vector<ThreadLine> lines;
  const std::string key = "\"kind\": \"" + kind + "\"";
  for (std::size_t at = json.find(key); at != std::string::npos; at = json.find(key, at + 1)) {
    const std::size_t begin = json.rfind("{\"from\"", at);
    const std::string line = json.substr(begin, at - begin);
    const auto point = [&](const std::string& end) {
      const std::size_t place = line.find("\"" + end + "\": [");
      const double x = number_after(line, "[", place);
      return Vec2(x, number_after(line, ", ", place));
    };
    lines.push_back({contains(line, "\"visible\": true"), point("from"), point("to")});
  }
  return lines;
}

class ThreadDrawings : public testing::Test {
 protected:
  Folder folder;
  std::string plate = EPURA_TEST_GOLDEN "/models/threaded-plate.obj";
  std::string stud = EPURA_TEST_GOLDEN "/models/stud.obj";

  std::string scene(const std::string& model, const std::string& keys) {
    return folder.file("scene.toml", "[sheet]\nsize = 'A3'\nscale = '2:1'\n[[model]]\nfile = '" + model + "'\n" + keys);
  }
  std::vector<ThreadLine> drawn(const std::string& scene, const std::string& kind) {
    const Outcome run = epura({"draw", "--allow-outside", scene, "-o", "x.json"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return lines_of(read_file(folder / "x.json"), kind);
  }
  void expect_refused(const std::string& keys, const std::string& reason) {
    const Outcome run = epura(
        {"draw", "--allow-outside", scene(plate, "[[view]]\nprojection = 'top'\n" + keys), "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 2) << keys;
    EXPECT_TRUE(contains(run.err, reason)) << run.err;
  }
};

constexpr const char* m6 = "[[thread]]\nthread = 'M6'\nat = {point = [12, 10, 24]}\ndepth = 12\n";

// At a scale of 2:1: three quarters of a circle of radius 6 mm around the crests, which are the core hole of 5 mm.
TEST_F(ThreadDrawings, RootsOfAHoleSeenAlongTheAxisAreThreeQuartersOfACircle) {
  const auto lines = drawn(scene(plate, std::string("[[view]]\nprojection = 'top'\n") + m6), "thread");
  ASSERT_FALSE(lines.empty());
  double length = 0;
  for (const ThreadLine& line : lines) {
    EXPECT_TRUE(line.visible);
    length += glm::length(line.to - line.from);
  }
  EXPECT_NEAR(length, 1.5 * std::acos(-1.0) * 6, 0.01);
}

// In a section, both roots are visible lines 12 mm apart and 24 mm long, and a wide line ends the thread; from the
// front they are hidden.
TEST_F(ThreadDrawings, RootsOfAHoleSeenAcrossTheAxis) {
  const std::string section = "[[section]]\nname = 'A'\npoint = [0, 10, 0]\n";
  for (const bool is_cut : {true, false}) {
    const std::string view = "[[view]]\nprojection = 'front'\n" + std::string(is_cut ? "section = 'A'\n" : "");
    const std::string text = scene(plate, (is_cut ? section : "") + view + m6);
    double length = 0, left = 1e9, right = -1e9;
    for (const ThreadLine& line : drawn(text, "thread")) {
      EXPECT_EQ(line.visible, is_cut);
      length += glm::length(line.to - line.from);
      left = std::min(left, line.from.x);
      right = std::max(right, line.from.x);
    }
    EXPECT_NEAR(length, 2 * 24, 1e-6);
    EXPECT_NEAR(right - left, 12, 1e-6);
    double end = 0;
    for (const ThreadLine& line : drawn(text, "thread-end")) end += glm::length(line.to - line.from);
    EXPECT_NEAR(end, 12, 1e-6);
  }
}

// The roots of M12x1.25, of radius 5.323, reach into the chamfer from radius 6 to 5.1 on 0.9 mm; its 30 mm count from
// the end of the stud.
TEST_F(ThreadDrawings, RootsOfAShaftReachIntoItsChamfer) {
  const std::string text = scene(
      stud, "[[view]]\nprojection = 'front'\n[[thread]]\nthread = 'M12x1.25'\nat = {point = [0, 0, 0]}\ndepth = 30\n");
  const double root = 12 / 2.0 - 0.625 * std::sqrt(3.0) / 2 * 1.25;
  double length = 0, low = 1e9, high = -1e9;
  for (const ThreadLine& line : drawn(text, "thread")) {
    EXPECT_TRUE(line.visible);
    length += std::abs(line.to.x - line.from.x);
    low = std::min(low, line.from.y);
    high = std::max(high, line.from.y);
  }
  EXPECT_NEAR(high - low, 2 * 2 * root, 1e-6);
  EXPECT_NEAR(length, 2 * 2 * (30 - 0.9 + (6 - root)), 1e-4);
}

// Of the creases seen from the end of the stud, the circles at the ends of its chamfers, of radius 5.1 and 3.8, are
// left out, if it has threads.
TEST_F(ThreadDrawings, ChamfersOfThreadsHaveNoCirclesSeenAlongTheAxis) {
  const std::string view = "[[view]]\nprojection = 'left'\n";
  const std::string threads =
      "[[thread]]\nthread = 'M12x1.25'\nat = {point = [0, 0, 0]}\n[[thread]]\nthread = 'M10'\nat = {point = [80, 0, "
      "0]}\n";
  const auto has_radius = [&](const std::string& keys, double radius) {
    const auto lines = drawn(scene(stud, view + keys), "crease");
    double low = 1e9, high = -1e9;
    for (const ThreadLine& line : lines) {
      low = std::min(low, line.from.x);
      high = std::max(high, line.from.x);
    }
    const double middle = (low + high) / 2;
    return std::any_of(lines.begin(), lines.end(), [&](const ThreadLine& line) {
      return std::abs(std::abs(line.from.x - middle) - 2 * radius) < 1e-6;
    });
  };
  for (const double radius : {5.1, 3.8}) {
    EXPECT_TRUE(has_radius("", radius)) << radius;
    EXPECT_FALSE(has_radius(threads, radius)) << radius;
  }
  const Outcome run =
      epura({"draw", "--allow-outside", "--verify", scene(stud, view + threads), "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

// A screw M10 whose thread is a helical face, 12 mm long: at 2:1, its roots are two lines of 24 mm that are twice the
// minor diameter apart. Pictures and meshes keep the faces.
TEST_F(ThreadDrawings, HelicalFacesAreDrawnAsThreads) {
  const std::string screw = EPURA_TEST_GOLDEN "/models/helical-screw.obj";
  const auto lines = drawn(scene(screw, "[[view]]\nprojection = 'front'\n"), "thread");
  double length = 0, low = 1e9, high = -1e9;
  for (const ThreadLine& line : lines) {
    EXPECT_TRUE(line.visible);
    length += glm::length(line.to - line.from);
    low = std::min(low, line.from.x);
    high = std::max(high, line.from.x);
  }
  EXPECT_NEAR(length, 2 * 24, 1e-3);
  EXPECT_NEAR(high - low, 2 * 8.376, 1e-3);
  EXPECT_TRUE(drawn(scene(screw, "surfaces = 'mesh'\n[[view]]\nprojection = 'front'\n"), "thread").empty());
  EXPECT_TRUE(drawn(scene(screw, "[[view]]\nprojection = 'isometric'\n"), "thread").empty());
  const Outcome run = epura(
      {"lint", "--allow-outside", screw, "--views", "front,top", "--dimensions", "auto", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"M10\""));
}

/// A screw M10 of eight turns, whose roots rise to its shank of the same diameter over some turns, with so many
/// vertices around it and in a pitch.
std::string screw_with_run_out(int around, int steps, double run_out) {
  constexpr double pitch = 1.5, major = 5, depth = 0.812, length = 12;
  std::string obj, faces;
  int rings = 0;
  const auto add_ring = [&](double z, const auto& radius) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around, r = radius(angle);
      obj += "v " + format_number(r * std::cos(angle)) + " " + format_number(r * std::sin(angle)) + " " +
             format_number(z) + "\n";
      if (rings == 0) continue;
      const int low = (rings - 1) * around + 1, next = (i + 1) % around;
      faces += "f " + std::to_string(low + i) + " " + std::to_string(low + next) + " " +
               std::to_string(low + around + next) + " " + std::to_string(low + around + i) + "\n";
    }
    ++rings;
  };
  const auto always = [](double of) { return [of](double) { return of; }; };
  for (int k = 0; k <= 8 * steps; ++k) {
    const double z = pitch * k / steps, full = std::clamp((length - z) / (run_out * pitch), 0.0, 1.0);
    add_ring(z, [&](double angle) {
      return major - full * depth * (1 - std::cos(2 * std::numbers::pi * k / steps - angle)) / 2;
    });
  }
  for (const auto& [z, r] : {std::pair(22.0, major), {22.0, 8.0}, {28.0, 8.0}}) add_ring(z, always(r));
  std::string bottom, top;
  for (int i = 0; i < around; ++i) {
    bottom = " " + std::to_string(i + 1) + bottom;
    top += " " + std::to_string((rings - 1) * around + i + 1);
  }
  return obj + faces + "f" + bottom + "\nf" + top + "\n";
}

// The lines of its roots end where it has its full depth, and a wide line crosses the shank there (ISO 6410-1).
TEST_F(ThreadDrawings, EndWhereTheyRunOut) {
  for (const auto& [around, steps] : {std::pair(40, 8), {24, 8}, {16, 4}, {12, 4}})
    for (const double run_out : {1.0, 2.0}) {
      const std::string screw = folder.file("screw.obj", screw_with_run_out(around, steps, run_out));
      const std::string front = scene(screw, "[[view]]\nprojection = 'front'\n");
      const std::string what = std::to_string(around) + "/" + std::to_string(steps) + ", " + format_number(run_out);
      double length = 0;
      for (const ThreadLine& line : drawn(front, "thread")) length += glm::length(line.to - line.from);
      EXPECT_NEAR(length / 4, 12 - 1.5 * run_out, 0.15 * run_out + 1.5 / steps + 1e-6) << what;
      double end = 0;
      for (const ThreadLine& line : drawn(front, "thread-end")) end += glm::length(line.to - line.from);
      EXPECT_NEAR(end, 2 * 10, 0.1) << what;
    }
}

// Stretched by a tenth, the thread has a pitch of 1.65 mm, which M10 does not come with.
TEST_F(ThreadDrawings, HelicesOfOtherPitchesAreTold) {
  const std::string screw = read_file(EPURA_TEST_GOLDEN "/models/helical-screw.obj");
  std::string stretched;
  for (const std::string_view line : split(screw, '\n')) {
    const std::size_t last = line.rfind(' ');
    if (line.starts_with("v "))
      stretched += std::string(line.substr(0, last + 1)) + format_number(1.1 * *parse_number(line.substr(last + 1)));
    else
      stretched += line;
    stretched += '\n';
  }
  const Outcome run =
      epura({"draw", folder.file("screw.obj", stretched), "--projection", "front", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "ISO 261 has no such thread: ⌀10 with a pitch of 1.65 mm\n  hint: ")) << run.err;
}

// Words for the thread of a screw come before what its faces tell.
TEST_F(ThreadDrawings, HelicalFacesMayHaveAThreadOfTheScene) {
  const std::string screw = EPURA_TEST_GOLDEN "/models/helical-screw.obj";
  const Outcome run = epura({"draw", "--allow-outside",
                             scene(screw,
                                   "[[view]]\nprojection = 'front'\n[[thread]]\nthread = 'M10-6g'\nat = {point = "
                                   "[0, 0, 0]}\n"),
                             "-o", "x.svg"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"M10-6g\""));
}

TEST_F(ThreadDrawings, HaveADimension) {
  const std::string keys =
      "[[view]]\nprojection = 'top'\n[[thread]]\nthread = 'M6'\nat = {point = [12, 10, 24]}\ndepth = 12\nequal = "
      "true\n";
  const Outcome run = epura({"draw", "--allow-outside", scene(plate, keys), "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"4× M6 ↧12/⌀5 ↧18\""));
  const Outcome without =
      epura({"draw", "--allow-outside", scene(plate, keys + "callout = false\n"), "-o", "y.svg"}, folder / "");
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_FALSE(contains(read_file(folder / "y.svg"), "M6"));
}

// Automatic dimensions name the thread instead of the diameter, and nothing is missing.
TEST_F(ThreadDrawings, AreAmongAutomaticDimensions) {
  const std::string keys =
      "[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'left'\n[[dimension]]\ntype = 'auto'\n"
      "[[thread]]\nthread = 'M12x1.25'\nat = {point = [0, 0, 0]}\ndepth = 30\n"
      "[[thread]]\nthread = 'M10'\nat = {point = [80, 0, 0]}\n";
  const Outcome run = epura({"lint", "--allow-outside", scene(stud, keys), "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const std::string svg = read_file(folder / "x.svg");
  for (const char* text : {"M12×1.25", "M10", "30"})
    EXPECT_TRUE(contains(svg, "aria-label=\"" + std::string(text) + "\"")) << text;
  EXPECT_FALSE(contains(svg, "aria-label=\"⌀12\""));
}

TEST_F(ThreadDrawings, ThatCannotBeAreRefusedWithTheLine) {
  const auto thread = [](const std::string& size, const std::string& at, const std::string& rest = "") {
    return "[[thread]]\nthread = '" + size + "'\nat = " + at + "\n" + rest;
  };
  const std::string core = "{point = [12, 10, 24]}";
  expect_refused(thread("M6.5", core), "scene.toml:9:10: 'M6.5' is not a thread: ISO 261 has no M6.5");
  expect_refused(thread("M6.5", core), "M6 and M7 are the nearest");
  expect_refused(thread("M6", "{point = [24, 0, 12]}"), "scene.toml:10:6: the thread M6 is at no round face");
  expect_refused(thread("M6", "{point = [24, 0, 12]}"), "the nearest is the hole");
  expect_refused(thread("M8", core), "scene.toml:9:10: M8 does not suit the hole ⌀5 around");
  expect_refused(thread("M8", core), "the minor diameter of ISO 724, has ⌀6.647");
  expect_refused(thread("M6", core, "depth = 20\n"), "scene.toml:11:9: the thread is 20 long, and the hole ⌀5");
  expect_refused(thread("M6", core) + thread("M6", core), "has the thread M6 already");
  expect_refused(thread("M6", core, "view = 'tpo'\n"), "there is no view 'tpo'");
}

// The clamp has four bores of 7 mm with counterbores; the thread gives all of them.
TEST_F(ThreadDrawings, ANoteGivesTheBoresOfEqualThreads) {
  const std::string text = folder.file(
      "equal.toml",
      "sheet = {size = 'A3', scale = '1:1'}\nmodel = [{file = '" EPURA_TEST_SAMPLES
      "/step/clamp.step'}]\nview = [{projection = 'front'}, {projection = 'top'}]\n"
      "thread = [{thread = 'M8', at = {point = [7.5, 11, 0]}, equal = true}]\ndimension = [{type = 'auto'}]\n");
  ASSERT_EQ(epura({"draw", "--allow-outside", text, "-o", "x.json"}, folder / "").code, 0);
  const std::string json = read_file(folder / "x.json");
  EXPECT_TRUE(contains(json, "4× M8 ⌴⌀12 ↧6"));
  EXPECT_FALSE(contains(json, "\"⌀7\""));
  const Outcome judged = epura({"lint", "--allow-outside", text}, folder / "");
  EXPECT_TRUE(contains(judged.out, "31 of 31 faces held by dimensions\nfidelity: no fault")) << judged.out;
}

}  // namespace
}  // namespace epura::test::threads_test
