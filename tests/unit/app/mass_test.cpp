// SPDX-License-Identifier: Apache-2.0
// Masses and centres of gravity in `epura info`, title blocks, parts lists and views.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::mass_test {
namespace {

// A block of 40 x 30 x 20, of 24 cm³.
constexpr const char* block =
    "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 20\nv 40 0 20\nv 40 30 20\nv 0 30 20\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Masses : public testing::Test {
 protected:
  Folder folder;
  std::string model = folder.file("block.obj", block);
  std::string open = folder.file("open.obj", std::string(block).substr(0, std::string(block).rfind("f ")));

  Outcome run(const std::vector<std::string>& arguments) { return epura(arguments, folder / ""); }
};

TEST_F(Masses, AreToldByInfo) {
  const std::string text = run({"info", model, "--density", "2700"}).out;
  EXPECT_TRUE(contains(text, "volume    24000, surface 5200\n")) << text;
  EXPECT_TRUE(contains(text, "centre    (20, 15, 10), of gravity\n")) << text;
  EXPECT_TRUE(contains(text, "mass      64.8 g, if the unit of the file is mm\n")) << text;
  const std::string json = run({"info", model, "--density", "2700", "--json", "-"}).out;
  EXPECT_TRUE(
      contains(json, "\"volume\": 24000, \"area\": 5200, \"mass\": 0.0648, \"centre_of_gravity\": [20, 15, 10]"))
      << json;
  EXPECT_FALSE(contains(run({"info", model}).out, "mass  "));
  const std::string of_open = run({"info", open, "--density", "2700"}).out;
  EXPECT_TRUE(contains(of_open, "volume    none, as body 0 is not a closed solid: it has 4 open edges\n")) << of_open;
}

TEST_F(Masses, AreInTitleBlocks) {
  const Outcome drawn =
      run({"draw", model, "--views", "front,top", "--mass", "auto", "--density", "7850", "-o", "a.svg"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(read_file(folder / "a.svg"), "aria-label=\"0.188 kg\""));
}

TEST_F(Masses, AreInPartsLists) {
  const Outcome drawn =
      run({"draw", model, "--views", "front,top", "--parts-list", "--density", "1000", "-o", "a.svg"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(read_file(folder / "a.svg"), "aria-label=\"24 g\""));
}

// The symbol has two filled quarters around the middle of each view.
TEST_F(Masses, HaveTheirCentreInViews) {
  const Outcome drawn = run({"draw", model, "--views", "front,top", "--centre-of-gravity", "-o", "a.svg"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  const std::string svg = read_file(folder / "a.svg");
  for (const char* layer : {"front-symbols\"", "top-symbols\""}) EXPECT_TRUE(contains(svg, layer)) << layer;
}

TEST_F(Masses, OfOpenBodiesAndWithoutADensityAreRefused) {
  const auto reason = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"draw", "-o", "b.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_TRUE(
      contains(reason({model, "--mass", "auto"}), "--mass: model 'block' has no density, so its mass is unknown"));
  EXPECT_TRUE(contains(reason({open, "--mass", "auto", "--density", "1000"}),
                       "--mass: model 'open' has no volume: it has 4 open edges"));
  EXPECT_TRUE(contains(reason({open, "--centre-of-gravity"}),
                       "--centre-of-gravity: model 'open' has no volume: it has 4 open edges"));
}

}  // namespace
}  // namespace epura::test::mass_test
