// SPDX-License-Identifier: Apache-2.0
// The visible differences between two drawings.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compare/picture.hpp"
#include "compare/read_pictures.hpp"

namespace epura::compare {

/// `visibility`: a visible line became hidden, or vice versa. `restyled`: another width, dash pattern or colour.
enum class Change { size, removed, added, moved, visibility, restyled, text };

std::string_view name_of(Change change);

/// A difference in one line, area border, text or page.
struct Difference {
  Change change;
  int page;                       ///< from 1
  std::string view{};             ///< as in the names of layers
  std::string before{}, after{};  ///< line styles, texts or page sizes; empty if absent
  /// Ends of a line in the drawing that contains it, in the new one if it moved; box of a text; of a view, `to` is by
  /// how much it moved.
  Vec2 from{0, 0}, to{0, 0};
  Vec2 centre{0, 0};     ///< of gravity of a line
  double length = 0;     ///< of a line, mm
  double distance = 0;   ///< by which it moved, mm
  std::string origin{};  ///< edges of the model, if known
  bool is_text = false;
  bool is_view = false;               ///< a whole view moved, and its content is compared as if it had not
  Vec2 old_from{0, 0}, old_to{0, 0};  ///< in the old drawing, of a line or text that moved
  double old_length = 0;
};

/// A requirement of a model that another revision of it states in other words; empty where one has none like it.
struct RequirementChange {
  std::string before, after;
};

/// How an item is painted: a moved line is `removed` at its old and `added` at its new position.
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
  Vec2 size;  ///< large enough for both pages
  std::vector<MarkedPiece> pieces{};
  std::vector<MarkedText> texts{};
};

struct Comparison {
  std::vector<Difference> differences{};  ///< by page, change and position
  std::vector<PageComparison> pages{};
  bool compares_texts = true;
  std::size_t followers = 0;  ///< differences that are not in the list, because they follow from sizes that changed
  std::vector<RequirementChange> requirements{};

  [[nodiscard]] bool is_same() const { return differences.empty() && requirements.empty(); }
};

/// mm; an item farther away has not moved: it was removed there and added here.
inline constexpr double max_moved = 5;

/// Lines are compared as sets of points: how they are cut, chained, ordered and numbered does not matter, and of
/// several lines within the tolerance of each other, only the widest counts. A line is the same if a line of the same
/// look lies within `tolerance` mm of it along its whole length; pieces shorter than 0.002 mm are ignored. A line in
/// only one drawing has moved if the other drawing has the same line within 5 mm, or has a line of the same edge. Views
/// that stand elsewhere on their sheet are compared where they stand in the new drawing; and if sizes changed, lines
/// that only follow them are counted, not listed.
/// Throws Error{input} for JSON with another format.
Comparison compare(const PictureFile& before, const PictureFile& after, double tolerance);

/// What the models of one revision require and those of the other do not, in words: changed, removed, then added.
/// Numbers of faces and, where nothing else is like it, ids may change with every export, so neither counts.
std::vector<RequirementChange> compare_requirements(std::vector<report::RequirementRow> before,
                                                    std::vector<report::RequirementRow> after);

/// One line for each difference, and a last line with their number.
std::string format_comparison(const Comparison& comparison, double tolerance);

/// The same as Markdown for a comment on a change, of at most 20 lines.
std::string to_markdown(const Comparison& comparison, double tolerance, const std::string& before,
                        const std::string& after);

/// The same in machine-readable form (docs/reports.md); `before` and `after` are the names of the files.
std::string to_json(const Comparison& comparison, double tolerance, const std::string& before,
                    const std::string& after);

}  // namespace epura::compare
