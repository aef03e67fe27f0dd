// SPDX-License-Identifier: Apache-2.0
// epura info, as users run it.
#include <gtest/gtest.h>

#include <array>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::info_test {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 3 4\nf 1 1 2\n";

Outcome info(std::vector<std::string> options, const Folder& folder) {
  options.insert(options.begin(), "info");
  return epura(options, folder / "");
}

TEST(InfoCommand, TellsWhatAPartIs) {
  const Outcome run = info({sample("bracket.obj")}, Folder());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* words :
       {"bracket.obj\n", "OBJ, rounded to 1e-06, 584 vertices, 896 faces, 1184 triangles\n",
        "80 x 70 x 75, from (0, 0, 0) to (80, 70, 75)\n", "not in the file; probably mm\n", "1, closed\n",
        "20; 100 % of the area is recognised\n", "12 planes; face 1 to 12\n",
        "8 cylinders: R 3.5 (2), R 5.5 (4), R 12, R 13; face 13 to 20\n",
        "hole 2: \u00d826, through, 10 long, along y, from (40, 70, 48)\n",
        "hole 1, 3: 2 x \u00d87, through, 10 long, along y, from (14, 70, 62), (66, 70, 62)\n", "repairs   none\n"})
    EXPECT_TRUE(contains(run.out, words)) << words << "\n" << run.out;
}

TEST(InfoCommand, ShowsThePartsOfAnAssembly) {
  const Folder folder;
  const std::string node = "{\"name\": \"";
  folder.file("a.gltf",
              "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [0]}], \"scene\": 0, \"nodes\": [" + node +
                  "stand\", \"children\": [1, 2, 3]}, " + node + "leg\", \"mesh\": 0}, " + node +
                  "leg\", \"mesh\": 0, \"translation\": [1, 0, 0]}, " + node +
                  "top\", \"mesh\": 0, \"translation\": [0, 1, 0]}], \"meshes\": [{\"primitives\": [{\"attributes\": "
                  "{\"POSITION\": 0}}]}], \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, "
                  "\"type\": \"VEC3\"}], \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}], \"buffers\": "
                  "[{\"byteLength\": 36, \"uri\": \"data:application/octet-stream;base64,"
                  "AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MzD0AAAAA\"}]}");
  const Outcome run = info({"a.gltf", "--json", "a.json"}, folder);
  if (contains(run.err, "install the package epura-gltf")) GTEST_SKIP() << "there is no importer of glTF";
  EXPECT_TRUE(contains(run.out, "  parts     stand\n              leg x 2\n              top\n")) << run.out << run.err;
  const Json part = JsonReader(read_file(folder / "a.json")).read()["models"].items[0];
  EXPECT_EQ(part["body_names"].items.size(), 3U);
  EXPECT_EQ(part["parts"].items[0]["name"].text, "stand");
  EXPECT_EQ(part["parts"].items[0]["parts"].items.size(), 3U);
}

TEST(InfoCommand, OfASurfaceThatIsNoPartItTellsTheRest) {
  const Outcome run = info({sample("sombrero.obj")}, Folder());
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.out, "open: 192 edges with one face")) << run.out;
  EXPECT_TRUE(contains(run.out, "no surfaces of a part recognised")) << run.out;
  EXPECT_FALSE(contains(run.out, "holes")) << run.out;
}

// As kernels write the corner of a body that was turned.
TEST(InfoCommand, WhatIsFarBelowThePrecisionOfTheFileIsNothing) {
  const Folder folder;
  folder.file("a.obj", "v -8.881784197001252e-16 0 1e-15\nv 1 0 0\nv 0.12345678901234567 1 0\nf 1 2 3\n");
  const Outcome run = info({"a.obj"}, folder);
  EXPECT_TRUE(contains(run.out, "from (0, 0, 0) to (1, 1, 0)")) << run.out;
}

TEST(InfoCommand, TellsRepairs) {
  const Folder folder;
  folder.file("square.obj", square);
  const Outcome run = info({"square.obj"}, folder);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "1 face without area left out\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "1 duplicate face left out\n")) << run.out;
}

