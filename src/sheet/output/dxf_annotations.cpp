// SPDX-License-Identifier: Apache-2.0
#include "output/dxf_annotations.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "base/error.hpp"
#include "output/dxf_tables.hpp"
#include "scene/geometric_tolerances.hpp"

namespace epura::output {

namespace {

constexpr int by_layer = -1073741824, by_block = -1056964608;  // colours as MULTILEADER encodes them
constexpr double dot_diameter = 0.5;                           // of its block, in lengths of arrows
constexpr double dot_on_sheet = 1.25;                          // mm

void add_all(DxfWriter& dxf, std::initializer_list<std::array<int, 2>> groups) {
  for (const auto& [code, value] : groups) dxf.add(code, value);
}

double head_length(const sheet::LeaderObject& leader) {
  return leader.end == LeaderEnd::dot ? dot_on_sheet / dot_diameter : leader.arrow;
}

// Whether the text is on the left of where the leader ends.
bool is_to_left(const sheet::LeaderObject& leader) {
  const std::size_t count = leader.points.size();
  return leader.points[count - 1].x < leader.points[count - 2].x;
}

std::string paragraphs(const std::vector<std::string>& lines, DxfVersion version) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\\P") + dxf_paragraph(line, version);
  return text;
}

constexpr int attached_by_underline = 5;  // of the last line

// What AutoCAD calls the context: where the text and the leader are.
void add_text_context(DxfWriter& dxf, const sheet::LeaderObject& leader, const DxfHandles& handles) {
  dxf.add(290, 1);  // a text
  dxf.add(304, paragraphs(leader.lines, dxf.version()));
  dxf.add_point(11, {0, 0});
  dxf.add(31, 1.0);
  dxf.add_handle(340, handles.text_style);
  dxf.add_point(12, leader.text_corner);
  dxf.add_point(13, {1, 0});
  for (const int code : {42, 43, 44}) dxf.add(code, 0.0);  // rotation, width, height: those of the text
  dxf.add(45, 1.0);
  constexpr int from_left = 1;
  add_all(dxf, {{170, 1}, {90, by_block}, {171, from_left}, {172, 1}, {91, by_layer}, {141, 1}, {92, 0}, {291, 0}});
  add_all(dxf, {{292, 0}, {173, 0}, {293, 0}, {142, 0}, {143, 0}, {294, 0}, {295, 0}});
}

void add_context(DxfWriter& dxf, const sheet::LeaderObject& leader, const Vec2& end, const DxfHandles& handles) {
  const bool has_text = !leader.lines.empty();
  dxf.add(300, "CONTEXT_DATA{");
  dxf.add(40, 1.0);
  dxf.add_point(10, end);
  dxf.add(41, has_text ? leader.text_height : leader.arrow);
  dxf.add(140, head_length(leader));
  dxf.add(145, 0.0);  // between leader and text
  add_all(dxf, {{174, attached_by_underline}, {175, attached_by_underline}, {176, 0}, {177, 0}});
  if (has_text)
    add_text_context(dxf, leader, handles);
  else
    dxf.add(290, 0);
  dxf.add(296, 0);  // no block
  dxf.add_point(110, end);
  dxf.add_point(111, {1, 0});
  dxf.add_point(112, {0, 1});
  dxf.add(297, 0);
  dxf.add(302, "LEADER{");
  dxf.add(290, 1);
  dxf.add(291, 1);
  dxf.add_point(10, end);
  dxf.add_point(11, {is_to_left(leader) ? -1 : 1, 0});
  dxf.add(90, 0);
  dxf.add(40, 0.0);
  dxf.add(304, "LEADER_LINE{");
  const std::size_t before_end = leader.points.size() - 1;
  for (std::size_t i = 0; i < before_end && (i == 0 || leader.points[i] != end); ++i)
    dxf.add_point(10, leader.points[i]);
  dxf.add(91, 0);
  dxf.add(92, by_layer);
  dxf.add(305, "}");
  dxf.add(303, "}");
  dxf.add(301, "}");
}

// The letter of the symbol in the font of AutoCAD.
char letter_of(Characteristic characteristic) {
  switch (characteristic) {
    case Characteristic::straightness:
      return 'u';
    case Characteristic::flatness:
      return 'c';
    case Characteristic::roundness:
      return 'e';
    case Characteristic::cylindricity:
      return 'g';
    case Characteristic::line_profile:
      return 'k';
    case Characteristic::surface_profile:
      return 'd';
    case Characteristic::parallelism:
      return 'f';
    case Characteristic::perpendicularity:
      return 'b';
    case Characteristic::angularity:
      return 'a';
    case Characteristic::position:
      return 'j';
    case Characteristic::concentricity:
      return 'r';
    case Characteristic::symmetry:
      return 'i';
    case Characteristic::circular_run_out:
      return 'h';
    case Characteristic::total_run_out:
      return 't';
  }
  return 'j';
}

std::string in_symbols(char letter) { return std::string("{\\Fgdt;") + letter + "}"; }

// Letters in circles that the font has; others in brackets.
std::string written(const scene::FramePiece& piece, DxfVersion version) {
  if (!piece.circled) {
    std::string text;
    std::string_view rest = piece.text;
    for (const std::string_view sign : {std::string_view("⌀"), std::string_view("Ø")})
      if (const std::size_t at = rest.find(sign); at != std::string_view::npos) {
        text = dxf_paragraph(rest.substr(0, at), version) + in_symbols('n');
        rest.remove_prefix(at + sign.size());
      }
    return text + dxf_paragraph(rest, version);
  }
  if (piece.text == "M") return in_symbols('m');
  if (piece.text == "L") return in_symbols('l');
  if (piece.text == "P") return in_symbols('p');
  return "(" + dxf_paragraph(piece.text, version) + ")";
}

// Compartments are separated by %%v, rows by ^J.
std::string text_of(const sheet::ToleranceObject& tolerance, DxfVersion version) {
  std::string text;
  for (const sheet::FrameRow& row : tolerance.rows) {
    if (!text.empty()) text += "^J";
    text += in_symbols(letter_of(row.characteristic));
    for (const scene::FrameCell& cell : row.cells) {
      text += "%%v";
      for (const scene::FramePiece& piece : cell) text += written(piece, version);
    }
  }
  return text;
}

struct CellSpan {
  std::size_t columns, rows;
};

void add_cell(DxfWriter& dxf, const sheet::TableCell& cell, const CellSpan& span, bool is_merged) {
  constexpr int text_cell = 1, own_alignment = 1, middle_left = 4, middle_right = 6;
  const std::string text = dxf_paragraph(cell.text, dxf.version());
  dxf.add(171, text_cell);
  dxf.add(172, 0);
  dxf.add(173, is_merged ? 1 : 0);
  dxf.add(174, 0);
  dxf.add(175, static_cast<int>(span.columns));
  dxf.add(176, static_cast<int>(span.rows));
  dxf.add(91, own_alignment);
  dxf.add(178, 0);
  dxf.add(145, 0.0);
  dxf.add(170, cell.is_right ? middle_right : middle_left);
  dxf.add(92, 0);
  dxf.add(301, "CELL_VALUE");
  dxf.add(93, 6);
  dxf.add(90, 4);  // a text
  dxf.add(1, text);
  dxf.add(94, 0);
  dxf.add(300, "");
  dxf.add(302, text);
  dxf.add(304, "ACVALUE_END");
}

void add_class(DxfWriter& dxf, std::string_view record, std::string_view name, bool is_entity) {
  dxf.add(0, "CLASS");
  dxf.add(1, record);
  dxf.add(2, name);
  dxf.add(3, "ObjectDBX Classes");
  dxf.add(90, is_entity ? 1025 : 4095);  // what programs that do not know it may do
  dxf.add(280, 0);
  dxf.add(281, is_entity ? 1 : 0);
}

}  // namespace

