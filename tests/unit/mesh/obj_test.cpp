// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: indices, so every face.
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "support.hpp"

namespace epura::obj_test {
namespace {

using test::words_of_error;

mesh::Soup soup_of(std::string_view text) { return mesh::read_obj(text, "m.obj"); }

TEST(Obj, AllFormsOfCorners) {
  const mesh::Soup soup = soup_of(
      "v 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n"
      "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -3 -2/1 -1//1\n");
  EXPECT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(soup.face_ends, (std::vector<int>{3, 6, 9, 12, 15}));
  EXPECT_TRUE(soup.notes.empty());
  EXPECT_FALSE(soup.single_precision);
}

TEST(Obj, DoublesArriveExactly) {
  const mesh::Soup soup =
      soup_of("v 10000000.123456789 1e-300 0.1\nv +1.5E+3 -.5 4.9e-324\nv 1e308 -1e308 1.000000001\n");
  EXPECT_EQ(soup.points[0], (std::array{10000000.123456789, 1e-300, 0.1}));
  EXPECT_EQ(soup.points[1], (std::array{1500.0, -0.5, 4.9e-324}));
  EXPECT_EQ(soup.points[2], (std::array{1e308, -1e308, 1.000000001}));
}

TEST(Obj, ValuesThatAreNoNumbersAsWindowsWroteThem) {
  const mesh::Soup soup =
      soup_of("v 1.#INF -1.#INF00 +1.#INF# c\nv 1.#IND -1.#IND000 1.#QNAN0\nv 1.#SNAN nan(ind) -nan\n");
  ASSERT_EQ(soup.points.size(), 3U);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(soup.points[0], (std::array{infinity, -infinity, infinity}));
  for (const std::size_t v : {1, 2})
    for (const double x : soup.points[v]) EXPECT_TRUE(std::isnan(x));
  // Any other '#' begins a comment.
  EXPECT_EQ(soup_of("v 3 2 1.#\nv 3 2 1.#INFO\nv 3 2 1#INF\n").points, (mesh::Points(3, {3, 2, 1})));
}

TEST(Obj, EveryLineEndAndContinuedLines) {
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    const mesh::Soup soup =
        soup_of("v 0 0 0" + end + "v 1 \\" + end + " 0 0 # comment \\" + end + end + "\tv\t0 1 0" + end + "f 1 2\\" +
                end + "  3" + end + "curv 0 1 \\" + end + "1 2" + end + "f 3 2 1");
    EXPECT_EQ(soup.points.size(), 3u);
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 2, 1, 0}));
    EXPECT_EQ(soup.notes.size(), 1u);
  }
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(soup_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").corners, (std::vector<int>{0, 1, 2}));
}

TEST(Obj, ObjectsAreBodiesAndReturn) {
  const mesh::Soup soup = soup_of(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no left arm\nf 1 2 3\no empty\no right\nf 1 2 3\no left arm\nf 1 2 3\n");
  EXPECT_EQ(soup.body_names, (std::vector<std::string>{"default", "left arm", "right"}));
  EXPECT_EQ(soup.face_body, (std::vector<int>{0, 1, 2, 1}));
}

TEST(Obj, GroupsAreBodiesWhereThereAreNoObjects) {
  const mesh::Soup soup = soup_of("o all\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng a b\nf 1 2 3\ng\nf 1 2 3\n");
  EXPECT_EQ(soup.body_names, (std::vector<std::string>{"a b", "default"}));
  EXPECT_EQ(soup.face_body, (std::vector<int>{0, 1}));
}

TEST(Obj, OtherStatementsAreNotedOnce) {
  const mesh::Soup soup =
      soup_of("# a comment\nmtllib x\nusemtl y#z\ns off\nv 0 0 0\nv 1 0 0\nl 1 2\nq 1\nl 2 1\n\x7F\xC3 3\n");
  EXPECT_EQ(soup.notes, (std::vector<std::string>{"ignored 2 unsupported lines ('q', '?"
                                                  "?'), the first is line 8"}));
}

TEST(Obj, LinesAreWires) {
  const mesh::Soup soup = soup_of("v 0 0 0\nl 1 2/7 3\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 2\nl -1 -3/1 \\\n 2\nl 3 3\n");
  EXPECT_EQ(soup.wires, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}, {0, 1}, {2, 2}}));
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(soup.notes.empty());
}

TEST(Obj, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) { return words_of_error([&] { soup_of(text); }); };
  EXPECT_EQ(error("v 0 0 0\nv 1 2\n"), "m.obj:2 | m.obj:2: the z coordinate is missing | ");
  EXPECT_EQ(error("v 0 # 0 0\n"), "m.obj:1 | m.obj:1: the y coordinate is missing | ");
  EXPECT_EQ(error("v\n"), "m.obj:1 | m.obj:1: the x coordinate is missing | ");
  EXPECT_EQ(error("v 1,5 0 0\n"),
            "m.obj:1 | m.obj:1: '1,5' is not a number, or too large | "
            "write numbers with a decimal point, separated by blanks");
  EXPECT_EQ(error("v 1e400 0 0\n"), "m.obj:1 | m.obj:1: '1e400' is not a number, or too large | ");
  EXPECT_EQ(error("v 0 0 0\n\nf 1 0 1\n"),
            "m.obj:3 | m.obj:3: a face refers to vertex 0 | vertices are numbered from 1");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 1\nf 1 2 12\nf 1 3 1\n"),
            "m.obj:3 | m.obj:3: a face refers to vertex 12, but there are 1 | ");
  EXPECT_EQ(error("v 0 0 0\nf -1 -2 -1\nv 0 0 0\n"),
            "m.obj:2 | m.obj:2: a face refers to vertex -2, but there are 1 before it | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 -9223372036854775808\n"),
            "m.obj:2 | m.obj:2: a face refers to vertex -9223372036854775808, but there are 1 before it | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 9223372036854775807\n"),
            "m.obj:2 | m.obj:2: a face refers to vertex 9223372036854775807, but there are 1 | ");
  EXPECT_EQ(error("v 0 0 0\nl 1 0\n"), "m.obj:2 | m.obj:2: a line refers to vertex 0 | vertices are numbered from 1");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 1\nl 1 2\n"), "m.obj:3 | m.obj:3: a line refers to vertex 2, but there are 1 | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 x 1\n"), "m.obj:2 | m.obj:2: 'x' is not a whole number | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 99999999999999999999 1\n"),
            "m.obj:2 | m.obj:2: '99999999999999999999' is not a whole number | ");
  EXPECT_EQ(error("v 0 0 0\nf /1 1 1\n"), "m.obj:2 | m.obj:2: the number of the vertex is missing | ");
}

