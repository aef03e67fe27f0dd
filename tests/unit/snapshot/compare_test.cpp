// SPDX-License-Identifier: Apache-2.0
// epura compare, as users run it.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::compare_test {
namespace {

// The bracket with and without its hidden lines.
struct Drawn {
  Folder folder;

  Drawn() {
    draw({"--hidden", "dashed", "-o", "a.json", "-o", "a.svg"});
    draw({"--hidden", "none", "-o", "b.json", "-o", "b.svg"});
  }

  void draw(std::vector<std::string> options) const {
    options.insert(options.begin(), {"draw", sample("bracket.obj")});
    ASSERT_EQ(epura(options, folder / "").code, 0);
  }
  [[nodiscard]] Outcome compare(std::vector<std::string> options) const {
    options.insert(options.begin(), "compare");
    return epura(options, folder / "");
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder / name); }
};

TEST(CompareCommand, ExitCodeTellsWhetherThereAreDifferences) {
  const Drawn drawn;
  for (const std::string extension : {".json", ".svg"}) {
    const Outcome same = drawn.compare({"a" + extension, "a" + extension});
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.out, "no differences above 0.001 mm\n");
    const Outcome different = drawn.compare({"a" + extension, "b" + extension});
    EXPECT_EQ(different.code, 1);
    EXPECT_TRUE(contains(different.out, "removed    isometric: hidden line")) << different.out;
    EXPECT_TRUE(contains(different.out, "8 differences above 0.001 mm: 8 removed")) << different.out;
    EXPECT_EQ(different.err, "");
  }
}

// The bracket with its right side 10 mm farther out.
std::string wider_bracket() {
  std::string text = read_file(sample("bracket.obj"));
  for (std::size_t at = 0; (at = text.find("\nv 80 ", at)) != std::string::npos; at += 6)
    text.replace(at, 6, "\nv 90 ");
  return text;
}

TEST(CompareCommand, DrawsModelsToOneScaleAndInOnePlace) {
  const Drawn drawn;
  drawn.folder.file("wider.obj", wider_bracket());
  EXPECT_EQ(drawn.compare({sample("bracket.obj"), sample("bracket.obj"), "--views", "front,top,isometric"}).out,
            "no differences above 0.001 mm\n");
  const Outcome run =
      drawn.compare({sample("bracket.obj"), "wider.obj", "--views", "front,top,isometric", "--json", "-"});
  EXPECT_EQ(run.code, 1);
  // Only the right side differs, though the larger part would be drawn smaller and farther left on its own sheet.
  const Json json = JsonReader(run.out).read();
  int in_front = 0;
  for (const Json& difference : json["differences"].items) in_front += difference["view"].text == "front" ? 1 : 0;
  EXPECT_EQ(in_front, 5) << run.out;
  for (const char* drawing : {"b.json", "b.svg"})
    EXPECT_EQ(drawn.compare({drawing, sample("bracket.obj")}).code, 0) << "a drawing, and what it was made from";
}

TEST(CompareCommand, DrawsScenes) {
  const Drawn drawn;
  drawn.folder.file("wider.obj", wider_bracket());
  drawn.folder.file("one.toml", "[[model]]\nfile = \"" + sample("bracket.obj") + "\"\n");
  drawn.folder.file("two.toml", "[[model]]\nfile = \"wider.obj\"\n");
  EXPECT_EQ(drawn.compare({"one.toml", "one.toml", "--allow-outside"}).code, 0);
  EXPECT_EQ(drawn.compare({"one.toml", "two.toml", "--allow-outside"}).code, 1);
  const Outcome missing = drawn.compare({"one.toml", "three.toml", "--allow-outside"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(contains(missing.err, "three.toml: cannot read")) << missing.err;
}

TEST(CompareCommand, ChainingAndLetteringDoNotCount) {
  const Drawn drawn;
  drawn.draw({"--hidden", "dashed", "--plain", "--svg-text", "text", "-o", "c.svg"});
  EXPECT_EQ(drawn.compare({"a.svg", "c.svg"}).code, 0);
}

TEST(CompareCommand, WritesWhatDiffers) {
  const Drawn drawn;
  const Outcome run = drawn.compare({"a.svg", "b.svg", "--json", "-"});
  const Json json = JsonReader(run.out).read();
  EXPECT_EQ(json["counts"]["removed"].text, "8");
  EXPECT_EQ(json["differences"].items.size(), 8U);
  EXPECT_EQ(json["differences"].items[0]["of"].text, "line");
  for (const std::string name : {"o.svg", "o.png", "o.html"})
    EXPECT_EQ(drawn.compare({"a.svg", "b.svg", "--overlay", name}).code, 1);
  EXPECT_TRUE(contains(drawn.read("o.svg"), "stroke=\"#cd0000\""));
  EXPECT_TRUE(drawn.read("o.png").starts_with("\x89PNG"));
  EXPECT_TRUE(contains(drawn.read("o.html"), "\"title\":\"Differences\""));
  EXPECT_TRUE(contains(drawn.read("o.html"), "8 removed"));
}

TEST(CompareCommand, RefusesWhatItCannotCompare) {
  const Drawn drawn;
  const auto refused = [&](const std::vector<std::string>& options, const std::string& reason) {
    const Outcome run = drawn.compare(options);
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, reason)) << run.err;
  };
  refused({"a.json", "a.svg"}, "drawing JSON has views without their sheet");
  refused({"a.json", "none.json"}, "none.json");
  refused({"a.json", "a.obj"}, "a.obj: cannot read");
  refused({"a.json", "b.json", "--overlay", "x.json"}, "is not a picture");
  refused({"a.json", "b.json", "--tolerance", "wide"}, "--tolerance");
}

}  // namespace
}  // namespace epura::test::compare_test
