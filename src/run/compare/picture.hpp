// SPDX-License-Identifier: Apache-2.0
// The appearance of a drawing, independent of its format: straight pieces of lines, areas and texts, without chaining,
// order and numbering of lines.
#pragma once

#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::compare {

/// Style of a line, or of the border of a filled area.
struct PictureLook {
  std::string name{};            ///< for people: "visible", "hidden", "dimension" ...; not compared
  bool visible = true;           ///< false: a hidden edge
  bool filled = false;           ///< the border of an area that is filled
  double width = 0;              ///< the border of a filled area
  std::vector<double> dashes{};  ///< mm: ink, gap, ink, gap ...; empty: continuous
  std::string colour = "#000000";
  bool is_short = false;  ///< no line of its layer is long enough to show the dashes; not compared, but without dashes
                          ///< beside a PDF, which tells them by the lines alone

  bool operator==(const PictureLook&) const = default;
};

/// Represents the dashes of a broken line with an unknown pattern.
inline const std::vector<double> some_dashes = {3, 0.75};

/// Numbers are indices of the lists of the picture.
struct PicturePiece {
  Vec2 from, to;  ///< mm, y up from the lower left corner
  int look;
  int view;
  int origin;  ///< -1 if the edges are unknown
};

struct PictureText {
  std::string words;  ///< UTF-8
  Vec2 min, max;      ///< box of the outlines of its letters with their control points, mm
  int view;
};

/// One page.
struct Picture {
  Vec2 size;  ///< mm
  std::vector<PictureLook> looks{};
  std::vector<std::string> views{};
  std::vector<std::string> origins{};  ///< edges of the model: "model:vertex-vertex", separated by spaces
  std::vector<PicturePiece> pieces{};
  std::vector<PictureText> texts{};
};

/// The number of a name in a list, to which it is added if necessary.
int number_of_name(std::vector<std::string>& names, const std::string& name);

/// The same for a look with its name.
int number_of_look(std::vector<PictureLook>& looks, const PictureLook& look);

}  // namespace epura::compare