// Long enough to be read in several parts: every line that counts from the beginning of the file, or goes on behind a
// backslash, once stands where a part ends.
struct LongFile {
  std::string text;
  mesh::Soup soup;
  std::size_t lines = 0;

  void add(const std::string& line, const std::string& end = "\n") {
    text += line + end;
    ++lines;
  }
  void add_vertex() {
    const int v = static_cast<int>(soup.points.size());
    soup.points.push_back({v + 0.5, -v / 8.0, 1e-3 * v});
    add("v " + format_number(v + 0.5) + " \\", v % 2 == 0 ? "\n" : "\r\n");
    add(" " + format_number(-v / 8.0) + " " + format_number(1e-3 * v) + " # comment \\");
  }
  void add_face(int body) {
    const int count = static_cast<int>(soup.points.size());
    add("f -1 " + std::to_string(count - 1) + "/1 -3//2", "\r\n");
    soup.corners.insert(soup.corners.end(), {count - 1, count - 2, count - 3});
    soup.end_face();
    soup.face_body.push_back(body);
  }
};

LongFile make_long_file() {
  LongFile file;
  for (int i = 0; i < 3; ++i) file.add_vertex();
  for (int i = 0; file.text.size() < 1'200'000; ++i) {
    if (i % 100 == 0) file.add("g body " + std::to_string(i / 100 % 7));
    file.add_vertex();
    file.add_face(i / 100 % 7);
  }
  return file;
}

TEST(Obj, LongFilesAreReadAsIfInOne) {
  const LongFile file = make_long_file();
  const mesh::Soup soup = soup_of(file.text);
  EXPECT_EQ(soup.points, file.soup.points);
  EXPECT_EQ(soup.corners, file.soup.corners);
  EXPECT_EQ(soup.face_ends, file.soup.face_ends);
  EXPECT_EQ(soup.face_body, file.soup.face_body);
  EXPECT_EQ(soup.body_names.size(), 7u);
  EXPECT_TRUE(soup.notes.empty());
}

TEST(Obj, ErrorsNameTheLineOfLongFiles) {
  const LongFile file = make_long_file();
  const std::string count = std::to_string(file.soup.points.size()), line = std::to_string(file.lines + 1),
                    next = std::to_string(file.lines + 2);
  const auto error = [&](const std::string& end) { return words_of_error([&] { soup_of(file.text + end); }); };
  EXPECT_EQ(error("v 1 2\n"), "m.obj:" + line + " | m.obj:" + line + ": the z coordinate is missing | ");
  EXPECT_EQ(error("f 1 2 9000000\nf 1 2 3\n"),
            "m.obj:" + line + " | m.obj:" + line + ": a face refers to vertex 9000000, but there are " + count + " | ");
  EXPECT_EQ(error("\nf 1 2 -9000000\n"), "m.obj:" + next + " | m.obj:" + next +
                                             ": a face refers to vertex -9000000, but there are " + count +
                                             " before it | ");
  EXPECT_EQ(error("\nl 1 -9000000\n"), "m.obj:" + next + " | m.obj:" + next +
                                           ": a line refers to vertex -9000000, but there are " + count +
                                           " before it | ");
  const mesh::Soup soup = soup_of(file.text + "\nq 1 2\nl 1 -1\np -1\n" + file.text + "x 1\nq 1\nl 2 -1\n");
  EXPECT_EQ(soup.notes,
            (std::vector<std::string>{"ignored 3 unsupported lines ('q', 'x'), the first is line " + next}));
  const int points = static_cast<int>(file.soup.points.size());
  EXPECT_EQ(soup.wires, (std::vector<std::array<int, 2>>{{0, points - 1}, {1, 2 * points - 1}}));
  EXPECT_EQ(soup.marked_points, std::vector<int>{points - 1});
}

// Nowhere to cut: every line goes on, or none ends with a line feed.
TEST(Obj, LongFilesThatCannotBeCut) {
  std::string continued = "f", lines;
  for (int i = 0; i < 300'000; ++i) continued += " 1\\\n";
  EXPECT_EQ(soup_of("v 0 0 0\n" + continued).corners.size(), 300'000u);
  for (int i = 0; i < 100'000; ++i) lines += "f 1 1 1\r";
  EXPECT_EQ(soup_of("v 0 0 0\r" + lines).face_ends.size(), 100'000u);
}

}  // namespace
}  // namespace epura::obj_test
