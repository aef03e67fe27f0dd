// SPDX-License-Identifier: Apache-2.0
// The visible differences between two drawings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compare/picture.hpp"
#include "compare/read_pictures.hpp"

namespace epura::compare {

/// `visibility`: a visible line became hidden, or the other way round. `restyled`: another width, dashes or colour.
enum class Change { size, removed, added, moved, visibility, restyled, text };

std::string_view name_of(Change change);

/// One line, area border, text or page that is not the same.
struct Difference {
  Change change;
  int page;                       ///< from 1
  std::string view{};             ///< as the layers are called
  std::string before{}, after{};  ///< styles of lines, words of texts, sizes of pages; empty if absent
  Vec2 from{0, 0},
      to{0, 0};          ///< ends of a line in the drawing that has it, in the new one where it moved; box of a text
  double length = 0;     ///< of a line, mm
  double distance = 0;   ///< by which it moved, mm
  std::string origin{};  ///< edges of the model, where known
  bool is_text = false;
};

/// An item of either drawing, to be painted: `moved` is painted at its old and new position.
enum class Mark { same, changed, removed, added };

struct MarkedPiece {
  Vec2 from, to;
  PictureLook look;
  Mark mark;
};

struct MarkedText {
  PictureText text;
  Mark mark;
};

struct PageComparison {
  Vec2 size;  ///< that holds both pages
  std::vector<MarkedPiece> pieces{};
  std::vector<MarkedText> texts{};
};

struct Comparison {
  std::vector<Difference> differences{};  ///< by page, change and place
  std::vector<PageComparison> pages{};
  bool compares_texts = true;
};

/// What is farther away has not moved, mm: it was removed there and added here.
inline constexpr double most_moved = 5;

/// Lines are sets of points: how they are cut, chained, ordered and numbered does not count, and where several lie
/// within the tolerance of one another, the widest is seen. A line is the same if one of the same look lies within
/// `tolerance` mm of it over all its length; pieces shorter than 0.002 mm are not seen. What is only in one drawing has
/// moved if the other has the same line within 5 mm, or has a line of the same edge. Throws Error{input} for JSON
/// with another format.
Comparison compare(const PictureFile& before, const PictureFile& after, double tolerance);

/// One line for each difference, and a last line that counts them.
std::string format_comparison(const Comparison& comparison, double tolerance);

/// The same for programs (docs/formats.md); `before` and `after` are the names of the files.
std::string to_json(const Comparison& comparison, double tolerance, const std::string& before,
                    const std::string& after);

}  // namespace epura::compare
