// SPDX-License-Identifier: Apache-2.0
// Points that scene files give by features.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

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

  [[nodiscard]] Outcome draw(const std::string& model, const std::string& parts) const {
    const std::string scene = "[[model]]\nfile = \"" + model +
                              ".obj\"\n[[view]]\nname = \"front\"\nprojection = \"front\"\n[[view]]\nname = "
                              "\"top\"\nprojection = \"top\"\n[sheet]\nsize = \"A3\"\n" +
                              parts;
    return epura({"draw", folder.file("scene.toml", scene), "-o", "x.svg"}, folder / "");
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
