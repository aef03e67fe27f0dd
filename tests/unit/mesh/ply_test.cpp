// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: legal headers in an unusual order, which other readers take for empty models.
#include <cmath>

#include "support.hpp"

namespace epura::ply_test {
namespace {

using test::append;
using test::words_of_error;

mesh::Soup soup_of(std::string_view bytes) { return mesh::read_ply(bytes, "m.ply"); }

const std::string vertex_header = "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
const std::string face_header = "element face 1\nproperty list uchar int vertex_indices\n";

TEST(Ply, TextWithEverythingBesides) {
  const mesh::Soup soup = soup_of(
      "ply\r\nformat ascii 1.0\r\ncomment # format binary\r\nobj_info x\r\nelement material 1\r\nproperty list int "
      "float k\r\n"
      "element face 2\r\nproperty uchar red\r\nproperty list uint8 uint32 vertex_index\r\nproperty list uchar float "
      "uv\r\n"
      "element vertex 3\r\nproperty uchar red\r\nproperty float z\r\nproperty float32 x\r\nproperty float y\r\nelement "
      "nothing 7\r\n"
      "end_header\r\n2 0.5 0.5\r\n255 3 0 1 2 2 0.1 0.2\r\n0 3 2 1\r\n0 0\r\n9 5 10000000.123456789 0.1\r\n9 6 1 "
      "0\r\n9 7 0 1\r\n");
  EXPECT_EQ(soup.points, (mesh::Points{{10000000.123456789, 0.1, 5}, {1, 0, 6}, {0, 1, 7}}));
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(soup.face_ends, (std::vector<int>{3, 6}));
  EXPECT_TRUE(soup.single_precision);
}

TEST(Ply, EdgesAreWires) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n", head = "ply\nformat ascii 1.0\n" + vertex_header;
  const std::string edges = "element edge 2\nproperty uchar red\nproperty int vertex2\nproperty int vertex1\n";
  const mesh::Soup soup = soup_of(head + edges + "end_header\n" + points + "255 1 0\n255 2 1\n");
  EXPECT_EQ(soup.wires, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(soup.corners.empty());
  EXPECT_TRUE(soup_of(head + "element edge 1\nproperty int crease\nend_header\n" + points + "7\n").wires.empty());
  EXPECT_EQ(words_of_error([&] { soup_of(head + edges + "end_header\n" + points + "255 1 0\n255 2 3\n"); }),
            "m.ply:16 | m.ply:16: an edge refers to vertex 3, but there are 3 | ");
}

// As meshio writes line cells.
TEST(Ply, FacesOfTwoCornersAreWires) {
  const mesh::Soup soup = soup_of("ply\nformat ascii 1.0\n" + vertex_header +
                                  "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
                                  "0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n2 2 0\n");
  EXPECT_EQ(soup.wires, (std::vector<std::array<int, 2>>{{0, 1}, {2, 0}}));
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(soup.face_ends, (std::vector<int>{0, 3, 3})) << "numbers of faces stay";
  EXPECT_EQ(soup.wire_faces, 2);
}

TEST(Ply, BinaryInBothByteOrdersWithFacesFirst) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string bytes = std::string("ply\nformat binary_") + (order == std::endian::big ? "big" : "little") +
                        "_endian 1.0\nelement face 1\nproperty short tag\nproperty list ushort int64 vertex_indices\n"
                        "property list uchar double w\n" +
                        vertex_header + "property uint8 alpha\nend_header\n";
    append(bytes, std::int16_t{-1}, order);
    append(bytes, std::uint16_t{3}, order);
    for (const std::int64_t corner : {2, 0, 1}) append(bytes, corner, order);
    append(bytes, std::uint8_t{1}, order);
    append(bytes, 0.25, order);
    for (const double x : {1e-300, 0.1, -0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
      append(bytes, x, order);
      if (x == -0.0 || x == 3.0 || x == 6.0) append(bytes, std::uint8_t{255}, order);
    }
    const mesh::Soup soup = soup_of(bytes);
    EXPECT_EQ(soup.points, (mesh::Points{{1e-300, 0.1, 0}, {1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(soup.corners, (std::vector<int>{2, 0, 1}));
    EXPECT_FALSE(soup.single_precision);
  }
}

TEST(Ply, EveryScalarType) {
  const std::vector<std::pair<std::string, std::function<void(std::string&)>>> types{
      {"char", [](std::string& b) { append(b, std::int8_t{-7}); }},
      {"int8", [](std::string& b) { append(b, std::int8_t{-7}); }},
      {"short", [](std::string& b) { append(b, std::int16_t{-7}); }},
      {"int16", [](std::string& b) { append(b, std::int16_t{-7}); }},
      {"int", [](std::string& b) { append(b, std::int32_t{-7}); }},
      {"int32", [](std::string& b) { append(b, std::int32_t{-7}); }},
      {"int64", [](std::string& b) { append(b, std::int64_t{-7}); }},
      {"float", [](std::string& b) { append(b, -7.0f); }},
      {"float32", [](std::string& b) { append(b, -7.0f); }},
      {"double", [](std::string& b) { append(b, -7.0); }},
      {"float64", [](std::string& b) { append(b, -7.0); }}};
  for (const auto& [name, add] : types) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty " + name + " x\nproperty " +
                        name + " y\nproperty ushort z\nend_header\n";
    add(bytes);
    add(bytes);
    append(bytes, std::uint16_t{65535});
    EXPECT_EQ(soup_of(bytes).points, (mesh::Points{{-7, -7, 65535}})) << name;
  }
}

TEST(Ply, HeaderWithCarriageReturnsBeforeDataThatBeginsWithALineFeed) {
  std::string bytes =
      "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar x\rproperty uchar y\r"
      "property uchar z\rend_header\r";
  bytes += "\n\x01\x02";
  EXPECT_EQ(soup_of(bytes).points, (mesh::Points{{10, 1, 2}}));
}

// As vtk.js writes triangles without normals: the vertices move up, and zeros follow.
TEST(Ply, NormalsThatAreAnnouncedMustBeThere) {
  const auto written = [](bool has_normals, bool is_black) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const std::size_t end = bytes.size() + 6 * 25;
    for (int i = 0; i < 6; ++i) {
      for (const bool place : {i % 3 == 1, i % 3 == 2, i >= 3}) append(bytes, place ? 1.f : 0.f);
      for (const float normal : {0.f, 0.f, 1.f})
        if (has_normals) append(bytes, normal);
      append(bytes, static_cast<std::uint8_t>(is_black ? 0 : 255));
    }
    bytes.resize(end, '\0');
    for (int face = 0; face < 2; ++face) {
      append(bytes, std::uint8_t{3});
      for (int i = 0; i < 3; ++i) append(bytes, std::int32_t{3 * face + i});
    }
    return bytes;
  };
  for (const bool is_black : {false, true}) {
    EXPECT_EQ(soup_of(written(true, is_black)).points.back(), (mesh::Points::value_type{0, 1, 1}));
    EXPECT_EQ(
        words_of_error([&] { soup_of(written(false, is_black)); }),
        "m.ply:3 | m.ply:3: the header announces normals that are not there: the last 2 of 6 vertices are nothing "
        "but zeros | export the model with normals, or in another format");
  }
}

TEST(Ply, StripsTurnEverySecondTriangle) {
  const mesh::Soup soup = soup_of(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty int x\nproperty int y\nproperty int z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n11 0 1 2 3 -1 4 3 2 2 -1 1\n");
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 2, 1, 3, 4, 3, 2}));
  EXPECT_EQ(soup.face_ends, (std::vector<int>{3, 6, 9}));
}

TEST(Ply, ElementsWithoutPropertiesTakeNoRoomHoweverMany) {
  EXPECT_TRUE(soup_of("ply\nformat ascii 1.0\nelement face 350000000000\nend_header\n").face_ends.empty());
}

TEST(Ply, TextErrorsNameTheLine) {
  const auto error = [](const std::string& text) { return words_of_error([&] { soup_of(text); }); };
  const std::string head = "ply\nformat ascii 1.0\n" + vertex_header + face_header + "end_header\n";  // 9 lines
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n"),
            "m.ply:12 | m.ply:12: 'x' is not a number, or too large | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0 5\n3 0 1 2\n"),
            "m.ply:12 | m.ply:12: '5' exceeds the properties of this element | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "m.ply:13 | m.ply:13: a face refers to vertex 3, but there are 3 | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
            "m.ply:13 | m.ply:13: a face refers to a vertex that does not exist | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"),
            "m.ply:13 | m.ply:13: a face refers to a vertex that does not exist | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"), "m.ply:13 | m.ply:13: a list has an invalid length | ");
  EXPECT_EQ(error(head + "0 0 0\n1 0 0\n0 1 0\n# c\n"), "m.ply:14 | m.ply:14: the file ends too early | ");
}

