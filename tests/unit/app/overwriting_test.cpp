// SPDX-License-Identifier: Apache-2.0
// Outputs that are inputs, or one file, by any of its names.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::overwriting_test {
namespace {

namespace fs = std::filesystem;

/// A cube, a scene of it, and other names for both and for their folder.
struct Files {
  Folder folder;

  Files() {
    fs::copy(root() / "tests/golden/models/cube.obj", folder / "cube.obj");
    folder.file("scene.toml",
                "[[model]]\nfile = \"cube.obj\"\n[[sheet]]\n[[sheet]]\n"
                "[[view]]\nprojection = \"front\"\n[[view]]\nprojection = \"top\"\nsheet = 2\n");
    fs::create_hard_link(folder / "cube.obj", folder / "hard.svg");
    fs::create_symlink("cube.obj", folder / "soft.svg");
    fs::create_symlink("soft.svg", folder / "softer.json");
    fs::create_symlink("scene.toml", folder / "scene.pdf");
    fs::create_symlink("cube.obj", folder / "sheet-2.svg");
    fs::create_symlink("to-come.svg", folder / "dangling.svg");
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& why) const {
    const std::string cube = read_file(folder / "cube.obj"), scene = read_file(folder / "scene.toml");
    const auto names = folder.names();
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 2) << arguments.back();
    EXPECT_TRUE(contains(run.err, why) && contains(run.err, "write to another file")) << run.err;
    EXPECT_EQ(read_file(folder / "cube.obj"), cube);
    EXPECT_EQ(read_file(folder / "scene.toml"), scene);
    EXPECT_EQ(folder.names(), names);
  }
};

TEST(ViewDrawing, OverwritesNoInput) {
  const Files files;
  for (const char* output : {"hard.svg", "soft.svg", "softer.json", "./soft.svg"}) {
    files.expect_refused({"draw", "cube.obj", "-o", output}, "is the input cube.obj under another name");
    files.expect_refused({"explain", "cube.obj", "-o", output}, "is the input cube.obj under another name");
  }
  files.expect_refused({"draw", "scene.toml", "-o", "scene.pdf"}, "is the input scene.toml under another name");
  files.expect_refused({"draw", "scene.toml", "-o", "sheet.svg"},
                       "sheet-2.svg: is the input cube.obj under another name");
}

TEST(ViewDrawing, WritesNoFileTwice) {
  const Files files;
  files.expect_refused({"draw", "cube.obj", "-o", "a.svg", "-o", "a.svg"},
                       "a.svg: is given twice, the other time as output");
  files.expect_refused({"draw", "cube.obj", "-o", "a.svg", "-o", "./a.svg"}, "is the output a.svg under another name");
  files.expect_refused({"draw", "cube.obj", "-o", "to-come.svg", "-o", "dangling.svg"},
                       "is the output to-come.svg under another name");
  files.expect_refused({"draw", "scene.toml", "-o", "s.svg", "-o", "s.json", "-o", "./s.svg"},
                       "./s-1.svg: is the output s-1.svg under another name");
}

TEST(ViewDrawing, GoesThroughALinkToNothingYet) {
  const Files files;
  EXPECT_EQ(epura({"draw", "cube.obj", "-o", "dangling.svg"}, files.folder / "").code, 0);
  EXPECT_TRUE(fs::is_symlink(files.folder / "dangling.svg"));
  EXPECT_TRUE(contains(read_file(files.folder / "to-come.svg"), "<svg"));
}

TEST(Comparing, OverwritesNoInput) {
  const Files files;
  ASSERT_EQ(epura({"draw", "cube.obj", "-o", "a.svg", "-o", "b.svg"}, files.folder / "").code, 0);
  fs::create_hard_link(files.folder / "a.svg", files.folder / "a.html");
  fs::create_symlink("b.svg", files.folder / "link.json");
  const std::string a = read_file(files.folder / "a.svg"), b = read_file(files.folder / "b.svg");
  const std::vector<std::vector<std::string>> wishes{
      {"--overlay", "a.svg"},  {"--overlay", "./b.svg"}, {"--overlay", "a.html"},
      {"--json", "link.json"}, {"--json", "b.svg"},      {"--overlay", "c.svg", "--json", "./c.svg"}};
  for (const std::vector<std::string>& wish : wishes) {
    std::vector<std::string> arguments{"compare", "a.svg", "b.svg"};
    arguments.insert(arguments.end(), wish.begin(), wish.end());
    files.expect_refused(arguments, "");
    EXPECT_EQ(read_file(files.folder / "a.svg"), a);
    EXPECT_EQ(read_file(files.folder / "b.svg"), b);
  }
}

TEST(Studying, OverwritesNoInput) {
  const Files files;
  fs::create_symlink("cube.obj", files.folder / "r.html");
  files.expect_refused({"study", "accuracy", "cube.obj", "-o", "r.html"}, "is the input cube.obj under another name");
  files.expect_refused({"study", "accuracy", "scene.toml", "-o", "r.html"}, "is the input cube.obj under another name");
  files.expect_refused({"study", "stability", "--cases", "P1", "-o", "x.csv", "-o", "./x.csv"},
                       "is the output x.csv under another name");
}

}  // namespace
}  // namespace epura::test::overwriting_test
