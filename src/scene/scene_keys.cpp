// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_keys.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/title_fields.hpp"
#include "scene/view_names.hpp"

namespace epura {

namespace {

/// One key of the section that describes a Part.
template <class Part>
struct SceneKey {
  std::string name;
  std::string value;  ///< kind of its values
  std::string help;
  std::function<void(Part&, const TomlValue&)> read;
  bool required = false;
};

template <class Part>
using SceneKeys = std::vector<SceneKey<Part>>;

constexpr const char* table_kind = "table";

/// A key whose value goes to `member` of the part, or to what `member` as a function finds in the part.
template <class Part, class Member, class Value>
SceneKey<Part> key(const std::string& name, Member member, const ValueKind<Value>& kind, const std::string& help,
                   bool required = false) {
  const auto read = [member, kind](Part& part, const TomlValue& value) {
    std::invoke(member, part) = kind.read(value);
  };
  return {name, kind.name + (required ? "; required" : ""), help, read, required};
}

// What words have in their description.
template <class Member>
auto in_description(Member member) {
  return [member](auto& words) -> auto& { return words.description.*member; };
}

// A key of the whole file is often written where it belongs to the last section.
std::string hint_for(const std::string& key, const std::vector<std::string>& known) {
  return key == "views" ? "it belongs above the first section" : did_you_mean(key, known);
}

template <class Part>
void read_entries(Part& part, const TomlValue& table, const SceneKeys<Part>& keys, const std::string& section) {
  std::vector<std::string> names;
  for (const auto& known : keys) names.push_back(known.name);
  const std::vector<TomlValue>& entries = table_of(table).values;
  for (const TomlValue& entry : entries)
    if (std::find(names.begin(), names.end(), entry.key) == names.end())
      throw Error(Trouble::input, entry.key_where, "'" + entry.key + "' is no key of " + section,
                  hint_for(entry.key, names));
  for (const auto& known : keys) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&known](const TomlValue& candidate) { return candidate.key == known.name; });
    if (entry != entries.end())
      known.read(part, *entry);
    else if (known.required)
      throw Error(Trouble::input, table.where, section + " lacks '" + known.name + "'", known.help);
  }
}

SceneKeys<ModelDescription> model_keys() {
  using Model = ModelDescription;
  return {
      key<Model>("file", &Model::file, any_text(), "obj, stl, ply or off; a relative path starts at the scene file",
                 true),
      key<Model>("name", &Model::name, any_text(), "for dimensions; by default the name of the file without extension"),
      key<Model>("unit", &Model::unit, any_text(), "of the file: `mm` (default), `in` or `m`"),
      key<Model>("up", &Model::up, any_text(), "axis that points up in the file: `z` (default) or `y`"),
      key<Model>("transform", &Model::transform, any_text(),
                 "steps as of `--transform`: `rotate:z,30 translate:0,0,5`"),
      key<Model>("line", &Model::line, any_text(), "its visible lines: `visible` (default), `narrow`, or `neighbour`"),
      key<Model>("hidden", &Model::hidden, any_text(), "its hidden lines, as in a view"),
      key<Model>("drawn", &Model::drawn, truth(), "`false` leaves it out; the others keep their numbers"),
  };
}

SceneKeys<SectionDescription> section_keys() {
  using Section = SectionDescription;
  return {
      key<Section>("name", &Section::name, any_text(), "by which views call it, such as `A`", true),
      key<Section>("point", &Section::point, triple_of_numbers(""), "of the plane; the origin by default"),
      key<Section>("normal", &Section::normal, direction(), "to the side that is taken away; `[0, -1, 0]` by default"),
  };
}

