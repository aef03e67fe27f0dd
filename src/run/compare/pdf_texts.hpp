// SPDX-License-Identifier: Apache-2.0
// The texts of PDF content streams. ISO 32000-1, 9.4.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "compare/pdf_operations.hpp"
#include "compare/picture.hpp"
#include "output/pdf/contents.hpp"
#include "sheet/lettering.hpp"
#include "svg/affine_map.hpp"
#include "svg/flatten.hpp"

namespace epura::compare {

/// Puts glyphs together to texts: those of one size and direction, each of which begins where the last one ends.
class PdfTexts {
 public:
  /// Both are kept as references; glyphs count as pieces.
  PdfTexts(const std::map<std::string, output::PdfFont>& fonts, svg::PieceRoom& room) : fonts_(fonts), room_(room) {}

  /// Takes any operator, most of which have nothing to do with texts. `map` is from user space to the page, mm. Throws
  /// Error{input} for too many glyphs.
  void take(const PdfOperation& operation, const svg::AffineMap& map);

  /// Those since the last call, with boxes from their first to their last glyph as high as capitals. They are of
  /// `view`.
  std::vector<PictureText> finish(int view);

 private:
  struct Line {
    std::string words;
    Vec2 from, to;  // on the base line, mm
    double em;      // mm
  };

  void show(const PdfOperation& operation, const svg::AffineMap& map);
  void add_glyph(const std::string& words, double width, const svg::AffineMap& map);

  const std::map<std::string, output::PdfFont>& fonts_;
  svg::PieceRoom& room_;
  svg::AffineMap line_{}, glyph_{};
  const output::PdfFont* font_ = nullptr;
  double size_ = 0;  // of the font, in units of text space
  std::vector<Line> lines_{};
  std::optional<sheet::Lettering> lettering_{};
};

}  // namespace epura::compare
