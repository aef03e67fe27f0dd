// SPDX-License-Identifier: Apache-2.0
// `epura describe`: sentences that are true of the sheet, and where else they are told.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/file.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::describe_test {
namespace {

// 30 x 20 x 10
const char* const box =
    "v 0 0 0\nv 30 0 0\nv 30 20 0\nv 0 20 0\nv 0 0 10\nv 30 0 10\nv 30 20 10\nv 0 20 10\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Describe : public testing::Test {
 protected:
  Outcome describe(const std::string& model, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"describe", model};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }
  std::string box_described(const std::vector<std::string>& more) {
    const Outcome run = describe(folder_.file("box.obj", box), more);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  }

  Folder folder_;
};

TEST_F(Describe, SaysWhatABoxIs) {
  EXPECT_EQ(box_described({"--views", "front,isometric", "--sheet", "A4", "--scale", "1:1", "--title", "Box",
                           "--dimensions", "overall"}),
            "The sheet \"Box\" shows a part.\n"
            "Overall size: 30 × 20 × 10 mm (width × depth × height).\n"
            "Faces: 6 plane.\n"
            "Views: front 1:1; isometric 1:1.\n"
            "Written on it: dimensions: 2.\n"
            "Views without hidden lines: front, isometric.\n");
}

TEST_F(Describe, SpeaksTheLanguageOfTheSheet) {
  const std::vector<std::string> words{"--views", "front",      "--sheet", "A4",        "--scale",
                                       "1:1",     "--material", "S235",    "--language"};
  const auto in = [&](const char* language) {
    std::vector<std::string> all = words;
    all.push_back(language);
    return box_described(all);
  };
  EXPECT_EQ(in("de"),
            "Das Blatt zeigt ein Teil.\nGesamtmaße: 30 × 20 × 10 mm (Breite × Tiefe × Höhe).\nFlächen: 6 eben.\n"
            "Werkstoff S235.\nAnsichten: Vorderansicht 1:1.\nAnsichten ohne verdeckte Kanten: Vorderansicht.\n");
  EXPECT_EQ(in("fr-CA").substr(0, 30), "La feuille montre une pièce.\n");
  EXPECT_EQ(in("ja").substr(0, 24), "The sheet shows a part.\n");
}

TEST_F(Describe, CountsWhatDimensionsMeasure) {
  // samples/make/parts_machine.cpp: a flange with a bore and eight holes.
  const Outcome run = describe(sample("flange.obj"), {"--views", "top"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "8 × diameter")) << run.out;
}

TEST_F(Describe, TellsOfAnAssemblyAndOfOpenModels) {
  const std::string two = std::string("o left\n") + box + "o right\nv 50 0 0\nv 60 0 0\nv 50 5 0\nv 50 0 5\n" +
                          "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n";
  const Outcome assembly = describe(folder_.file("two.obj", two), {"--views", "front"});
  EXPECT_EQ(assembly.out.substr(0, 42), "The sheet shows an assembly of 2 bodies.\nO") << assembly.err;
  EXPECT_TRUE(contains(assembly.out, "Parts: left; right.\n")) << assembly.out;
  const Outcome open = describe(folder_.file("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), {"--views", "top"});
  EXPECT_EQ(open.out.substr(0, 42), "The sheet shows a model with open edges.\nO") << open.err;
}

TEST_F(Describe, IsToldByFilesForScreenReaders) {
  const std::vector<std::string> words{"--views", "front,top", "--dimensions", "auto", "--title", "Bracket"};
  const Outcome told = describe(sample("bracket.obj"), words);
  const auto sentences = split(std::string_view(told.out).substr(0, told.out.size() - 1), '\n');
  EXPECT_GE(sentences.size(), 6U);
  EXPECT_LE(sentences.size(), 12U);
  std::string text;
  for (const std::string_view sentence : sentences) text += (text.empty() ? "" : " ") + std::string(sentence);
  std::vector<std::string> draw{"draw", sample("bracket.obj"), "--svg", "accessible", "-o", "bracket.svg"};
  draw.insert(draw.end(), words.begin(), words.end());
  EXPECT_EQ(epura(draw, folder_ / "").code, 0);
  const std::string svg = read_file(folder_ / "bracket.svg");
  std::string escaped;
  for (const char c : text) escaped += c == '"' ? "&quot;" : std::string(1, c);
  EXPECT_TRUE(contains(svg, ">" + text + "</desc>") || contains(svg, ">" + escaped + "</desc>")) << text;
  EXPECT_TRUE(contains(svg, "<desc lang=\"de\">Das Blatt"));
  EXPECT_TRUE(contains(svg, "<desc lang=\"fr\">La feuille"));
  EXPECT_TRUE(contains(svg, " aria-label=\"2 × hole, diameter")) << "a feature has its lines";
}

TEST_F(Describe, DrawsTheSameInkForScreenReaders) {
  for (const char* kind : {"usual", "accessible"})
    EXPECT_EQ(epura({"draw", sample("bracket.obj"), "--views", "front,top", "--dimensions", "auto", "--svg", kind, "-o",
                     std::string(kind) + ".svg"},
                    folder_ / "")
                  .code,
              0);
  const Outcome run = epura({"compare", "usual.svg", "accessible.svg"}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Outcome plain =
      epura({"draw", sample("bracket.obj"), "--svg", "accessible", "--plain", "-o", "plain.svg"}, folder_ / "");
  EXPECT_EQ(plain.code, 2);
  EXPECT_TRUE(contains(plain.err, "--svg accessible")) << plain.err;
}

}  // namespace
}  // namespace epura::test::describe_test
