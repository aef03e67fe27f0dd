// SPDX-License-Identifier: Apache-2.0
#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "base/error.hpp"
#include "output/format.hpp"
#include "output/write.hpp"
#include "support.hpp"

namespace epura::page_test {
namespace {

std::string header_line(const std::string& postscript, const std::string& key) {
  const std::size_t begin = postscript.find("\n" + key) + 1;
  if (begin == 0) return "";
  return postscript.substr(begin, postscript.find('\n', begin) - begin);
}

TEST(Eps, BoundingBoxIsTheSheet) {
  const std::string eps = output::to_eps(random_sheet(100, 50));
  EXPECT_EQ(eps.substr(0, 23), "%!PS-Adobe-3.0 EPSF-3.0");
  EXPECT_EQ(header_line(eps, "%%BoundingBox:"), "%%BoundingBox: 0 0 284 142");  // 283.46 x 141.73
  EXPECT_EQ(header_line(eps, "%%HiResBoundingBox:"), "%%HiResBoundingBox: 0 0 283.464567 141.732283");
  EXPECT_EQ(eps.find("CreationDate"), std::string::npos);
}

TEST(Eps, TheLowerLeftCornerOfTheSheetIsTheOrigin) {
  sheet::Sheet sheet = random_sheet(100, 50, 0);
  sheet.layers[1].strokes = {{{{25.4, 25.4}, {50.8, 25.4}}, false}};
  const std::string eps = output::to_eps(sheet);
  // 142 points high, y down: one inch from below is 70 from above.
  EXPECT_NE(eps.find("1 0 0 -1 0 142 cm"), std::string::npos);
  EXPECT_NE(eps.find("72 70 m 144 70 l S"), std::string::npos);
}

TEST(PostScript, HasNoDateAndATitleOfOneLine) {
  sheet::Sheet sheet = random_sheet(297, 210, 2);
  sheet.title = "a\n%%BoundingBox: 1 2 3 4";
  const std::string ps = output::to_ps({&sheet}), eps = output::to_eps(sheet);
  EXPECT_EQ(ps.substr(0, 11), "%!PS-Adobe-");
  EXPECT_EQ(ps.find("CreationDate"), std::string::npos);
  EXPECT_EQ(header_line(ps, "%%Title:"), "%%Title: a?%%BoundingBox: 1 2 3 4");
  EXPECT_EQ(header_line(eps, "%%BoundingBox:"), "%%BoundingBox: 0 0 842 596");
}

struct Reader {
  const std::string& bytes;
  std::size_t at = 0;
};

cairo_status_t read(void* closure, unsigned char* data, unsigned length) {
  auto& reader = *static_cast<Reader*>(closure);
  if (reader.at + length > reader.bytes.size()) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, reader.bytes.data() + reader.at, length);
  reader.at += length;
  return CAIRO_STATUS_SUCCESS;
}

TEST(Png, HasTheSizeOfTheSheetAndBlackLinesOnWhite) {
  sheet::Sheet sheet = random_sheet(50.8, 25.4, 0);
  sheet.layers[1].strokes = {{{{10, 5}, {40, 5}}, false}};
  const std::string png = output::to_png(sheet, 254);  // ten pixels a millimetre
  Reader reader{png};
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &reader);
  ASSERT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(surface), 508);
  EXPECT_EQ(cairo_image_surface_get_height(surface), 254);
  const auto shade = [surface](int x, int y) {
    return int(cairo_image_surface_get_data(surface)[y * cairo_image_surface_get_stride(surface) + 4 * x]);
  };
  EXPECT_EQ(shade(200, 254 - 50), 0);
  EXPECT_EQ(shade(200, 50), 255);
  EXPECT_EQ(shade(0, 0), 255);
  EXPECT_EQ(shade(450, 254 - 50), 255);
  cairo_surface_destroy(surface);
}

TEST(Png, RefusesAbsurdSizes) {
  EXPECT_THROW(output::to_png(random_sheet(1189, 841, 0), 600), Error);
  for (const double dpi : {0.0, -1.0, 1e9, HUGE_VAL, std::nan("")})
    EXPECT_THROW(output::to_png(random_sheet(10, 10, 0), dpi), Error);
  try {
    output::to_png(random_sheet(1189, 841, 0), 600);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::output);
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(Formats, AreKnownByTheirExtension) {
  for (const char* name : {"svg", "pdf", "ps", "eps", "png", "dxf", "json", "html"}) {
    const output::Format* format = output::find_format("." + std::string(name));
    ASSERT_TRUE(format != nullptr) << name;
    EXPECT_EQ(format->name, name);
    EXPECT_EQ(format->has_pages,
              name == std::string("pdf") || name == std::string("ps") || name == std::string("html"));
    EXPECT_EQ(format->has_drawings, name == std::string("json") || name == std::string("html"));
    EXPECT_EQ(format->has_facts, name == std::string("html"));
  }
  EXPECT_EQ(output::find_format("PDF"), output::find_format("pdf"));
  EXPECT_EQ(output::find_format("dwg"), nullptr);
  EXPECT_EQ(output::find_format(""), nullptr);
  EXPECT_EQ(output::format_names().size(), 8U);
}

TEST(Formats, AreNamedInsteadOfOthers) {
  EXPECT_EQ(output::format_hint("DWG"), "write dxf instead, which programs for dwg read");
  EXPECT_EQ(output::format_hint("jpeg"), "write png instead, which programs for jpeg read");
  EXPECT_EQ(output::format_hint("emf"), "write svg instead, which programs for emf read");
}

TEST(Formats, EncodeAsTheirWritersDo) {
  const sheet::Sheet first = random_sheet(100, 50), second = random_sheet(60, 60);
  const output::VectorOptions options;
  const report::Report report;
  const auto encoded = [&](const char* name, std::vector<output::SheetContent> sheets) {
    return output::find_format(name)->encode({std::move(sheets), options, report}, {});
  };
  EXPECT_EQ(encoded("svg", {{first}}), output::to_svg(first, options));
  EXPECT_EQ(encoded("pdf", {{first}, {second}}), output::to_pdf({&first, &second}));
  EXPECT_EQ(encoded("ps", {{first}, {second}}), output::to_ps({&first, &second}));
  EXPECT_EQ(encoded("eps", {{first}}), output::to_eps(first));
  EXPECT_EQ(encoded("png", {{first}}), output::to_png(first, options.dpi.value_or(output::usual_dpi)));
  EXPECT_EQ(encoded("dxf", {{first}}), output::to_dxf(first));
  EXPECT_EQ(encoded("json", {{first, 0.5}}), output::to_json(first, 0.5, {}, report));
}

}  // namespace
}  // namespace epura::page_test
