// SPDX-License-Identifier: Apache-2.0
// Assembles a picture from the content of a file, and rejects content that no drawing has, such as positions
// outside any paper.
#pragma once

#include <string>
#include <utility>

#include "compare/picture.hpp"

namespace epura::compare {

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
