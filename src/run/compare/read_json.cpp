// SPDX-License-Identifier: Apache-2.0
// Drawing JSON -> picture.
#include <rapidjson/error/en.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "compare/json_document.hpp"
#include "compare/picture_maker.hpp"
#include "compare/read_pictures.hpp"
#include "sheet/lettering.hpp"
#include "sheet/paper.hpp"
#include "sheet/view_lines.hpp"

namespace epura::compare {

namespace {

// Numbers are kept as text: rapidjson would not round all of them correctly.
constexpr unsigned flags = rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseIterativeFlag;

using Value = JsonDocument::ValueType;

std::optional<double> number_in(const Value& value) {
  const auto read = value.IsString() ? parse_number(value.GetString()) : std::nullopt;
  return read && std::isfinite(*read) ? read : std::nullopt;
}

// A value, and for errors its key and the last list on its path.
struct Place {
  const Value& value;
  const std::string& file;
  const char* key = "the drawing";
  const char* list = nullptr;
  unsigned item = 0;

  [[noreturn]] void refuse(const std::string& what) const {
    const std::string in = list == nullptr ? "" : list + ("[" + std::to_string(item) + "]: ");
    throw Error(ErrorKind::input, file, in + key + " " + what, "only drawing JSON written by epura can be read");
  }
  [[nodiscard]] bool has(const char* name) const { return value.IsObject() && value.HasMember(name); }
  [[nodiscard]] Place at(const char* name) const {
    if (!has(name)) refuse("has no '" + std::string(name) + "'");
    return {value[name], file, name, list, item};
  }
  [[nodiscard]] Place at(unsigned i) const { return {value[i], file, key, key, i}; }
  [[nodiscard]] unsigned items() const {
    if (!value.IsArray()) refuse("is not a list");
    return value.Size();
  }
  [[nodiscard]] Vec2 point() const {
    const bool pair = value.IsArray() && value.Size() == 2;
    const auto x = pair ? number_in(value[0]) : std::nullopt, y = pair ? number_in(value[1]) : std::nullopt;
    if (!x || !y) refuse("is not a point");
    return {*x, *y};
  }
  [[nodiscard]] std::string text() const {
    if (!value.IsString()) refuse("is not a text");
    return value.GetString();
  }
  [[nodiscard]] bool boolean() const {
    if (!value.IsBool()) refuse("is neither true nor false");
    return value.GetBool();
  }
};

// The look after those of all lines.
constexpr int cut_face = scene::sheet_lines.size();

// As drawn on sheets below A1, by number of the line.
std::vector<PictureLook> looks() {
  std::vector<PictureLook> looks;
  for (const scene::SheetLineRow& row : scene::sheet_lines) {
    const sheet::LineStyle style = sheet::line_style(row.line, sheet::line_widths(sheet::Paper()));
    PictureLook& look = looks.emplace_back(PictureLook{style.name, !row.is_hidden, false, style.width});
    if (style.dashes.dash > 0) look.dashes = {style.dashes.dash, style.dashes.gap};
    for (int i = 0; i < style.dashes.dots; ++i)
      look.dashes.insert(look.dashes.end(), {style.dashes.dot, style.dashes.gap});
  }
  looks.push_back({"cut face", true, true});
  return looks;
}

// Unknown kinds look like most lines.
EdgeKind kind_named(const std::string& name) {
  auto kind = EdgeKind::contour;
  for (int i = 0; i <= static_cast<int>(EdgeKind::smooth); ++i)
    if (name == edges::name_of(static_cast<EdgeKind>(i))) kind = static_cast<EdgeKind>(i);
  return kind;
}

// Empty for lines that are not edges of a file.
std::string edge_of(const Place& segment) {
  const Value& edge = segment.at("edge").value;
  if (!edge.IsArray() || edge.Size() != 2 || !edge[0].IsString() || !edge[1].IsString()) return {};
  return segment.at("model").text() + ":" + edge[0].GetString() + "-" + edge[1].GetString();
}

void add_segment(PictureMaker& picture, const Place& segment, int view) {
  const std::optional<scene::SheetLine> line =
      sheet::edge_line(kind_named(segment.at("kind").text()), segment.at("visible").boolean());
  if (!line) return;
  int origin = -1;
  if (std::string edge = edge_of(segment); !edge.empty()) origin = picture.add_origins({std::move(edge)});
  picture.add({segment.at("from").point(), segment.at("to").point(), static_cast<int>(*line), view, origin});
}

void add_ring(PictureMaker& picture, const Place& ring, int view) {
  const unsigned corners = ring.items();
  for (unsigned i = 0; i < corners; ++i)
    picture.add({ring.at(i).point(), ring.at((i + 1) % corners).point(), cut_face, view, -1});
}

void add_view(PictureMaker& picture, const Place& view) {
  const int number = picture.view(view.at("name").text());
  const Place segments = view.at("segments");
  for (unsigned i = 0; i < segments.items(); ++i) add_segment(picture, segments.at(i), number);
  if (!view.has("cut_faces")) return;
  const Place faces = view.at("cut_faces");
  for (unsigned i = 0; i < faces.items(); ++i) {
    const Place rings = faces.at(i).at("rings");
    for (unsigned j = 0; j < rings.items(); ++j) add_ring(picture, rings.at(j), number);
  }
}

// "B | 30 | 12": one text for what stands in one place.
std::string joined(const Place& list, const char* between) {
  std::string words;
  for (unsigned i = 0; i < list.items(); ++i) words += (i > 0 ? between : "") + list.at(i).text();
  return words;
}

// Whether a dimension measures from left to right, or in no such direction: its extension lines are then upright, and
// end at the dimension line. (`points`: see annotations.schema.json.)
bool is_across(const Place& dimension) {
  const Place points = dimension.at("points");
  const std::string type = dimension.at("type").text();
  if ((type != "linear" && type != "ordinate") || points.items() < 3) return true;
  const Vec2 extension = points.at(2).point() - points.at(1).point();
  return std::abs(extension.y) >= std::abs(extension.x);
}

/// Adds the texts of a drawing's annotations.
class AnnotationReader {
 public:
  explicit AnnotationReader(PictureMaker& picture) : picture_(picture) {}

