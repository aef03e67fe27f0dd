// SPDX-License-Identifier: Apache-2.0
#include "sheet/font_file.hpp"

#include <ft2build.h>
#include <hb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"

#include FT_FREETYPE_H
#include FT_ADVANCES_H
#include FT_OUTLINE_H

namespace epura::sheet {

namespace {

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

// Four quadratic curves: off by less than a thousandth of the length of a curve as in letters.
int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* outlines) {
  constexpr int parts = 4;
  GlyphOutline& outline = last_outline(outlines);
  const Vec2 a = outline.curves.back().end, b = point_of(*first), c = point_of(*second), d = point_of(*to);
  const auto at = [&](double t) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
  };
  const auto slope = [&](double t) {
    const double s = 1 - t;
    return 3 * s * s * (b - a) + 6 * s * t * (c - b) + 3 * t * t * (d - c);
  };
  for (int i = 0; i < parts; ++i) {
    const double from = double(i) / parts, until = double(i + 1) / parts;
    const Vec2 p = at(from), q = i + 1 == parts ? d : at(until);
    const Vec2 control = (p + q) / 2.0 + (slope(from) - slope(until)) * ((until - from) / 4);
    add_curve(outline, control, q);
  }
  return 0;
}

// Removes the first curve, which only stored the starting point; an open outline is closed by a straight curve.
void close(GlyphOutline& outline) {
  const Vec2 first = outline.curves.front().end, last = outline.curves.back().end;
  if (first != last) add_curve(outline, (first + last) / 2.0, first);
  outline.curves.erase(outline.curves.begin());
}

// A font that there is no memory to read is not a font without glyphs.
bool is_read(FT_Error error) {
  if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
  return error == 0;
}

Glyph load_glyph(FT_Face face, unsigned index) {
  Glyph glyph;
  if (!is_read(FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE))) return glyph;
  glyph.advance = static_cast<double>(face->glyph->metrics.horiAdvance);
  const FT_Outline_Funcs functions{move_to, line_to, curve_to, cubic_to, 0, 0};
  FT_Outline_Decompose(&face->glyph->outline, &functions, &glyph.outlines);
  for (GlyphOutline& outline : glyph.outlines) close(outline);
  // A single point serves for hinting only.
  std::erase_if(glyph.outlines, [](const GlyphOutline& outline) { return outline.curves.empty(); });
  return glyph;
}

double glyph_height_of(const Glyph& glyph) {
  double height = 0;
  for (const GlyphOutline& outline : glyph.outlines)
    for (const GlyphOutline::Curve& curve : outline.curves) height = std::max(height, curve.end.y);
  return height;
}

template <auto Destroy>
struct HarfBuzzFree {
  template <class Object>
  void operator()(Object* object) const {
    Destroy(object);
  }
};
using ShapingBlob = std::unique_ptr<hb_blob_t, HarfBuzzFree<hb_blob_destroy>>;
using ShapingFace = std::unique_ptr<hb_face_t, HarfBuzzFree<hb_face_destroy>>;
using ShapingFont = std::unique_ptr<hb_font_t, HarfBuzzFree<hb_font_destroy>>;
using ShapingBuffer = std::unique_ptr<hb_buffer_t, HarfBuzzFree<hb_buffer_destroy>>;

}  // namespace

struct FontFile::Open {
  Open() = default;
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  ~Open() { FT_Done_FreeType(library); }  // frees the face, too

  FT_Library library = nullptr;
  FT_Face face = nullptr;
  double capital = 0;
  ShapingFont shaping{};  // opened on first use
  std::mutex reading{};
  std::unordered_map<unsigned, Glyph> glyphs{};
  std::unordered_map<char32_t, unsigned> indices{};  // of characters that were asked for
  std::once_flag measured{};
  std::array<double, 0x180> advances{};  // by character, up to Latin Extended-A; NaN: the font does not have it
};

FontFile::FontFile(std::filesystem::path path, int number, std::string family)
    : file(std::move(path)), face(number), name(std::move(family)), open_(std::make_unique<Open>()) {
  if (FT_Init_FreeType(&open_->library) != 0) throw std::bad_alloc();  // nothing else can fail
  if (!is_read(FT_New_Face(open_->library, file.c_str(), number, &open_->face))) open_->face = nullptr;
  if (!is_open()) return;
  constexpr double usual_capital = 0.7;
  open_->capital = has(U'H') ? glyph_height_of(glyph(index_of(U'H'))) : usual_capital * units_per_em();
}

