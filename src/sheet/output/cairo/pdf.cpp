// SPDX-License-Identifier: Apache-2.0
// PDF: Cairo draws each layer; qpdf assembles them into pages.
#include <cairo-pdf.h>

#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/cairo/canvas.hpp"
#include "output/cairo/glyphs.hpp"
#include "output/cairo/library.hpp"
#include "output/of_sheet.hpp"
#include "output/reading_order.hpp"

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

/// Draws the marks of a layer in their order, one after the other.
class Marker {
 public:
  Marker(const Pen& pen, const std::vector<PdfMark>& marks) : pen_(pen), marks_(marks) {}

  /// The mark of all ink that is not text.
  void begin_ink() {
    if (!marks_.empty() && marks_.front().begin_texts == marks_.front().end_texts) begin();
  }
  void begin_text(std::size_t text) {
    if (next_ < marks_.size() && marks_[next_].begin_texts == text) begin();
  }
  void end() {
    if (is_open_) cairo_tag_end(pen_.get(), mark_tag);
    is_open_ = false;
  }

 private:
  void begin() {
    end();
    cairo_tag_begin(pen_.get(), mark_tag, nullptr);
    is_open_ = true;
    ++next_;
  }

  const Pen& pen_;
  const std::vector<PdfMark>& marks_;
  std::size_t next_ = 0;
  bool is_open_ = false;
};

// One page for each layer: so each font, and each name, is there once. Without marks, nothing is marked.
std::string cairo_pdf(const Canvas& canvas, const sheet::Sheet& sheet, const std::vector<std::vector<PdfMark>>& marks,
                      const Progress& progress) {
  const std::optional<sheet::Lettering> lettering = lettering_of(sheet);
  static const std::vector<PdfMark> no_marks;
  std::string bytes;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, canvas.size.x, canvas.size.y));
  for (const sheet::Layer& layer : sheet.layers) {
    if (&layer != &sheet.layers.front()) cairo_surface_show_page(surface.get());
    const Pen pen = make_pen(surface);
    begin_vector_file(pen, canvas);
    set_colour(pen, layer.style.colour);
    Marker marker(pen, marks.empty() ? no_marks : marks[static_cast<std::size_t>(&layer - sheet.layers.data())]);
    marker.begin_ink();
    draw_pictures(pen, canvas, layer);
    draw_fills(pen, canvas, layer);
    draw(pen, canvas, layer, progress);
    if (lettering)
      write_texts_one_by_one(pen, canvas, layer, *lettering, [&](std::size_t text) { marker.begin_text(text); });
    marker.end();
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

PdfPage page_of(const sheet::Sheet& sheet, std::size_t number, PdfKind kind, const Progress& progress) {
  const Canvas canvas = enlarged_canvas(sheet);
  const Vec2 size = Vec2(sheet.width, sheet.height) * points_per_millimetre;
  const std::string title = "Sheet " + std::to_string(number) + (sheet.title.empty() ? "" : ": " + sheet.title);
  PdfTags tags = kind == PdfKind::archive ? reading_order(sheet) : PdfTags();
  PdfPage page{cairo_pdf(canvas, sheet, tags.marks, progress),
               {},
               box(size),
               placement(canvas),
               {title, "/Fit"},
               {},
               std::move(tags)};
  for (const sheet::Layer& layer : sheet.layers) page.layers.push_back(layer.name);
  for (const sheet::ViewFrame& view : sheet.views) page.views.push_back({view.name, view_of(view)});
  return page;
}

}  // namespace

PdfDocument make_pdf_layers(const Pages& sheets, PdfKind kind, const Progress& progress) {
  check(!sheets.empty(), "a PDF file without pages");
  PdfDocument document;
  for (std::size_t i = 0; i < sheets.size(); ++i) document.pages.push_back(page_of(*sheets[i], i + 1, kind, progress));
  document.title = sheets.front()->title;
  document.author = fact_of(*sheets.front(), "author");
  document.subject = description_of(*sheets.front());
  document.is_archive = kind == PdfKind::archive;
  if (document.is_archive && document.title.empty()) document.title = "Drawing";
  document.language = fact_of(*sheets.front(), "language");
  if (document.language.empty()) document.language = "en";
  progress.expect_time();
  return document;
}

}  // namespace epura::output