SceneKeys<ViewDescription> view_keys() {
  using View = ViewDescription;
  return {
      key<View>("projection", &View::projection, projection_text(),
                "`NAME[:key=value...]`, or `{name = NAME, key = value}`", true),
      key<View>("name", &View::name, any_text(), "of its layers, and for dimensions; the projection's by default"),
      key<View>("scale", &View::scale, any_text(), "such as `2:1`; the sheet's by default"),
      key<View>("at", &View::at, pair_of_numbers("mm"),
                "middle of the view, from the lower left corner of the sheet; arranged by default"),
      key<View>("sheet", &View::sheet, whole_number(1), "which one of several, from 1"),
      key<View>("section", &View::section, any_text(), "name of the section that it shows"),
      key<View>("label", &View::label, any_text(), "written above it; `A-A` for section `A` by default"),
      key<View>("hidden", &View::hidden, any_text(), "hidden lines: `none`, `dashed` or `solid`"),
      key<View>("edges", &View::edges, words(), "which: `contour crease boundary intersection tangent smooth`"),
      key<View>("crease_angle", &View::crease_angle, number_between(0, 180, "degrees"),
                "between faces, from which their edge is a crease; 30 by default"),
      key<View>("near", &View::near, any_number(""), "leave out what is nearer to the viewer"),
      key<View>("far", &View::far, any_number(""), "leave out what is farther from the viewer"),
  };
}

SceneKey<DimensionWords> anchor_key(const std::string& name, const std::string& help) {
  const ValueKind<AnchorWords> kind = anchor();
  const auto read = [name, kind](DimensionWords& words, const TomlValue& value) {
    words.anchors.emplace_back(name, kind.read(value));
  };
  return {name, kind.name, help, read};
}

SceneKeys<DimensionWords> dimension_keys() {
  using Words = DimensionWords;
  using Dimension = DimensionDescription;
  return {
      key<Words>("type", in_description(&Dimension::type), any_text(),
                 "`linear`, `aligned`, `angular`, `radius`, `diameter` or `overall`", true),
      key<Words>("view", in_description(&Dimension::view), any_text(), "name of the view; the first one by default"),
      key<Words>("direction", in_description(&Dimension::direction), any_text(),
                 "linear: `horizontal` or `vertical`; overall: `width`, `height` or `depth`, or all by default"),
      anchor_key("corner", "angular: where the legs meet"),
      anchor_key("from", "linear, aligned: one end; angular: end of a leg"),
      anchor_key("to", "linear, aligned: the other end; angular: end of the other leg"),
      anchor_key("at", "radius, diameter: a vertex on the circle"),
      key<Words>("offset", in_description(&Dimension::offset), any_number("mm"),
                 "of the dimension line from the anchors, on paper; its sign gives the side"),
      key<Words>("text", in_description(&Dimension::text), any_text(),
                 "instead of the measured value, for which `<>` stands"),
  };
}

void set_field(TitleBlockFields& fields, const std::string& name, const Given& text) {
  std::erase_if(fields, [&name](const auto& field) { return field.first == name; });
  fields.emplace_back(name, text);
}

void read_free_fields(TitleBlockFields& fields, const TomlValue& table) {
  TitleBlockFields read;
  std::set<std::string> names;
  for (const TomlValue& entry : table_of(table).values) {
    const auto same = [&entry](const TitleField& field) { return field.name == entry.key; };
    if (std::any_of(title_fields().begin(), title_fields().end(), same))
      throw Error(Trouble::input, entry.key_where, "'" + entry.key + "' is no free field", "put it into [title_block]");
    names.insert(entry.key);
    read.emplace_back(entry.key, field_text().read(entry));
  }
  // As set_field would do, all at once: a table names no key twice.
  std::erase_if(fields, [&names](const auto& field) { return names.contains(field.first); });
  fields.insert(fields.end(), read.begin(), read.end());
}

SceneKeys<TitleBlockFields> title_block_keys() {
  SceneKeys<TitleBlockFields> keys;
  const ValueKind<Given> kind = field_text();
  for (const TitleField& field : title_fields())
    keys.push_back({field.name, kind.name, field.help,
                    [name = field.name, kind](TitleBlockFields& fields, const TomlValue& value) {
                      set_field(fields, name, kind.read(value));
                    }});
  keys.push_back({"free", table_kind, "more fields, of any name", read_free_fields});
  return keys;
}

SceneKeys<SheetDescription> shared_sheet_keys() {
  using Sheet = SheetDescription;
  return {
      key<Sheet>("size", &Sheet::size, any_text(), "`A4` to `A0`, `WIDTHxHEIGHT` in mm, `none`, or `auto`"),
      key<Sheet>("orientation", &Sheet::orientation, any_text(), "`landscape` or `portrait`"),
      key<Sheet>("scale", &Sheet::scale, any_text(), "`fit`, `auto`, or such as `1:2`"),
      key<Sheet>("angle", &Sheet::angle, any_text(), "projection method: `first` or `third` angle"),
      key<Sheet>("frame", &Sheet::frame, any_text(), "`auto`, `none`, `plain` or `full`"),
  };
}

