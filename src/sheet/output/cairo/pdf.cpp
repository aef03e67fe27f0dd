// SPDX-License-Identifier: Apache-2.0
// PDF: Cairo draws each layer; qpdf assembles them into pages.
#include <cairo-pdf.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/cairo/canvas.hpp"
#include "output/cairo/glyphs.hpp"
#include "output/cairo/library.hpp"
#include "output/metadata.hpp"

namespace epura::output {

namespace {

// PDF has no exponents.
std::string real(double value) { return format_fixed(value, 15); }

std::string box(const Vec2& size) { return "[0 0 " + real(size.x) + " " + real(size.y) + "]"; }

// The matrix from the surface, with y up as in PDF, to points on the page.
std::string placement(const Canvas& canvas) {
  const std::string scale = real(points_per_millimetre / canvas.units);
  const Vec2 corner = canvas.to_sheet({0, canvas.size.y}) * points_per_millimetre;
  return scale + " 0 0 " + scale + " " + real(corner.x) + " " + real(corner.y);
}

// One page for each layer: so each font, and each name, is there once.
std::string cairo_pdf(const Canvas& canvas, const sheet::Sheet& sheet, const std::optional<sheet::Lettering>& lettering,
                      const Progress& progress) {
  std::string bytes;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, canvas.size.x, canvas.size.y));
  for (const sheet::Layer& layer : sheet.layers) {
    if (&layer != &sheet.layers.front()) cairo_surface_show_page(surface.get());
    const Pen pen = make_pen(surface);
    begin_vector_file(pen, canvas);
    set_colour(pen, layer.style.colour);
    draw_pictures(pen, canvas, layer);
    draw_fills(pen, canvas, layer);
    draw(pen, canvas, layer, progress);
    if (lettering) write_texts(pen, canvas, layer, *lettering);
  }
  finish(surface, "PDF");
  return bytes;
}

// A box slightly larger than the ink.
std::string view_of(const sheet::ViewFrame& frame) {
  constexpr double margin = 5;  // mm
  const Vec2 min = (frame.min - margin) * points_per_millimetre, max = (frame.max + margin) * points_per_millimetre;
  return "/FitR " + real(min.x) + " " + real(min.y) + " " + real(max.x) + " " + real(max.y);
}

PdfPage page_of(const sheet::Sheet& sheet, std::size_t number, const Progress& progress) {
  const Canvas canvas = enlarged_canvas(sheet);
  const Vec2 size = Vec2(sheet.width, sheet.height) * points_per_millimetre;
  const std::string title = "Sheet " + std::to_string(number) + (sheet.title.empty() ? "" : ": " + sheet.title);
  PdfPage page{
      cairo_pdf(canvas, sheet, lettering_of(sheet), progress), {}, box(size), placement(canvas), {title, "/Fit"}, {}};
  for (const sheet::Layer& layer : sheet.layers) page.layers.push_back(layer.name);
  for (const sheet::ViewFrame& view : sheet.views) page.views.push_back({view.name, view_of(view)});
  return page;
}

}  // namespace

PdfDocument make_pdf_layers(const Pages& sheets, const Progress& progress) {
  check(!sheets.empty(), "a PDF file without pages");
  PdfDocument document;
  for (std::size_t i = 0; i < sheets.size(); ++i) document.pages.push_back(page_of(*sheets[i], i + 1, progress));
  document.title = sheets.front()->title;
  document.author = fact_of(*sheets.front(), "author");
  document.subject = description_of(*sheets.front());
  progress.expect_time();
  return document;
}

}  // namespace epura::output
