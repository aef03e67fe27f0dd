// SPDX-License-Identifier: Apache-2.0
// Designations and sizes of screw threads.
#include "scene/threads.hpp"

#include <gtest/gtest.h>

#include <string>

#include "errors.hpp"

namespace epura::test::threads_test {
namespace {

// Minor diameters of ISO 724:1993, table 1.
TEST(Threads, HaveTheMinorDiametersOfIso724) {
  const auto minor = [](const char* text) { return scene::parse_thread(text, "").minor(); };
  EXPECT_NEAR(minor("M3"), 2.459, 5e-4);
  EXPECT_NEAR(minor("M6"), 4.917, 5e-4);
  EXPECT_NEAR(minor("M8x1"), 6.917, 5e-4);
  EXPECT_NEAR(minor("M10"), 8.376, 5e-4);
  EXPECT_NEAR(minor("M12×1.25"), 10.647, 5e-4);
  EXPECT_NEAR(minor("M20"), 17.294, 5e-4);
  EXPECT_NEAR(minor("M64"), 57.505, 5e-4);
}

TEST(Threads, AreWrittenAsOnDrawings) {
  const auto text = [](const char* given) { return scene::parse_thread(given, "").text; };
  EXPECT_EQ(text("M6"), "M6");
  EXPECT_EQ(text("M6x1"), "M6") << "the coarse pitch is not written";
  EXPECT_EQ(text("M6x0.75"), "M6×0.75");
  EXPECT_EQ(text("M16×1.5-6H"), "M16×1.5-6H");
  EXPECT_EQ(text("M10-5g6g-LH"), "M10-5g6g-LH");
}

TEST(Threads, OfOtherSizesAreRefused) {
  const auto refusal = [](const char* given) {
    const Error error = error_of([given] { scene::parse_thread(given, "part.toml:7:10"); });
    return error.what() + std::string("\n") + error.hint();
  };
  EXPECT_EQ(refusal("M6.5"), "part.toml:7:10: 'M6.5' is not a thread: ISO 261 has no M6.5\nM6 and M7 are the nearest");
  EXPECT_EQ(refusal("M8x0.9"),
            "part.toml:7:10: 'M8x0.9' is not a thread: ISO 261 has no pitch of 0.9 for M8\nits pitches are "
            "1.25, 1, 0.75");
  EXPECT_TRUE(contains(refusal("M15"), "'M15' has no coarse pitch in ISO 261\ngive its pitch, as M15x1.5"));
  EXPECT_TRUE(contains(refusal("M400"), "the largest known here is M100"));
  for (const char* given : {"", "M", "6", "m6", "M6x", "Mx1", "M6-", "M6-H", "M6-6Z", "M-6", "M1e999", "Mnan", "G1/2"})
    EXPECT_TRUE(contains(refusal(given), "is not a")) << given << ": " << refusal(given);
}

}  // namespace
}  // namespace epura::test::threads_test
