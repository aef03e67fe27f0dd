// SPDX-License-Identifier: Apache-2.0
// Bytes of SVG files beside those of the bare coordinates.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "output/write.hpp"
#include "support.hpp"

namespace epura::size_test {
namespace {

// Lines as drawings of parts have them: half of them straight, the others around curves; some dashed.
sheet::Sheet many_strokes() {
  std::mt19937 random(3);
  const auto number = [&random](double max) { return max * (static_cast<double>(random()) / 4294967295.0); };
  sheet::Sheet sheet{
      420, 297, "many", {{"front/hidden", {"hidden", 0.25, {3, 0.75}}, {}}, {"front/visible", {"visible", 0.5}, {}}}};
  for (int i = 0; i < 3000; ++i) {
    sheet::Layer& layer = sheet.layers[i % 4 == 0 ? 0 : 1];
    sheet::Stroke stroke;
    const Vec2 centre(number(420), number(297));
    const int lines = i % 2 == 0 ? 1 : 12;
    for (int k = 0; k <= lines; ++k) stroke.points.push_back(centre + 8.0 * Vec2(std::cos(k * 0.2), std::sin(k * 0.2)));
    if (i % 4 == 0) stroke.dashes = {2.5 + number(1), 0.75};
    stroke.kind = i % 3 == 0 ? EdgeKind::contour : EdgeKind::crease;
    for (int k = 0; k < lines; ++k) {
      const auto vertex = static_cast<int>(1000 + random() % 9000), next = static_cast<int>(1000 + random() % 9000);
      stroke.edges.push_back({0, {vertex, next}});
    }
    layer.strokes.push_back(stroke);
  }
  return sheet;
}

double bare_bytes(const sheet::Sheet& sheet) {
  std::string text;
  for (const sheet::Layer& layer : sheet.layers)
    for (const sheet::Stroke& stroke : layer.strokes)
      for (const Vec2& p : stroke.points)
        text += format_fixed(p.x, 4) + " " + format_fixed(sheet.height - p.y, 4) + " ";
  return static_cast<double>(text.size());
}

TEST(SvgSize, IsNearThatOfTheCoordinates) {
  const sheet::Sheet sheet = many_strokes();
  const double bare = bare_bytes(sheet);
  EXPECT_LT(static_cast<double>(output::to_svg(sheet, {true}).size()), 1.3 * bare);
  EXPECT_LT(static_cast<double>(output::to_svg(sheet, {}).size()), 2.5 * bare);
}

}  // namespace
}  // namespace epura::size_test
