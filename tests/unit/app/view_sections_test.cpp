// SPDX-License-Identifier: Apache-2.0
// Sections in the words of a view draw what sections of scene files draw.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::view_sections_test {
namespace {

class ViewSections : public testing::Test {
 protected:
  ViewSections() { std::filesystem::copy(sample("flange.obj"), folder_ / "part.obj"); }

  [[nodiscard]] std::string by_words(const std::string& views) const {
    const Outcome run = epura({"draw", "part.obj", "--views", views, "-o", "words.svg"}, folder_ / "");
    EXPECT_EQ(run.code, 0) << views << run.err;
    return read_file(folder_ / "words.svg");
  }
  /// `section`: its keys but for the name.
  [[nodiscard]] std::string by_file(const std::string& view, const std::string& section) const {
    write_file(folder_ / "scene.toml", "[[model]]\nfile = \"part.obj\"\n[[section]]\nname = \"A\"\n" + section +
                                           "\n[[view]]\nprojection = \"" + view +
                                           "\"\nsection = \"A\"\n[[view]]\nprojection = \"top\"\n");
    const Outcome run = epura({"draw", "scene.toml", "-o", "file.svg"}, folder_ / "");
    EXPECT_EQ(run.code, 0) << section << run.err;
    return read_file(folder_ / "file.svg");
  }
  [[nodiscard]] std::string refusal(const std::string& views) const {
    const Outcome run = epura({"draw", "part.obj", "--views", views, "-o", "x.svg"}, folder_ / "");
    EXPECT_EQ(run.code, 2) << views;
    return run.err;
  }

  Folder folder_;
};

TEST_F(ViewSections, RemoveWhatIsBeforeThePlane) {
  EXPECT_EQ(by_words("front:section=y@3,top"), by_file("front", "point = [0, 3, 0]\nnormal = [0, -1, 0]"));
  EXPECT_EQ(by_words("back:section=y@3,top"), by_file("back", "point = [0, 3, 0]\nnormal = [0, 1, 0]"));
  EXPECT_EQ(by_words("left:section=x@-2,top"), by_file("left", "point = [-2, 0, 0]\nnormal = [-1, 0, 0]"));
  EXPECT_EQ(by_words("right:section=x@-2,top"), by_file("right", "point = [-2, 0, 0]\nnormal = [1, 0, 0]"));
  EXPECT_EQ(by_words("isometric:section=+y@3,top"), by_file("isometric", "point = [0, 3, 0]\nnormal = [0, 1, 0]"));
}

TEST_F(ViewSections, CutAHalf) {
  EXPECT_EQ(by_words("front:section=y@0/x@0,top"),
            by_file("front", "path = [[1, 0, 0], [0, 0, 0], [0, -1, 0]]\nnormal = [0, -1, 0]"));
  EXPECT_EQ(by_words("front:section=y@0/-x@0,top"),
            by_file("front", "path = [[-1, 0, 0], [0, 0, 0], [0, -1, 0]]\nnormal = [0, -1, 0]"));
}

TEST_F(ViewSections, HaveLettersOfTheirOwn) {
  const std::string svg = by_words("front:section=y@0,left:section=x@0");
  EXPECT_TRUE(contains(svg, "data-text=\"A-A\"") || contains(svg, "A\xE2\x80\x93") || contains(svg, "A-A")) << "A";
  EXPECT_NE(svg, by_words("front:section=y@0,left"));
  write_file(folder_ / "scene.toml",
             "[[model]]\nfile = \"part.obj\"\n[[section]]\nname = \"A\"\npoint = [0, 3, 0]\nnormal = [0, -1, 0]\n");
  for (const char* views : {"front:section=A", "front:section=y@3"}) {
    const Outcome run = epura({"draw", "scene.toml", "--views", views, "-o", "x.svg"}, folder_ / "");
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

// A step that is highest where the section removes it: another view has the height, and none refuses it.
TEST_F(ViewSections, LeaveOverallSizesToViewsThatShowThem) {
  write_file(folder_ / "step.obj",
             "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 18\nv 40 0 18\nv 40 10 18\nv 0 10 18\n"
             "v 0 10 8\nv 40 10 8\nv 40 30 8\nv 0 30 8\n"
             "f 4 3 2 1\nf 1 2 6 5\nf 5 6 7 8\nf 8 7 10 9\nf 9 10 11 12\nf 12 11 3 4\n"
             "f 2 3 11 10 7 6\nf 4 1 5 8 9 12\n");
  for (const char* dimensions : {"overall", "auto", "hole-table"}) {
    const Outcome run = epura({"draw", "step.obj", "--views", "front:section=y@20,top,left", "--dimensions", dimensions,
                               "-o", "step.svg", "--svg-text", "text"},
                              folder_ / "");
    EXPECT_EQ(run.code, 0) << dimensions << run.err;
    const std::string svg = read_file(folder_ / "step.svg");
    for (const char* size : {">40<", ">30<", ">18<"}) EXPECT_TRUE(contains(svg, size)) << dimensions << size;
  }
}

TEST_F(ViewSections, AreRefusedUnlessTheyAreSound) {
  for (const char* words : {"y", "y@", "w@3", "y@a", "y@1e60", "y@3/y@4", "y@3/x@1/z@1", "B", "y@3/"})
    EXPECT_TRUE(
        contains(refusal("front:section=" + std::string(words)), "is neither a plane nor the name of a section"))
        << refusal("front:section=" + std::string(words));
  EXPECT_TRUE(contains(refusal("front:section=y@300"), "removes everything")) << refusal("front:section=y@300");
}

}  // namespace
}  // namespace epura::test::view_sections_test
