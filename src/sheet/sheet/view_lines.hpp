// SPDX-License-Identifier: Apache-2.0
// Drawing -> layers of strokes with line types and widths. ISO 128-2.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The role of an edge on a sheet, unless its model has its own role. Hidden edges between smooth faces have none.
std::optional<scene::SheetLine> edge_line(EdgeKind kind, bool visible);

/// How the cut faces of one body are hatched, as far as it is given.
struct HatchStyle {
  std::optional<HatchPattern> pattern{};
  std::optional<double> angle{};  ///< degrees counterclockwise
  std::optional<double> pitch{};  ///< mm
};

/// How one body is drawn.
struct BodyStyle {
  LineRole line = LineRole::visible;
  HiddenLines hidden = HiddenLines::dashed;
  Colour colour{};
  HatchStyle hatch{};
  std::string layer{};  ///< name of layers of its own; empty: it shares those of the view
};

/// How all bodies are drawn.
struct BodyStyles {
  std::vector<std::vector<BodyStyle>> of_model;  ///< by body; or a single one for all bodies

  /// The style of a body; of an unnamed one (-1), that of the first.
  [[nodiscard]] const BodyStyle& operator()(int model, int body) const;
  template <class Test>
  [[nodiscard]] bool any(const Test& test) const {
    return std::any_of(of_model.begin(), of_model.end(), [&](const std::vector<BodyStyle>& styles) {
      return std::any_of(styles.begin(), styles.end(), test);
    });
  }
};

/// Of two coinciding lines, the one with the greater number is seen: visible before hidden, wide before narrow, as they
/// are painted. Below 0: not drawn.
int line_strength(EdgeKind kind, bool visible, const BodyStyle& style);

/// Layers of a drawing in its final position, to be painted in this order:
///   VIEW/hidden     hidden lines: narrow, dashed (type 02.1) or continuous
///   VIEW/neighbour, VIEW/narrow   visible lines of models with that role
///   VIEW/tangent    visible edges between smooth faces: narrow, continuous, short of the lines that they end at
///   VIEW/section    outlines of cut faces: wide, continuous
///   VIEW/visible    visible lines: wide, continuous
/// Bodies with a layer or a colour of their own have layers "VIEW/visible NAME #rrggbb" likewise.
/// The first and the last layer are present even if they are empty, unless no model has hidden lines. Dashed lines have
/// ink at their ends, at corners and where other lines cross them, unless there are too many crossings. Hidden edges
/// between smooth faces are omitted.
std::vector<Layer> view_layers(const drawing::ViewDrawing& drawing, const LineWidths& widths, const BodyStyles& styles,
                               const Progress& progress = {});

}  // namespace epura::sheet
