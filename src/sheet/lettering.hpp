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

/// A closed outline of quadratic curves (TrueType): from the end of one to the end of the next, the first one from the
/// end of the last. A straight piece has its control point in its middle.
struct GlyphOutline {
  struct Curve {
    Vec2 control, end;
  };
  std::vector<Curve> curves;
};

/// What is written of a line of text: valid UTF-8 with spaces in place of control characters, without the characters
/// that only steer the layout of others (U+200B, U+202E ...).
std::string written(std::string_view text);

/// Widths are those of the font's own units, without hinting and kerning: the same everywhere. All texts are taken as
/// they are written. A box replaces a character missing from the font.
class Lettering {
 public:
  /// Opens `file`, or the font of Debian's package fonts-osifont. Throws Error{input} when there is none.
  explicit Lettering(const std::filesystem::path& file = {});

  /// Length of a line of text, mm, whose capitals are `height` mm high.
  [[nodiscard]] double width(std::string_view text, double height) const;

  /// Characters of the text that the font cannot write, each once, in their order.
  [[nodiscard]] std::vector<std::string> missing(std::string_view text) const;

  /// Outlines of a line of text that begins at the origin, mm, to be filled by the non-zero rule.
  [[nodiscard]] std::vector<GlyphOutline> outlines(std::string_view text, double height) const;

  /// Size of the font (its em), in heights of capitals.
  [[nodiscard]] double em() const;

  [[nodiscard]] const std::filesystem::path& file() const;

 private:
  class Font;
  std::shared_ptr<const Font> font_;
};

/// A character of a sheet that the font cannot write.
struct MissingCharacter {
  std::string character;  ///< UTF-8
  std::string role;       ///< of the first text that has it
};

/// Each such character once, in the order of the texts. Opens the font where there are texts.
std::vector<MissingCharacter> missing_characters(const Sheet& sheet);

}  // namespace epura::sheet
