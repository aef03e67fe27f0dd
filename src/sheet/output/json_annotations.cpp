// SPDX-License-Identifier: Apache-2.0
#include "output/json_annotations.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/json_text.hpp"

namespace epura::output {

namespace {

constexpr std::array shape_names{"linear", "angular", "diameter", "radius", "ordinate"};
constexpr std::size_t sheet_name = 5;  // letters of "sheet"

std::string place(const Vec2& p) { return "[" + json_number(p.x) + ", " + json_number(p.y) + "]"; }
std::string places(const std::vector<Vec2>& list) { return json_list(list, place); }

// "front" of "front/dimensions"; empty for what belongs to no view.
std::string view_of(const sheet::Layer& layer) {
  const std::string view = layer.name.substr(0, layer.name.rfind('/'));
  return view.size() == sheet_name && view == "sheet" ? "" : view;
}

std::string with_view(const sheet::Layer& layer) {
  const std::string view = view_of(layer);
  return view.empty() ? "" : "\"view\": " + json_string(view) + ", ";
}

// The value of an angle stands in its text alone.
double value_of(const sheet::DimensionObject& one) {
  if (one.shape != sheet::DimensionShape::angular) return one.value;
  const std::size_t begin = one.text.find_first_of("0123456789");
  if (begin == std::string::npos) return 0;
  std::string digits = one.text.substr(begin, one.text.find_first_not_of("0123456789.,", begin) - begin);
  std::replace(digits.begin(), digits.end(), ',', '.');
  return parse_number(digits).value_or(0);
}

std::string dimension_of(const sheet::Layer& layer, const sheet::DimensionObject& one) {
  check(one.points.size() >= 2, "a dimension has two points or more");
  const double value = value_of(one);
  const auto face = [](int number_of_face) { return std::to_string(number_of_face); };
  return "{" + (one.id.empty() ? "" : "\"id\": " + json_string(one.id) + ", ") + with_view(layer) +
         "\"type\": " + json_string(shape_names[static_cast<std::size_t>(one.shape)]) +
         (value > 0 ? ", \"value\": " + json_number(value) : "") + ", \"text\": " + json_string(one.text) +
         (one.tolerance.empty() ? "" : ", \"tolerance\": " + json_string(one.tolerance)) +
         (one.faces.empty() ? "" : ", \"faces\": " + json_list(one.faces, face)) +
         ", \"points\": " + places(one.points) + ", \"text_at\": " + place(one.text_middle) + "}";
}

std::string note_of(const sheet::Layer& layer, const sheet::LeaderObject& one) {
  return "{" + with_view(layer) + "\"lines\": " + json_list(one.lines, json_string) +
         ", \"leader\": " + places(one.points) + ", \"at\": " + place(one.text_corner) + "}";
}

std::string free_note_of(const sheet::Layer& layer, const sheet::Text& text) {
  return "{" + with_view(layer) + "\"lines\": [" + json_string(text.text) + "], \"at\": " + place(text.at) + "}";
}

// "⌀0.1 (M)": what is in a circle on the sheet is in brackets.
std::string cell_text(const scene::FrameCell& cell) {
  std::string text;
  for (const scene::FramePiece& piece : cell)
    text += std::string(text.empty() ? "" : " ") + (piece.circled ? "(" + piece.text + ")" : piece.text);
  return text;
}

std::string name_of(Characteristic characteristic) {
  const auto row = std::find_if(scene::characteristics.begin(), scene::characteristics.end(),
                                [&](const auto& one) { return one.characteristic == characteristic; });
  check(row != scene::characteristics.end(), "each characteristic has a row");
  return row->name;
}

std::string frame_of(const sheet::Layer& layer, const sheet::ToleranceObject& one) {
  const auto row = [](const sheet::FrameRow& row_of_frame) {
    return "{\"characteristic\": " + json_string(name_of(row_of_frame.characteristic)) + ", \"cells\": " +
           json_list(row_of_frame.cells, [](const scene::FrameCell& cell) { return json_string(cell_text(cell)); }) +
           "}";
  };
  return "{" + with_view(layer) + "\"rows\": " + json_list(one.rows, row) + ", \"at\": " + place(one.at) + "}";
}

std::string table_of(const sheet::Layer& layer, const sheet::TableObject& one) {
  const auto cell = [](const sheet::TableCell& text) { return json_string(text.text); };
  const auto row = [&cell](const std::vector<sheet::TableCell>& cells) { return json_list(cells, cell); };
  return "{" + with_view(layer) + "\"rows\": " + json_list(one.rows, row) + ", \"at\": " + place(one.corner) +
         ", \"widths\": " + json_list(one.widths, json_number) + ", \"row_height\": " + json_number(one.row_height) +
         "}";
}

/// Items in JSON, by kind.
struct Annotations {
  std::vector<std::string> dimensions, notes, frames, tables, balloons;

  [[nodiscard]] bool any() const {
    return !dimensions.empty() || !notes.empty() || !frames.empty() || !tables.empty() || !balloons.empty();
  }
};

void add_texts(Annotations& found, const sheet::Layer& layer) {
  for (std::size_t i = 0; i < layer.texts.size(); ++i) {
    const sheet::Text& text = layer.texts[i];
    const bool has_leader =
        std::any_of(layer.leaders.begin(), layer.leaders.end(), [i](const sheet::LeaderObject& leader) {
          return !leader.lines.empty() && leader.texts.begin <= i && i < leader.texts.end;
        });
    if (text.role == "note" && !has_leader) found.notes.push_back(free_note_of(layer, text));
    if (text.role == "balloon")
      found.balloons.push_back("{" + with_view(layer) + "\"text\": " + json_string(text.text) +
                               ", \"at\": " + place(text.at) + "}");
  }
}

}  // namespace

std::string json_of_annotations(const sheet::Sheet& sheet) {
  Annotations found;
  for (const sheet::Layer& layer : sheet.layers) {
    for (const sheet::DimensionObject& one : layer.dimensions) found.dimensions.push_back(dimension_of(layer, one));
    for (const sheet::LeaderObject& one : layer.leaders)
      if (!one.lines.empty()) found.notes.push_back(note_of(layer, one));
    for (const sheet::ToleranceObject& one : layer.tolerances)
      if (!one.rows.empty()) found.frames.push_back(frame_of(layer, one));
    for (const sheet::TableObject& one : layer.tables) found.tables.push_back(table_of(layer, one));
    add_texts(found, layer);
  }
  if (!found.any()) return "";
  std::string title = sheet.title.empty() ? "" : "\"title\": " + json_string(sheet.title);
  for (const auto& [name, value] : sheet.facts) append_to_list(title, json_string(name) + ": " + json_string(value));
  const auto as_it_is = [](const std::string& text) { return text; };
  return "{\"dimensions\": " + json_lines(found.dimensions, as_it_is, "\n   ") +
         ",\n  \"notes\": " + json_lines(found.notes, as_it_is, "\n   ") +
         ",\n  \"frames\": " + json_lines(found.frames, as_it_is, "\n   ") +
         ",\n  \"tables\": " + json_lines(found.tables, as_it_is, "\n   ") +
         ",\n  \"balloons\": " + json_lines(found.balloons, as_it_is, "\n   ") + ",\n  \"title\": {" + title + "}}";
}

}  // namespace epura::output
