// SPDX-License-Identifier: Apache-2.0
// What people see: the same sheet as SVG and PDF in the programs that show them.
#include <gtest/gtest.h>

#include "output/write.hpp"
#include "rasters.hpp"
#include "support.hpp"

namespace epura::render_test {
namespace {

constexpr double dpi = 150;

class Rendered : public Rasters {
 protected:
  const sheet::Sheet sheet = random_sheet(297, 210, 12);

  // A fifth of a millimetre is more than a pixel.
  [[nodiscard]] sheet::Sheet shifted() const {
    sheet::Sheet moved = sheet;
    for (sheet::Layer& layer : moved.layers)
      for (sheet::Stroke& stroke : layer.strokes)
        for (Vec2& point : stroke.points) point += Vec2(0.2, 0.2);
    return moved;
  }
};

// Edges of lines are grey in one way or another, but what is black here is not white there: at 150 dpi, where 1 pixel
// in 20 has ink, none differs by three quarters of black. Of lines moved by 0.2 mm, 1 in 40 pixels does.
constexpr double same = 1e-5, moved = 1e-2;

TEST_F(Rendered, PdfAndSvgLookTheSame) {
  const GreyPicture svg = of_svg(sheet, dpi);
  ASSERT_EQ(svg.width, 1754);
  EXPECT_LT(difference(of_pdf(sheet, dpi), svg), same);
  EXPECT_GT(difference(of_pdf(shifted(), dpi), svg), moved);
}

TEST_F(Rendered, BrowsersShowSvgTheSame) {
  const GreyPicture svg = of_svg(sheet, 96);
  const auto shown = [&](const sheet::Sheet& one) {
    write("shown.svg", output::to_svg(one, {}));
    return in_browser("shown.svg", svg.width, svg.height);
  };
  EXPECT_LT(difference(shown(sheet), svg), same);
  EXPECT_GT(difference(shown(shifted()), svg), moved);
}

TEST_F(Rendered, SvgIsValidXml) {
  sheet::Sheet odd = sheet;
  odd.title = "<script>&\"']]> \x01 " + std::string(10000, '<');
  odd.layers[0].name = odd.title + "/hidden";
  odd.views = {{odd.title, "front", "1:2", {0, 0}, {9, 9}}};
  odd.facts = {{"author", odd.title}, {odd.title, odd.title}};
  write("odd.svg", output::to_svg(odd, {}));
  EXPECT_EQ(run("xmllint --noout " + path("odd.svg") + " 2>&1"), "");
}

TEST_F(Rendered, PdfFilesAreSound) {
  sheet::Sheet odd = sheet;
  odd.title = "(<script>&\"') " + std::string(10000, ')');
  odd.layers[0].name = odd.title;
  odd.views = {{odd.title, "front", "1:2", {0, 0}, {9, 9}}};
  odd.facts = {{"author", odd.title}};
  write("odd.pdf", output::to_pdf({&odd, &sheet, &odd}));
  EXPECT_NE(run("qpdf --check " + path("odd.pdf") + " 2>&1").find("No syntax or stream encoding errors"),
            std::string::npos);
  write("odd.ps", output::to_ps({&odd, &sheet, &odd}));
  EXPECT_EQ(run("grep -ac '^%%Page: ' " + path("odd.ps")), "3\n");
}

}  // namespace
}  // namespace epura::render_test
