// SPDX-License-Identifier: Apache-2.0
// The same sheet gives the same bytes, whatever happens around it.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <clocale>
#include <locale>
#include <thread>

#include "output/format.hpp"
#include "output/write.hpp"
#include "support.hpp"

namespace epura::stable_test {
namespace {

std::vector<std::string> all_formats() {
  sheet::Sheet sheet = random_sheet(297, 210);
  sheet.views = {{"front", "front", "1:2", {10.5, 20.25}, {1234.5, 90}}};
  sheet.facts = {{"author", "N. N."}, {"scale", "1:2"}};
  drawing::ViewDrawing drawing{};
  drawing.name = "front";
  drawing.world_to_page = Mat4(1234.5678);
  drawing.projection.projector = {0.5, -1234567.25, 1e-9};
  return {output::to_svg(sheet, {}),
          output::to_svg(sheet, {true}),
          output::to_pdf({&sheet}),
          output::to_ps({&sheet}),
          output::to_pdf({&sheet, &sheet}),
          output::to_eps(sheet),
          output::to_dxf(sheet),
          output::to_png(sheet, 100),
          output::to_json(sheet, 0.5, std::array{drawing}, {})};
}

class Stable : public testing::Test {
 protected:
  const std::vector<std::string> expected = all_formats();
};

TEST_F(Stable, LaterAndAfterOtherSurfaces) {
  cairo_surface_destroy(cairo_svg_surface_create_for_stream(nullptr, nullptr, 10, 10));
  cairo_surface_destroy(cairo_pdf_surface_create_for_stream(nullptr, nullptr, 10, 10));
  // Dates in files have seconds.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  EXPECT_EQ(all_formats(), expected);
}

TEST_F(Stable, OnTwoThreadsAtOnce) {
  std::vector<std::string> other;
  std::thread thread([&other] { other = all_formats(); });
  const std::vector<std::string> here = all_formats();
  thread.join();
  EXPECT_EQ(here, expected);
  EXPECT_EQ(other, expected);
}

struct GermanNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(Stable, UnderAnotherCppLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
  const std::vector<std::string> german = all_formats();
  std::locale::global(before);
  EXPECT_EQ(german, expected);
}

TEST_F(Stable, UnderAnotherCLocale) {
  const char* locale = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "cs_CZ.UTF-8"})
    if (locale == nullptr) locale = std::setlocale(LC_ALL, name);
  if (locale == nullptr) GTEST_SKIP() << "no locale with a decimal comma is installed";
  const std::vector<std::string> german = all_formats();
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(german, expected);
}

}  // namespace
}  // namespace epura::stable_test
