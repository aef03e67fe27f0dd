// SPDX-License-Identifier: Apache-2.0
// What happens where epura itself is wrong: with a planted fault.
#include "base/broken.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <epura/epura.hpp>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::broken_test {
namespace {

// The program with the planted fault, in place of the usual one.
constexpr const char* broken = R"(EPURA_BREAK=1 exec ")" EPURA_TEST_BROKEN R"(" "$@")";

TEST(BrokenProgram, SaysWhatToSendAndLeavesFiles) {
  for (const char* threads : {"1", "3"}) {
    const Folder folder;
    folder.file("it's.svg", "old");
    const Outcome run = epura({"draw", sample("gear.stl"), "--threads", threads, "-o", "it's.svg", "-o", "new.json"},
                              folder / "", {}, broken);
    EXPECT_EQ(run.code, broken_exit_code) << run.err;
    EXPECT_TRUE(contains(run.err, "epura: internal error: this does not hold: what is hidden lies on the edge\n"))
        << run.err;
    EXPECT_TRUE(contains(run.err, "send the models, the version and the command:\n    epura " EPURA_TEST_VERSION "\n"))
        << run.err;
    EXPECT_TRUE(contains(run.err, std::string("/epura-broken draw ") + sample("gear.stl") + " --threads " + threads +
                                      R"( -o 'it'\''s.svg' -o new.json)"
                                      "\n"))
        << run.err;
    EXPECT_EQ(read_file(folder / "it's.svg"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"it's.svg"});
  }
}

TEST(BrokenProgram, IsSoundWithoutTheFault) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("gear.stl"), "-o", "x.svg"}, folder / "", {}, R"(exec ")" EPURA_TEST_BROKEN R"(" "$@")");
  EXPECT_EQ(run.code, 0) << run.err;
}

// One job fails, and says why; the worker goes on.
TEST(BrokenProgram, FailsItsJobsOfABatch) {
  const Folder folder;
  std::filesystem::copy_file(sample("gear.stl"), folder / "gear.stl");
  const Outcome run = epura({"batch", (folder / "").string(), "-o", "out/{name}.svg"}, folder / "", {}, broken);
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_TRUE(contains(run.err + run.out, "internal error: this does not hold: what is hidden lies on the edge"))
      << run.err << run.out;
}

TEST(BrokenLibrary, ThrowsItsOneTypeOfException) {
  ::setenv("EPURA_BREAK", "1", 1);
  const Scene scene{.models = {{.file = sample("gear.stl")}}, .views = {{.projection = "isometric"}}};
  try {
    static_cast<void>(draw(scene, {.plugin_path = {EPURA_TEST_PLUGINS}}));
    ADD_FAILURE() << "drawn";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), Failure::Kind::broken);
    EXPECT_TRUE(contains(failure.what(), "internal error: this does not hold: what is hidden lies on the edge"))
        << failure.what();
    EXPECT_TRUE(contains(failure.hint(), EPURA_TEST_VERSION)) << failure.hint();
  }
  ::unsetenv("EPURA_BREAK");
}

}  // namespace
}  // namespace epura::test::broken_test
