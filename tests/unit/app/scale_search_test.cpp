// SPDX-License-Identifier: Apache-2.0
// "The largest scale that fits": whoever gives the next larger one is told that there is no room for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <set>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::scale_search_test {
namespace {

class ScaleSearch : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(std::vector<std::string> options) {
    options.insert(options.begin(), {"draw", "part.obj", "-o", "x.svg"});
    return epura(options, folder / "");
  }
};

// A block with a step: an L of `thickness`, extruded.
std::string block(const Vec3& size, double thickness) {
  const std::vector<Vec2> outline{
      {0, 0}, {size.x, 0}, {size.x, thickness}, {thickness, thickness}, {thickness, size.z}, {0, size.z}};
  std::string obj, near = "f", far = "f";
  for (const double y : {0.0, size.y})
    for (const Vec2& p : outline)
      obj += "v " + format_number(p.x) + " " + format_number(y) + " " + format_number(p.y) + "\n";
  for (int i = 1; i <= 6; ++i) {
    near += " " + std::to_string(i);
    far += " " + std::to_string(13 - i);
    const int next = i % 6 + 1;
    obj += "f " + std::to_string(next) + " " + std::to_string(i) + " " + std::to_string(i + 6) + " " +
           std::to_string(next + 6) + "\n";
  }
  return obj + near + "\n" + far + "\n";
}

// 1, 2, 5, 10 ... and 1:2, 1:5, 1:10 ...
std::string next_larger(const std::string& scale) {
  static const std::vector<std::string> scales{"1:100", "1:50", "1:20", "1:10", "1:5",  "1:2",  "1:1",
                                               "2:1",   "5:1",  "10:1", "20:1", "50:1", "100:1"};
  const auto found = std::find(scales.begin(), scales.end(), scale);
  return found == scales.end() || found + 1 == scales.end() ? "" : *(found + 1);
}

TEST_F(ScaleSearch, FindsTheLargestScaleThatFits) {
  static const std::regex chosen("the scale is (\\S+), the largest of ISO 5455 that fits");
  std::mt19937 random(11);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * double(random() % 1000) / 1000;
  };
  const std::vector<std::string> views{"front,top,left", "front,top,left,isometric", "front,left", "front,top"};
  std::set<std::string> scales;
  for (int part = 0; part < 40; ++part) {
    const double unit = std::pow(10.0, between(0.7, 2.8));
    const Vec3 size(unit * between(0.3, 1), unit * between(0.3, 1), unit * between(0.3, 1));
    folder.file("part.obj", block(size, std::min(size.x, size.z) / 3));
    std::vector<std::string> options{"--views", views[part % 4], "--sheet", part % 3 == 0 ? "A4" : "A3"};
    if (part % 5 > 1) options.insert(options.end(), {"--dimensions", part % 5 == 2 ? "overall" : "auto"});
    const Outcome found = draw(options);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(found.err, match, chosen)) << part << ": " << found.err;
    scales.insert(match[1]);
    options.insert(options.end(), {"--scale", next_larger(match[1])});
    const Outcome larger = draw(options);
    EXPECT_TRUE(contains(larger.err, "larger than the sheet") || contains(larger.err, "the views fill the sheet") ||
                contains(larger.err, "fits with smaller pictorial views") || contains(larger.err, "has no room for"))
        << part << ": " << match[1] << " was found: " << larger.err;
  }
  EXPECT_GE(scales.size(), 5u);
}

}  // namespace
}  // namespace epura::test::scale_search_test
