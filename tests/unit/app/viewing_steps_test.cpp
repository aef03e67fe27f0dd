// SPDX-License-Identifier: Apache-2.0
// epura plugins NAME --model MODEL: the matrices of seed document 003 give the drawing.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../output/json_reader.hpp"
#include "base/vec.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::viewing_steps_test {
namespace {

Outcome answer(const std::vector<std::string>& arguments) { return epura(arguments, std::filesystem::current_path()); }

Json steps_of(const std::string& projection, const std::string& model, const std::string& vertex) {
  const Outcome run = answer({"plugins", projection, "--model", model, "--trace", vertex, "--notation", "json"});
  EXPECT_EQ(run.code, 0) << projection << ": " << run.err;
  return JsonReader(run.out).read();
}

TEST(ViewingSteps, OfAllProjectionsLeadToTheDrawing) {
  const std::vector<std::string> names = built_in_projections();
  EXPECT_GE(names.size(), 20U);
  for (const std::string& name : names)
    for (const char* vertex : {"0", "37"}) {
      const Json json = steps_of(name, sample("bracket.obj"), vertex);
      EXPECT_LT(json["trace"]["residue"].number(), 1e-9) << name << ", vertex " << vertex;
      EXPECT_EQ(json["steps"].items.size(), json["central"].type == 't' ? 4U : 3U) << name;
    }
}

TEST(ViewingSteps, NormaliseTheWindow) {
  // In normalised coordinates, the scene is in the unit cube, or in the pyramid with the apex (1/2, 1/2, 1).
  for (const char* name : {"isometric", "cabinet", "two-point"})
    for (int vertex = 0; vertex < 8; ++vertex) {
      const Json json = steps_of(name, sample("bracket.obj"), std::to_string(vertex));
      const Json& at = json["trace"]["after"].items.at(1);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(at.items.at(i).number(), -1e-9) << name;
        EXPECT_LT(at.items.at(i).number(), 1 + 1e-9) << name;
      }
    }
}

TEST(ViewingSteps, AreWrittenInEveryNotation) {
  const std::string text =
      answer({"plugins", "cabinet:angle=30", "--model", sample("bracket.obj"), "--trace", "1"}).out;
  for (const char* word :
       {"cabinet:angle=30", "VRP", "M_par (3.20)", "VOM (3.36)", "N_par (3.48)", "M_wv (3.63)", "Vertex 1", "drawn at"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  const std::string latex =
      answer({"plugins", "three-point", "--model", sample("bracket.obj"), "--notation", "latex", "--trace", "1"}).out;
  for (const char* word : {"\\[ \\mathrm{VOM} = \\begin{pmatrix}", "N_{\\mathrm{per}}", "% 5. ", "\\tag{3.60}",
                           "\\cdot10^{-", "P_{2} = N_{\\mathrm{per}}\\,P_{1} = (", "\\mathrm{residue} = "})
    EXPECT_NE(latex.find(word), std::string::npos) << word;
}

TEST(ViewingSteps, RefuseWhatIsNotThere) {
  const auto refusal = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "plugins");
    const Outcome run = answer(arguments);
    EXPECT_EQ(run.code, 2);
    return run.err;
  };
  EXPECT_NE(refusal({"isometric", "--trace", "1"}).find("name its file with --model"), std::string::npos);
  EXPECT_NE(refusal({"--model", sample("bracket.obj")}).find("needs a projection"), std::string::npos);
  EXPECT_NE(refusal({"isometric", "--model", sample("bracket.obj"), "--trace", "99999"}).find("has no vertex 99999"),
            std::string::npos);
}

}  // namespace
}  // namespace epura::test::viewing_steps_test
