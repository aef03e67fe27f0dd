// SPDX-License-Identifier: Apache-2.0
// Sheets with all that belongs to them: nothing stands over anything else.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "scene/line_roles.hpp"

namespace epura::test::sheets_test {
namespace {

class Sheets : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(const std::string& scene, const std::vector<std::string>& outputs) {
    std::vector<std::string> arguments{"draw", "--allow-outside", folder.file("scene.toml", scene)};
    for (const std::string& output : outputs) arguments.insert(arguments.end(), {"-o", output});
    return epura(arguments, folder / "");
  }
  std::string model() const { return "[[model]]\nfile = '" + sample("bracket.obj") + "'\n"; }
};

// Places of the texts in a layer of an SVG whose texts are texts: y of their base lines.
std::vector<double> heights_of(const std::string& svg, const std::string& layer) {
  const std::size_t begin = svg.find("-" + layer + "\" inkscape:groupmode");
  if (begin == std::string::npos) return {};
  const std::string group = svg.substr(begin, svg.find("</g>\n</g>", begin) - begin);
  static const std::regex place("<text[^>]* y=\"([-0-9.]+)\"");
  std::vector<double> heights;
  for (std::sregex_iterator it(group.begin(), group.end(), place), end; it != end; ++it)
    heights.push_back(std::stod((*it)[1]));
  return heights;
}

// Sheet and scale together: a bracket of 80 x 70 x 75 mm, enlarged.
TEST_F(Sheets, AreChosenWithTheirScale) {
  const auto chosen = [&](const std::string& factor, std::vector<std::string> more) {
    std::vector<std::string> arguments{"draw",         sample("bracket.obj"),
                                       "--transform",  "scale:" + factor,
                                       "--sheet",      "auto",
                                       "--projection", "front",
                                       "-o",           "x.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string json = read_file(folder / "x.json");
    const std::size_t begin = json.find("\"size\"");
    return json.substr(begin, json.find('}', begin) - begin);
  };
  EXPECT_EQ(chosen("1", {}), "\"size\": [297, 210], \"scale\": 2");
  EXPECT_EQ(chosen("4", {}), "\"size\": [420, 297], \"scale\": 0.5") << "A4 would need 1:2";
  EXPECT_EQ(chosen("20", {}), "\"size\": [594, 420], \"scale\": 0.2");
  EXPECT_EQ(chosen("1000", {}), "\"size\": [1189, 841], \"scale\": 0.01");
  EXPECT_EQ(chosen("2.4", {"--landscape"}), "\"size\": [297, 210], \"scale\": 1");
  EXPECT_EQ(chosen("3", {"--scale", "1:1"}), "\"size\": [420, 297], \"scale\": 1") << "a given scale decides";
}

TEST_F(Sheets, DimensionsStandOutsideTheMarksOfSections) {
  const std::string scene = model() +
                            "[sheet]\nsize = 'A3'\n[[section]]\nname = 'A'\npoint = [40, 0, 0]\nnormal = [-1, 0, 0]\n"
                            "[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'left'\nsection = 'A'\n"
                            "[[dimension]]\ntype = 'overall'\ndirection = 'width'\nview = 'front'\n";
  folder.file("scene.toml", scene);
  const Outcome run =
      epura({"draw", "--allow-outside", "scene.toml", "--svg-text", "text", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  const std::vector<double> width = heights_of(svg, "front-dimensions"), marks = heights_of(svg, "front-cutting-plane");
  ASSERT_EQ(width.size(), 1U);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_GT(width[0], std::max(marks[0], marks[1]) + 3.5);  // y points down; letters are 5 mm high
}

TEST_F(Sheets, ManyMakeOneFileOfPagesAndManyOfOnePage) {
  const Outcome run = draw(model() +
                               "[[sheet]]\nsize = 'A3'\n[[sheet]]\nsize = 'A4'\n[[view]]\nprojection = 'front'\n"
                               "[[view]]\nprojection = 'top'\nsheet = 2\n",
                           {"x.svg", "x.pdf", "x.json", "x.dxf", "x.png", "x.ps", "x.eps"});
  ASSERT_EQ(run.code, 0) << run.err;
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) files.insert(entry.path().filename());
  EXPECT_EQ(files, (std::set<std::string>{"scene.toml", "x-1.svg", "x-2.svg", "x.pdf", "x-1.json", "x-2.json",
                                          "x-1.dxf", "x-2.dxf", "x-1.png", "x-2.png", "x.ps", "x-1.eps", "x-2.eps"}));
  EXPECT_TRUE(contains(read_file(folder / "x-1.svg"), "width=\"420mm\""));
  EXPECT_TRUE(contains(read_file(folder / "x-2.svg"), "width=\"297mm\""));
}

// Layers of a view are painted in the order of the table, and each is in it.
TEST_F(Sheets, PaintTheLinesOfAViewInOneOrder) {
  folder.file(
      "scene.toml",
      model() +
          "line = 'visible'\n[sheet]\nsize = 'A3'\n[[section]]\nname = 'A'\npoint = [40, 0, 0]\nnormal = [-1, 0, 0]\n"
          "[[view]]\nprojection = 'front'\nedges = ['contour', 'crease', 'tangent']\n"
          "[[view]]\nprojection = 'left'\nsection = 'A'\n[[dimension]]\ntype = 'overall'\n");
  const Outcome run = epura({"draw", "--allow-outside", "scene.toml", "--centre-lines", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  static const std::regex group("inkscape:label=\"([^\"]+)\"( class)?");
  std::set<std::string> seen;
  int before = -1;
  for (std::sregex_iterator it(svg.begin(), svg.end(), group), end; it != end; ++it) {
    const std::string name = (*it)[1];
    if (!(*it)[2].matched) {
      before = -1;  // a view
      continue;
    }
    const scene::SheetLineRow* row = scene::find_line(name);
    ASSERT_TRUE(row != nullptr) << name;
    EXPECT_GT(static_cast<int>(row->line), before) << name;
    before = static_cast<int>(row->line);
    seen.insert(name);
  }
  for (const char* name :
       {"frame", "text", "hatch", "centre", "hidden", "tangent", "section", "visible", "dimensions", "cutting-plane"})
    EXPECT_TRUE(seen.contains(name)) << name;
}

TEST_F(Sheets, HaveIdsOfTheirOwn) {
  folder.file("scene.toml", model() +
                                "[[sheet]]\n[[sheet]]\n[[view]]\nprojection = 'front'\n"
                                "[[view]]\nprojection = 'front'\nsheet = 2\n");
  ASSERT_EQ(epura({"draw", "--allow-outside", "scene.toml", "--id-prefix", "part", "-o", "x.svg"}, folder / "").code,
            0);
  for (const std::string number : {"1", "2"})
    EXPECT_TRUE(contains(read_file(folder / ("x-" + number + ".svg")), "<svg id=\"part-" + number + "\""));
}

// A projection of a stranger that is a front view stands where front views stand.
TEST_F(Sheets, ViewsStandByTheirGeometryNotByTheirNames) {
  const std::string plugins = EPURA_TEST_BAD_PLUGINS "/anything";
  const auto places = [&](const std::string& front) {
    const Outcome run = epura({"draw", sample("bracket.obj"), "--plugin-path", plugins, "--views", front + ",top,left",
                               "--frame", "none", "--plain", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string svg = read_file(folder / "x.svg");
    std::set<std::string> paths;
    static const std::regex path(" d=\"([^\"]*)\"");
    for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) paths.insert((*it)[1]);
    EXPECT_GE(paths.size(), 3U);
    return paths;
  };
  EXPECT_EQ(places("anything"), places("front"));
}

TEST(SheetsOfViews, SectionsSeenFromTheSideThatIsKeptAreReported) {
  const Folder folder;
  const auto said = [&](const std::string& normal) {
    folder.file("s.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                              "\"\n[[section]]\nname = \"A\"\npoint = [40, 0, 0]\nnormal = " + normal +
                              "\n[[view]]\nprojection = \"left\"\nsection = \"A\"\n");
    return epura({"draw", "--allow-outside", "s.toml", "-o", "x.svg"}, folder / "").err;
  };
  EXPECT_EQ(said("[-1, 0, 0]"), "");
  EXPECT_TRUE(contains(said("[1, 0, 0]"), "view 'left' looks at section A from the side that is kept"))
      << said("[1, 0, 0]");
  folder.file("s.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                            "\"\n[[section]]\nname = \"A\"\npoint = [400, 0, 0]\nnormal = [1, 0, 0]\n"
                            "[[view]]\nprojection = \"right\"\nsection = \"A\"\n");
  const Outcome beside = epura({"draw", "--allow-outside", "s.toml", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(beside.code, 2);
  EXPECT_TRUE(contains(beside.err, "along its normal, the models reach from -400 to -320 of its point")) << beside.err;
}

TEST(SheetsOfViews, PictorialViewsHaveHiddenLinesOnRequest) {
  const Folder folder;
  const auto hidden_layers = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"draw", sample("bracket.obj"), "-o", "x.json", "--views"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(epura(arguments, folder / "").code, 0);
    const Json drawing = JsonReader(read_file(folder / "x.json")).read();
    std::string views;
    for (const Json& view : drawing["views"].items)
      for (const Json& segment : view["segments"].items)
        if (segment["visible"].type == 'f') {
          views += view["name"].text + " ";
          break;
        }
    return views;
  };
  EXPECT_EQ(hidden_layers({"front,isometric,cabinet,two-point"}), "front ");
  EXPECT_EQ(hidden_layers({"front:hidden=none,isometric:hidden=dashed,left"}), "isometric left ");
  EXPECT_EQ(hidden_layers({"front,isometric", "--hidden", "dashed"}), "front isometric ");
}

TEST(Scales, OtherThanThoseOfTheStandardAreSaid) {
  const Folder folder;
  const auto said = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"draw", sample("bracket.obj"), "--projection", "front", "-o", "x.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "").err;
  };
  EXPECT_TRUE(contains(said({"--scale", "1:3", "--sheet", "A2"}), "not a scale of ISO 5455: 1:3 (the nearest is 1:2)"));
  EXPECT_EQ(said({"--scale", "1/2", "--sheet", "A2"}), "");
  EXPECT_EQ(said({"--scale", "1:3", "--sheet", "none"}), "");
}

}  // namespace
}  // namespace epura::test::sheets_test
