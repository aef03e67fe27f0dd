// `epura draw --verify`: what it says, where, and with which exit code.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test {
namespace {

TEST(Verify, ARightDrawingIsToldOnStandardError) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("bracket.obj"), "--verify", "-o", "-", "--format", "svg"}, folder / "");
  const Outcome plain = epura({"draw", sample("bracket.obj"), "-o", "-", "--format", "svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, plain.out);
  EXPECT_TRUE(contains(run.err, " decided, 0 wrong, ")) << run.err;
  EXPECT_TRUE(contains(run.err, "95 % confidence")) << run.err;
}

TEST(Verify, TheReportHoldsIt) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("cylinders.obj"), "--projection", "look-at:eye=400,-900,500", "--verify",
                             "--verify-samples", "300", "-o", "-", "--format", "json"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = JsonReader(run.out).read();
  const Json& found = json["report"]["verify"];
  EXPECT_EQ(found.keys(), "points decided wrong samples length misclassified at_most undecided untested strata worst");
  EXPECT_GE(found["samples"].number(), 300);
  EXPECT_GT(found["points"].number(), found["samples"].number());
  EXPECT_EQ(found["wrong"].number(), 0);
  EXPECT_TRUE(found["worst"].items.empty());
  double samples = 0;
  for (const Json& stratum : found["strata"].items) samples += stratum["samples"].number();
  EXPECT_EQ(samples, found["samples"].number());
}

TEST(Verify, HiddenLinesThatAreNotWantedAreNotMissed) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--hidden", "none", "--verify", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Verify, AWireframeIsRefused) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--visibility", "none", "--verify", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--verify")) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace epura::test
