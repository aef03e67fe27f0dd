// SPDX-License-Identifier: Apache-2.0
// Assembles a picture from the content of a file, and rejects content that no drawing has: a few bytes can stand for
// curves of millions of pieces, or for positions outside any paper.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "compare/picture.hpp"

namespace epura::compare {

/// How many more pieces of lines a file may contain. A line takes at least two bytes, but a piece of a curve takes
/// fewer.
class PieceRoom {
 public:
  /// Allows 250 000, and one for every two bytes. `where` names the file in errors.
  PieceRoom(std::size_t bytes, std::string where);

  /// Throws Error{input} if there are too many.
  void take(std::size_t pieces);

 private:
  std::string where_;
  std::size_t most_, left_;
};

/// Throws Error{input} for more than 200 looks or 2000 views, and for positions and lengths that are not numbers or
/// beyond all paper.
class PictureMaker {
 public:
  explicit PictureMaker(std::string where) : where_(std::move(where)), picture_{Vec2(0, 0)} {}

  void set_size(const Vec2& size);
  /// The number in the picture, to which the look is added if necessary.
  int look(const PictureLook& look);
  int view(const std::string& name);
  /// Returns the number of the first one.
  int add_origins(std::vector<std::string> origins);
  void add(const PicturePiece& piece);
  void add(const PictureText& text);

  [[nodiscard]] const Vec2& size() const { return picture_.size; }
  [[nodiscard]] Picture finish() { return std::move(picture_); }

 private:
  void expect_on_paper(const Vec2& place) const;

  std::string where_;
  Picture picture_;
};

}  // namespace epura::compare