TEST(Ply, AShortRowIsSaidWhereItStands) {
  const std::string head = "ply\nformat ascii 1.0\n" + vertex_header + "property list uchar int marks\n" + face_header;
  const auto error = [&](const std::string& rows) {
    return words_of_error([&] { soup_of(head + "end_header\n" + rows); });
  };
  const auto short_row = [](int line, const std::string& property) {
    const std::string place = "m.ply:" + std::to_string(line);
    return place + " | " + place + ": the row ends too early: a number of '" + property + "' is missing | ";
  };
  EXPECT_EQ(error("0 0 0 0\n1 0\n0 1 0 0\n3 0 1 2\n"), short_row(12, "z"));
  EXPECT_EQ(error("0 0 0 0\n1 0 0 0\n\n0 1 0 2 7\n3 0 1 2\n"), short_row(14, "marks"));
  EXPECT_EQ(error("0 0 0 0\n1 0 0 0\n0\n3 0 0 1 2\n"), short_row(13, "y"));
  EXPECT_EQ(error("0 0 0 0\n1 0 0 0\n0 1 0 0\n3 0 1\n"), short_row(14, "vertex_indices"));
  // An element may stand in several lines of its own.
  EXPECT_EQ(error("0 0\n0 0\n1 0 0\n0\n0 1 0 0\n3\n0 1 2\n"), "");
}

