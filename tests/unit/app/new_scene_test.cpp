// SPDX-License-Identifier: Apache-2.0
// epura new-scene: what it writes is drawn, also with all its proposals.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::new_scene_test {
namespace {

/// A scene file without the marks before its proposals.
std::string with_proposals(const std::string& scene) {
  std::string text;
  for (std::string_view line : split(scene, '\n')) {
    if (line.starts_with('#') && !line.starts_with("# ")) line.remove_prefix(1);
    text.append(line).append("\n");
  }
  return text;
}

TEST(NewScene, IsDrawnAsItIsAndWithAllItsProposals) {
  const Folder folder;
  std::filesystem::copy(sample("flange.obj"), folder / "flange.obj");
  const Outcome made = epura({"new-scene", "flange.obj"}, folder / "");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "epura draw flange.toml -o flange.pdf")) << made.out;
  const std::string scene = read_file(folder / "flange.toml");
  EXPECT_TRUE(contains(scene, "# hole 1 to 4, 6 to 9: 8 x Ø18, through, along z, the first one from [")) << scene;
  EXPECT_TRUE(contains(scene, "file = \"flange.obj\"")) << scene;
  const Outcome drawn = epura({"draw", "flange.toml", "-o", "a.svg"}, folder / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  write_file(folder / "all.toml", with_proposals(scene));
  const Outcome all = epura({"draw", "all.toml", "-o", "all.svg"}, folder / "");
  EXPECT_EQ(all.code, 0) << all.err << read_file(folder / "all.toml");
}

TEST(NewScene, NeverOverwritesNorNamesWhatASceneMayNot) {
  const Folder folder;
  std::filesystem::create_directory(folder / "in");
  std::filesystem::copy(sample("bracket.obj"), folder / "in/bracket.obj");
  EXPECT_EQ(epura({"new-scene", "in/bracket.obj", "-o", "scene.toml"}, folder / "").code, 0);
  EXPECT_TRUE(contains(read_file(folder / "scene.toml"), "file = \"in/bracket.obj\""));
  const Outcome again = epura({"new-scene", "in/bracket.obj", "-o", "scene.toml"}, folder / "");
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(contains(again.err, "scene.toml: exists already")) << again.err;
  const Outcome outside = epura({"new-scene", "../scene.toml", "-o", "x.toml"}, folder / "in");
  EXPECT_EQ(outside.code, 2);
  EXPECT_TRUE(contains(outside.err, "below its own folder")) << outside.err;
}

// Its positions are along its own axes, in the place where it is drawn.
TEST(NewScene, TurnsAPartThatLiesAskew) {
  const Folder folder;
  const std::string straight = plates()[0].obj;
  folder.file("straight.obj", straight);
  folder.file("turned.obj", turned_about_z(straight, -27));
  for (const char* name : {"straight", "turned"}) {
    const std::string model = std::string(name) + ".obj";
    ASSERT_EQ(epura({"new-scene", model}, folder / "").code, 0);
    const std::string scene = read_file(folder / (std::string(name) + ".toml"));
    EXPECT_EQ(contains(scene, "\ntransform = \"rotate:z,27\"\n"), name == std::string("turned")) << scene;
    EXPECT_TRUE(contains(scene, ", through, along z")) << scene;
    const Outcome drawn = epura({"lint", std::string(name) + ".toml", "-o", std::string(name) + ".svg"}, folder / "");
    EXPECT_EQ(drawn.code, 0) << drawn.out << drawn.err;
  }
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "turned.svg"))),
            sorted(dimensions_in(read_file(folder / "straight.svg"))));
}

}  // namespace
}  // namespace epura::test::new_scene_test
