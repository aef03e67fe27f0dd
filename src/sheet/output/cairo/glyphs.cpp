// SPDX-License-Identifier: Apache-2.0
#include "output/cairo/glyphs.hpp"

#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include FT_FREETYPE_H
#include <cairo-ft.h>

namespace epura::output {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

struct OpenFont {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  OpenFont(const std::filesystem::path& file, int number) {
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();  // nothing else can fail
    if (FT_New_Face(library, file.c_str(), number, &face) == 0) return;
    FT_Done_FreeType(library);
    throw Error(ErrorKind::input, file.string(), "the lettering font cannot be opened again");
  }
  OpenFont(const OpenFont&) = delete;
  OpenFont& operator=(const OpenFont&) = delete;
  ~OpenFont() { FT_Done_FreeType(library); }
};

using CairoFont = std::unique_ptr<cairo_font_face_t, Free<cairo_font_face_destroy>>;
using CairoFontOptions = std::unique_ptr<cairo_font_options_t, Free<cairo_font_options_destroy>>;

// Cairo may need the file until the surface is finished.
CairoFont font_of(const std::filesystem::path& path, int number) {
  static const cairo_user_data_key_t key{};
  auto file = std::make_unique<OpenFont>(path, number);
  CairoFont font(cairo_ft_font_face_create_for_ft_face(file->face, FT_LOAD_NO_HINTING));
  const auto close = [](void* opened) { delete static_cast<OpenFont*>(opened); };
  require(cairo_font_face_set_user_data(font.get(), &key, file.get(), close), "lettering");
  file.release();  // now owned by the font face
  return font;
}

// Widths as in the font, regardless of the system settings for screens.
void set_font(cairo_t* cairo, const CairoFont& font) {
  cairo_set_font_face(cairo, font.get());
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

using FontsOfRuns = std::map<const sheet::FontFile*, CairoFont>;  // only searched, never listed

// UTF-8 of a run, and how its characters correspond to the glyphs, in the order of reading.
struct Clusters {
  std::string text;
  std::vector<cairo_text_cluster_t> list;
};

Clusters clusters_of(const sheet::GlyphRun& run) {
  std::vector<std::size_t> starts;  // of clusters, one for each glyph
  for (const sheet::ShapedGlyph& glyph : run.glyphs) starts.push_back(glyph.cluster);
  if (run.right_to_left) std::reverse(starts.begin(), starts.end());
  Clusters clusters;
  for (std::size_t i = 0; i < starts.size();) {
    std::size_t next = i;
    while (next < starts.size() && starts[next] == starts[i]) ++next;
    const std::size_t end = next < starts.size() ? starts[next] : run.characters.size();
    std::string characters;
    for (std::size_t c = starts[i]; c < end; ++c) characters += utf8(run.characters[c]);
    clusters.list.push_back({static_cast<int>(characters.size()), static_cast<int>(next - i)});
    clusters.text += characters;
    i = next;
  }
  return clusters;
}

// The pen is at the beginning of the run, in units of the surface.
void show_run(cairo_t* cairo, const sheet::GlyphRun& run, double start, double units) {
  const double scale = run.scale * units;
  std::vector<cairo_glyph_t> glyphs;
  double at = start * units;
  for (const sheet::ShapedGlyph& glyph : run.glyphs) {
    glyphs.push_back({glyph.index, at + glyph.offset.x * scale, -glyph.offset.y * scale});
    at += glyph.advance * scale;
  }
  const Clusters clusters = clusters_of(run);
  const auto direction =
      run.right_to_left ? CAIRO_TEXT_CLUSTER_FLAG_BACKWARD : static_cast<cairo_text_cluster_flags_t>(0);
  cairo_set_font_size(cairo, run.font->units_per_em() * scale);
  cairo_show_text_glyphs(cairo, clusters.text.c_str(), static_cast<int>(clusters.text.size()), glyphs.data(),
                         static_cast<int>(glyphs.size()), clusters.list.data(), static_cast<int>(clusters.list.size()),
                         direction);
}

void show_runs(cairo_t* cairo, const std::vector<sheet::GlyphRun>& runs, double units, FontsOfRuns& fonts) {
  double start = 0;
  for (const sheet::GlyphRun& run : runs) {
    CairoFont& font = fonts[run.font];
    if (!font) font = font_of(run.font->file, run.font->face);
    set_font(cairo, font);
    show_run(cairo, run, start, units);
    start += run.width;
  }
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

void write_texts(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  write_texts_one_by_one(pen, canvas, layer, lettering, [](std::size_t) {});
}

void write_texts_one_by_one(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer,
                            const sheet::Lettering& lettering, const std::function<void(std::size_t)>& before) {
  if (layer.texts.empty()) return;
  cairo_t* cairo = pen.get();
  const CairoFont usual = font_of(lettering.file(), lettering.face());
  FontsOfRuns fonts;
  set_font(cairo, usual);
  for (const sheet::Text& text : layer.texts) {
    before(static_cast<std::size_t>(&text - layer.texts.data()));
    along_base_line(cairo, canvas, text, lettering, [&] {
      if (!lettering.covers(text.text))
        return show_runs(cairo, lettering.runs(text.text, text.height), canvas.units, fonts);
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
