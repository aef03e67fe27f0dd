// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: which reader a file gets, what a user is told, and every number in some locales.
#include <locale>

#include "support.hpp"

namespace epura::read_test {
namespace {

using test::Folder;
using test::words_of_error;

const std::string triangle_obj = "v 0 0 0\nv 1.5 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string triangle_off = "OFF\n3 1 0\n0 0 0\n1.5 0 0\n0 1 0\n3 0 1 2\n";
const std::string triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1.5 0 0\n0 1 0\n3 0 1 2\n";
const std::string triangle_stl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1.5 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "t\n";

void expect_triangle(const mesh::Mesh& mesh, const std::string& format) {
  test::expect_valid(mesh);
  EXPECT_EQ(mesh.report.format, format);
  ASSERT_EQ(mesh.report.triangles, 1);
  EXPECT_EQ(mesh.point(1), Vec3(1.5, 0, 0));
}

std::string utf16(const std::string& text, std::endian order) {
  std::string bytes;
  test::append(bytes, std::uint16_t{0xFEFF}, order);
  for (const char c : text) test::append(bytes, static_cast<std::uint16_t>(c), order);
  return bytes;
}

TEST(ReadMesh, EveryFormatInEveryEncoding) {
  const Folder folder;
  for (const auto& [format, text] :
       {std::pair{"obj", triangle_obj}, {"off", triangle_off}, {"ply", triangle_ply}, {"stl", triangle_stl}}) {
    const std::string name = std::string("m.") + format;
    expect_triangle(mesh::read_mesh(folder.file(name, text)), format);
    expect_triangle(mesh::read_mesh(folder.file(name, "\xEF\xBB\xBF" + text)), format);
    expect_triangle(mesh::read_mesh(folder.file(name, utf16(text, std::endian::little))), format);
    expect_triangle(mesh::read_mesh(folder.file(name, utf16(text, std::endian::big))), format);
  }
}

TEST(ReadMesh, NamesInUtf16BecomeUtf8) {
  const Folder folder;
  std::string bytes = utf16("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no a\nf 1 2 3\no ", std::endian::little);
  for (const int unit : {0xC9, 0x20AC, 0xD83D, 0xDE00, 0xDC00}) test::append(bytes, static_cast<std::uint16_t>(unit));
  for (const char c : std::string("\nf 1 2 4\n")) test::append(bytes, static_cast<std::uint16_t>(c));
  const mesh::Mesh mesh = mesh::read_mesh(folder.file("m.obj", bytes));
  EXPECT_EQ(mesh.report.body_names,
            (std::vector<std::string>{"a", "\xC3\x89\xE2\x82\xAC\xF0\x9F\x98\x80\xEF\xBF\xBD"}));
}

TEST(ReadMesh, ContentWinsOverTheExtension) {
  const Folder folder;
  const mesh::Mesh mesh = mesh::read_mesh(folder.file("m.obj", triangle_ply));
  expect_triangle(mesh, "ply");
  EXPECT_EQ(mesh.report.notes, (std::vector<std::string>{"the file is named .obj, but holds ply"}));
  expect_triangle(mesh::read_mesh(folder.file("m.ply", triangle_off)), "off");
  expect_triangle(mesh::read_mesh(folder.file("m.off", triangle_stl)), "stl");
  const mesh::Mesh unnamed = mesh::read_mesh(folder.file("m.dat", triangle_stl));
  EXPECT_TRUE(unnamed.report.notes.empty());
  const std::string binary = test::binary_stl({{{{{0, 0, 0}}, {{1.5, 0, 0}}, {{0, 1, 0}}}}}, "solid");
  expect_triangle(mesh::read_mesh(folder.file("m", binary)), "stl");
  expect_triangle(mesh::read_mesh(folder.file("m.OBJ", triangle_obj)), "obj");
}

TEST(ReadMesh, ObjIsReadWhateverItsName) {
  const Folder folder;
  for (const char* name : {"m.stl", "m.ply", "m.off"}) {
    const mesh::Mesh mesh = mesh::read_mesh(folder.file(name, "# a comment\n" + triangle_obj));
    expect_triangle(mesh, "obj");
    EXPECT_EQ(mesh.report.notes.size(), 1U) << name;
  }
  std::string cut = test::binary_stl({{{{{0, 0, 0}}, {{1.5, 0, 0}}, {{0, 1, 0}}}}}, "v of a binary file");
  cut.pop_back();
  EXPECT_NE(words_of_error([&] { mesh::read_mesh(folder.file("m.stl", cut)); }).find("the file ends at triangle"),
            std::string::npos);
}

TEST(ReadMesh, FormsThatAreSoundThoughUnusual) {
  const Folder folder;
  const std::string one_line = "OFF3 1 0" + triangle_off.substr(triangle_off.find("\n0 0 0"));
  for (const char* name : {"m.off", "m.dat"}) expect_triangle(mesh::read_mesh(folder.file(name, one_line)), "off");
  const std::string facets = triangle_stl.substr(triangle_stl.find("facet"), triangle_stl.find("endsolid") - 8);
  for (const std::string& text : {facets, " \nFACET" + facets.substr(5), "# c\n" + facets})
    for (const char* name : {"m.stl", "m.dat"}) expect_triangle(mesh::read_mesh(folder.file(name, text)), "stl");
}

TEST(ReadMesh, FacesThatCollapseOpenNothing) {
  const Folder folder;
  std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  for (const auto& quad : test::cube_quads)
    for (const int last : {2, 3})
      cube += "f " + std::to_string(quad[0] + 1) + " " + std::to_string(quad[last - 1] + 1) + " " +
              std::to_string(quad[last] + 1) + "\n";
  const mesh::MeshReport report = mesh::read_mesh(folder.file("m.obj", cube + "f 1 1 2\nf 3 4 3 4\n")).report;
  EXPECT_EQ(report.dropped_degenerate, 2);
  EXPECT_EQ(report.open_edges + report.non_manifold_edges + report.misoriented_edges, 0);
}

TEST(ReadMesh, ErrorsNameTheFileAndTheReason) {
  const Folder folder;
  const auto error = [&](const std::string& name, const std::string& bytes) {
    const std::string path = folder.file(name, bytes);
    std::string text = words_of_error([&] { mesh::read_mesh(path); });
    for (std::size_t at; (at = text.find(path)) != std::string::npos;) text.replace(at, path.size(), "FILE");
    return text;
  };
  EXPECT_EQ(error("m.obj", ""), "FILE | FILE: is empty | ");
  EXPECT_EQ(error("m.step", "ISO-10303-21;"),
            "FILE | FILE: '.step' is not a supported model format | supported: .obj, .stl, .ply, .off");
  EXPECT_EQ(error("m.stpz", "\x1f\x8b\b"), "FILE | FILE: is packed | unpack it first: gunzip FILE");
  EXPECT_EQ(error("model", "# of OBJ\nv 0 0 0\n"), "FILE | FILE: holds no faces | points at one place have no size");
  EXPECT_EQ(error("model", "vertices\n"),
            "FILE | FILE: has no extension, so its format is unknown | supported: .obj, .stl, .ply, .off");
  EXPECT_EQ(error("m.obj", "v 0 0 0\nl 1 1\n"), "FILE | FILE: holds no faces | points at one place have no size");
  EXPECT_EQ(error("m.stl", test::binary_stl({})), "FILE | FILE: holds no faces | ");
  EXPECT_EQ(error("m.obj", "v nan inf 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\nf 2 2 3\n"),
            "FILE | FILE: none of its faces can be drawn: 1 with coordinates that are not finite, "
            "1 with fewer than three distinct corners | ");
  EXPECT_EQ(error("m.obj", "v 0 0 0\nf 1 2 3\n"), "FILE:2 | FILE:2: a face refers to vertex 3, but there are 1 | ");
  EXPECT_EQ(error("m.ply", "junk"), "FILE:1 | FILE:1: does not begin with 'ply' | ");
  EXPECT_NE(error("m.stl", std::string(300, '\x7F')).find("FILE: byte 300"), std::string::npos);
}

TEST(ReadMesh, MissingFileIsAnError) {
  EXPECT_NE(words_of_error([] { mesh::read_mesh("no/such/file.obj"); }).find("no/such/file.obj"), std::string::npos);
}

/// Numbers as German or Swiss programs print them.
struct Decimals : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(ReadMesh, NoLocaleChangesANumber) {
  const Folder folder;
  const std::locale before = std::locale::global(std::locale(std::locale(), new Decimals));
  const char* const named = std::setlocale(LC_ALL, "de_DE.UTF-8");  // where the system has it
  for (const auto& [format, text] :
       {std::pair{"obj", triangle_obj}, {"off", triangle_off}, {"ply", triangle_ply}, {"stl", triangle_stl}})
    expect_triangle(mesh::read_mesh(folder.file(std::string("m.") + format, text)), format);
  if (named != nullptr) std::setlocale(LC_ALL, "C");
  std::locale::global(before);
}

}  // namespace
}  // namespace epura::read_test