void add_dot_head(DxfWriter& dxf, int owner) {
  static const std::string layer = "0";
  begin_entity(dxf, {owner, layer, false, true}, "LWPOLYLINE", "AcDbPolyline");
  dxf.add(90, 2);
  dxf.add(70, 1);                 // closed
  dxf.add(43, dot_diameter / 2);  // a line as wide as its radius fills the circle
  for (const double x : {-dot_diameter / 4, dot_diameter / 4}) {
    dxf.add(10, Vec2(x, 0));
    dxf.add(42, 1.0);
  }
}

void add_leader(DxfWriter& dxf, const Place& place, const sheet::LeaderObject& leader, int head,
                const DxfHandles& handles) {
  check(leader.points.size() > 1, "a leader has two ends");
  // A text stands on the last piece, as its underline.
  const bool has_text = !leader.lines.empty();
  const std::size_t last = leader.points.size() - 1;
  const Vec2 end = leader.points[has_text && last > 1 ? last - 1 : last];
  begin_entity(dxf, place, "MULTILEADER", "AcDbMLeader");
  dxf.add(270, 2);
  add_context(dxf, leader, end, handles);
  dxf.add_handle(340, handles.leader_style);
  dxf.add(90, 0x7fffffff);  // all is told here, nothing by the style
  dxf.add(170, 1);          // straight
  dxf.add(91, by_layer);
  dxf.add(171, -1);  // line weight of the layer
  dxf.add(290, 1);
  dxf.add(291, 0);
  dxf.add(41, 0.0);
  if (head != 0) dxf.add_handle(342, head);
  dxf.add(42, head_length(leader));
  dxf.add(172, has_text ? 2 : 0);
  dxf.add_handle(343, handles.text_style);
  add_all(dxf, {{173, attached_by_underline}, {95, attached_by_underline}, {174, 1}, {175, 0}, {92, by_layer}});
  add_all(dxf, {{292, 0}, {93, by_block}});
  dxf.add_point(10, {1, 1});
  add_all(dxf, {{43, 0}, {176, 0}, {293, 0}, {294, 0}, {178, 0}, {179, 1}, {45, 1}});
}

