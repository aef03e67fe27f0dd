// SPDX-License-Identifier: Apache-2.0
// A bound on what a file may stand for: a few bytes can stand for curves of millions of pieces.
#pragma once

#include <cstddef>
#include <string>

namespace epura::svg {

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
  std::size_t max_, left_;
};

}  // namespace epura::svg