// Two cubes with a common edge: four faces meet there, two of each body, and none ends.
TEST(InfoCommand, EdgesWhereBodiesTouchAreNotOpen) {
  const Folder folder;
  std::string obj;
  for (const int at : {0, 1})
    for (int i = 0; i < 8; ++i)
      obj +=
          "v " + std::to_string(at + i % 2) + " " + std::to_string(at + i / 2 % 2) + " " + std::to_string(i / 4) + "\n";
  for (const int first : {1, 9})
    for (const auto& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                             std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
      obj += "f";
      for (const int v : face) obj += " " + std::to_string(first + v);
      obj += "\n";
    }
  folder.file("cubes.obj", obj);
  const Outcome run = info({"cubes.obj", "--json", "x.json"}, folder);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "bodies    2, closed")) << run.out;
  EXPECT_TRUE(contains(run.out, "23 sharp, 0 tangent\n")) << run.out;
  const Json edges = JsonReader(read_file(folder / "x.json")).read()["models"].items[0]["part_edges"];
  EXPECT_EQ(edges["open"].text, "0");
  EXPECT_EQ(edges["shared"].text, "0");
}

TEST(InfoCommand, EdgesOfThreeFacesAreNotOpen) {
  const Folder folder;
  folder.file("book.obj",
              "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\n"
              "f 1 2 4 3\nf 1 2 6 5\nf 1 2 8 7\n");
  const Outcome run = info({"book.obj", "--json", "x.json"}, folder);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "0 sharp, 0 tangent, 3 open, 1 of three or more faces\n")) << run.out;
  const Json edges = JsonReader(read_file(folder / "x.json")).read()["models"].items[0]["part_edges"];
  EXPECT_EQ(edges["open"].text, "3");
  EXPECT_EQ(edges["shared"].text, "1");
}

TEST(InfoCommand, JsonHasTheSameForSeveralModels) {
  const Outcome run = info({sample("bracket.obj"), sample("flange.obj"), "--json", "-"}, Folder());
  EXPECT_EQ(run.code, 0) << run.err;
  const Json json = JsonReader(run.out).read();
  EXPECT_EQ(json["epura_info"].text, "1");
  ASSERT_EQ(json["models"].items.size(), 2U);
  const Json& bracket = json["models"].items[0];
  EXPECT_EQ(bracket["unit"].text, "mm");
  EXPECT_EQ(bracket["part_faces"].items.size(), 20U);
  EXPECT_EQ(bracket["part_edges"]["sharp"].text, "41");
  EXPECT_EQ(bracket["box"]["max"].items[2].text, "75");
  const Json& flange = json["models"].items[1];
  ASSERT_EQ(flange["holes"].items.size(), 9U);
  EXPECT_EQ(flange["holes"].items[0]["through"].type, 't');
  EXPECT_NEAR(std::stod(flange["holes"].items[0]["diameters"].items[0].text), 82.5, 1e-4);
}

TEST(InfoCommand, JsonGoesToAFile) {
  const Folder folder;
  const Outcome run = info({sample("bracket.obj"), "--json", "part.json"}, folder);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "12 planes")) << run.out;
  EXPECT_EQ(JsonReader(read_file(folder / "part.json")).read()["models"].items.size(), 1U);
}

TEST(InfoCommand, RefusesWhatItCannotRead) {
  const Folder folder;
  EXPECT_EQ(info({"missing.stl"}, folder).code, 2);
  EXPECT_EQ(info({}, folder).code, 2);
  folder.file("broken.obj", "v 0 0\n");
  const Outcome broken = info({"broken.obj"}, folder);
  EXPECT_EQ(broken.code, 2);
  EXPECT_TRUE(contains(broken.err, "broken.obj:1")) << broken.err;
  folder.file("cube.obj", read_file(sample("bracket.obj")));
  const Outcome over = info({"cube.obj", "--json", "cube.obj"}, folder);
  EXPECT_EQ(over.code, 2);
  EXPECT_EQ(read_file(folder / "cube.obj"), read_file(sample("bracket.obj")));
}

}  // namespace
}  // namespace epura::test::info_test
