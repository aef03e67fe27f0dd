// The font of all lettering on a sheet: osifont, drawn after ISO 3098.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace epura {

/// Widths are those of the font's own units, without hinting and kerning: the same everywhere.
class Lettering {
 public:
  /// Opens `file`, or the font of Debian's package fonts-osifont. Throws Error{input} when there is none.
  explicit Lettering(const std::filesystem::path& file = {});

  /// Length of a line of text, mm, whose capitals are `height` mm high.
  [[nodiscard]] double width(std::string_view text, double height) const;

  /// Characters of the text that the font cannot write, each once, in their order.
  [[nodiscard]] std::vector<std::string> missing(std::string_view text) const;

 private:
  struct Font;
  std::shared_ptr<const Font> font_;
};

}  // namespace epura
