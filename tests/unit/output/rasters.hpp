// SPDX-License-Identifier: Apache-2.0
// Files drawn by the programs that people look at them with, as pixels.
#pragma once

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "folder.hpp"
#include "output/cairo/canvas.hpp"
#include "output/write.hpp"

namespace epura {

/// What a command prints. Its failure is one of the test.
inline std::string run(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << text;
  return text;
}

/// Shades from 0, black, to 255.
struct GreyPicture {
  int width = 0, height = 0;
  std::vector<int> grey;
};

inline GreyPicture read_png(const std::filesystem::path& file) {
  const output::CairoSurface image(cairo_image_surface_create_from_png(file.c_str()));
  GreyPicture picture{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
  const unsigned char* rows = cairo_image_surface_get_data(image.get());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.grey.push_back(rows[y * cairo_image_surface_get_stride(image.get()) + 4 * x]);
  return picture;
}

/// Share of pixels that differ by more than three quarters of black; 1 when the sizes do. The outermost ones, which the
/// sheet covers in part only, do not count.
inline double difference(const GreyPicture& a, const GreyPicture& b) {
  // Sizes are rounded one way or the other.
  if (std::abs(a.width - b.width) > 1 || std::abs(a.height - b.height) > 1) return 1;
  double differing = 0;
  for (int y = 1; y < std::min(a.height, b.height) - 1; ++y)
    for (int x = 1; x < std::min(a.width, b.width) - 1; ++x) {
      const auto shade = [&](const GreyPicture& p) { return p.grey[static_cast<std::size_t>(y * p.width + x)]; };
      differing += std::abs(shade(a) - shade(b)) > 192 ? 1 : 0;
    }
  return differing / static_cast<double>(a.grey.size());
}

class Rasters : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const { folder_.file(name, bytes); }
  [[nodiscard]] std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }
  [[nodiscard]] GreyPicture picture(const std::string& name) const { return read_png(folder_ / name); }

  [[nodiscard]] GreyPicture of_pdf(const sheet::Sheet& sheet, double dpi) const {
    write("sheet.pdf", output::to_pdf({&sheet}));
    run("pdftocairo -png -r " + format_number(dpi) + " -singlefile " + path("sheet.pdf") + " " + path("pdf"));
    return picture("pdf.png");
  }
  [[nodiscard]] GreyPicture of_svg(const sheet::Sheet& sheet, double dpi) const {
    write("sheet.svg", output::to_svg(sheet, {}));
    const std::string resolution = format_number(dpi);
    run("rsvg-convert --background-color=white -d " + resolution + " -p " + resolution + " -o " + path("svg.png") +
        " " + path("sheet.svg"));
    return picture("svg.png");
  }

  /// A page or picture of the folder in Chromium, one pixel to a pixel of CSS. Nothing is fetched, and nothing is kept.
  [[nodiscard]] GreyPicture in_browser(const std::string& name, int width, int height) const {
    std::filesystem::remove_all(folder_ / "profile");
    run("HOME=" + path("") +
        " timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --force-device-scale-factor=1 "
        "--no-first-run --disable-background-networking --disable-component-update --disable-dev-shm-usage "
        "--host-resolver-rules='MAP * ~NOTFOUND' --window-size=" +
        std::to_string(width) + "," + std::to_string(height) + " --user-data-dir=" + path("profile") +
        " --screenshot=" + path("shown.png") + " " + path(name) + " 2>/dev/null");
    return picture("shown.png");
  }

 private:
  test::Folder folder_;
};

}  // namespace epura
