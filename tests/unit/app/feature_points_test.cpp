// SPDX-License-Identifier: Apache-2.0
// Points that scene files give by features.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::feature_points_test {
namespace {

// The same surface with its faces in the reverse order, as another program may write it.
std::string written_anew(const std::string& obj) {
  std::istringstream lines(obj);
  std::vector<std::string> points, faces;
  for (std::string line; std::getline(lines, line);) (line.starts_with("f ") ? faces : points).push_back(line);
  std::reverse(faces.begin(), faces.end());
  std::string text;
  for (const auto* list : {&points, &faces})
    for (const std::string& line : *list) text += line + "\n";
  return text;
}

class FeaturePoints : public testing::Test {
 protected:
  FeaturePoints() {
    // Holes at (20, 15), (20, 45), (60, 15) and (60, 45).
    const std::string four = plate({40, 30}, 2, 2, 20, stepped_hole({{4, 20}, {4, 0}}));
    folder.file("four.obj", four);
    folder.file("anew.obj", written_anew(four));
  }

  [[nodiscard]] Outcome draw(const std::string& model, const std::string& parts,
                             const std::string& output = "x.svg") const {
    const std::string scene = "[[model]]\nfile = \"" + model +
                              ".obj\"\n[[view]]\nname = \"front\"\nprojection = \"front\"\n[[view]]\nname = "
                              "\"top\"\nprojection = \"top\"\n[sheet]\nsize = \"A3\"\n" +
                              parts;
    return epura({"draw", folder.file("scene.toml", scene), "-o", output}, folder / "");
  }
  [[nodiscard]] Words texts() const { return sorted(dimensions_in(read_file(folder / "x.svg"))); }

