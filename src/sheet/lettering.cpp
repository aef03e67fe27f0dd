// SPDX-License-Identifier: Apache-2.0
#include "sheet/lettering.hpp"

#include <ft2build.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace epura::sheet {

namespace {

/// In font units.
struct Glyph {
  double advance = 0;
  std::vector<GlyphOutline> outlines;
};

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

// Unicode Default_Ignorable_Code_Point, as far as it may occur in lines of drawings.
bool is_invisible(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return code == 0xAD || code == 0x34F || code == 0x61C || within(0x200B, 0x200F) || within(0x202A, 0x202E) ||
         within(0x2060, 0x206F) || within(0xFE00, 0xFE0F) || code == 0xFEFF || within(0xE0000, 0xE0FFF);
}

Vec2 point_of(const FT_Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

GlyphOutline& last_outline(void* outlines) { return static_cast<std::vector<GlyphOutline>*>(outlines)->back(); }

void add_curve(GlyphOutline& outline, const Vec2& control, const Vec2& end) {
  outline.curves.push_back({control, end});
}

int move_to(const FT_Vector* to, void* outlines) {
  auto& all = *static_cast<std::vector<GlyphOutline>*>(outlines);
  // The first point is stored as the end of a curve until the outline is closed.
  all.push_back({{{point_of(*to), point_of(*to)}}});
  return 0;
}

int line_to(const FT_Vector* to, void* outlines) {
  GlyphOutline& outline = last_outline(outlines);
  add_curve(outline, (outline.curves.back().end + point_of(*to)) / 2.0, point_of(*to));
  return 0;
}

int curve_to(const FT_Vector* control, const FT_Vector* to, void* outlines) {
  add_curve(last_outline(outlines), point_of(*control), point_of(*to));
  return 0;
}

int cubic_to(const FT_Vector*, const FT_Vector*, const FT_Vector*, void*) { return 1; }

// Removes the first curve, which only stored the starting point; an open outline is closed by a straight curve.
void close(GlyphOutline& outline) {
  const Vec2 first = outline.curves.front().end, last = outline.curves.back().end;
  if (first != last) add_curve(outline, (first + last) / 2.0, first);
  outline.curves.erase(outline.curves.begin());
}

Glyph load_glyph(FT_Face face, unsigned index) {
  Glyph glyph;
  if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE) != 0) return glyph;
  glyph.advance = static_cast<double>(face->glyph->metrics.horiAdvance);
  const FT_Outline_Funcs functions{move_to, line_to, curve_to, cubic_to, 0, 0};
  FT_Outline_Decompose(&face->glyph->outline, &functions, &glyph.outlines);
  for (GlyphOutline& outline : glyph.outlines) close(outline);
  // A single point serves for hinting only.
  std::erase_if(glyph.outlines, [](const GlyphOutline& outline) { return outline.curves.empty(); });
  return glyph;
}

}  // namespace

/// Glyphs are read on first use: a sheet needs a few dozen of the font's fifteen hundred.
class Lettering::Font {
 public:
  explicit Font(const std::filesystem::path& path) : file(path) {
    check(FT_Init_FreeType(&library_) == 0, "FreeType begins");
    FT_New_Face(library_, path.c_str(), 0, &face_);
  }
  ~Font() { FT_Done_FreeType(library_); }  // frees the face, too
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  [[nodiscard]] bool is_open() const { return face_ != nullptr; }
  [[nodiscard]] double units_per_em() const { return face_->units_per_EM; }
  [[nodiscard]] bool has(char32_t character) const {
    const std::lock_guard lock(reading_);
    return FT_Get_Char_Index(face_, character) != 0;
  }

  /// The glyph of a character, or the box that replaces it if the font does not have it. Thread-safe.
  [[nodiscard]] const Glyph& glyph(char32_t character) const {
    const std::lock_guard lock(reading_);
    const auto found = glyphs_.find(character);
    if (found != glyphs_.end()) return found->second;
    return glyphs_.emplace(character, load_glyph(face_, FT_Get_Char_Index(face_, character))).first->second;
  }

  const std::filesystem::path file;
  double capital = 0;  ///< height of an H in font units

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  mutable std::mutex reading_;
  mutable std::unordered_map<char32_t, Glyph> glyphs_;
};

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw Error(ErrorKind::input, file.string(), reason, "install the Debian package fonts-osifont");
}

double height_of(const Glyph& glyph) {
  double height = 0;
  for (const GlyphOutline& outline : glyph.outlines)
    for (const GlyphOutline::Curve& curve : outline.curves) height = std::max(height, curve.end.y);
  return height;
}

}  // namespace

std::string written(std::string_view text) {
  std::string line;
  for (const char32_t character : characters(text))
    if (!is_invisible(character)) line += is_control(character) ? " " : utf8(character);
  return line;
}

Lettering::Lettering(const std::filesystem::path& file) {
  const auto font = std::make_shared<Font>(file.empty() ? EPURA_FONT : file);
  if (!font->is_open()) refuse(font->file, "the lettering font is missing");
  font->capital = height_of(font->glyph(U'H'));
  if (!(font->capital > 0) || !(font->units_per_em() > 0)) refuse(font->file, "is not an outline font");
  font_ = font;
}

double Lettering::width(std::string_view text, double height) const {
  double units = 0;
  for (const char32_t character : characters(written(text))) units += font_->glyph(character).advance;
  return units * (height / font_->capital);
}

std::vector<std::string> Lettering::missing(std::string_view text) const {
  std::vector<std::string> found;
  for (const char32_t character : characters(written(text))) {
    if (font_->has(character)) continue;
    std::string letter = utf8(character);
    if (std::find(found.begin(), found.end(), letter) == found.end()) found.push_back(std::move(letter));
  }
  return found;
}

std::vector<GlyphOutline> Lettering::outlines(std::string_view text, double height) const {
  const double scale = height / font_->capital;
  std::vector<GlyphOutline> placed;
  double at = 0;
  for (const char32_t character : characters(written(text))) {
    const Glyph& glyph = font_->glyph(character);
    const auto place = [&](const Vec2& p) { return Vec2(at + p.x, p.y) * scale; };
    for (const GlyphOutline& outline : glyph.outlines) {
      GlyphOutline& copy = placed.emplace_back();
      for (const GlyphOutline::Curve& curve : outline.curves)
        copy.curves.push_back({place(curve.control), place(curve.end)});
    }
    at += glyph.advance;
  }
  return placed;
}

double Lettering::em() const { return font_->units_per_em() / font_->capital; }

const std::filesystem::path& Lettering::file() const { return font_->file; }

std::vector<MissingCharacter> missing_characters(const Sheet& sheet) {
  std::vector<MissingCharacter> all;
  std::optional<Lettering> lettering;
  std::set<std::string> seen;
  for (const Layer& layer : sheet.layers) {
    for (const Text& text : layer.texts) {
      if (!lettering) lettering.emplace();
      for (const std::string& character : lettering->missing(text.text))
        if (seen.insert(character).second) all.push_back({character, text.role});
    }
  }
  return all;
}

}  // namespace epura::sheet
