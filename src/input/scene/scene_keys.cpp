// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_keys.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "base/error.hpp"
#include "scene/read_entries.hpp"
#include "scene/title_fields.hpp"
#include "scene/view_names.hpp"

namespace epura::scene {

namespace {

constexpr const char* table_kind = "table";

/// A key of one or several tables.
template <class Part>
Option<Part> table_option(const std::string& key, const std::string& help,
                          std::function<void(Part&, const TomlValue&)> read) {
  return {{.key = key, .form = {table_kind}, .help = help, .type = typeid(TomlTable)}, std::move(read)};
}

void read_free_fields(TitleBlockFields& fields, const TomlValue& table) {
  TitleBlockFields read;
  std::set<std::string> names;
  for (const TomlValue& entry : table_of(table).values) {
    const auto same = [&entry](const TitleField& field) { return field.name == entry.key; };
    if (std::any_of(title_fields().begin(), title_fields().end(), same))
      throw Error(ErrorKind::input, entry.key_where, "'" + entry.key + "' is not a free field",
                  "put it into [title_block]");
    names.insert(entry.key);
    read.emplace_back(entry.key, LocatedText{field_text().read(entry), entry.where});
  }
  // Has the effect of set_field for all fields at once: a table has no duplicate keys.
  std::erase_if(fields, [&names](const auto& field) { return names.contains(field.first); });
  fields.insert(fields.end(), read.begin(), read.end());
}

Options<TitleBlockFields> title_block_keys() {
  Options<TitleBlockFields> keys = title_block_options();
  keys.push_back(table_option<TitleBlockFields>("free", "additional fields with any name", read_free_fields));
  return keys;
}

Options<SheetDescription> own_sheet_keys() {
  OptionInfo info{.key = "title_block",
                  .form = {table_kind},
                  .help = "like `[title_block]`, for this sheet only",
                  .type = typeid(TitleBlockFields)};
  return {{std::move(info), [](SheetDescription& sheet, const TomlValue& value) {
             read_entries(sheet.title_block, value, title_block_keys(), "[sheet.title_block]");
           }}};
}

Options<SheetDescription> sheet_keys() {
  Options<SheetDescription> keys = sheet_options();
  for (const auto& key : own_sheet_keys()) keys.push_back(key);
  return keys;
}

// Initialises a part before its keys are read.
void prepare(const SceneWords&, const TomlValue&, auto&) {}
void prepare(const SceneWords&, const TomlValue& table, DimensionWords& words) {
  words.description.where = table.where;
}
void prepare(const SceneWords&, const TomlValue& table, ThreadWords& words) { words.description.where = table.where; }
void prepare(const SceneWords&, const TomlValue& table, RequirementWords& words) {
  words.description.where = table.where;
}
void prepare(const SceneWords&, const TomlValue& where, TableDescription& table) { table.where = where.where; }
void prepare(const SceneWords&, const TomlValue& table, ViewDescription& view) { view.projection.where = table.where; }
void prepare(const SceneWords&, const TomlValue& table, ExplodeDescription& explode) { explode.where = table.where; }
void prepare(const SceneWords& words, const TomlValue& table, SheetDescription& sheet) {
  sheet = words.every_sheet;
  sheet.where = table.where;
}

/// A key for several tables, or a single one. Each table is appended as a part to the list that `parts` returns.
template <class Part, class Parts>
Option<SceneWords> parts_key(const std::string& name, const Options<Part>& keys, Parts parts) {
  const auto read = [name, keys, parts](SceneWords& words, const TomlValue& value) {
    for (const TomlValue* table : tables_of(value)) {
      Part part{};
      prepare(words, *table, part);
      read_entries(part, *table, keys, "[[" + name + "]]");
      parts(words).push_back(std::move(part));
    }
  };
  return table_option<SceneWords>(name, "", read);
}

template <class Content>
Option<SceneWords> callouts_key(const std::string& name, const Options<CalloutWords>& keys) {
  const auto read = [name, keys](SceneWords& words, const TomlValue& value) {
    for (const TomlValue* table : tables_of(value)) {
      CalloutWords callout;
      callout.description.where = table->where;
      callout.description.content = Content();
      read_entries(callout, *table, keys, "[[" + name + "]]");
      words.callouts.push_back(std::move(callout));
    }
  };
  return table_option<SceneWords>(name, "", read);
}

void read_short_views(SceneWords& words, const TomlValue& value) {
  const std::vector<LocatedText> projections = each_word(value);
  expect_few_views(projections.size(), value.where);
  for (const LocatedText& projection : projections) {
    TomlValue one = value;
    one.content = *projection;
    one.where = projection.where;
    words.description.views.emplace_back().projection = {projection_request().read(one), one.where};
  }
}

void read_every_sheet(SceneWords& words, const TomlValue& value) {
  read_entries(words.every_sheet, value, sheet_options(), "[all_sheets]");
}

void read_title_block(SceneWords& words, const TomlValue& value) {
  read_entries(words.every_sheet.title_block, value, title_block_keys(), "[title_block]");
}

void read_parts_list(SceneWords& words, const TomlValue& value) {
  words.description.parts_list = PartsListDescription{value.where};
  read_entries(*words.description.parts_list, value, parts_list_options(), "[parts_list]");
}

// In reading order: values shared by all sheets precede the sheets.
Options<SceneWords> scene_keys() {
  return {
      {{.key = "views", .form = {"list of texts"}, .help = "projections; short for a `[[view]]` for each"},
       read_short_views},
      parts_key("model", model_options(), in_description(&SceneDescription::models)),
      parts_key("style", style_options(), in_description(&SceneDescription::styles)),
      parts_key("section", section_options(), in_description(&SceneDescription::sections)),
      parts_key("detail", detail_options(), in_description(&SceneDescription::details)),
      parts_key("broken_out", broken_out_options(), in_description(&SceneDescription::broken_outs)),
      parts_key("revolved", revolved_options(), in_description(&SceneDescription::revolved)),
      parts_key("explode", explode_options(), in_description(&SceneDescription::explosions)),
      parts_key("view", view_options(), in_description(&SceneDescription::views)),
      parts_key("dimension", dimension_options(), std::mem_fn(&SceneWords::dimensions)),
      parts_key("thread", thread_options(), std::mem_fn(&SceneWords::threads)),
      callouts_key<NoteText>("note", note_options()),
      callouts_key<ToleranceFrame>("tolerance_frame", tolerance_frame_options()),
      callouts_key<DatumFeature>("datum", datum_options()),
      callouts_key<SurfaceTexture>("surface_texture", texture_options()),
      parts_key("requirement", requirement_options(), std::mem_fn(&SceneWords::requirements)),
      parts_key("accepted", accepted_options(), std::mem_fn(&SceneWords::accepted)),
      parts_key("table", table_options(), in_description(&SceneDescription::tables)),
      parts_key("revision", revision_options(), in_description(&SceneDescription::revisions)),
      table_option<SceneWords>("parts_list", "", read_parts_list),
      table_option<SceneWords>("all_sheets", "", read_every_sheet),
      table_option<SceneWords>("title_block", "", read_title_block),
      parts_key("sheet", sheet_keys(), in_description(&SceneDescription::sheets)),
  };
}

std::string in_code(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back("`" + word + "`");
  return words_as_text(quoted);
}

void append_rows(std::string& table, const std::string& section, const std::vector<OptionInfo>& keys) {
  for (const OptionInfo& key : keys) {
    if (key.help.empty()) continue;
    const std::string value = !key.form.is_closed ? key.form.name
                              : key.form.is_list  ? "list of " + in_code(key.form.words)
                                                  : in_code(key.form.words);
    table += "| " + section + " | `" + key.key + "` | " + value + (key.required ? "; required" : "") + " | " +
             key.usual + " | " + key.help + " |\n";
  }
}

template <class Part>
std::vector<OptionInfo> infos_of(const Options<Part>& keys) {
  return {keys.begin(), keys.end()};
}

}  // namespace

std::vector<SceneSection> scene_sections() {
  return {
      {"model", infos_of(model_options()), true},
      {"style", infos_of(style_options()), true},
      {"view", infos_of(view_options()), true},
      {"section", infos_of(section_options()), true},
      {"detail", infos_of(detail_options()), true},
      {"broken_out", infos_of(broken_out_options()), true},
      {"revolved", infos_of(revolved_options()), true},
      {"explode", infos_of(explode_options()), true},
      {"dimension", infos_of(dimension_options()), true},
      {"thread", infos_of(thread_options()), true},
      {"note", infos_of(note_options()), true},
      {"tolerance_frame", infos_of(tolerance_frame_options()), true},
      {"datum", infos_of(datum_options()), true},
      {"surface_texture", infos_of(texture_options()), true},
      {"requirement", infos_of(requirement_options()), true},
      {"accepted", infos_of(accepted_options()), true},
      {"table", infos_of(table_options()), true},
      {"revision", infos_of(revision_options()), true},
      {"parts_list", infos_of(parts_list_options()), false},
      {"all_sheets", infos_of(sheet_options()), false},
      {"sheet", infos_of(sheet_keys()), true},
      {"title_block", infos_of(title_block_keys()), false},
  };
}

SceneWords read_scene_words(const TomlValue& file) {
  SceneWords words;
  read_entries(words, file, scene_keys(), "a scene file");
  return words;
}

std::string describe_scene_keys() {
  std::string table = "| section | key | value | default | meaning |\n|---|---|---|---|---|\n";
  append_rows(table, "", infos_of(scene_keys()));
  for (const SceneSection& section : scene_sections()) {
    // Sheets have the keys of all sheets, and some of their own.
    if (section.name == "all_sheets")
      append_rows(table, "`[all_sheets]`, `[[sheet]]`", section.keys);
    else if (section.name == "sheet")
      append_rows(table, "`[[sheet]]`", infos_of(own_sheet_keys()));
    else
      append_rows(table, section.is_list ? "`[[" + section.name + "]]`" : "`[" + section.name + "]`", section.keys);
  }
  return table;
}

}  // namespace epura::scene
