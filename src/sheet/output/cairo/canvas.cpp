// SPDX-License-Identifier: Apache-2.0
#include "output/cairo/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "output/curve_pieces.hpp"
#include "sheet/walk_stroke.hpp"

namespace epura::output {

Canvas enlarged_canvas(const sheet::Sheet& sheet) {
  Vec2 min(0, 0), max(sheet.width, sheet.height);
  double tallest = 0;
  const auto add = [&](const Vec2& p) {
    check(std::isfinite(p.x) && std::isfinite(p.y), "ink lies at infinity");
    min = glm::min(min, p);
    max = glm::max(max, p);
  };
  for (const sheet::Layer& layer : sheet.layers) {
    for (const sheet::Stroke& stroke : layer.strokes) {
      for (const Vec2& p : stroke.points) add(p);
      for (const drawing::CurvePart& part : stroke.curves)
        for (const BezierPiece& piece : bezier_pieces(part))
          for (const Vec2& p : piece.controls) add(p);
    }
    for (const sheet::Fill& fill : layer.fills)
      for (const std::vector<Vec2>& ring : fill.rings)
        for (const Vec2& p : ring) add(p);
    for (const sheet::Text& text : layer.texts) {
      add(text.at);
      tallest = std::max(tallest, text.height);
    }
  }
  const Vec2 size = max - min;
  // Cairo's coordinates end at 2^31 / 2^8 units, and FreeType's glyphs at a height of 2^16 units.
  const double units = std::min({1000.0, 8e6 / std::max(size.x, size.y), 4e4 / tallest});
  return {units, {min.x, max.y}, glm::max(glm::ceil(size * units), Vec2(1, 1))};
}

Pen make_pen(const CairoSurface& surface) {
  Pen pen(cairo_create(surface.get()));
  cairo_set_source_rgb(pen.get(), 0, 0, 0);
  cairo_set_line_cap(pen.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
  return pen;
}

void begin_vector_file(const Pen& pen, const Canvas& canvas) {
  cairo_t* cairo = pen.get();
  // Cairo would drop lines narrower than half of this.
  cairo_set_tolerance(cairo, 0.005 * canvas.units);
  cairo_save(cairo);
  // A dash of zero length with butt ends at each corner, and a gap along the rest.
  const std::array<double, 2> dashes = {0, canvas.size.x + canvas.size.y};
  cairo_set_dash(cairo, dashes.data(), 2, 0);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
  cairo_move_to(cairo, 0, 0);
  cairo_line_to(cairo, canvas.size.x, canvas.size.y);
  cairo_move_to(cairo, canvas.size.x, canvas.size.y);
  cairo_line_to(cairo, 0, 0);
  cairo_stroke(cairo);
  cairo_restore(cairo);
}

namespace {

void set_dashes(cairo_t* cairo, const sheet::Stroke& stroke, double units) {
  const sheet::Dashes& dashes = stroke.dashes;
  std::vector<double> lengths = stroke.pattern;
  if (lengths.empty() && dashes.dash > 0) lengths = {dashes.dash, dashes.gap};
  for (int i = 0; i < dashes.dots; ++i) lengths.insert(lengths.end(), {dashes.dot, dashes.gap});
  for (double& length : lengths) length *= units;
  cairo_set_dash(cairo, lengths.data(), static_cast<int>(lengths.size()), 0);
}

}  // namespace

void set_colour(const Pen& pen, const Colour& colour) {
  cairo_set_source_rgb(pen.get(), colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void add_path(const Pen& pen, const Canvas& canvas, const sheet::Stroke& stroke) {
  cairo_t* cairo = pen.get();
  cairo_new_sub_path(cairo);
  const auto line = [&](const Vec2& point) {
    const Vec2 p = canvas.to_surface(point);
    cairo_line_to(cairo, p.x, p.y);
  };
  const auto curve = [&](const drawing::CurvePart& part) {
    for (const BezierPiece& piece : bezier_pieces(part)) {
      const Vec2 a = canvas.to_surface(piece.controls[0]), b = canvas.to_surface(piece.controls[1]);
      const Vec2 to = canvas.to_surface(piece.to);
      cairo_curve_to(cairo, a.x, a.y, b.x, b.y, to.x, to.y);
    }
  };
  if (!stroke.points.empty()) line(stroke.points.front());
  sheet::walk_stroke(stroke, line, curve);
  if (stroke.closed) cairo_close_path(cairo);
}

namespace {

// For Cairo's streams.
struct BytesToRead {
  const std::string& bytes;
  std::size_t at = 0;
};

cairo_status_t next_bytes(void* from, unsigned char* data, unsigned length) {
  auto& reader = *static_cast<BytesToRead*>(from);
  if (reader.bytes.size() - reader.at < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, reader.bytes.data() + reader.at, length);
  reader.at += length;
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void draw_pictures(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer) {
  cairo_t* cairo = pen.get();
  for (const sheet::Picture& picture : layer.pictures) {
    BytesToRead reader{*picture.png};
    const CairoSurface image(cairo_image_surface_create_from_png_stream(next_bytes, &reader));
    if (const cairo_status_t status = cairo_surface_status(image.get()); status != CAIRO_STATUS_SUCCESS)
      throw Error(ErrorKind::input, picture.name,
                  "is a damaged PNG file: " + std::string(cairo_status_to_string(status)));
    const Vec2 corner = canvas.to_surface({picture.min.x, picture.max.y});
    const Vec2 size = (picture.max - picture.min) * canvas.units;
    cairo_save(cairo);
    cairo_translate(cairo, corner.x, corner.y);
    cairo_scale(cairo, size.x / cairo_image_surface_get_width(image.get()),
                size.y / cairo_image_surface_get_height(image.get()));
    cairo_set_source_surface(cairo, image.get(), 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
  }
}

void draw(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const Progress& progress) {
  cairo_t* cairo = pen.get();
  cairo_set_line_width(cairo, layer.style.width * canvas.units);
  for (const sheet::Stroke& stroke : layer.strokes) {
    progress.expect_time();
    progress.advance(1);
    set_dashes(cairo, stroke, canvas.units);
    add_path(pen, canvas, stroke);
    cairo_stroke(cairo);
  }
  require(cairo_status(cairo), "drawing");
}

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned length) {
  // No exception may pass through Cairo.
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

void require(cairo_status_t status, const char* format) {
  if (status != CAIRO_STATUS_SUCCESS) throw Error(ErrorKind::output, format, cairo_status_to_string(status));
}

void finish(const CairoSurface& surface, const char* format) {
  cairo_surface_show_page(surface.get());
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()), format);
}

}  // namespace epura::output
