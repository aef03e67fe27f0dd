// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of blocks whose fillets begin in the planes of their walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_texts.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::rounded_blocks_test {
namespace {

// A block of 40 x 30 x 20 in three decimals, with some of its upright edges rounded. The first facets of fine fillets
// rise by a step of these decimals, so that they lie in the walls.
std::string rounded_block(double radius, int steps, std::array<bool, 4> rounded) {
  std::vector<Vec2> outline;
  for (std::size_t corner = 0; corner < rounded.size(); ++corner) {
    const Vec2 out(corner == 0 || corner == 3 ? 1 : -1, corner < 2 ? 1 : -1);
    const Vec2 centre = Vec2(0, 100) + out * (Vec2(20, 15) - radius);
    if (!rounded[corner]) outline.push_back(centre + radius * out);
    for (int i = 0; rounded[corner] && i <= steps; ++i) {
      const double angle = (static_cast<double>(corner) + static_cast<double>(i) / steps) * std::numbers::pi / 2;
      outline.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  std::string obj, bottom = "f", top = "f", walls;
  const std::size_t n = outline.size();
  for (const int z : {0, 20})
    for (const Vec2& p : outline)
      obj += "v " + format_fixed(p.x, 3) + " " + format_fixed(p.y, 3) + " " + std::to_string(z) + "\n";
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t one = i + 1, next = (i + 1) % n + 1;
    bottom += " " + std::to_string(n - i);
    top += " " + std::to_string(n + one);
    walls += "f";
    for (const std::size_t v : {one, next, n + next, n + one}) walls += " " + std::to_string(v);
    walls += "\n";
  }
  return obj + bottom + "\n" + top + "\n" + walls;
}

TEST(RoundedBlocks, HaveTheirSizesInThreeDecimals) {
  const Folder folder;
  for (const double radius : {2.0, 3.0})
    for (const int steps : {32, 48})
      for (const std::array<bool, 4>& rounded :
           {std::array{true, true, true, true}, {false, true, false, false}, {true, false, true, false}}) {
        const std::string block = folder.file("block.obj", rounded_block(radius, steps, rounded));
        const Outcome run =
            epura({"draw", block, "--views", "front,top,left", "--dimensions", "auto", "-o", "x.svg"}, folder / "");
        EXPECT_EQ(run.code, 0) << radius << " " << steps << run.err;
        const Words texts = dimensions_in(read_file(folder / "x.svg"));
        for (const char* size : {"40", "30", "20"})
          EXPECT_EQ(std::count(texts.begin(), texts.end(), size), 1) << radius << " " << steps << " " << size;
      }
}

}  // namespace
}  // namespace epura::test::rounded_blocks_test
