// SPDX-License-Identifier: Apache-2.0
// One outline font: its glyphs, and the shaping of a run of text.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::sheet {

/// A closed outline of quadratic curves (TrueType): each curve runs from the end of the previous one to its own end,
/// the first one from the end of the last. A straight line has its control point in the middle. Cubic curves of other
/// fonts are approximated.
struct GlyphOutline {
  struct Curve {
    Vec2 control, end;
  };
  std::vector<Curve> curves;
};

/// In font units.
struct Glyph {
  double advance = 0;
  std::vector<GlyphOutline> outlines;
};

/// A glyph of a shaped run, in font units.
struct ShapedGlyph {
  unsigned index;       ///< in the font
  Vec2 offset;          ///< from the pen
  double advance;       ///< of the pen
  std::size_t cluster;  ///< first of the characters of the run that it stands for
};

/// Thread-safe. Glyphs are read on first use: a sheet needs a few dozen of a font's thousands.
class FontFile {
 public:
  /// `face` is the number of the font in a collection. The font may be unusable: see is_open.
  explicit FontFile(std::filesystem::path file, int face = 0, std::string name = {});
  ~FontFile();
  FontFile(const FontFile&) = delete;
  FontFile& operator=(const FontFile&) = delete;

  /// Whether the file is an outline font.
  [[nodiscard]] bool is_open() const;
  [[nodiscard]] bool has(char32_t character) const;
  /// The glyph of a character; 0, a box, if the font does not have it.
  [[nodiscard]] unsigned index_of(char32_t character) const;
  [[nodiscard]] const Glyph& glyph(unsigned index) const;
  /// How far the pen moves on, in font units; nothing if the font does not have the character. Letters of European
  /// languages wait for no other thread: widths are measured wherever a text might stand.
  [[nodiscard]] std::optional<double> advance(char32_t character) const;
  [[nodiscard]] double units_per_em() const;
  /// Height of an H in font units, or 0.7 em in fonts without it; 0 in an H without outline.
  [[nodiscard]] double capital() const;

  /// The glyphs of characters of one script and direction, from left to right.
  [[nodiscard]] std::vector<ShapedGlyph> shaped(const std::u32string& characters, bool right_to_left) const;

  const std::filesystem::path file;
  const int face;
  const std::string name;  ///< of its family, for messages

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace epura::sheet
