// SPDX-License-Identifier: Apache-2.0
// The fonts of this computer, for characters that the lettering font lacks.
#pragma once

#include <memory>
#include <string>

#include "sheet/font_file.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The font of a file, or the upright outline font of a family whose weight is nearest to normal. A text with a slash
/// or with the extension of a font file is a file. Throws Error{input} with `where` as the location of the text.
Font find_font(const std::string& text, const std::string& where);

/// Upright outline fonts of normal weight, as fontconfig sorts them for "sans-serif", whatever the user's language.
/// The list is read on first use. Thread-safe.
class InstalledFonts {
 public:
  InstalledFonts();
  ~InstalledFonts();
  InstalledFonts(const InstalledFonts&) = delete;
  InstalledFonts& operator=(const InstalledFonts&) = delete;

  /// The first font that has all these characters; null if none has. Lives as long as this object.
  [[nodiscard]] const FontFile* font_with(const std::u32string& characters) const;

 private:
  struct List;
  std::unique_ptr<List> list_;
};

}  // namespace epura::sheet
