// SPDX-License-Identifier: Apache-2.0
#include "sheet/lettering.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/utf8.hpp"

namespace epura::sheet {

namespace {

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

// Unicode Default_Ignorable_Code_Point, as far as it may occur in lines of drawings.
bool is_invisible(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return code == 0xAD || code == 0x34F || code == 0x61C || within(0x200B, 0x200F) || within(0x202A, 0x202E) ||
         within(0x2060, 0x206F) || within(0xFE00, 0xFE0F) || code == 0xFEFF || within(0xE0000, 0xE0FFF);
}

// Invisible characters that shaping and the order of letters need.
bool controls_letters(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return code == 0x61C || within(0x200C, 0x200F) || within(0x202A, 0x202E) || within(0x2066, 0x2069);
}

// As `written`, with the characters that control others.
std::u32string one_line_of(std::string_view text) {
  std::u32string line;
  for (const char32_t character : characters(text))
    if (!is_invisible(character) || controls_letters(character)) line += is_control(character) ? U' ' : character;
  return line;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw Error(ErrorKind::input, file.string(), reason, "install the Debian package fonts-osifont");
}

// Appends the outlines of a glyph at a point, in font units, scaled to millimetres.
void append_outlines(std::vector<GlyphOutline>& placed, const Glyph& glyph, const Vec2& at, double scale) {
  const auto place = [&](const Vec2& p) { return (at + p) * scale; };
  for (const GlyphOutline& outline : glyph.outlines) {
    GlyphOutline& copy = placed.emplace_back();
    for (const GlyphOutline::Curve& curve : outline.curves)
      copy.curves.push_back({place(curve.control), place(curve.end)});
  }
}

std::vector<GlyphOutline> outlines_of_text(const std::vector<GlyphRun>& runs) {
  std::vector<GlyphOutline> placed;
  double start = 0;  // mm
  for (const GlyphRun& run : runs) {
    double at = start / run.scale;
    for (const ShapedGlyph& shaped : run.glyphs) {
      append_outlines(placed, run.font->glyph(shaped.index), Vec2(at, 0) + shaped.offset, run.scale);
      at += shaped.advance;
    }
    start += run.width;
  }
  return placed;
}

}  // namespace

std::string written(std::string_view text) {
  std::string line;
  for (const char32_t character : characters(text))
    if (!is_invisible(character)) line += is_control(character) ? " " : utf8(character);
  return line;
}

std::filesystem::path Lettering::usual_font() { return EPURA_FONT; }

Lettering::Lettering(const std::filesystem::path& file) : Lettering(Font{file}) {}

Lettering::Lettering(const Font& font)
    : font_(std::make_shared<FontFile>(font.file.empty() ? usual_font() : font.file, font.face, font.family)),
      installed_(std::make_shared<InstalledFonts>()) {
  std::error_code error;
  if (!font_->is_open())
    refuse(font_->file, std::filesystem::exists(font_->file, error) ? "the lettering font cannot be read, or is no font"
                                                                    : "the lettering font is missing");
  if (!(font_->capital() > 0) || !(font_->units_per_em() > 0)) refuse(font_->file, "is not an outline font");
}

const FontFile& Lettering::font_for(const std::u32string& characters) const {
  if (std::all_of(characters.begin(), characters.end(), [this](char32_t c) { return font_->has(c); })) return *font_;
  const FontFile* other = installed_->font_with(characters);
  if (other == nullptr && characters.size() > 1) return font_for(characters.substr(0, 1));
  return other != nullptr ? *other : *font_;
}

bool Lettering::covers(std::string_view text) const {
  const std::vector<char32_t> line = characters(written(text));
  return std::all_of(line.begin(), line.end(), [this](char32_t c) { return font_->has(c); });
}

// The lettering font has a few ideographs: those of a line that lacks others come from one font, too.
std::vector<TextRun> Lettering::split(std::string_view text) const {
  const std::u32string line = one_line_of(text);
  std::u32string ideographs;
  std::copy_if(line.begin(), line.end(), std::back_inserter(ideographs), is_ideographic);
  const bool has_all = std::all_of(ideographs.begin(), ideographs.end(), [this](char32_t c) { return font_->has(c); });
  const FontFile* of_ideographs = has_all ? nullptr : installed_->font_with(ideographs);
  return text_runs(line, [&](const std::u32string& characters) -> const FontFile& {
    return of_ideographs != nullptr && is_ideographic(characters[0]) ? *of_ideographs : font_for(characters);
  });
}

std::vector<GlyphRun> Lettering::runs(std::string_view text, double height) const {
  std::vector<GlyphRun> runs;
  for (TextRun& run : split(text)) {
    const double scale = height / run.font->capital();
    GlyphRun& glyphs =
        runs.emplace_back(GlyphRun{run.font, scale, std::move(run.characters), run.right_to_left, {}, 0});
    glyphs.glyphs = run.font->shaped(glyphs.characters, run.right_to_left);
    for (const ShapedGlyph& glyph : glyphs.glyphs) glyphs.width += glyph.advance * scale;
  }
  return runs;
}

namespace {

// In font units, of what the font has; nothing if it lacks a character. Places of texts are found by trying many.
std::optional<double> own_width(const FontFile& font, std::string_view text) {
  double units = 0;
  for (const char32_t character : characters(text)) {
    if (is_invisible(character)) continue;
    const auto advance = font.advance(is_control(character) ? U' ' : character);
    if (!advance) return std::nullopt;
    units += *advance;
  }
  check(units >= 0, "a line of letters has a width");
  return units;
}

}  // namespace

double Lettering::width(std::string_view text, double height) const {
  if (const auto units = own_width(*font_, text)) return *units * (height / font_->capital());
  double width = 0;
  for (const GlyphRun& run : runs(text, height)) width += run.width;
  return width;
}

std::vector<std::string> Lettering::missing(std::string_view text) const {
  std::vector<std::string> found;
  if (covers(text)) return found;
  for (const TextRun& run : split(text))
    for (const char32_t character : run.characters) {
      if (is_invisible(character) || run.font->has(character)) continue;
      std::string letter = utf8(character);
      if (std::find(found.begin(), found.end(), letter) == found.end()) found.push_back(std::move(letter));
    }
  return found;
}

std::vector<BorrowedCharacter> Lettering::borrowed(std::string_view text) const {
  std::vector<BorrowedCharacter> found;
  if (covers(text)) return found;
  std::set<char32_t> seen;
  for (const TextRun& run : split(text))
    for (const char32_t character : run.characters)
      if (run.font != font_.get() && !is_invisible(character) && run.font->has(character) &&
          seen.insert(character).second)
        found.push_back({utf8(character), run.font->name});
  return found;
}

std::vector<GlyphOutline> Lettering::outlines(std::string_view text, double height) const {
  if (!covers(text)) return outlines_of_text(runs(text, height));
  std::vector<GlyphOutline> placed;
  double at = 0;
  for (const char32_t character : characters(written(text))) {
    const Glyph& glyph = font_->glyph(font_->index_of(character));
    append_outlines(placed, glyph, {at, 0}, height / font_->capital());
    at += glyph.advance;
  }
  return placed;
}

double Lettering::em() const { return font_->units_per_em() / font_->capital(); }

const std::filesystem::path& Lettering::file() const { return font_->file; }

int Lettering::face() const { return font_->face; }

const std::string& Lettering::family() const { return font_->name; }

FontNotes font_notes(const Sheet& sheet) {
  FontNotes notes;
  std::optional<Lettering> lettering;
  std::set<std::string> seen;
  for (const Layer& layer : sheet.layers)
    for (const Text& text : layer.texts) {
      if (!lettering) lettering.emplace(sheet.font);
      for (const BorrowedCharacter& one : lettering->borrowed(text.text)) {
        if (!seen.insert(one.character).second) continue;
        const auto is_its_font = [&one](const auto& font) { return font.first == one.font; };
        auto font = std::find_if(notes.borrowed.begin(), notes.borrowed.end(), is_its_font);
        if (font == notes.borrowed.end()) font = notes.borrowed.insert(font, {one.font, {}});
        font->second.push_back(one.character);
      }
      for (const std::string& character : lettering->missing(text.text)) {
        if (!seen.insert(character).second) continue;
        if (notes.missing.empty()) notes.role = text.role;
        notes.missing.push_back(character);
      }
    }
  check(notes.borrowed.size() + notes.missing.size() <= seen.size(), "a font that lends has a character");
  return notes;
}

}  // namespace epura::sheet