  Folder folder;
};

TEST_F(FeaturePoints, AreEndsOfDimensionsWhateverTheOrderOfTheFile) {
  const auto linear = [](const std::string& direction, const std::string& from, const std::string& to) {
    return "[[dimension]]\nview = \"top\"\ntype = \"linear\"\ndirection = \"" + direction + "\"\nfrom = " + from +
           "\nto = " + to + "\n";
  };
  for (const std::string model : {"four", "anew"}) {
    const Outcome run =
        draw(model, linear("horizontal", "\"hole 1\"", "\"hole 3\"") + linear("vertical", "\"hole 3\"", "\"hole 4\"") +
                        linear("horizontal", "\"face 1\"", "[\"" + model + "\", \"hole 2\"]") +
                        "[[dimension]]\nview = \"top\"\ntype = \"diameter\"\nat = \"hole 2\"\ntolerance = \"H7\"\n");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(texts(), sorted({"40", "30", "20", "⌀8 H7"}));
  }
}

TEST_F(FeaturePoints, AreThoseOfSectionsDetailsAndLeaders) {
  const Outcome run = draw("four",
                           "[[section]]\nname = \"A\"\npoint = \"hole 3\"\n"
                           "[[view]]\nprojection = \"front\"\nname = \"cut\"\nsection = \"A\"\n"
                           "[[detail]]\nname = \"X\"\nview = \"top\"\ncentre = \"hole 2\"\nradius = 6\n"
                           "[[view]]\ndetail = \"X\"\nscale = \"5:1\"\n"
                           "[[note]]\nview = \"top\"\ntext = \"drilled\"\nto = \"hole 4\"\n"
                           "[[thread]]\nthread = \"M9\"\nat = \"hole 1\"\n");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  for (const char* text : {"A-A", "X", "drilled", "M9"})
    EXPECT_TRUE(contains(svg, "aria-label=\"" + std::string(text))) << text;
}

// The leaders in a JSON drawing.
std::vector<std::vector<Vec2>> leaders_in(const std::string& json) {
  static const std::regex leader(R"re("leader": \[(\[.*?\])\])re"), point(R"re(\[([-0-9.e]+), ([-0-9.e]+)\])re");
  std::vector<std::vector<Vec2>> leaders;
  for (std::sregex_iterator one(json.begin(), json.end(), leader), end; one != end; ++one) {
    const std::string points = (*one)[1].str();
    std::vector<Vec2>& found = leaders.emplace_back();
    for (std::sregex_iterator p(points.begin(), points.end(), point); p != end; ++p)
      found.push_back({*parse_number((*p)[1].str()), *parse_number((*p)[2].str())});
  }
  return leaders;
}

// From wherever they come, leaders to a hole end on the nearest point of its rim: where they would pass its centre.
TEST_F(FeaturePoints, LeadersToHolesAimAtTheirCentres) {
  std::string notes = "scale = \"1:1\"\n";
  for (const char* at : {"[20, 250]", "[380, 250]", "[380, 60]", "[20, 100]"})
    notes += "[[note]]\nview = \"top\"\ntext = \"drilled\"\nto = \"hole 4\"\nat = " + std::string(at) + "\n";
  const Outcome run = draw("four", notes, "x.json");
  EXPECT_EQ(run.code, 0) << run.err;
  const auto leaders = leaders_in(read_file(folder / "x.json"));
  ASSERT_EQ(leaders.size(), 4U);
  for (const auto& one : leaders) {
    const Vec2 centre = one[0] - 4.0 * glm::normalize(one[1] - one[0]);
    for (const auto& other : leaders) EXPECT_NEAR(glm::distance(other[0], centre), 4, 1e-6);
  }
}

// To the wall of a bore in a section: out of the bore, not through the material beside it.
TEST_F(FeaturePoints, LeadersComeFromOutsideOfCutMaterial) {
  const Outcome run = draw("four",
                           "scale = \"1:1\"\n[[section]]\nname = \"A\"\npoint = [0, 15, 0]\nnormal = [0, -1, 0]\n"
                           "[[view]]\nprojection = \"front\"\nname = \"cut\"\nsection = \"A\"\n"
                           "[[note]]\nview = \"cut\"\ntext = \"honed\"\nto = {point = [24, 15, 12]}\n",
                           "x.json");
  EXPECT_EQ(run.code, 0) << run.err;
  const auto leaders = leaders_in(read_file(folder / "x.json"));
  ASSERT_EQ(leaders.size(), 1U);
  const Vec2 way = leaders[0][1] - leaders[0][0];
  const double at_mouth = way.x / std::abs(way.y) * (way.y > 0 ? 8 : 12);
  EXPECT_LE(at_mouth, 0);
  EXPECT_GE(at_mouth, -8) << "the diameter of the bore";
}

TEST_F(FeaturePoints, ThatAreNotThereAreRefusedWithWhatThereIs) {
  const auto at = [](const std::string& name) {
    return "[[dimension]]\nview = \"top\"\ntype = \"diameter\"\nat = " + name + "\n";
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {at("\"hole 5\""), "'four' has no hole 5\n  hint: it has hole 1 to 4; epura info"},
      {at("\"hole\""), "'hole' is not a feature"},
      {at("\"hole 0\""), "'hole 0' is not a feature"},
      {at("\"face 1\""), "face 1 is not cylindrical"},
      {at("[\"plate\", \"hole 1\"]"), "there is no model 'plate'"},
      {"[[section]]\nname = \"A\"\npoint = \"hole 9\"\n[[view]]\nprojection = \"front\"\nname = \"cut\"\nsection = "
       "\"A\"\n",
       "has no hole 9"},
      {"[[model]]\nfile = \"anew.obj\"\n" + at("\"hole 1\""), "there are 2 models that have 'hole 1'"},
  };
  for (const auto& [parts, why] : cases) {
    const Outcome run = draw("four", parts);
    EXPECT_EQ(run.code, 2) << parts;
    EXPECT_TRUE(contains(run.err, why)) << run.err;
  }
}

TEST_F(FeaturePoints, HaveTheirNumbersInInfo) {
  for (const char* model : {"four.obj", "anew.obj"}) {
    const Outcome run = epura({"info", model}, folder / "");
    EXPECT_TRUE(contains(run.out, "hole 1 to 4: 4 x Ø8")) << run.out;
    EXPECT_TRUE(contains(run.out, "6 planes; face 1 to 6")) << run.out;
    EXPECT_TRUE(contains(run.out, "face 7 to 10")) << run.out;
  }
}

}  // namespace
}  // namespace epura::test::feature_points_test