TEST(Ply, HeaderErrorsNameTheLine) {
  const auto error = [](const std::string& text) { return words_of_error([&] { soup_of("ply\n" + text); }); };
  EXPECT_EQ(
      error("format ascii 1.0\nelement vertex 350000000000\nproperty float x\nproperty float y\nproperty float "
            "z\nend_header\n0 0 0\n"),
      "m.ply:3 | m.ply:3: the file is too short for the 350000000000 elements 'vertex' that its header announces | is "
      "the file complete?");
  EXPECT_EQ(error("format ascii 1.0\nelement vertex 1\nproperty half x\n"),
            "m.ply:4 | m.ply:4: 'half' is not a PLY type | use char, uchar, short, ushort, int, uint, float, "
            "double");
  EXPECT_EQ(error("format ebcdic 1.0\n"),
            "m.ply:2 | m.ply:2: 'ebcdic' is not a PLY format | use ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(error("element vertex 0\nproperty float x\nproperty float y\nend_header\n"),
            "m.ply:5 | m.ply:5: the header names no format | ");
  EXPECT_EQ(error("format ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nend_header\n"),
            "m.ply:3 | m.ply:3: the vertices have no property 'z' | ");
  EXPECT_EQ(error("format ascii 1.0\nproperty float x\n"), "m.ply:3 | m.ply:3: a property before the first element | ");
  EXPECT_EQ(error("format ascii 1.0\nelement vertex -1\n"), "m.ply:3 | m.ply:3: there cannot be -1 elements | ");
  EXPECT_EQ(error("format ascii 1.0\nnonsense\n"),
            "m.ply:3 | m.ply:3: 'nonsense' does not belong in the header of a PLY file | ");
  EXPECT_EQ(error("format ascii 1.0\n"), "m.ply:3 | m.ply:3: the header does not end | is the file complete?");
}

TEST(Ply, BinaryErrorsNameTheByte) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + vertex_header + face_header + "end_header\n";
  const std::size_t data = bytes.size();
  for (int i = 0; i < 9; ++i) append(bytes, 1.0 * i);
  append(bytes, std::uint8_t{3});
  for (const int corner : {0, 1, 7}) append(bytes, corner);
  const std::string last = std::to_string(data + 85);
  EXPECT_EQ(words_of_error([&] { soup_of(bytes); }),
            "m.ply: byte " + last + " | m.ply: byte " + last + ": a face refers to vertex 7, but there are 3 | ");
  bytes.resize(data + 80);
  EXPECT_NE(words_of_error([&] { soup_of(bytes); }).find("the file ends too early"), std::string::npos);
  bytes.resize(data + 60);
  EXPECT_NE(words_of_error([&] { soup_of(bytes); }).find("m.ply:3: the file is too short for the 3 elements 'vertex'"),
            std::string::npos);
  bytes.resize(data + 72);
  bytes += '\xFF';
  const std::string list = std::to_string(data + 72);
  EXPECT_EQ(words_of_error([&] { soup_of(bytes); }),
            "m.ply: byte " + list + " | m.ply: byte " + list + ": a list has an invalid length | ");
}

}  // namespace
}  // namespace epura::ply_test
