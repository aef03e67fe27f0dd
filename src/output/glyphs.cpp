// SPDX-License-Identifier: Apache-2.0
#include "output/glyphs.hpp"

#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/error.hpp"
#include FT_FREETYPE_H
#include <cairo-ft.h>

namespace epura::output {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

struct FontFile {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  explicit FontFile(const std::filesystem::path& file) {
    check(FT_Init_FreeType(&library) == 0, "FreeType begins");
    check(FT_New_Face(library, file.c_str(), 0, &face) == 0, "the font that gave widths can be opened again");
  }
  FontFile(const FontFile&) = delete;
  FontFile& operator=(const FontFile&) = delete;
  ~FontFile() { FT_Done_FreeType(library); }
};

using CairoFont = std::unique_ptr<cairo_font_face_t, Free<cairo_font_face_destroy>>;
using CairoFontOptions = std::unique_ptr<cairo_font_options_t, Free<cairo_font_options_destroy>>;

// Cairo may need the file until the surface is finished.
CairoFont font_of(const sheet::Lettering& lettering) {
  static const cairo_user_data_key_t key{};
  auto file = std::make_unique<FontFile>(lettering.file());
  CairoFont font(cairo_ft_font_face_create_for_ft_face(file->face, FT_LOAD_NO_HINTING));
  const auto close = [](void* opened) { delete static_cast<FontFile*>(opened); };
  require(cairo_font_face_set_user_data(font.get(), &key, file.get(), close), "lettering");
  file.release();  // now owned by the font face
  return font;
}

// Widths as in the font, regardless of the system settings for screens.
void set_font(cairo_t* cairo, const sheet::Lettering& lettering) {
  cairo_set_font_face(cairo, font_of(lettering).get());
  const CairoFontOptions options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options.get());
}

// Calls `draw` with the pen at the beginning of a text's base line and rotated along it.
template <class Draw>
void along_base_line(cairo_t* cairo, const Canvas& canvas, const sheet::Text& text, const sheet::Lettering& lettering,
                     const Draw& draw) {
  const Vec2 start = canvas.to_surface(start_of(text, lettering));
  cairo_save(cairo);
  cairo_translate(cairo, start.x, start.y);
  cairo_rotate(cairo, -radians(text.angle));
  draw();
  cairo_restore(cairo);
  require(cairo_status(cairo), "lettering");
}

void add_outline(cairo_t* cairo, const sheet::GlyphOutline& outline, double units) {
  const auto down = [units](const Vec2& p) { return Vec2(p.x, -p.y) * units; };
  Vec2 at = down(outline.curves.back().end);
  cairo_move_to(cairo, at.x, at.y);
  for (const sheet::GlyphOutline::Curve& curve : outline.curves) {
    const Vec2 control = down(curve.control), end = down(curve.end);
    const Vec2 first = at + (control - at) * (2.0 / 3), second = end + (control - end) * (2.0 / 3);
    cairo_curve_to(cairo, first.x, first.y, second.x, second.y, end.x, end.y);
    at = end;
  }
  cairo_close_path(cairo);
}

}  // namespace

std::optional<sheet::Lettering> lettering_of(const sheet::Sheet& sheet) {
  const bool written = std::any_of(sheet.layers.begin(), sheet.layers.end(),
                                   [](const sheet::Layer& layer) { return !layer.texts.empty(); });
  return written ? std::optional<sheet::Lettering>(std::in_place) : std::nullopt;
}

Vec2 start_of(const sheet::Text& text, const sheet::Lettering& lettering) {
  const Vec2 along(std::cos(radians(text.angle)), std::sin(radians(text.angle)));
  const double before = text.align == sheet::Align::left ? 0 : text.align == sheet::Align::middle ? 0.5 : 1;
  return text.at - along * (before * lettering.width(text.text, text.height));
}

void write_texts(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  if (layer.texts.empty()) return;
  cairo_t* cairo = pen.get();
  set_font(cairo, lettering);
  for (const sheet::Text& text : layer.texts) {
    along_base_line(cairo, canvas, text, lettering, [&] {
      cairo_set_font_size(cairo, text.height * lettering.em() * canvas.units);
      cairo_move_to(cairo, 0, 0);
      cairo_show_text(cairo, sheet::written(text.text).c_str());
    });
  }
}

void fill_texts(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  cairo_t* cairo = pen.get();
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
  for (const sheet::Text& text : layer.texts) {
    along_base_line(cairo, canvas, text, lettering, [&] {
      cairo_new_path(cairo);
      for (const sheet::GlyphOutline& outline : lettering.outlines(text.text, text.height))
        add_outline(cairo, outline, canvas.units);
      cairo_fill(cairo);
    });
  }
}

void draw_fills(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer) {
  cairo_t* cairo = pen.get();
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  for (const sheet::Fill& fill : layer.fills) {
    for (const std::vector<Vec2>& ring : fill.rings) {
      cairo_new_sub_path(cairo);
      for (const Vec2& point : ring) {
        const Vec2 p = canvas.to_surface(point);
        cairo_line_to(cairo, p.x, p.y);
      }
      cairo_close_path(cairo);
    }
    cairo_fill(cairo);
    require(cairo_status(cairo), "filling");
  }
}

}  // namespace epura::output
