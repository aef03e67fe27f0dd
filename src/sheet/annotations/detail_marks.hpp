// SPDX-License-Identifier: Apache-2.0
// Details: where they are in the enlarged view, and the boundary of the view that shows them. ISO 128-3.
#pragma once

#include <span>
#include <string>

#include "drawing/boundary.hpp"
#include "sheet/boxes.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// A detail in the view that it enlarges.
struct DetailMark {
  std::string name;
  drawing::Boundary boundary;  ///< mm on paper
};

/// Room for the letter outside the boundary of a detail, mm.
inline constexpr double detail_room = 8;

/// The box of a boundary.
inline Rectangle box_of(const drawing::Boundary& boundary) {
  return {boundary.centre - boundary.half, boundary.centre + boundary.half};
}

/// The boundary as a narrow continuous line.
Stroke boundary_line(const drawing::Boundary& boundary);

/// Where letters may be.
struct LetterRoom {
  Rectangle area;                     ///< letters are inside it
  std::span<const Layer> drawn;       ///< letters do not touch their ink
  std::vector<TurnedBox> reserved{};  ///< nor these areas
};

/// Layer "VIEW/detail" of an enlarged view: the boundaries of its details, and their names next to them where there is
/// no ink, as near as possible; farther away, a leader line joins them.
Layer detail_marks(const std::string& view, std::span<const DetailMark> marks, const LetterRoom& room,
                   const Lettering& lettering, const LineWidths& widths);

}  // namespace epura::sheet
