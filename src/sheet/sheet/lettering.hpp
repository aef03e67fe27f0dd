// SPDX-License-Identifier: Apache-2.0
// The lettering font, by default osifont, designed after ISO 3098; and other fonts for what it lacks.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sheet/font_file.hpp"
#include "sheet/installed_fonts.hpp"
#include "sheet/sheet.hpp"
#include "sheet/text_runs.hpp"

namespace epura::sheet {

/// The text as it is written: valid UTF-8 with spaces instead of control characters, without characters that only
/// control the layout of others (U+200B, U+202E ...).
std::string written(std::string_view text);

/// Glyphs of one font, one beside the other.
struct GlyphRun {
  const FontFile* font;
  double scale;               ///< millimetres per font unit
  std::u32string characters;  ///< in the order of reading; the clusters of glyphs count them
  bool right_to_left;
  std::vector<ShapedGlyph> glyphs;  ///< from left to right
  double width;                     ///< mm
};

/// A character that another font provides.
struct BorrowedCharacter {
  std::string character;  ///< UTF-8
  std::string font;       ///< name of the font
};

/// Widths are computed in the font's own units, without hinting; texts of the lettering font have no kerning, so they
/// are the same everywhere. All texts are treated as by `written`. Texts with characters that the lettering font lacks
/// are shaped (HarfBuzz), with the installed fonts that have them, and with bidirectional order (Unicode Annex 9); a
/// box replaces a character that no font has.
class Lettering {
 public:
  /// The file of the font that letters everything: that of Debian's package fonts-osifont.
  static std::filesystem::path usual_font();

  /// Opens `file`, or the usual font. Throws Error{input} if there is none.
  explicit Lettering(const std::filesystem::path& file = {});
  explicit Lettering(const Font& font);

  /// Length of a line of text, mm, with capitals `height` mm high.
  [[nodiscard]] double width(std::string_view text, double height) const;

  /// Whether the lettering font has all characters of the text.
  [[nodiscard]] bool covers(std::string_view text) const;

  /// The characters of the text that no font has, each once, in their order.
  [[nodiscard]] std::vector<std::string> missing(std::string_view text) const;

  /// The characters that only other fonts have, each once, in their order.
  [[nodiscard]] std::vector<BorrowedCharacter> borrowed(std::string_view text) const;

  /// The runs of a line of text, from left to right. Their fonts live as long as the lettering.
  [[nodiscard]] std::vector<GlyphRun> runs(std::string_view text, double height) const;

  /// Outlines of a line of text that begins at the origin, mm, to be filled by the non-zero rule.
  [[nodiscard]] std::vector<GlyphOutline> outlines(std::string_view text, double height) const;

  /// Size of the font (its em) relative to the height of capitals.
  [[nodiscard]] double em() const;

  [[nodiscard]] const std::filesystem::path& file() const;
  [[nodiscard]] int face() const;
  /// Name of the font; empty for osifont.
  [[nodiscard]] const std::string& family() const;

 private:
  [[nodiscard]] const FontFile& font_for(const std::u32string& characters) const;
  [[nodiscard]] std::vector<TextRun> split(std::string_view text) const;

  std::shared_ptr<const FontFile> font_;
  std::shared_ptr<const InstalledFonts> installed_;
};

/// Where the fonts of a sheet's characters differ from the lettering font.
struct FontNotes {
  /// Names of fonts, each with its characters, in the order of the texts.
  std::vector<std::pair<std::string, std::vector<std::string>>> borrowed;
  std::vector<std::string> missing;  ///< characters that no font has, UTF-8
  std::string role;                  ///< of the first text with a missing character
};

/// Each character once. Opens fonts only if there are texts.
FontNotes font_notes(const Sheet& sheet);

}  // namespace epura::sheet
