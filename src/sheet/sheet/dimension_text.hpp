// SPDX-License-Identifier: Apache-2.0
// The text of a dimension: a line, parts of which may be two numbers above each other. ISO 129-1.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace epura::sheet {

/// A part of the text, or, with a lower one, two numbers above each other with their decimal signs aligned.
struct TextPiece {
  std::string upper;
  std::string lower{};

  [[nodiscard]] bool is_stack() const { return !lower.empty(); }
};

struct DimensionText {
  std::vector<TextPiece> pieces;
  bool framed = false;  ///< theoretically exact. ISO 1101

  DimensionText() = default;
  DimensionText(std::string line) { add(std::move(line)); }  // NOLINT(google-explicit-constructor): most are lines

  void add(const std::string& line) {
    if (line.empty()) return;
    if (!pieces.empty() && !pieces.back().is_stack())
      pieces.back().upper += line;
    else
      pieces.push_back({line});
  }
  void add(const DimensionText& text) {
    for (const TextPiece& piece : text.pieces) piece.is_stack() ? pieces.push_back(piece) : add(piece.upper);
  }

  [[nodiscard]] bool has_stack() const {
    for (const TextPiece& piece : pieces)
      if (piece.is_stack()) return true;
    return false;
  }

  /// As one line: "20 +0.2/-0.1".
  [[nodiscard]] std::string line() const {
    std::string text;
    for (const TextPiece& piece : pieces) text += piece.upper + (piece.is_stack() ? "/" + piece.lower : "");
    return text;
  }
};

}  // namespace epura::sheet
