// SPDX-License-Identifier: Apache-2.0
// What `epura draw` answers to --why and --dump.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::questions_test {
namespace {

using Words = std::vector<std::string>;

// A plate of 4 x 2 at height 0, and above it a square from (1, 0.5) to (3, 2.5) at height 1.
struct Plates : ::testing::Test {
  Folder folder;
  std::string plate = folder.file("plate.obj", "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nf 1 2 3 4\n");
  std::string cover = folder.file("cover.obj", "v 1 .5 1\nv 3 .5 1\nv 3 2.5 1\nv 1 2.5 1\nf 1 2 3 4\n");

  Outcome ask(const Words& questions) {
    Words arguments{"draw", "plate.obj", "cover.obj", "--projection", "top", "--scale", "10:1"};
    arguments.insert(arguments.end(), questions.begin(), questions.end());
    return epura(arguments, folder / "");
  }
};

TEST_F(Plates, WhyTellsWhatHidesAnEdgeAndWhere) {
  const Outcome run = ask({"--why", "0:2-3"});
  EXPECT_EQ(run.code, 0) << run.err;
  // 40 mm of ink in the middle between the margins of 20 and 10 mm, from 133.5 to 173.5 mm.
  EXPECT_EQ(run.out,
            "0:2-3 of plate.obj, (4, 2, 0) to (0, 2, 0)\n"
            "  drawn as boundary: no face continues face 0:0\n"
            "  visible t 0 to 0.25, (173.5, 112.5) to (163.5, 112.5) mm\n"
            "  hidden  t 0.25 to 0.75, (163.5, 112.5) to (143.5, 112.5) mm\n"
            "    by face 1:0 of cover.obj, 1 in front, t 0.25 to 0.75\n"
            "  visible t 0.75 to 1, (143.5, 112.5) to (133.5, 112.5) mm\n");
  EXPECT_EQ(folder.names(), (Words{"cover.obj", "plate.obj"})) << "no drawing is written unasked";
}

TEST_F(Plates, APlaceOfThePageMeansTheEdgesNearestToIt) {
  const Outcome run = ask({"--why", "@153,113"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("0:2-3 of plate.obj, (4, 2, 0) to (0, 2, 0), 0.5 mm from the place\n")) << run.out;
}

TEST_F(Plates, APlaceFarFromAllEdgesIsToldToBeFar) {
  // The end of 40 mm of ink nearest to the place is 173.5, 112.5.
  const Outcome run = ask({"--why", "@473.5,512.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, " 500 mm from the place\n")) << run.out;
}

TEST_F(Plates, TheDrawingIsWrittenTooWhereAskedFor) {
  const Outcome run = ask({"--why", "2-3", "--why", "1:0-1", "--dump", "edges", "-o", "x.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("edge\tkind\t")) << run.out;
  EXPECT_TRUE(contains(run.out, "\n1:0-1 of cover.obj")) << run.out;
  EXPECT_TRUE(read_file(folder / "x.svg").starts_with("<?xml"));
}

TEST_F(Plates, TablesAreTheSameForAnyNumberOfThreads) {
  for (const char* table : {"edges", "spans"}) {
    const Outcome one = ask({"--dump", table, "--threads", "1"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(ask({"--dump", table, "--threads", "7"}).out, one.out);
  }
  EXPECT_TRUE(contains(ask({"--dump", "spans"}).out,
                       "\n0:2-3\tboundary\t163.5\t112.5\t143.5\t112.5\t0.25\t0.75\thidden\t1\t1:0\t1\n"));
}

TEST_F(Plates, WrongQuestionsAreRefused) {
  const auto refused = [&](const Words& questions, const std::string& part) {
    const Outcome run = ask(questions);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(contains(run.err, part)) << run.err;
  };
  refused({"--why", "nonsense"}, "does not name an edge");
  refused({"--why", "2:0-1"}, "models are numbered from 0 to 1");
  refused({"--why", "0-4"}, "its vertices are numbered from 0 to 3");
  refused({"--why", "1-3"}, "edges at 1: 0-1 1-2");
  refused({"--dump", "span"}, "did you mean 'spans'?");
  refused({"--why", "0-1", "-o", "-", "--format", "svg"}, "standard output");
  refused({}, "--output is required");
}

}  // namespace
}  // namespace epura::test::questions_test
