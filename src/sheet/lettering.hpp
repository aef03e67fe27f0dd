// SPDX-License-Identifier: Apache-2.0
// The lettering font: osifont, designed after ISO 3098.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::sheet {

/// A closed outline of quadratic curves (TrueType): each curve runs from the end of the previous one to its own end,
/// the first one from the end of the last. A straight line has its control point in the middle.
struct GlyphOutline {
  struct Curve {
    Vec2 control, end;
  };
  std::vector<Curve> curves;
};

/// The text as it is written: valid UTF-8 with spaces instead of control characters, without characters that only
/// control the layout of others (U+200B, U+202E ...).
std::string written(std::string_view text);

/// Widths are computed in the font's own units, without hinting and kerning, so they are the same everywhere. All texts
/// are treated as by `written`. A box replaces a character missing from the font.
class Lettering {
 public:
  /// Opens `file`, or the font of Debian's package fonts-osifont. Throws Error{input} if there is none.
  explicit Lettering(const std::filesystem::path& file = {});

  /// Length of a line of text, mm, with capitals `height` mm high.
  [[nodiscard]] double width(std::string_view text, double height) const;

  /// The characters of the text missing from the font, each once, in their order.
  [[nodiscard]] std::vector<std::string> missing(std::string_view text) const;

  /// Outlines of a line of text that begins at the origin, mm, to be filled by the non-zero rule.
  [[nodiscard]] std::vector<GlyphOutline> outlines(std::string_view text, double height) const;

  /// Size of the font (its em) relative to the height of capitals.
  [[nodiscard]] double em() const;

  [[nodiscard]] const std::filesystem::path& file() const;

 private:
  class Font;
  std::shared_ptr<const Font> font_;
};

/// A character of a sheet missing from the font.
struct MissingCharacter {
  std::string character;  ///< UTF-8
  std::string role;       ///< of the first text that contains it
};

/// Each such character once, in the order of the texts. Opens the font only if there are texts.
std::vector<MissingCharacter> missing_characters(const Sheet& sheet);

}  // namespace epura::sheet
