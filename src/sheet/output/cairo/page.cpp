// SPDX-License-Identifier: Apache-2.0
// PostScript, EPS and PNG: whole sheets drawn by Cairo in one pass.
#include <cairo-ps.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <new>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/cairo/canvas.hpp"
#include "output/cairo/glyphs.hpp"
#include "output/cairo/library.hpp"

namespace epura::output {

namespace {

constexpr int max_pixels = 20000;  // per side
constexpr double max_dpi = 1200;

// PostScript comments are lines of ASCII with at most 255 characters.
std::string comment_text(std::string_view text) {
  std::string plain(text.substr(0, 200));
  for (char& c : plain)
    if (c < ' ' || c > '~') c = '?';
  return plain;
}

// Replaces the header line that begins with `key`. Cairo writes each of these lines once.
void replace_line(std::string& bytes, std::string_view key, const std::string& line) {
  // At the beginning of a line, not inside the title.
  std::size_t begin = bytes.find(key);
  while (begin != std::string::npos && bytes[begin - 1] != '\n') begin = bytes.find(key, begin + 1);
  check(begin != std::string::npos, "Cairo wrote another PostScript header");
  bytes.replace(begin, bytes.find('\n', begin) + 1 - begin, line);
}

struct PngBytes {
  std::string bytes;
  const Progress& progress;
};

// Called by Cairo, which stops on an error.
cairo_status_t append_in_time(void* png, const unsigned char* data, unsigned length) {
  auto& written = *static_cast<PngBytes*>(png);
  if (written.progress.is_out_of_time()) return CAIRO_STATUS_WRITE_ERROR;
  return append_bytes(&written.bytes, data, length);
}

// Whole points, rounded up.
Vec2 paper_size(const sheet::Sheet& sheet) {
  return glm::max(glm::ceil(Vec2(sheet.width, sheet.height) * points_per_millimetre), Vec2(1, 1));
}

// `draw_texts`: write_texts or fill_texts.
void draw_layers(const Pen& pen, const Canvas& canvas, const sheet::Sheet& sheet, decltype(write_texts)& draw_texts,
                 const Progress& progress) {
  const std::optional<sheet::Lettering> lettering = lettering_of(sheet);
  for (const sheet::Layer& layer : sheet.layers) {
    set_colour(pen, layer.style.colour);
    draw_pictures(pen, canvas, layer);
    draw_fills(pen, canvas, layer);
    draw(pen, canvas, layer, progress);
    if (lettering) draw_texts(pen, canvas, layer, *lettering);
  }
}

void draw_page(const CairoSurface& surface, const sheet::Sheet& sheet, const Progress& progress) {
  const Vec2 whole = paper_size(sheet);
  cairo_ps_surface_set_size(surface.get(), whole.x, whole.y);
  // The lower left corners coincide: PostScript measures from there.
  const Canvas canvas{points_per_millimetre, {0, whole.y / points_per_millimetre}, whole};
  const Pen pen = make_pen(surface);
  begin_vector_file(pen, canvas);
  draw_layers(pen, canvas, sheet, write_texts, progress);
}

std::string postscript(const Pages& sheets, bool encapsulated, const Progress& progress) {
  check(!sheets.empty(), "a PostScript file without pages");
  const Vec2 first = paper_size(*sheets.front());
  std::string bytes;
  const CairoSurface surface(cairo_ps_surface_create_for_stream(append_bytes, &bytes, first.x, first.y));
  cairo_ps_surface_set_eps(surface.get(), encapsulated);
  cairo_ps_surface_dsc_comment(surface.get(), ("%%Title: " + comment_text(sheets.front()->title)).c_str());
  for (const sheet::Sheet* const& sheet : sheets) {
    if (&sheet != &sheets.front()) cairo_surface_show_page(surface.get());
    draw_page(surface, *sheet, progress);
  }
  finish(surface, "PostScript");
  replace_line(bytes, "%%CreationDate:", "");
  return bytes;
}

Vec2 pixels_of(const sheet::Sheet& sheet, double dpi) {
  if (!(dpi >= 1 && dpi <= max_dpi))
    throw Error(ErrorKind::input, "--dpi", "PNG cannot be drawn at " + format_number(dpi) + " dots per inch",
                "1 to " + format_number(max_dpi) + " are possible");
  // The slack keeps 25.4 mm at 300 dpi at 300 pixels.
  const Vec2 pixels = glm::max(glm::ceil(Vec2(sheet.width, sheet.height) * (dpi / 25.4) - 1e-6), Vec2(1, 1));
  if (std::max(pixels.x, pixels.y) > max_pixels)
    throw Error(
        ErrorKind::output, "PNG",
        "a picture of " + format_fixed(pixels.x, 0) + " x " + format_fixed(pixels.y, 0) + " pixels is too large",
        "use a smaller sheet or fewer --dpi: at most " + std::to_string(max_pixels) + " pixels a side");
  return pixels;
}

std::size_t hash_of_pixels(const CairoSurface& surface) {
  cairo_surface_flush(surface.get());
  const auto size = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get())) *
                    static_cast<std::size_t>(cairo_image_surface_get_height(surface.get()));
  const auto* pixels = reinterpret_cast<const char*>(cairo_image_surface_get_data(surface.get()));
  return pixels == nullptr ? 0 : std::hash<std::string_view>{}({pixels, size});
}

}  // namespace

std::string make_ps(const Pages& sheets, const Progress& progress) { return postscript(sheets, false, progress); }

std::string make_eps(const sheet::Sheet& sheet, const Progress& progress) {
  std::string bytes = postscript({&sheet}, true, progress);
  // An EPS file is as large as its sheet: Cairo would omit the margins.
  const Vec2 whole = paper_size(sheet), size = Vec2(sheet.width, sheet.height) * points_per_millimetre;
  replace_line(bytes, "%%BoundingBox:",
               "%%BoundingBox: 0 0 " + format_fixed(whole.x, 0) + " " + format_fixed(whole.y, 0) +
                   "\n%%HiResBoundingBox: 0 0 " + format_fixed(size.x, 6) + " " + format_fixed(size.y, 6) + "\n");
  return bytes;
}

std::string make_png(const sheet::Sheet& sheet, double dpi, const Progress& progress) {
  const Vec2 pixels = pixels_of(sheet, dpi);
  const Canvas canvas{dpi / 25.4, {0, sheet.height}, pixels};
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(pixels.x), static_cast<int>(pixels.y)));
  const auto draw = [&] {
    const Pen pen = make_pen(surface);
    cairo_set_source_rgb(pen.get(), 1, 1, 1);
    cairo_paint(pen.get());
    draw_layers(pen, canvas, sheet, fill_texts, progress);
    return hash_of_pixels(surface);
  };
  // Where memory is missing for a moment, Cairo leaves out a line and says nothing. Compressing takes fifty times as
  // long.
  const std::size_t first = draw();
  if (draw() != first) throw std::bad_alloc();
  PngBytes png{{}, progress};
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append_in_time, &png);
  progress.expect_time();
  require(status, "PNG");
  return std::move(png.bytes);
}

}  // namespace epura::output
