// SPDX-License-Identifier: Apache-2.0
// Notes and symbols with leaders, from scenes to sheets.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::notes_test {
namespace {

// A block of 40 x 30 x 20.
constexpr const char* block =
    "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 20\nv 40 0 20\nv 40 30 20\nv 0 30 20\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Notes : public testing::Test {
 protected:
  Folder folder;
  std::string model = folder.file("block.obj", block);

  Outcome draw(const std::string& keys) {
    const std::string views = "[[view]]\nprojection = \"front\"\n[[view]]\nprojection = \"top\"\n";
    const std::string scene = folder.file("scene.toml", "[[model]]\nfile = \"block.obj\"\n" + views + keys);
    return epura({"draw", scene, "-o", "a.svg", "--svg-text", "text"}, folder / "");
  }
  void refused(const std::string& keys, const std::string& reason) {
    const Outcome run = draw(keys);
    EXPECT_EQ(run.code, 2) << keys;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("scene.toml:"), std::string::npos) << "has a place: " << run.err;
  }
};

TEST_F(Notes, AreInLayersOfTheirViews) {
  const Outcome run = draw(
      "[[note]]\ntext = \"top face\"\nview = \"top\"\nto = {point = [20, 15, 20]}\n"
      "[[note]]\ntext = \"everywhere\"\n[[note]]\ntext = \"alone\"\nat = [30, 180]\n");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  for (const char* text : {">top face<", ">Notes<", ">1.<", ">everywhere<", ">alone<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find(">2.<"), std::string::npos) << "what has a position is not in the list";
}

TEST_F(Notes, NameTheirFaults) {
  const std::string note = "[[note]]\ntext = \"a\"\n";
  refused("[[note]]\nto = [0, 1]\n", "[[note]] lacks 'text'");
  refused("[[note]]\ntext = []\n", "'text' is empty");
  refused("[[note]]\ntext = \"a\\tb\"\n", "'text' has a tab");
  refused(note + "to = [0, 1]\nview = \"tpo\"\n", "there is no view 'tpo'");
  refused(note + "to = [0, 99]\n", "model 0 has no vertex 99");
  refused(note + "to = [\"bolck\", 1]\n", "there is no model 'bolck'");
  refused(note + "to = {point = [90, 0, 0]}\n", "view 'front' shows nothing at the end of the leader of note 'a'");
  refused(note + "to = {page = [1, 1]}\n", "view 'front' shows nothing at the end of the leader of note 'a'");
  refused(note + "at = [600, 20]\n", "note 'a' does not fit on the sheet");
  refused(note + "view = \"top\"\n", "what has no leader has no 'view'");
  refused(note + "sheet = 2\n", "note 'a' is for sheet 2 of 1");
  refused(note + "to = [0, 1]\nsheet = 1\n", "what has a leader is on the sheet of its view");
  refused(note + "to = [0, 1]\nend = \"arow\"\n", "unknown value 'arow'");
}

TEST_F(Notes, RefuseTolerancesThatMeanNothing) {
  const std::string to = "to = {point = [20, 0, 20]}\n", frame = "[[tolerance_frame]]\n" + to;
  const std::string datum = "[[datum]]\nletter = \"A\"\nto = {point = [20, 0, 0]}\n";
  refused(frame + "characteristic = \"flatnes\"\nzone = \"0.1\"\n", "did you mean 'flatness'?");
  refused(frame + "characteristic = \"flatness\"\nzone = \"0.1\"\ndatums = \"A\"\n" + datum, "flatness has no datums");
  refused(frame + "characteristic = \"perpendicularity\"\nzone = \"0.1\"\n", "perpendicularity needs a datum");
  refused(frame + "characteristic = \"position\"\nzone = \"0.1\"\ndatums = \"B\"\n" + datum,
          "the sheet has no datum B, to which the tolerance of position refers");
  refused(frame + "characteristic = \"position\"\nzone = \"0.1 X\"\n", "'X' is not a modifier");
  refused(frame + "characteristic = \"position\"\nzone = \"0.1\"\ndatums = [\"A\", \"B\", \"C\", \"D\"]\n",
          "has 4 datums, at most 3");
  refused("[[tolerance_frame]]\ncharacteristic = \"flatness\"\nzone = \"0.1\"\n", "[[tolerance_frame]] lacks 'to'");
  refused(datum + datum, "datum A is on the sheet twice");
  refused("[[datum]]\nletter = \"A\"\nto = {point = [20, 0, 10]}\n",
          "datum A does not stand on a line of view 'front'");
  refused("[[datum]]\nletter = \"I\"\n" + to, "'I' is not a datum letter");
  refused("[[surface_texture]]\nremoval = \"forbidden\"\n", "unknown value 'forbidden'");
}

TEST_F(Notes, DrawSymbolsAndOneForTheWholePart) {
  const Outcome run = draw(
      "[[datum]]\nletter = \"A\"\nto = {point = [20, 0, 0]}\n"
      "[[tolerance_frame]]\ncharacteristic = \"parallelism\"\nzone = \"0.1\"\ndatums = \"A\"\n"
      "to = {point = [20, 0, 20]}\n[[surface_texture]]\ntext = \"Ra 3.2\"\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_NE(svg.find(">Ra 3.2<"), std::string::npos);
  EXPECT_EQ(svg.find(">(<"), std::string::npos) << "no symbol says otherwise";
  EXPECT_NE(svg.find("inkscape:label=\"symbols\""), std::string::npos);
}

TEST_F(Notes, TellOfPointsThatAreHidden) {
  const Outcome hidden = draw("[[note]]\ntext = \"rear\"\nto = {point = [20, 30, 10]}\n");
  EXPECT_EQ(hidden.code, 0);
  EXPECT_NE(hidden.err.find("a face hides the point of note 'rear'"), std::string::npos) << hidden.err;
  const Outcome seen = draw("[[note]]\ntext = \"near\"\nto = {point = [20, 0, 10]}\n");
  EXPECT_EQ(seen.err.find("hides"), std::string::npos) << seen.err;
}

// In line with the dimension line, whose ends are 40 mm apart in the front view; the triangle stands on one of them.
TEST_F(Notes, DatumsStandInLineWithDimensions) {
  const std::string width =
      "[[dimension]]\ntype = \"linear\"\ndirection = \"horizontal\"\nname = \"width\"\nview = \"front\"\n"
      "from = [0, 0]\nto = [0, 1]\n";
  const std::string datum = "[[datum]]\nletter = \"A\"\ndimension = \"width\"\n";
  const Outcome run = draw(width + datum +
                           "[[tolerance_frame]]\ncharacteristic = \"flatness\"\nzone = \"0.1\"\nto = [0, 5]\n"
                           "also = [{characteristic = \"parallelism\", zone = \"0.2\", datums = [\"A\"]}]\n");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "a.svg");
  for (const char* text : {">40<", ">A<", ">0.1<", ">0.2<"}) EXPECT_NE(svg.find(text), std::string::npos) << text;
  refused(datum, "there is no dimension 'width'");
  refused(width + datum + "to = [0, 1]\n", "it has a 'dimension' and needs no 'to'");
  refused(width + datum + "at = [9, 9]\n", "what stands in line with a dimension has no 'at'");
  refused(width + "[[datum]]\nletter = \"A\"\n", "[[datum]] lacks 'to'");
  refused(width + width, "'width' is the name of an earlier dimension");
  std::string both = width + datum;
  for (const char* letter : {"B", "C"})
    both += "[[datum]]\nletter = \"" + std::string(letter) + "\"\ndimension = \"width\"\n";
  refused(both, "dimension 'width' has no free end of a straight dimension line for datum C");
  refused(
      "[[tolerance_frame]]\ncharacteristic = \"flatness\"\nzone = \"0.1\"\nto = [0, 5]\n"
      "also = [{characteristic = \"parallelism\", zone = \"0.2\"}]\n",
      "a tolerance of parallelism needs a datum");
}

}  // namespace
}  // namespace epura::test::notes_test
