// SPDX-License-Identifier: Apache-2.0
// Fillets that other features part: one where a groove does, several where lugs stand apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "drawn_texts.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::parted_fillets_test {
namespace {

// Two lugs, each with a rounded edge of radius 10 along y, on a base of 40 x 80; between them a gap in y.
std::string lugs(double from, double to) {
  constexpr int steps = 12;
  constexpr double length = 80, base = 10, top = 30, width = 40, radius = 10;
  Loop above{{width, base}};  // of a lug: x and z
  for (int i = 0; i <= steps; ++i) {
    const double angle = 90.0 * i / steps;
    above.emplace_back(width - radius + radius * cosine(angle), top - radius + radius * sine(angle));
  }
  above.emplace_back(0, top);
  above.emplace_back(0, base);
  Model model;
  const auto at = [](const Vec2& p, double y) { return Vec3(p.x, y, p.y); };
  const auto end = [&](double y, bool with_base, bool towards) {
    std::vector<Vec3> face;
    for (const Vec2& p : above) face.push_back(at(p, y));
    if (with_base) face.insert(face.end(), {Vec3(0, y, 0), Vec3(width, y, 0)});
    if (!towards) std::reverse(face.begin(), face.end());
    model.face(face);
  };
  end(0, true, true);
  end(from, false, false);
  end(to, false, true);
  end(length, true, false);
  for (const auto& [low, high] : {std::pair(0.0, from), std::pair(to, length)})
    for (std::size_t i = 1; i + 2 < above.size(); ++i)
      model.face({at(above[i], low), at(above[i], high), at(above[i + 1], high), at(above[i + 1], low)});
  model.face({Vec3(0, from, base), Vec3(width, from, base), Vec3(width, to, base), Vec3(0, to, base)});
  model.face({Vec3(0, 0, 0), Vec3(0, length, 0), Vec3(width, length, 0), Vec3(width, 0, 0)});
  const double high = top - radius;
  model.face({Vec3(width, 0, 0), Vec3(width, length, 0), Vec3(width, length, base), Vec3(width, length, high),
              Vec3(width, to, high), Vec3(width, to, base), Vec3(width, from, base), Vec3(width, from, high),
              Vec3(width, 0, high), Vec3(width, 0, base)});
  model.face({Vec3(0, 0, 0), Vec3(0, 0, base), Vec3(0, 0, top), Vec3(0, from, top), Vec3(0, from, base),
              Vec3(0, to, base), Vec3(0, to, top), Vec3(0, length, top), Vec3(0, length, base), Vec3(0, length, 0)});
  return model.obj();
}

TEST(PartedFillets, AreCountedWhereTheyStandApart) {
  Folder folder;
  const auto texts_of = [&](double from, double to) {
    folder.file("lugs.obj", lugs(from, to));
    const Outcome drawn = epura({"draw", "lugs.obj", "--dimensions", "auto", "-o", "a.svg"}, folder / "");
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    return dimensions_in(read_file(folder / "a.svg"));
  };
  const Words apart = texts_of(20, 60), grooved = texts_of(35, 45);
  EXPECT_EQ(std::ranges::count(apart, "2× R10"), 1);
  EXPECT_EQ(std::ranges::count(grooved, "R10"), 1);
}

}  // namespace
}  // namespace epura::test::parted_fillets_test
