// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: the legal forms that other readers drop without a word.
#include "support.hpp"

namespace epura::off_test {
namespace {

using test::words_of_error;

mesh::Soup soup_of(std::string_view text) { return mesh::read_off(text, "m.off"); }

TEST(Off, CountsAndCommentsAnywhere) {
  for (const std::string head : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF 3 1\n", "# c\n OFF # c\n# c\n3 # c\n1\n0\n",
                                 "3 1 0\n", "OFF\r3 1 0\r", "OFF\n3 1\n0\n", "OFF3 1 0\n", "OFF3\n1\n0\n"}) {
    const mesh::Soup soup = soup_of(head + "0 0 0\n# c\n1 0 0 # c\n\n0 1\n0.1\n3 0 1\n2 # c\n");
    EXPECT_EQ(soup.points, (mesh::Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}})) << head;
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2})) << head;
  }
}

TEST(Off, FacesOfTwoCornersAreWiresAndCount) {
  const std::string text = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n2 0 3\n3 0 1 2\n2 3 1 255 0 0\n";
  EXPECT_EQ(soup_of(text).wires, (std::vector<std::array<int, 2>>{{0, 3}, {3, 1}}));
  const mesh::Mesh mesh = mesh::make_mesh(soup_of(text), "m.off");
  EXPECT_EQ(mesh.polygon, std::vector<int>{1});
  EXPECT_EQ(mesh.report.dropped_degenerate, 0);
  EXPECT_EQ(mesh.report.wires, 2);
}

TEST(Off, ColoursNormalsAndTexturesAreSkipped) {
  for (const std::string keyword : {"COFF\n", "NOFF\n", "STOFF\n", "STCNOFF\n", "COFF"}) {
    const mesh::Soup soup =
        soup_of(keyword + "3 2 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2 1 0 0\n3 2 1 0\n");
    EXPECT_EQ(soup.points, (mesh::Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(soup.face_ends, (std::vector<int>{3, 6}));
  }
}

TEST(Off, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) { return words_of_error([&] { soup_of(text); }); };
  EXPECT_EQ(error("OFF BINARY\n"), "m.off:1 | m.off:1: binary OFF is not supported | save it as text OFF or as PLY");
  EXPECT_EQ(error("4OFF\n1 0 0\n"), "m.off:1 | m.off:1: '4OFF' has vertices that are not three-dimensional | ");
  EXPECT_EQ(error("hello\n"), "m.off:1 | m.off:1: does not begin with 'OFF' | ");
  EXPECT_EQ(error("OFF\n353535235358 6 0\n0 0 0\n"),
            "m.off:2 | m.off:2: the file is too short for the 353535235358 vertices that its header announces | ");
  EXPECT_EQ(error("OFFER\n"), "m.off:1 | m.off:1: does not begin with 'OFF' | ");
  EXPECT_EQ(error("OFF3x 1 0\n"), "m.off:1 | m.off:1: '3x' is not a whole number | ");
  EXPECT_EQ(error("OFF\n0\n"), "m.off:3 | m.off:3: the number of faces is missing | ");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
            "m.off:4 | m.off:4: a coordinate of the vertex is missing | ");
  EXPECT_EQ(error("OFF\n1 -6 0\n0 0 0\n"),
            "m.off:2 | m.off:2: the file is too short for the -6 faces that its header announces | ");
  EXPECT_EQ(error("OFF\n2 1 0\n0 0 0\n1 x 0\n"), "m.off:4 | m.off:4: 'x' is not a number, or too large | ");
  EXPECT_EQ(error("OFF\n1 1 0\n0 0 0\n3 0 1 0\n"),
            "m.off:4 | m.off:4: a face refers to vertex 1, but there are 1 | vertices are numbered from 0");
  EXPECT_EQ(error("OFF\n1 1 0\n0 0 0\n3 0 0"), "m.off:4 | m.off:4: the file ends at face 1 of 1 | ");
  EXPECT_EQ(error("OFF\n1 1 0\n0 0 0\n99 0 0 0\n"), "m.off:4 | m.off:4: a face cannot have 99 corners | ");
  EXPECT_EQ(error("OFF\n2 0 0\n0 0 0\n0 0\n"), "m.off:5 | m.off:5: the file ends at vertex 2 of 2 | ");
}

}  // namespace
}  // namespace epura::off_test
