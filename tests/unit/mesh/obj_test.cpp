// What would break if this were wrong: indices, so every face.
#include "support.hpp"

namespace epura {
namespace {

using test::error_of;

Soup soup_of(std::string_view text) { return read_obj(text, "m.obj"); }

TEST(Obj, AllFormsOfCorners) {
  const Soup soup = soup_of(
      "v 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n"
      "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -3 -2/1 -1//1\n");
  EXPECT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(soup.face_ends, (std::vector<int>{3, 6, 9, 12, 15}));
  EXPECT_TRUE(soup.notes.empty());
  EXPECT_FALSE(soup.single_precision);
}

TEST(Obj, DoublesArriveExactly) {
  const Soup soup = soup_of("v 10000000.123456789 1e-300 0.1\nv +1.5E+3 -.5 4.9e-324\nv 1e308 -1e308 1.000000001\n");
  EXPECT_EQ(soup.points[0], (std::array{10000000.123456789, 1e-300, 0.1}));
  EXPECT_EQ(soup.points[1], (std::array{1500.0, -0.5, 4.9e-324}));
  EXPECT_EQ(soup.points[2], (std::array{1e308, -1e308, 1.000000001}));
}

TEST(Obj, EveryLineEndAndContinuedLines) {
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    const Soup soup = soup_of("v 0 0 0" + end + "v 1 \\" + end + " 0 0 # comment \\" + end + end + "\tv\t0 1 0" + end +
                              "f 1 2\\" + end + "  3" + end + "curv 0 1 \\" + end + "1 2" + end + "f 3 2 1");
    EXPECT_EQ(soup.points.size(), 3u);
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 2, 1, 0}));
    EXPECT_EQ(soup.notes.size(), 1u);
  }
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(soup_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").corners, (std::vector<int>{0, 1, 2}));
}

TEST(Obj, ObjectsAreBodiesAndReturn) {
  const Soup soup = soup_of(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no left arm\nf 1 2 3\no empty\no right\nf 1 2 3\no left arm\nf 1 2 3\n");
  EXPECT_EQ(soup.body_names, (std::vector<std::string>{"default", "left arm", "right"}));
  EXPECT_EQ(soup.face_body, (std::vector<int>{0, 1, 2, 1}));
}

TEST(Obj, GroupsAreBodiesWhereThereAreNoObjects) {
  const Soup soup = soup_of("o all\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng a b\nf 1 2 3\ng\nf 1 2 3\n");
  EXPECT_EQ(soup.body_names, (std::vector<std::string>{"a b", "default"}));
  EXPECT_EQ(soup.face_body, (std::vector<int>{0, 1}));
}

TEST(Obj, OtherStatementsAreNotedOnce) {
  const Soup soup =
      soup_of("# a comment\nmtllib x\nusemtl y#z\ns off\nv 0 0 0\nv 1 0 0\nl 1 2\np 1\nl 2 1\n\x7F\xC3 3\n");
  EXPECT_EQ(soup.notes, (std::vector<std::string>{"ignored 4 lines of other kinds ('l', 'p', '?"
                                                  "?'), the first of them line 7"}));
}

TEST(Obj, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) { return error_of([&] { soup_of(text); }); };
  EXPECT_EQ(error("v 0 0 0\nv 1 2\n"), "m.obj:2 | m.obj:2: a number is missing | ");
  EXPECT_EQ(error("v 1,5 0 0\n"),
            "m.obj:1 | m.obj:1: '1,5' is not a number that a double can hold | "
            "numbers are written with a point and separated by blanks");
  EXPECT_EQ(error("v 1e400 0 0\n"), "m.obj:1 | m.obj:1: '1e400' is not a number that a double can hold | ");
  EXPECT_EQ(error("v 0 0 0\n\nf 1 0 1\n"),
            "m.obj:3 | m.obj:3: a face refers to vertex 0 | vertices are numbered from 1");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 1\nf 1 2 12\nf 1 3 1\n"),
            "m.obj:3 | m.obj:3: a face refers to vertex 12, but there are 1 | ");
  EXPECT_EQ(error("v 0 0 0\nf -1 -2 -1\nv 0 0 0\n"),
            "m.obj:2 | m.obj:2: a face refers to vertex -2, but there are 1 before it | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 x 1\n"), "m.obj:2 | m.obj:2: 'x' is not a whole number | ");
  EXPECT_EQ(error("v 0 0 0\nf 1 99999999999999999999 1\n"),
            "m.obj:2 | m.obj:2: '99999999999999999999' is not a whole number | ");
  EXPECT_EQ(error("v 0 0 0\nf /1 1 1\n"), "m.obj:2 | m.obj:2: a number is missing | ");
}

}  // namespace
}  // namespace epura