void add_tolerance(DxfWriter& dxf, const Place& place, const sheet::ToleranceObject& tolerance) {
  begin_entity(dxf, place, "TOLERANCE", "AcDbFcf");
  dxf.add(3, dxf_frame_style);
  dxf.add_point(10, tolerance.at);
  dxf.add(1, text_of(tolerance, dxf.version()));
  dxf.add_point(11, {1, 0});
}

void add_table(DxfWriter& dxf, const Place& place, const sheet::TableObject& table, const BlockOfTable& block,
               const DxfHandles& handles) {
  begin_entity(dxf, place, "ACAD_TABLE", "AcDbBlockReference");
  dxf.add(2, block.name);
  dxf.add_point(10, table.corner);
  dxf.add(100, "AcDbTable");
  dxf.add(280, 0);
  dxf.add_handle(342, handles.table_style);
  dxf.add_handle(343, block.handle);
  dxf.add_point(11, {1, 0});
  dxf.add(90, 0);
  dxf.add(91, static_cast<int>(table.rows.size()));
  dxf.add(92, static_cast<int>(table.widths.size()));
  for (const int none : {93, 94, 95, 96}) dxf.add(none, 0);
  for (std::size_t i = 0; i < table.rows.size(); ++i) dxf.add(141, table.row_height);
  for (const double width : table.widths) dxf.add(142, width);
  for (const std::vector<sheet::TableCell>& row : table.rows)
    for (std::size_t i = 0; i < table.widths.size(); ++i) {
      const bool is_wide = row.size() == 1 && table.widths.size() > 1;
      const CellSpan span{is_wide && i == 0 ? table.widths.size() : 1, 1};
      add_cell(dxf, i < row.size() ? row[i] : sheet::TableCell{}, span, is_wide && i > 0);
    }
}

void add_dxf_classes(DxfWriter& dxf, const DxfEntities& wanted) {
  if (!wanted.leaders && !wanted.tables) return;
  dxf.add(0, "SECTION");
  dxf.add(2, "CLASSES");
  if (wanted.leaders) add_class(dxf, "MULTILEADER", "AcDbMLeader", true);
  if (wanted.leaders) add_class(dxf, "MLEADERSTYLE", "AcDbMLeaderStyle", false);
  if (wanted.tables) add_class(dxf, "ACAD_TABLE", "AcDbTable", true);
  if (wanted.tables) add_class(dxf, "TABLESTYLE", "AcDbTableStyle", false);
  dxf.add(0, "ENDSEC");
}