  void read(const Place& annotations) {
    for_each(annotations, "dimensions", [&](const Place& one) { add_dimension(one); });
    for_each(annotations, "notes",
             [&](const Place& one) { add_at(one, one.at("at"), joined(one.at("lines"), " / ")); });
    for_each(annotations, "balloons", [&](const Place& one) { add_at(one, one.at("at"), one.at("text").text()); });
    for_each(annotations, "frames", [&](const Place& one) {
      const Place rows = one.at("rows");
      for (unsigned i = 0; i < rows.items(); ++i)
        add_row(one, i, rows.at(i).at("characteristic").text() + " | " + joined(rows.at(i).at("cells"), " | "));
    });
    for_each(annotations, "tables", [&](const Place& one) {
      const Place rows = one.at("rows");
      for (unsigned i = 0; i < rows.items(); ++i) add_row(one, i, joined(rows.at(i), " | "));
    });
  }

 private:
  template <class Take>
  static void for_each(const Place& annotations, const char* kind, const Take& take) {
    if (!annotations.has(kind)) return;
    const Place list = annotations.at(kind);
    for (unsigned i = 0; i < list.items(); ++i) take(list.at(i));
  }

  void add_dimension(const Place& one) {
    const std::string words = one.at("text").text();
    const Vec2 box = box_of(words), turned = is_across(one) ? box : Vec2(box.y, box.x);
    add(one, words, one.at("text_at").point() - turned / 2.0, turned);
  }

  [[nodiscard]] Vec2 box_of(const std::string& words) const { return {lettering_.width(words, height), height}; }

  // Rows stand below each other.
  void add_row(const Place& one, unsigned row, const std::string& words) {
    add(one, words, one.at("at").point() - Vec2(0, row * 2 * height), box_of(words));
  }

  void add_at(const Place& one, const Place& at, const std::string& words) {
    add(one, words, at.point(), box_of(words));
  }

  void add(const Place& one, const std::string& words, const Vec2& min, const Vec2& size) {
    const int view = picture_.view(one.has("view") ? one.at("view").text() : "sheet");
    if (!words.empty()) picture_.add(PictureText{sheet::written(words), min, min + size, view});
  }

  static constexpr double height = 3.5;  // of capitals, mm: that of dimensions on most sheets

  PictureMaker& picture_;
  sheet::Lettering lettering_{};
};

Place drawing_in(JsonDocument& document, std::string_view bytes, const std::string& where) {
  document.Parse<flags>(bytes.data(), bytes.size());
  if (document.HasParseError())
    throw Error(ErrorKind::input, where,
                "is not valid JSON: " + std::string(rapidjson::GetParseError_En(document.GetParseError())) + " (byte " +
                    std::to_string(document.GetErrorOffset()) + ")");
  const Place root{document, where};
  if (number_in(root.at("epura").value) != 1.0) root.refuse("does not use schema 1");
  return root;
}

std::string text_or_empty(const Place& place) { return place.value.IsNull() ? std::string() : place.text(); }

report::RequirementRow requirement_in(const Place& row) {
  report::RequirementRow requirement;
  requirement.model = row.at("model").text();
  requirement.id = row.at("id").text();
  requirement.kind = row.at("kind").text();
  requirement.what = row.at("what").text();
  requirement.view = text_or_empty(row.at("view"));
  requirement.sheet = static_cast<int>(std::clamp(number_in(row.at("sheet").value).value_or(0), 0.0, 1e6));
  requirement.zone = text_or_empty(row.at("sheet_zone"));
  requirement.characteristic =
      static_cast<int>(std::clamp(number_in(row.at("characteristic").value).value_or(0), 0.0, 1e9));
  requirement.why = text_or_empty(row.at("reason"));
  requirement.wanted = row.at("wanted").boolean();
  return requirement;
}

}  // namespace

std::vector<report::RequirementRow> requirements_of_json(std::string_view bytes, const std::string& where) {
  JsonDocument document;
  const Place facts = drawing_in(document, bytes, where).at("report");
  std::vector<report::RequirementRow> rows;
  if (!facts.has("requirements")) return rows;
  const Place list = facts.at("requirements");
  for (unsigned i = 0; i < list.items(); ++i) rows.push_back(requirement_in(list.at(i)));
  return rows;
}

Picture picture_of_json(std::string_view bytes, const std::string& where) {
  JsonDocument document;
  const Place root = drawing_in(document, bytes, where);
  PictureMaker picture(where);
  picture.set_size(root.at("sheet").at("size").point());
  for (const PictureLook& look : looks()) picture.look(look);
  const Place views = root.at("views");
  for (unsigned i = 0; i < views.items(); ++i) add_view(picture, views.at(i));
  if (root.has("annotations")) AnnotationReader(picture).read(root.at("annotations"));
  return picture.finish();
}

}  // namespace epura::compare
