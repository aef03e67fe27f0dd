// SPDX-License-Identifier: Apache-2.0
// Where the system gives little: memory, threads, descriptors, bytes in a file.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::limits_test {
namespace {

/// A sentence of the program, or a drawing; nothing that ends it from within, and no mistake of its own.
void expect_sound(const Outcome& run, const std::string& limits) {
  EXPECT_TRUE(run.code == 0 || (run.code >= 2 && run.code <= 4)) << limits << ": " << run.code << "\n" << run.err;
  EXPECT_FALSE(contains(run.err, "internal error")) << limits << ": " << run.err;
  EXPECT_FALSE(contains(run.err, "terminate")) << limits << ": " << run.err;
  EXPECT_FALSE(contains(run.err, "pthread_create")) << limits << ": " << run.err;
  EXPECT_EQ(run.code != 0, contains(run.err, "epura: ")) << limits << ": " << run.err;
}

// From too little for anything, up to enough.
TEST(Limits, OfMemoryAreSaid) {
  bool was_enough = false;
  for (const char* threads : {"1", "2", "7"})
    for (int kilobytes = 24000; kilobytes <= 120000; kilobytes += 4000) {
      const Folder folder;
      const std::string limits = "ulimit -v " + std::to_string(kilobytes);
      const Outcome run = epura(
          {"draw", sample("sombrero.obj"), "--edges", "contour,boundary,smooth", "--threads", threads, "-o", "x.svg"},
          folder / "", {}, limits);
      // Not even begun: the loader of glibc fails, or ends with a fault of its own where threads have no memory.
      if (run.code == 127 || (run.code == 139 && epura({"--version"}, folder / "", {}, limits).code == 139)) continue;
      expect_sound(run, limits);
      was_enough = was_enough || run.code == 0;
    }
  EXPECT_TRUE(was_enough);
}

TEST(Limits, OfDescriptorsAreSaid) {
  for (int descriptors = 3; descriptors <= 12; ++descriptors) {
    const Folder folder;
    const std::string limits = "ulimit -n " + std::to_string(descriptors);
    const Outcome run = epura({"draw", sample("bracket.obj"), "-o", "x.pdf"}, folder / "", {}, limits);
    if (run.code == 127) continue;  // not even begun
    expect_sound(run, limits);
    EXPECT_EQ(run.code != 0, contains(run.err, "Too many open files")) << limits << ": " << run.err;
    EXPECT_TRUE(run.code == 0 || descriptors < 12) << run.err;
  }
}

TEST(Limits, OfTheSizeOfFilesLeaveTheOldOne) {
  const Folder folder;
  for (const char* name : {"x.svg", "x.pdf", "x.json"}) {
    folder.file(name, "old");
    const Outcome run =
        epura({"draw", sample("sombrero.obj"), "-o", name}, folder / "", (folder / "out").string(), "ulimit -f 1");
    EXPECT_EQ(run.code, 4) << name;
    EXPECT_TRUE(contains(run.err, std::string("epura: ") + name + ": cannot write: File too large")) << run.err;
    EXPECT_EQ(read_file(folder / name), "old");
  }
  const Outcome run = epura({"draw", sample("sombrero.obj"), "-o", "-", "--format", "svg"}, folder / "",
                            (folder / "out").string(), "ulimit -f 1");
  EXPECT_EQ(run.code, 4) << run.err;
}

}  // namespace
}  // namespace epura::test::limits_test