namespace {

void add_leader_style(DxfWriter& dxf, int dictionary, const DxfHandles& handles) {
  dxf.begin_as(handles.leader_style, "MLEADERSTYLE", dictionary, "AcDbMLeaderStyle");
  add_all(dxf, {{179, 2}, {170, 2}, {171, 1}, {172, 0}, {90, 2}, {40, 0}, {41, 0}, {173, 1}, {91, by_layer}, {92, -2}});
  add_all(dxf, {{290, 1}, {42, 2}, {291, 1}, {43, 8}});
  dxf.add(3, "Standard");
  dxf.add(44, 4.0);
  dxf.add(300, "");
  dxf.add_handle(342, handles.text_style);
  add_all(dxf, {{174, attached_by_underline}, {178, attached_by_underline}, {175, 1}, {176, 0}, {93, by_layer}});
  add_all(dxf, {{45, 4}, {292, 0}, {297, 0}, {46, 4}, {94, by_layer}, {47, 1}, {49, 1}, {140, 1}, {294, 1}, {141, 0}});
  add_all(dxf, {{177, 0}, {142, 1}, {295, 0}, {296, 0}, {143, 4}, {271, 0}, {272, 9}, {273, 9}});
}

void add_table_style(DxfWriter& dxf, int dictionary, const DxfHandles& handles) {
  constexpr int middle_left = 4;
  dxf.begin_as(handles.table_style, "TABLESTYLE", dictionary, "AcDbTableStyle");
  dxf.add(3, "Standard");
  for (const int code : {70, 71}) dxf.add(code, 0);
  for (const int margin : {40, 41}) dxf.add(margin, 1.0);
  for (const int shown : {280, 281}) dxf.add(shown, 1);  // no row is a title or heads the others by itself
  for (int kind = 0; kind < 3; ++kind) {                 // data, title, header
    dxf.add(7, dxf_text_style);
    dxf.add(140, 2.5);
    dxf.add(170, middle_left);
    dxf.add(62, 0);
    dxf.add(63, 7);
    dxf.add(283, 0);
    for (const std::array<int, 3>& side :
         {std::array{274, 284, 64}, {275, 285, 65}, {276, 286, 66}, {277, 287, 67}, {278, 288, 68}, {279, 289, 69}}) {
      dxf.add(side[0], -2);
      dxf.add(side[1], 1);
      dxf.add(side[2], 0);
    }
  }
}

}  // namespace

// Dictionaries of styles have one each, called Standard.
void add_dxf_objects(DxfWriter& dxf, const DxfHandles& handles) {
  struct Style {
    const char* dictionary;
    int handle;
    void (*add)(DxfWriter&, int, const DxfHandles&);
  };
  std::vector<Style> styles{{"ACAD_GROUP", 0, nullptr}};
  if (handles.leader_style != 0) styles.push_back({"ACAD_MLEADERSTYLE", handles.leader_style, add_leader_style});
  if (handles.table_style != 0) styles.push_back({"ACAD_TABLESTYLE", handles.table_style, add_table_style});
  dxf.add(0, "SECTION");
  dxf.add(2, "OBJECTS");
  const int root = dxf.begin("DICTIONARY", 0, "AcDbDictionary");
  dxf.add(281, 1);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    dxf.add(3, styles[i].dictionary);
    dxf.add_handle(350, root + 1 + static_cast<int>(i));
  }
  for (const Style& style : styles) {
    dxf.begin("DICTIONARY", root, "AcDbDictionary");
    dxf.add(281, 1);
    if (style.handle == 0) continue;
    dxf.add(3, "Standard");
    dxf.add_handle(350, style.handle);
  }
  for (std::size_t i = 0; i < styles.size(); ++i)
    if (styles[i].add != nullptr) styles[i].add(dxf, root + 1 + static_cast<int>(i), handles);
  dxf.add(0, "ENDSEC");
  dxf.add(0, "EOF");
}

}  // namespace epura::output