FontFile::~FontFile() = default;

bool FontFile::is_open() const { return open_->face != nullptr && FT_IS_SCALABLE(open_->face); }

unsigned FontFile::index_of(char32_t character) const {
  const std::lock_guard lock(open_->reading);
  const auto [known, is_new] = open_->indices.try_emplace(character, 0);
  if (is_new) known->second = FT_Get_Char_Index(open_->face, character);
  return known->second;
}

bool FontFile::has(char32_t character) const { return index_of(character) != 0; }

const Glyph& FontFile::glyph(unsigned index) const {
  const std::lock_guard lock(open_->reading);
  const auto found = open_->glyphs.find(index);
  if (found != open_->glyphs.end()) return found->second;
  return open_->glyphs.emplace(index, load_glyph(open_->face, index)).first->second;
}

std::optional<double> FontFile::advance(char32_t character) const {
  if (character >= open_->advances.size()) {
    const unsigned index = index_of(character);
    return index == 0 ? std::nullopt : std::optional(glyph(index).advance);
  }
  std::call_once(open_->measured, [this] {
    const std::lock_guard lock(open_->reading);
    for (std::size_t c = 0; c < open_->advances.size(); ++c) {
      const unsigned index = FT_Get_Char_Index(open_->face, static_cast<FT_ULong>(c));
      FT_Fixed units = 0;
      const bool is_there = index != 0 && is_read(FT_Get_Advance(open_->face, index, FT_LOAD_NO_SCALE, &units));
      open_->advances[c] = is_there ? static_cast<double>(units) : NAN;
    }
  });
  const double known = open_->advances[character];
  return std::isnan(known) ? std::nullopt : std::optional(known);
}

double FontFile::units_per_em() const { return open_->face->units_per_EM; }

double FontFile::capital() const { return open_->capital; }

std::vector<ShapedGlyph> FontFile::shaped(const std::u32string& characters, bool right_to_left) const {
  const std::lock_guard lock(open_->reading);
  if (!open_->shaping) {
    const ShapingBlob blob(hb_blob_create_from_file_or_fail(file.c_str()));
    if (blob == nullptr) throw Error(ErrorKind::input, file.string(), "the lettering font cannot be opened again");
    const ShapingFace shaping_face(hb_face_create(blob.get(), static_cast<unsigned>(face)));
    ShapingFont font(hb_font_create(shaping_face.get()));  // its scale is that of the font units
    if (shaping_face.get() == hb_face_get_empty() || font.get() == hb_font_get_empty()) throw std::bad_alloc();
    open_->shaping = std::move(font);
  }
  const ShapingBuffer buffer(hb_buffer_create());
  static_assert(sizeof(char32_t) == sizeof(std::uint32_t));
  const std::vector<std::uint32_t> codes(characters.begin(), characters.end());
  const int size = static_cast<int>(codes.size());
  hb_buffer_add_codepoints(buffer.get(), codes.data(), size, 0, size);
  hb_buffer_set_direction(buffer.get(), right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
  // Otherwise the language would be that of the user's environment.
  hb_buffer_set_language(buffer.get(), hb_language_from_string("und", -1));
  hb_buffer_guess_segment_properties(buffer.get());
  hb_shape(open_->shaping.get(), buffer.get(), nullptr, 0);
  if (hb_buffer_allocation_successful(buffer.get()) == 0) throw std::bad_alloc();
  unsigned count = 0;
  const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(buffer.get(), &count);
  std::vector<ShapedGlyph> glyphs;
  for (unsigned i = 0; i < count; ++i) {
    check(info[i].cluster < codes.size(), "a glyph belongs to a character of the text");
    glyphs.push_back({info[i].codepoint,
                      {double(position[i].x_offset), double(position[i].y_offset)},
                      double(position[i].x_advance),
                      info[i].cluster});
  }
  return glyphs;
}

}  // namespace epura::sheet
