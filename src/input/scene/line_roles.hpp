// SPDX-License-Identifier: Apache-2.0
// The line roles of sheets, one row each: name, width and dashes. ISO 128-2. Sheets, writers and comparison use this
// table. It is in `scene` because a model's role is chosen in the scene.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "scene/choices.hpp"

namespace epura::scene {

/// Nominal lengths of a line type, in line widths; dash 0: continuous.
struct DashType {
  double dash = 0, gap = 0, dot = 0;
  int dots = 0;
  const char* dxf = "CONTINUOUS";  ///< beginning of its name there

  [[nodiscard]] constexpr bool is_broken() const { return dash > 0; }
  /// Length of the pattern without the dash.
  [[nodiscard]] constexpr double rest() const { return gap + dots * (dot + gap); }
  /// Shorter lines are drawn continuous: two dashes and the pattern between them do not fit.
  [[nodiscard]] constexpr double shortest() const { return 2 * dash + rest(); }
};

inline constexpr DashType continuous_line{};                              ///< type 01
inline constexpr DashType dashed{12, 3, 0, 0, "DASHED"};                  ///< type 02
inline constexpr DashType long_dash_dot{24, 3, 0.5, 1, "DASHDOT"};        ///< type 04
inline constexpr DashType long_dash_double_dot{24, 3, 0.5, 2, "DIVIDE"};  ///< type 05

/// Returns the broken type with this number of dots between its dashes; at most two.
constexpr const DashType& type_with_dots(int dots) {
  return dots == 0 ? dashed : dots == 1 ? long_dash_dot : long_dash_double_dot;
}

/// `wide` and `narrow` depend on the size of the sheet, the others are the same on all sheets (ISO 5457, ISO 7200).
enum class LineWidth { wide, narrow, frame, grid, symbol };

/// In painting order within one view.
enum class SheetLine {
  frame,
  grid,
  title_block,
  symbol_axes,
  text,
  construction,
  hatch,
  centre,
  hidden,
  hidden_solid,
  neighbour,
  target,
  narrow,
  tangent,
  thread,
  wire,
  section,
  visible,
  wide,
  dimension,
  cutting_plane,
  detail,
  limit,
  revolved,
  trace,
  arrows,
  balloon,
  cloud,
  note,
  symbol,
  table,
  parts_list,
  form,
  logo,
  partial
};

struct SheetLineRow {
  SheetLine line;
  const char* name;   ///< name of the style: class in SVG
  const char* layer;  ///< name of the layer after "VIEW/"
  LineWidth width;
  DashType dashes{};  ///< dashes of all lines of the layer; individual lines of other layers may also be broken
  bool is_hidden = false;
  std::optional<LineRole> role{};  ///< role of the models whose visible lines these are
};

inline constexpr std::array sheet_lines = {
    SheetLineRow{SheetLine::frame, "frame", "frame", LineWidth::frame},
    SheetLineRow{SheetLine::grid, "grid", "grid", LineWidth::grid},
    SheetLineRow{SheetLine::title_block, "title-block", "title-block", LineWidth::grid},
    SheetLineRow{SheetLine::symbol_axes, "centre-lines", "centre-lines", LineWidth::symbol},
    SheetLineRow{SheetLine::text, "text", "text", LineWidth::grid},
    SheetLineRow{SheetLine::construction, "construction", "construction", LineWidth::narrow},
    SheetLineRow{SheetLine::hatch, "hatch", "hatch", LineWidth::narrow},
    SheetLineRow{SheetLine::centre, "centre", "centre", LineWidth::narrow, long_dash_dot},
    SheetLineRow{SheetLine::hidden, "hidden", "hidden", LineWidth::narrow, dashed, true},
    SheetLineRow{SheetLine::hidden_solid, "hidden-solid", "hidden-solid", LineWidth::narrow, continuous_line, true},
    SheetLineRow{SheetLine::neighbour, "neighbour", "neighbour", LineWidth::narrow, long_dash_double_dot, false,
                 LineRole::neighbour},
    SheetLineRow{SheetLine::target, "target", "targets", LineWidth::narrow},
    SheetLineRow{SheetLine::narrow, "narrow", "narrow", LineWidth::narrow, continuous_line, false, LineRole::narrow},
    SheetLineRow{SheetLine::tangent, "tangent", "tangent", LineWidth::narrow},
    SheetLineRow{SheetLine::thread, "thread", "thread", LineWidth::narrow},
    SheetLineRow{SheetLine::wire, "wire", "wire", LineWidth::narrow},
    SheetLineRow{SheetLine::section, "section", "section", LineWidth::wide},
    SheetLineRow{SheetLine::visible, "visible", "visible", LineWidth::wide, continuous_line, false, LineRole::visible},
    SheetLineRow{SheetLine::wide, "wide", "wide", LineWidth::wide, continuous_line, false, LineRole::wide},
    SheetLineRow{SheetLine::dimension, "dimension", "dimensions", LineWidth::narrow},
    SheetLineRow{SheetLine::cutting_plane, "cutting-plane", "cutting-plane", LineWidth::narrow},
    SheetLineRow{SheetLine::detail, "detail", "detail", LineWidth::narrow},
    SheetLineRow{SheetLine::limit, "limit", "limit", LineWidth::narrow},
    SheetLineRow{SheetLine::revolved, "revolved", "revolved", LineWidth::narrow},
    SheetLineRow{SheetLine::trace, "trace", "trace", LineWidth::narrow, long_dash_dot},
    SheetLineRow{SheetLine::arrows, "arrows", "arrows", LineWidth::narrow},
    SheetLineRow{SheetLine::balloon, "balloon", "balloons", LineWidth::narrow},
    SheetLineRow{SheetLine::cloud, "cloud", "clouds", LineWidth::narrow},
    SheetLineRow{SheetLine::note, "note", "notes", LineWidth::narrow},
    SheetLineRow{SheetLine::symbol, "symbol", "symbols", LineWidth::narrow},
    SheetLineRow{SheetLine::table, "table", "tables", LineWidth::grid},
    SheetLineRow{SheetLine::parts_list, "parts-list", "parts-list", LineWidth::grid},
    SheetLineRow{SheetLine::form, "template", "template", LineWidth::grid},
    SheetLineRow{SheetLine::logo, "logo", "logo", LineWidth::grid},
    SheetLineRow{SheetLine::partial, "partial", "partial", LineWidth::wide},
};

static_assert(std::all_of(sheet_lines.begin(), sheet_lines.end(), [](const SheetLineRow& row) {
  return &sheet_lines[static_cast<std::size_t>(row.line)] == &row;
}));

constexpr const SheetLineRow& row_of(SheetLine line) { return sheet_lines[static_cast<std::size_t>(line)]; }

/// Returns the kind of visible lines for models with this role.
constexpr SheetLine line_of(LineRole role) {
  return std::find_if(sheet_lines.begin(), sheet_lines.end(),
                      [role](const SheetLineRow& row) { return row.role == role; })
      ->line;
}

/// Finds a row by the name of its style, or of its layer without the view; null if there is none. The names of layers
/// of single bodies have more words, which do not count.
constexpr const SheetLineRow* find_line(std::string_view name) {
  name = name.substr(0, name.find(' '));
  const auto is_it = [name](const SheetLineRow& row) { return row.name == name || row.layer == name; };
  const auto found = std::find_if(sheet_lines.begin(), sheet_lines.end(), is_it);
  return found == sheet_lines.end() ? nullptr : &*found;
}

template <>
struct Words<LineRole> {
  static constexpr auto list = [] {
    constexpr auto has_role = [](const SheetLineRow& row) { return row.role.has_value(); };
    std::array<const char*, std::count_if(sheet_lines.begin(), sheet_lines.end(), has_role)> words{};
    for (const SheetLineRow& row : sheet_lines)
      if (row.role) words[static_cast<std::size_t>(*row.role)] = row.name;
    return words;
  }();
};

}  // namespace epura::scene
