// SPDX-License-Identifier: Apache-2.0
// Files of strangers that promise more than they hold, or nest without end: each is refused with a sentence, before it
// has taken more memory than 64 times its size and 256 MB.
#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::hostile_files_test {
namespace {

struct Repeated {
  Repeated(std::string unit, int count = 1) : text(std::move(unit)), times(count) {}
  std::string text;
  int times;
};
/// Written out where it is needed: any test of this program lists the files, and some have megabytes.
using Content = std::vector<Repeated>;

std::string written_out(const Content& content) {
  std::string all;
  for (const Repeated& part : content) {
    for (int i = 0; i < part.times; ++i) all += part.text;
  }
  return all;
}

/// As float32, least significant byte first.
const std::string zeros(48, '\0'), huge_count = "\xff\xff\xff\xff";

std::string ply(const std::string& header, const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + body;
}

std::string gltf(const std::string& rest) {
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
         rest + "}";
}

enum class Use { model_or_scene, drawing, form };

struct HostileFile {
  const char* name;
  Content content;
  Use use = Use::model_or_scene;
};
void PrintTo(const HostileFile& file, std::ostream* out) { *out << file.name; }

constexpr int deep = 1000000;

std::vector<HostileFile> hostile_files() {
  const std::string position = "property float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uint int vertex_indices\n";
  const Content groups = {
      {"<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'>"}, {"<g>", deep}, {"</g>", deep}, {"</svg>"}};
  return {
      {"vertices.ply", {{ply("element vertex 4000000000\n" + position, zeros)}}},
      {"faces.ply",
       {{ply("element vertex 3\n" + position + "element face 4000000000\nproperty list uchar int vertex_indices\n",
             zeros)}}},
      {"corners.ply", {{ply("element vertex 3\n" + position + face, zeros.substr(0, 36) + huge_count + zeros)}}},
      {"text.ply", {{"ply\nformat ascii 1.0\nelement vertex 999999999999\n" + position + "end_header\n0 0 0\n"}}},
      {"triangles.stl", {{std::string(80, ' ') + huge_count + zeros}}},
      {"counts.off", {{"OFF\n2000000000 2000000000 0\n0 0 0\n"}}},
      {"corners.off", {{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"}}},
      {"index.obj", {{"v 0 0 0\nv 1 0 0\nf 1 2 2000000000\n"}}},
      {"digits.obj", {{"v 0 0 "}, {"1", deep}, {"\n"}}},
      {"corners.obj", {{"v 0 0 0\nf"}, {" 2", deep}, {"\n"}}},
      {"nested.gltf", {{"[", deep}}},
      {"accessor.gltf", {{gltf(R"("accessors":[{"count":4000000000,"componentType":5126,"type":"VEC3"}])")}}},
      {"sparse.gltf",
       {{gltf(R"("accessors":[{"count":1000000000,"componentType":5126,"type":"VEC3","sparse":{"count":1,)"
              R"("indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":0}}}],)"
              R"("bufferViews":[{"buffer":0,"byteLength":4}],"buffers":[{"byteLength":4,)"
              R"("uri":"data:application/octet-stream;base64,AAAAAA=="}])")}}},
      {"buffer.gltf",
       {{gltf(R"("buffers":[{"byteLength":4000000000,"uri":"data:application/octet-stream;base64,AAAA"}])")}}},
      {"nested.step",
       {{"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=A("}, {"(", deep}, {";\nENDSEC;\nEND-ISO-10303-21;\n"}}},
      {"counts.brep", {{"CASCADE Topology V1, (c) Matra-Datavision\nLocations 2000000000\n1\n"}}},
      {"nested.toml", {{"a = "}, {"[", deep}}},
      {"tables.toml", {{"[", deep}}},
      {"keys.toml", {{"a"}, {".a", deep}, {" = 1\n"}}},
      {"nested.json", {{"[", deep}}, Use::drawing},
      {"objects.json", {{"{\"a\":", deep}}, Use::drawing},
      {"nested.svg", {{"<svg xmlns='http://www.w3.org/2000/svg'>"}, {"<g>", deep}}, Use::drawing},
      {"entities.svg",
       {{"<!DOCTYPE svg [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;'>"
         "<!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;'><!ENTITY d '&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;'>"
         "<!ENTITY e '&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;'><!ENTITY f '&e;&e;&e;&e;&e;&e;&e;&e;&e;&e;'>]>"
         "<svg xmlns='http://www.w3.org/2000/svg'><text>&f;&f;&f;&f;&f;&f;&f;&f;&f;&f;</text></svg>"}},
       Use::drawing},
      {"groups.svg", groups, Use::drawing},
      {"groups_in.svg", groups, Use::form},
      {"texts_in.svg",
       {{"<svg width='9mm' height='9mm'><text font-size='3'>"},
        {"<tspan>", deep},
        {"</tspan>", deep},
        {"</text></svg>"}},
       Use::form},
      {"nested.pdf", {{"%PDF-1.7\n1 0 obj\n"}, {"[", deep}, {"\nendobj\ntrailer<</Root 1 0 R>>\n"}}, Use::drawing},
  };
}

class Hostile : public testing::TestWithParam<HostileFile> {};
INSTANTIATE_TEST_SUITE_P(Files, Hostile, testing::ValuesIn(hostile_files()), [](const auto& file) {
  std::string name = file.param.name;
  name[name.find('.')] = '_';
  return name;
});

TEST_P(Hostile, IsRefusedBeforeItTakesMemory) {
  const Folder folder;
  const std::string content = written_out(GetParam().content), file = folder.file(GetParam().name, content);
  const std::vector<std::string> words =
      GetParam().use == Use::drawing ? std::vector<std::string>{"compare", file, file}
      : GetParam().use == Use::form
          ? std::vector<std::string>{"draw", EPURA_TEST_SAMPLES "/models/bracket.obj", "--template", file, "-o",
                                     "x.svg"}
          : std::vector<std::string>{"draw", file, "-o", "x.svg"};
  const Outcome run = epura(words, folder / "");
  EXPECT_TRUE(run.code == 2 || run.code == 3) << run.code << run.out << run.err;
  EXPECT_TRUE(contains(run.err, GetParam().name)) << run.err;
  EXPECT_FALSE(contains(run.err, "internal error") || contains(run.err, "crashes")) << run.err;
  EXPECT_LT(run.err.size(), 2000U);
  EXPECT_LE(run.megabytes, 256 + 64 * static_cast<double>(content.size()) / 1e6);
}

/// No character that a terminal obeys.
void expect_shown(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool is_control = (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f ||
                            (c == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0);
    ASSERT_FALSE(is_control) << "byte " << i << " of " << text.size() << ": " << static_cast<int>(c);
  }
}

class OnATerminal : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Commands, OnATerminal,
                         testing::Values("info", "draw --projection front --why @100,100",
                                         "draw --projection front --dump edges",
                                         "draw --projection front -o a.svg --parts-list", "draw -o a.unknown",
                                         "draw --projection unknown -o a.svg", "explain --projection front",
                                         "lint --views front", "batch -o {name}.svg"));

TEST_P(OnATerminal, NamesOfFilesBodiesAndKeysAreShownNotObeyed) {
  const Folder folder;
  const std::string attack =
      "\x1b[2J\x1b]0;x\a\b\xC2\x9B"
      "31m";
  folder.file("a" + attack + ".obj",
              "o " + attack + "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  folder.file("b" + attack + ".toml", "[[model]]\nfile = \"a.obj\"\n\"\\u001b[2J\" = 1\n");
  folder.file("c" + attack + ".obj", "v 0 0 " + attack + "\n");
  for (const char* name : {"a", "b", "c", "missing"}) {
    std::vector<std::string> words;
    std::istringstream command(GetParam());
    for (std::string word; command >> word;) words.push_back(word);
    words.push_back(name + attack + (name[0] == 'b' ? ".toml" : ".obj"));
    const Outcome run = epura(words, folder / "");
    expect_shown(run.out);
    expect_shown(run.err);
    EXPECT_FALSE(run.out.empty() && run.err.empty() && run.code != 0);
  }
}

}  // namespace
}  // namespace epura::test::hostile_files_test
