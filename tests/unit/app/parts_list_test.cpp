// SPDX-License-Identifier: Apache-2.0
// Parts lists and balloons, from files of models to the texts on the sheet.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::parts_list_test {
namespace {

// An object with vertices of its own: a box.
std::string box(const std::string& name, double x, const Vec3& size, int number) {
  std::string text = "o " + name + "\n";
  for (int corner = 0; corner < 8; ++corner)
    text += "v " + format_number(x + (corner % 4 == 1 || corner % 4 == 2 ? size.x : 0)) + " " +
            format_number(corner % 4 >= 2 ? size.y : 0) + " " + format_number(corner >= 4 ? size.z : 0) + "\n";
  const auto face = [&](int a, int b, int c, int d) {
    text += "f";
    for (const int v : {a, b, c, d}) text += " " + std::to_string(8 * number + 1 + v);
    text += "\n";
  };
  face(3, 2, 1, 0), face(4, 5, 6, 7), face(0, 1, 5, 4), face(1, 2, 6, 5), face(2, 3, 7, 6), face(3, 0, 4, 7);
  return text;
}

// Texts of a role, in their order.
std::vector<std::string> texts_of(const std::string& svg, const std::string& role) {
  std::vector<std::string> texts;
  const std::string mark = "text-" + role + "\"";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t from = svg.find('>', at) + 1;
    if (svg.compare(from - 1, 1, ">") == 0 && svg.compare(svg.rfind('<', at), 5, "<text") == 0)
      texts.push_back(svg.substr(from, svg.find('<', from) - from));
  }
  return texts;
}

using Texts = std::vector<std::string>;

class PartsList : public testing::Test {
 protected:
  Folder folder;
  // Three legs of one shape, one of them turned, and a table.
  std::string model = folder.file("table.obj", box("leg_1", 0, {4, 4, 30}, 0) + box("leg_2", 20, {4, 4, 30}, 1) +
                                                   box("leg_3", 40, {4, 30, 4}, 2) + box("top", 60, {50, 40, 3}, 3));

  Outcome draw(const std::vector<std::string>& options) {
    std::vector<std::string> all{"draw"};
    all.insert(all.end(), options.begin(), options.end());
    for (const char* more : {"-o", "a.svg", "--svg-text", "text"}) all.emplace_back(more);
    return epura(all, folder / "");
  }
  Outcome draw_scene(const std::string& keys) {
    return draw({folder.file("scene.toml", "[[model]]\nfile = \"table.obj\"\n" + keys)});
  }
};

TEST_F(PartsList, CountsAndNumbersTheBodies) {
  const Outcome run = draw({model, "--views", "front,isometric", "--parts-list"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_EQ(texts_of(svg, "parts-list"), (Texts{"Item", "Qty", "Name", "1", "3", "leg", "2", "1", "top"}));
  EXPECT_EQ(texts_of(svg, "balloon"), (Texts{"1", "2"})) << "one for each item";
}

// 4 x 4 x 30 mm³ of 7850 kg/m³ are 3.768 g; 50 x 40 x 3 mm³ of 2700 kg/m³ are 16.2 g.
TEST_F(PartsList, HasMaterialsAndMassesInTheLanguageOfTheSheet) {
  const Outcome run = draw_scene(
      "[parts_list]\nballoons = false\n[title_block]\nlanguage = \"de\"\n[sheet]\ndecimal_sign = \",\"\n"
      "[[style]]\nmatch = \"leg*\"\ndensity = 7850\nmaterial = \"S235JR\"\n"
      "[[style]]\nmatch = \"top\"\ndensity = 2700\n");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_EQ(texts_of(svg, "parts-list"), (Texts{"Pos.", "Menge", "Benennung", "Werkstoff", "Masse", "1", "3", "leg",
                                                "S235JR", "3,77 g", "2", "1", "top", "16,2 g"}));
  EXPECT_TRUE(texts_of(svg, "balloon").empty());
}

TEST_F(PartsList, HasBalloonsInTheChosenView) {
  const std::string views = "[[view]]\nprojection = \"front\"\n[[view]]\nprojection = \"top\"\n";
  const Outcome run = draw_scene("[parts_list]\nview = \"top\"\n" + views);
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_TRUE(contains(svg, "top-balloons"));
  EXPECT_FALSE(contains(svg, "front-balloons"));
}

TEST_F(PartsList, RefusesWhatItCannotDraw) {
  const auto refused = [&](const std::string& keys, const std::string& reason) {
    const Outcome run = draw_scene(keys);
    EXPECT_EQ(run.code, 2) << keys;
    EXPECT_TRUE(contains(run.err, reason)) << run.err;
    EXPECT_TRUE(contains(run.err, "scene.toml:")) << run.err;
    EXPECT_TRUE(contains(run.err, "hint:") || contains(run.err, "is wanted")) << run.err;
  };
  refused("[parts_list]\nview = \"tpo\"\n[[view]]\nprojection = \"top\"\n", "there is no view 'tpo'");
  refused("[parts_list]\nsheet = 2\n", "the parts list is for sheet 2 of 1");
  refused("[parts_list]\nballons = true\n", "'ballons' is not a key of [parts_list]");
  refused("[[style]]\nmatch = \"*\"\ndensity = 0\n[parts_list]\n", "more than 0 is wanted");
  refused("[parts_list]\n[sheet]\nsize = \"none\"\n", "a parts list needs a sheet");
  std::string many;
  for (int i = 0; i < 40; ++i)
    many += box("part" + std::string(static_cast<std::size_t>(i + 1), 'x'), 9 * i, {5, 5, 5}, i);
  folder.file("table.obj", many);
  refused("[parts_list]\n[sheet]\nsize = \"A4\"\n", "the parts list of 40 items is 246 mm high");
}

}  // namespace
}  // namespace epura::test::parts_list_test
