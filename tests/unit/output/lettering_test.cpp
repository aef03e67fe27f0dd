// Texts and filled areas in every format.
#include "sheet/lettering.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "folder.hpp"
#include "output/canvas.hpp"
#include "output/write.hpp"

namespace epura {
namespace {

Sheet lettered() {
  Sheet sheet{120, 80, "lettered", {}};
  Layer layer{"sheet/text", {"frame", 0.35}, {}};
  layer.strokes.push_back({{{5, 5}, {115, 5}, {115, 75}, {5, 75}}, true});
  layer.fills.push_back({{{{80, 20}, {110, 20}, {110, 40}, {80, 40}}, {{90, 25}, {100, 25}, {100, 35}, {90, 35}}}});
  layer.texts = {{"Gehäuse Ø12 <&>", {10, 65}, 5, 0, Align::left, "title"},
                 {"middle", {60, 52}, 3.5, 0, Align::middle, "label"},
                 {"right", {110, 52}, 3.5, 0, Align::right, "label"},
                 {"upright", {10, 10}, 7, 90, Align::left, "label"},
                 {"aslant 30", {25, 10}, 3.5, 30, Align::left, "label"}};
  sheet.layers.push_back(std::move(layer));
  return sheet;
}

std::string run(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return text;
}

struct Picture {
  int width = 0, height = 0;
  std::vector<int> grey;
};

Picture read_png(const std::filesystem::path& file) {
  const CairoSurface image(cairo_image_surface_create_from_png(file.c_str()));
  Picture picture{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
  const unsigned char* rows = cairo_image_surface_get_data(image.get());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.grey.push_back(rows[y * cairo_image_surface_get_stride(image.get()) + 4 * x]);
  return picture;
}

class Rasters : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }

  // 8 pixels a millimetre.
  [[nodiscard]] Picture of_pdf(const Sheet& sheet) const {
    write("sheet.pdf", to_pdf({&sheet}));
    run("pdftocairo -png -r 203.2 -singlefile " + path("sheet.pdf") + " " + path("pdf"));
    return read_png(folder_ / "pdf.png");
  }
  [[nodiscard]] Picture of_svg(const Sheet& sheet) const {
    write("sheet.svg", to_svg(sheet, {}));
    run("rsvg-convert --background-color=white -d 203.2 -p 203.2 -o " + path("svg.png") + " " + path("sheet.svg"));
    return read_png(folder_ / "svg.png");
  }

  test::Folder folder_;
};

// Share of pixels that differ by more than three quarters of black: Cairo moves the glyphs of the PDF to whole pixels,
// by half a pixel at most.
double difference(const Picture& a, const Picture& b) {
  // Sizes are rounded one way or the other.
  if (std::abs(a.width - b.width) > 1 || std::abs(a.height - b.height) > 1) return 1;
  double differing = 0;
  for (int y = 0; y < std::min(a.height, b.height); ++y)
    for (int x = 0; x < std::min(a.width, b.width); ++x)
      differing += std::abs(a.grey[y * a.width + x] - b.grey[y * b.width + x]) > 192;
  return differing / double(a.grey.size());
}

TEST_F(Rasters, SvgAndPdfLookTheSame) {
  const Sheet sheet = lettered();
  const Picture pdf = of_pdf(sheet);
  ASSERT_GT(pdf.width, 900);
  EXPECT_LT(difference(pdf, of_svg(sheet)), 1e-4);
  Sheet shifted = sheet;
  for (Text& text : shifted.layers[0].texts) text.at.x += 0.2;
  EXPECT_GT(difference(pdf, of_svg(shifted)), 2e-3);
}

TEST_F(Rasters, PdfKeepsTextAsText) {
  write("sheet.pdf", to_pdf(lettered()));
  const std::string text = run("pdftotext -layout " + path("sheet.pdf") + " -");
  EXPECT_NE(text.find("Gehäuse Ø12 <&>"), std::string::npos) << text;
  EXPECT_NE(text.find("upright"), std::string::npos) << text;
  EXPECT_NE(run("pdffonts " + path("sheet.pdf")).find("osifont"), std::string::npos);
}

TEST(Lettered, TheSameBytesEachTime) {
  const Sheet sheet = lettered();
  EXPECT_EQ(to_pdf({&sheet}), to_pdf({&sheet}));
  EXPECT_EQ(to_ps({&sheet}), to_ps({&sheet}));
  EXPECT_EQ(to_svg(sheet, {}), to_svg(sheet, {}));
}

TEST(Lettered, SvgHasOutlinesOrText) {
  const std::string outlines = to_svg(lettered(), {});
  EXPECT_NE(outlines.find("aria-label=\"Gehäuse Ø12 &lt;&amp;&gt;\""), std::string::npos);
  EXPECT_EQ(outlines.find("<text"), std::string::npos);
  VectorOptions options;
  options.text = SvgText::text;
  const std::string text = to_svg(lettered(), options);
  EXPECT_NE(text.find(">Gehäuse Ø12 &lt;&amp;&gt;</text>"), std::string::npos);
  EXPECT_NE(text.find("transform=\"rotate(-30 25 70)\""), std::string::npos);
}

}  // namespace
}  // namespace epura