SceneKeys<SheetDescription> own_sheet_keys() {
  const auto read = [](SheetDescription& sheet, const TomlValue& value) {
    read_entries(sheet.title_block, value, title_block_keys(), "[sheet.title_block]");
  };
  return {{"title_block", table_kind, "as `[title_block]`, for this sheet alone", read}};
}

SceneKeys<SheetDescription> sheet_keys() {
  SceneKeys<SheetDescription> keys = shared_sheet_keys();
  for (const auto& key : own_sheet_keys()) keys.push_back(key);
  return keys;
}

// What a part is before its keys are read.
void prepare(const SceneWords&, const TomlValue&, auto&) {}
void prepare(const SceneWords&, const TomlValue& table, DimensionWords& words) {
  words.description.where = table.where;
}
void prepare(const SceneWords& words, const TomlValue& table, SheetDescription& sheet) {
  sheet = words.every_sheet;
  sheet.where = table.where;
}

/// A key of the file under which stand several tables, or a single one: each is a part in the list that `parts` finds.
template <class Part, class Parts>
SceneKey<SceneWords> parts_key(const std::string& name, const SceneKeys<Part>& keys, Parts parts) {
  const auto read = [name, keys, parts](SceneWords& words, const TomlValue& value) {
    for (const TomlValue* table : tables_of(value)) {
      Part part{};
      prepare(words, *table, part);
      read_entries(part, *table, keys, "[[" + name + "]]");
      parts(words).push_back(std::move(part));
    }
  };
  return {name, table_kind, "", read};
}

void read_short_views(SceneWords& words, const TomlValue& value) {
  const std::vector<Given> projections = each_word(value);
  expect_few_views(projections.size(), value.where);
  for (const Given& projection : projections) words.description.views.emplace_back().projection = projection;
}

void read_every_sheet(SceneWords& words, const TomlValue& value) {
  read_entries(words.every_sheet, value, shared_sheet_keys(), "[all_sheets]");
}

void read_title_block(SceneWords& words, const TomlValue& value) {
  read_entries(words.every_sheet.title_block, value, title_block_keys(), "[title_block]");
}

// In the order of reading: what all sheets share stands before the sheets.
SceneKeys<SceneWords> scene_keys() {
  return {
      {"views", words().name, "projections: short for a `[[view]]` of each", read_short_views},
      parts_key("model", model_keys(), in_description(&SceneDescription::models)),
      parts_key("section", section_keys(), in_description(&SceneDescription::sections)),
      parts_key("view", view_keys(), in_description(&SceneDescription::views)),
      parts_key("dimension", dimension_keys(), std::mem_fn(&SceneWords::dimensions)),
      {"all_sheets", table_kind, "", read_every_sheet},
      {"title_block", table_kind, "", read_title_block},
      parts_key("sheet", sheet_keys(), in_description(&SceneDescription::sheets)),
  };
}

template <class Part>
void append_rows(std::string& table, const std::string& section, const SceneKeys<Part>& keys) {
  for (const auto& key : keys)
    if (!key.help.empty()) table += "| " + section + " | `" + key.name + "` | " + key.value + " | " + key.help + " |\n";
}

}  // namespace

SceneWords read_scene_words(const TomlValue& file) {
  SceneWords words;
  read_entries(words, file, scene_keys(), "a scene file");
  return words;
}

std::string describe_scene_keys() {
  std::string table = "| section | key | value | meaning |\n|---|---|---|---|\n";
  append_rows(table, "", scene_keys());
  append_rows(table, "`[[model]]`", model_keys());
  append_rows(table, "`[[view]]`", view_keys());
  append_rows(table, "`[[section]]`", section_keys());
  append_rows(table, "`[[dimension]]`", dimension_keys());
  append_rows(table, "`[all_sheets]`, `[[sheet]]`", shared_sheet_keys());
  append_rows(table, "`[[sheet]]`", own_sheet_keys());
  append_rows(table, "`[title_block]`", title_block_keys());
  return table;
}

}  // namespace epura
