// SPDX-License-Identifier: Apache-2.0
// What a section says of models with cracks.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "program.hpp"

namespace epura::test::section_cracks_test {
namespace {

std::string vertex(double x, double y, double z) {
  return "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
}

// A disc of radius 10 and 48 facets; the first of these begins beside the last one's end, a gap from it.
std::string slit_disc(double gap) {
  constexpr int around = 48;
  std::string points, walls, low = "f", high;
  for (int i = 0; i <= around; ++i) {
    const double a = 2 * std::numbers::pi * i / around, shift = i == around ? -gap : 0;
    for (const double z : {0.0, 4.0}) points += vertex(10 * std::cos(a), 10 * std::sin(a) + shift, z);
    const auto number = [](int ring, int top) { return " " + std::to_string(2 * ring + top + 1); };
    if (i == around) break;
    walls += "f" + number(i, 0) + number(i + 1, 0) + number(i + 1, 1) + number(i, 1) + "\n";
    low += number(around - 1 - i, 0);
    high += number(i, 1);
  }
  return points + walls + low + "\nf" + high + "\n";
}

class SectionCracks : public ::testing::Test {
 protected:
  std::string said(double gap, const std::string& plane) {
    const std::string model = folder_.file("disc.obj", slit_disc(gap));
    const Outcome run =
        epura({"draw", model, "--projection", "top", "--section", plane, "-o", "disc.svg"}, folder_ / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  }
  const Folder folder_;
};

TEST_F(SectionCracks, NarrowGapsAreHatchedAcrossAndTold) {
  const std::string text = said(0.002, "0,0,2:0,0,1");
  EXPECT_NE(text.find("has a gap 0.002 wide at 10,-0.001,2 in its outline in section A; bridged for hatching"),
            std::string::npos)
      << text;
}

TEST_F(SectionCracks, WideOnesLeaveAnOpenOutline) {
  const std::string text = said(0.5, "0,0,2:0,0,1");
  EXPECT_NE(text.find("has an outline in section A that is open at 10,"), std::string::npos) << text;
  EXPECT_NE(text.find("the area it would enclose is not hatched"), std::string::npos) << text;
}

TEST_F(SectionCracks, ThoseElsewhereAreNothingToTheSection) {
  const std::string text = said(0.5, "-4,0,2:1,0,0.01");
  EXPECT_EQ(text.find("section"), std::string::npos) << text;
}

}  // namespace
}  // namespace epura::test::section_cracks_test
