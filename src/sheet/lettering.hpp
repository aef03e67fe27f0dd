// The font of all lettering on a sheet: osifont, drawn after ISO 3098.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.hpp"

namespace epura {

/// A closed outline of quadratic curves (TrueType): from the end of one to the end of the next, the first one from the
/// end of the last. A straight piece has its control point in its middle.
struct GlyphOutline {
  struct Curve {
    Vec2 control, end;
  };
  std::vector<Curve> curves;
};

/// Widths are those of the font's own units, without hinting and kerning: the same everywhere.
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
  struct Font;
  std::shared_ptr<const Font> font_;
};

}  // namespace epura
