// SPDX-License-Identifier: Apache-2.0
// Tables and lists of revisions, from scenes to sheets.
#include <gtest/gtest.h>

#include <string>

#include "base/file.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::tables_test {
namespace {

class Tables : public testing::Test {
 protected:
  Folder folder;
  std::string model =
      folder.file("part.obj", "v 0 0 0\nv 40 0 0\nv 0 30 0\nv 0 0 20\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");

  Outcome draw(const std::string& keys) {
    const std::string scene =
        folder.file("scene.toml", "[[model]]\nfile = \"part.obj\"\n[[view]]\nprojection = \"front\"\n" + keys);
    return epura({"draw", scene, "-o", "a.svg", "--svg-text", "text"}, folder / "");
  }
  void refused(const std::string& keys, const std::string& reason) {
    const Outcome run = draw(keys);
    EXPECT_EQ(run.code, 2) << keys;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("scene.toml:"), std::string::npos) << "has a place: " << run.err;
  }
};

TEST_F(Tables, AreWritten) {
  const Outcome run = draw(
      "[[table]]\ntitle = \"Gear\"\nrows = [[\"Module\", 2.5]]\n"
      "[[revision]]\nrevision = \"B\"\ntext = \"larger\"\ndate = 2026-03-02\n");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  for (const char* text : {">Gear<", ">Module<", ">2.5<", ">Change<", ">B<", ">larger<", ">2026-03-02<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST_F(Tables, NameTheirFaults) {
  refused("[[table]]\ntitle = \"a\"\n", "[[table]] lacks 'rows'");
  refused("[[table]]\nrows = []\n", "'rows' has no rows");
  refused("[[table]]\nrows = [[]]\n", "'rows' is empty");
  refused("[[table]]\nrows = [\"a\"]\n", "'rows' is a text, a list is wanted");
  refused("[[table]]\nheader = [\"a\", \"b\"]\nrows = [[1, 2], [3]]\n", "row 2 of the table has 1 cell instead of 2");
  refused("[[table]]\nrows = [[1]]\ncorner = \"top\"\n", "unknown value 'top'");
  refused("[[table]]\nrows = [[1]]\nat = [1, 2]\ncorner = \"top-left\"\n", "has a position and a corner");
  refused("[[table]]\nrows = [[1]]\nat = [1, 2]\n", "the table does not fit on the sheet");
  refused("[[table]]\nrows = [[1]]\nsheet = 2\n", "the table is for sheet 2 of 1");
  refused("[[revision]]\nrevision = \"B\"\n", "[[revision]] lacks 'text'");
  refused("[[revision]]\nrevision = \"B\"\ntext = \"a\"\nsheet = 3\n", "revision B is for sheet 3 of 1");
  refused("[[revision]]\nrevision = \"B\"\ntext = \"a\"\n[sheet]\nsize = \"none\"\n",
          "a list of revisions needs a sheet");
  std::string many;
  for (int i = 0; i < 40; ++i) many += "[[revision]]\nrevision = \"" + std::to_string(i) + "\"\ntext = \"a\"\n";
  refused(many + "[sheet]\nsize = \"A4\"\n", "the list of 40 revisions is 246 mm high");
}

}  // namespace
}  // namespace epura::test::tables_test
