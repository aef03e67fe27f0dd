// SPDX-License-Identifier: Apache-2.0
// A section of one part after another order of its faces is the same drawing.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "program.hpp"

namespace epura::test::section_order_test {
namespace {

// Blocks that touch and one that does not, each a body of its own, numbered by `seed`.
std::string blocks(unsigned seed) {
  constexpr std::array<std::array<int, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<std::array<int, 3>> places;
  std::vector<std::array<int, 4>> faces;
  for (const int x : {0, 10, 20, 45})
    for (const int z : {0, 10}) {
      const int first = static_cast<int>(places.size());
      for (int i = 0; i < 8; ++i)
        places.push_back({x + ((i & 1) != 0 ? 10 : 0), (i & 2) != 0 ? 9 : 0, z + (i & 4) * 2});
      for (const auto& [a, b, c, d] : sides) faces.push_back({first + a, first + b, first + c, first + d});
    }
  std::mt19937 random(seed);
  std::vector<int> number(places.size());
  std::iota(number.begin(), number.end(), 0);
  if (seed != 0) {
    std::shuffle(number.begin(), number.end(), random);
    std::shuffle(faces.begin(), faces.end(), random);
  }
  std::vector<std::string> lines(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const auto& [x, y, z] = places[v];
    lines[number[v]] = "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  }
  std::string text = std::accumulate(lines.begin(), lines.end(), std::string());
  for (const auto& [a, b, c, d] : faces) {
    text += "f";
    for (const int v : {a, b, c, d}) text += " " + std::to_string(number[v] + 1);
    text += "\n";
  }
  return text;
}

TEST(SectionOrder, OfFacesDoesNotCount) {
  const Folder folder;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const std::string name = std::to_string(seed);
    const std::string model = folder.file(name + ".obj", blocks(seed));
    const Outcome run = epura(
        {"draw", model, "--projection", "front", "--section", "0,4,0:0,-1,0.1", "-o", name + ".svg"}, folder / "");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(epura({"compare", "0.svg", name + ".svg"}, folder / "").out, "no differences above 0.001 mm\n") << seed;
  }
}

}  // namespace
}  // namespace epura::test::section_order_test
