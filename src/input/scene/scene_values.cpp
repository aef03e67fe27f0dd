// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"
#include "scene/transform.hpp"

namespace epura::scene {

namespace {

constexpr std::array<std::string_view, std::variant_size_v<TomlContent>> kinds = {
    "a text", "a number", "true or false", "a date", "a time", "a list", "a table"};

template <class Content>
std::string kind_name() {
  return std::string(kinds[TomlContent(Content()).index()]);
}

[[noreturn]] void refuse_kind(const TomlValue& value, const std::string& wanted) {
  const std::string found(kinds[value.content.index()]);
  const bool loose =  // a word without quotes
      wanted == kind_name<std::string>() && value.content.index() < TomlContent(TomlList()).index();
  refuse(value, "is " + found + ", " + wanted + " is wanted", loose ? "put it in quotes" : "");
}

// Returns the text if the value comes from the command line, otherwise null.
const std::string* option_text(const TomlValue& value) {
  return value.is_option ? std::get_if<std::string>(&value.content) : nullptr;
}

template <class Content>
const Content& content_of(const TomlValue& value) {
  const auto* content = std::get_if<Content>(&value.content);
  if (content == nullptr) refuse_kind(value, kind_name<Content>());
  return *content;
}

std::string checked_text(const TomlValue& value) {
  const auto& text = content_of<std::string>(value);
  if (std::any_of(text.begin(), text.end(), is_control))
    refuse(value, "has a line break or another control character", "write it on one line");
  return text;
}

std::string read_field(const TomlValue& value) {
  const auto* date = std::get_if<TomlDate>(&value.content);
  return date != nullptr ? date->text : checked_text(value);
}

[[noreturn]] void refuse_range(const TomlValue& value, double number, double min, double max) {
  const std::string range = std::isfinite(max) ? " to " + format_number(max) : " or more";
  refuse(value, "is " + format_number(number) + ", allowed is " + format_number(min) + range);
}

double usable(const TomlValue& value, double number) {
  if (!is_usable(number)) refuse_range(value, number, -largest_number, largest_number);
  return number;
}

double option_number(const TomlValue& value, const std::string& text, bool whole) {
  const auto number = parse_number(text);
  if (!number || !std::isfinite(*number) || (whole && *number != std::floor(*number)))
    refuse(value, "'" + text + "' is not a " + (whole ? "whole number" : "number"));
  return usable(value, *number);
}

double read_number(const TomlValue& value) {
  if (const std::string* text = option_text(value)) return option_number(value, *text, false);
  const double number = content_of<double>(value);
  if (!std::isfinite(number)) refuse(value, "is not a finite number");
  return usable(value, number);
}

bool read_truth(const TomlValue& value) { return option_text(value) != nullptr || content_of<bool>(value); }

int read_whole(const TomlValue& value, int min, int max = std::numeric_limits<int>::max()) {
  const std::string* text = option_text(value);
  const double number = text != nullptr ? option_number(value, *text, true) : read_number(value);
  if (number != std::floor(number)) refuse(value, "is " + format_number(number) + ", a whole number is wanted");
  const bool open = max == std::numeric_limits<int>::max();
  if (number < min) refuse_range(value, number, min, open ? HUGE_VAL : max);
  if (number > max) refuse_range(value, number, min, max);
  return static_cast<int>(number);
}

template <class Vector>
Vector read_vector(const TomlValue& value) {
  const auto& elements = content_of<TomlList>(value).values;
  constexpr int count = Vector::length();
  if (static_cast<int>(elements.size()) != count)
    refuse(value,
           "has " + std::to_string(elements.size()) + " elements, " + std::to_string(count) + " numbers are wanted");
  Vector vector;
  for (int i = 0; i < count; ++i) vector[i] = read_number(elements[std::size_t(i)]);
  return vector;
}

Vec3 read_direction(const TomlValue& value) {
  const auto vector = read_vector<Vec3>(value);
  if (vector == Vec3(0)) refuse(value, "is zero and has no direction");
  return vector;
}

// Three rows of an affine matrix for column vectors; the last row of four is 0, 0, 0, 1.
Mat4 read_matrix(const TomlValue& value) {
  std::vector<Vec4> read;
  for (const TomlValue& row : content_of<TomlList>(value).values) read.push_back(read_vector<Vec4>(row));
  const Vec4 last(0, 0, 0, 1);
  if (read.size() == 3) read.push_back(last);
  if (read.size() != 4) refuse(value, "has " + std::to_string(read.size()) + " rows, 3 or 4 are wanted");
  if (read[3] != last) refuse(value, "has a last row other than 0, 0, 0, 1", "models are moved by affine matrices");
  return rows(read[0], read[1], read[2], read[3]);
}

// Returns the value of a projection's parameter as it is written on the command line.
std::string read_parameter(const TomlValue& value) {
  if (const auto* flag = std::get_if<bool>(&value.content)) return *flag ? "true" : "false";
  if (std::holds_alternative<std::string>(value.content)) return read_text(value);
  if (!std::holds_alternative<TomlList>(value.content)) return format_number(read_number(value));
  std::string text;
  for (const TomlValue& element : std::get<TomlList>(value.content).values)
    text += (text.empty() ? "" : ",") + format_number(read_number(element));
  return text;
}

// Parses a text. Errors of `parse` may name only the text; for a scene file, the location in the file is added.
template <class Parse>
auto parsed(const TomlValue& value, const Parse& parse) {
  const std::string text = read_text(value);
  try {
    return parse(text);
  } catch (const Error& error) {
    if (value.is_option) throw;
    throw Error(error.kind(), value.where, error.what(), error.hint());
  }
}

ProjectionRequest read_projection(const TomlValue& value) {
  const auto* table = std::get_if<TomlTable>(&value.content);
  if (table == nullptr) return parsed(value, parse_request);
  ProjectionRequest request;
  for (const TomlValue& entry : table->values) {
    if (entry.key == "name")
      request.name = read_text(entry);
    else
      request.assignments.emplace_back(entry.key, read_parameter(entry));
  }
  if (request.name.empty()) refuse(value, "lacks 'name'", "{name = \"look-at\", eye = [4, -9, 5]}");
  return request;
}

std::vector<std::string> words_of_edge_kinds() {
  std::vector<std::string> words;
  for (const auto& [kind, member] : chosen_edge_kinds) words.emplace_back(word_of(kind));
  return words;
}

EdgeKinds read_edge_kinds(const TomlValue& value) {
  const std::vector<std::string> words = words_of_edge_kinds();
  EdgeKinds chosen{false, false, false, false, false, false, false};
  for (const LocatedText& one : each_word(value)) {
    TomlValue word = value;
    word.content = *one;
    word.where = one.where;
    chosen.*chosen_edge_kinds[read_word(word, words)].second = true;
  }
  return chosen;
}

ConstructionChoice read_constructions(const TomlValue& value) {
  std::vector<std::string> words;
  for (const LocatedText& one : each_word(value)) words.push_back(*one);
  ConstructionChoice choice;
  for (const std::string& word : join_directions(words)) choice.push_back(parse_construction(word, value.where));
  return choice;
}

BreakChoice read_break(const TomlValue& value) {
  BreakChoice choice;
  choice.is_optional = value.is_option;
  const std::vector<LocatedText> words = each_word(value);
  choice.automatic = words.size() == 1 && to_lower(*words.front()) == "auto";
  if (choice.automatic) return choice;
  for (const LocatedText& word : words) choice.parts.push_back(parse_break(*word, word.where));
  return choice;
}

AnchorWords read_vertex(const TomlValue& value, const std::vector<TomlValue>& elements) {
  if (elements.size() != 2)
    refuse(value, "has " + std::to_string(elements.size()) + " elements instead of [model, vertex]",
           "a point of the world is {point = [x, y, z]}");
  AnchorWords anchor{value.where, {}, read_whole(elements[1], 0), {}};
  if (std::holds_alternative<std::string>(elements[0].content))
    anchor.model = read_text(elements[0]);
  else
    anchor.model = read_whole(elements[0], 0);
  return anchor;
}

constexpr const char* anchor_forms = "[model, vertex], {point = [x, y, z]} or a feature, \"hole 3\"";

AnchorWords read_anchor(const TomlValue& value) {
  if (std::optional<FeatureName> feature = read_feature(value)) return {value.where, {}, -1, {}, std::move(*feature)};
  if (const auto* list = std::get_if<TomlList>(&value.content)) return read_vertex(value, list->values);
  const auto* table = std::get_if<TomlTable>(&value.content);
  if (table == nullptr) refuse_kind(value, anchor_forms);
  if (table->values.size() != 1 || table->values[0].key != "point") refuse(value, "is not an anchor", anchor_forms);
  return {value.where, {}, -1, read_vector<Vec3>(table->values[0])};
}

// Elements of a list with its key, for messages: they have none of their own.
std::vector<TomlValue> named_elements(const TomlValue& value) {
  std::vector<TomlValue> elements = content_of<TomlList>(value).values;
  for (TomlValue& element : elements) element.key = value.key;
  return elements;
}

// Numbers may be written without quotes.
std::vector<std::string> read_texts(const TomlValue& value) {
  std::vector<std::string> texts;
  for (const TomlValue& element : named_elements(value))
    texts.push_back(std::holds_alternative<double>(element.content) ? format_number(read_number(element))
                                                                    : read_field(element));
  if (texts.empty()) refuse(value, "is empty", "give one text or more");
  return texts;
}

LeaderWords read_leader_target(const TomlValue& value) {
  const auto* table = std::get_if<TomlTable>(&value.content);
  if (table == nullptr || table->values.size() != 1 || table->values[0].key != "page") return read_anchor(value);
  return read_vector<Vec2>(table->values[0]);
}

// Lines may be indented; only those between others may be empty.
std::vector<std::string> read_lines(const TomlValue& value) {
  std::vector<std::string> lines;
  const auto add = [&](const TomlValue& text) {
    for (const std::string_view line : split(content_of<std::string>(text), '\n')) {
      if (std::any_of(line.begin(), line.end(), is_control))
        refuse(value, "has a tab or another control character", "use spaces, and line breaks between lines");
      lines.emplace_back(line.substr(0, line.find_last_not_of(' ') + 1));
    }
  };
  if (const auto* list = std::get_if<TomlList>(&value.content))
    for (const TomlValue& element : list->values) add(element);
  else
    add(value);
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  if (lines.empty() || lines.front().empty()) refuse(value, "is empty", "omit it, or give a value");
  return lines;
}

// For instance `--hidden front:hidden=dashed`.
bool is_of_one_view(const TomlValue& value, const std::string& word) {
  return value.is_option && value.where.starts_with("--") &&
         word.find(":" + value.where.substr(2) + "=") != std::string::npos;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + ", " + unit;
}

}  // namespace

void refuse(const TomlValue& value, const std::string& reason, const std::string& hint) {
  throw Error(ErrorKind::input, value.where, value.is_option ? reason : "'" + value.key + "' " + reason, hint);
}

TomlValue value_of_option(const std::string& flag, const std::string& text) { return {"", flag, flag, text, true}; }

std::string read_text(const TomlValue& value) {
  const std::string text = checked_text(value);
  if (text.empty()) refuse(value, "is empty", "omit it, or give a value");
  return text;
}

std::size_t read_word(const TomlValue& value, const std::vector<std::string>& words) {
  const std::string word = read_text(value);
  const auto found = std::find(words.begin(), words.end(), to_lower(word));
  if (found == words.end())
    throw Error(
        ErrorKind::input, value.where,
        (value.is_option ? "" : "'" + value.key + "': ") + "unknown value '" + word + "'",
        is_of_one_view(value, word) ? "options of one view stand in --views: " + word : did_you_mean(word, words));
  return static_cast<std::size_t>(found - words.begin());
}

std::string words_as_text(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

ValueKind<std::string> any_text() { return {{"text", "TEXT"}, read_text}; }

ValueKind<std::string> field_text() { return {{"text or date", "TEXT"}, read_field}; }

ValueKind<ProjectionRequest> projection_request() {
  ValueForm form{"text or table", "NAME"};
  form.completion = Completion::projection;
  return {form, read_projection};
}

ValueKind<bool> truth() { return {{"true or false"}, read_truth}; }

ValueKind<int> whole_number(int min) {
  return {{"whole number", "N"}, [min](const TomlValue& value) { return read_whole(value, min); }};
}

ValueKind<int> whole_number(int min, int max) {
  return {{"whole number, " + std::to_string(min) + " to " + std::to_string(max), "N"},
          [min, max](const TomlValue& value) { return read_whole(value, min, max); }};
}

ValueKind<double> any_number(const std::string& unit) { return {{with_unit("number", unit), "D"}, read_number}; }

ValueKind<double> number_between(double min, double max, const std::string& unit) {
  const auto read = [min, max](const TomlValue& value) {
    const double number = read_number(value);
    if (number < min || number > max) refuse_range(value, number, min, max);
    return number;
  };
  return {{with_unit(format_number(min) + (std::isinf(max) ? " or more" : " to " + format_number(max)), unit), "D"},
          read};
}

ValueKind<double> positive_number() {
  const auto read = [](const TomlValue& value) {
    const double number = any_number("").read(value);
    if (!(number > 0)) refuse(value, "is " + format_number(number) + ", more than 0 is wanted");
    return number;
  };
  return {{"number above 0", "D"}, read};
}

ValueKind<Vec2> pair_of_numbers(const std::string& unit) {
  return {{with_unit("[x, y]", unit), "X,Y"}, read_vector<Vec2>};
}

ValueKind<Vec3> triple_of_numbers(const std::string& unit) {
  return {{with_unit("[x, y, z]", unit), "X,Y,Z"}, read_vector<Vec3>};
}

ValueKind<std::vector<Vec3>> list_of_triples() {
  return {{"[[x, y, z], ...]", "POINTS"}, [](const TomlValue& value) {
            std::vector<Vec3> triples;
            for (const TomlValue& triple : named_elements(value)) triples.push_back(read_vector<Vec3>(triple));
            return triples;
          }};
}

ValueKind<Vec3> direction() { return {{"[x, y, z]", "X,Y,Z"}, read_direction}; }

ValueKind<Mat4> transform_steps() {
  return {{"text, or rows of a matrix", "STEPS"}, [](const TomlValue& value) {
            if (std::holds_alternative<TomlList>(value.content)) return read_matrix(value);
            return parsed(value, parse_transform);
          }};
}

ValueKind<ColourChoice> colour() {
  const auto read = [](const TomlValue& value) {
    const std::string text = read_text(value);
    if (text == "file") return ColourChoice{.of_file = true};
    const std::optional<Colour> found = parse_colour(text);
    if (!found) refuse(value, "'" + text + "' is not a colour", "write it as #rgb or #rrggbb, such as #c00, or file");
    return ColourChoice{.colour = *found};
  };
  return {{"`#rgb`, `#rrggbb` or `file`", "COLOUR"}, read};
}

ValueKind<ScaleChoice> scale_choice() {
  const std::vector<std::string> usual{"fit", "auto", "1:1", "1:2", "1:5", "1:10", "2:1", "5:1", "10:1"};
  const auto read = [](const TomlValue& value) {
    const bool is_number = std::holds_alternative<double>(value.content);
    return parse_scale(is_number ? format_number(read_number(value)) : read_text(value), value.where);
  };
  return {{"text or number", "SCALE", usual}, read};
}

ValueKind<PaperChoice> paper_choice() {
  return {{"text",
           "SIZE",
           {"A4", "A3", "A2", "A1", "A0", "ANSI-A", "ANSI-B", "ANSI-C", "ANSI-D", "ANSI-E", "letter", "tabloid",
            "ledger", "none", "auto", "ANSI-auto"}},
          [](const TomlValue& value) { return parse_paper_size(read_text(value), value.where); }};
}

ValueKind<EdgeKinds> edge_kinds() {
  ValueForm form{"list of texts", "KINDS", words_of_edge_kinds()};
  form.is_closed = form.is_list = true;
  return {std::move(form), read_edge_kinds};
}

ValueKind<ConstructionChoice> construction_choice() {
  ValueForm form{"list of texts", "KINDS", {}};
  for (const ConstructionRow& row : construction_rows)
    form.words.push_back(std::string(row.word) + (row.required ? ":" : ""));
  form.is_list = true;
  return {std::move(form), read_constructions};
}

ValueKind<BreakChoice> break_choice() { return {{"`auto`, or list of texts", "PLACES", {"auto"}}, read_break}; }

ValueKind<AnchorWords> anchor() { return {{"anchor", "ANCHOR"}, read_anchor}; }

ValueKind<std::vector<AnchorWords>> list_of_anchors() {
  return {{"list of anchors", "ANCHORS"}, [](const TomlValue& value) {
            std::vector<AnchorWords> anchors;
            for (const TomlValue& one : named_elements(value)) anchors.push_back(read_anchor(one));
            return anchors;
          }};
}

ValueKind<LeaderWords> leader_target() { return {{"anchor, or `{page = [x, y]}`", "TARGET"}, read_leader_target}; }

ValueKind<std::vector<std::string>> text_lines() { return {{"text, or list of texts", "LINES"}, read_lines}; }

ValueKind<std::vector<std::string>> list_of_texts() { return {{"list of texts", "TEXTS"}, read_texts}; }

ValueKind<std::vector<std::vector<std::string>>> rows_of_texts() {
  return {{"list of lists of texts", "ROWS"}, [](const TomlValue& value) {
            std::vector<std::vector<std::string>> rows;
            for (const TomlValue& row : named_elements(value)) rows.push_back(read_texts(row));
            if (rows.empty()) refuse(value, "has no rows");
            return rows;
          }};
}

std::pair<std::string, std::size_t> parse_feature(const std::string& text, const std::string& where) {
  const std::vector<std::string_view> words = split(text, ' ');
  const auto number = words.size() == 2 ? parse_integer(words[1]) : std::nullopt;
  if (!number || *number < 1 || (words[0] != "hole" && words[0] != "face"))
    throw Error(ErrorKind::input, where, "'" + text + "' is not a feature",
                "write \"hole 3\" or \"face 12\": epura info and epura new-scene number them");
  return {std::string(words[0]), static_cast<std::size_t>(*number)};
}

std::optional<FeatureName> read_feature(const TomlValue& value) {
  FeatureName feature;
  std::string where = value.where;
  if (std::holds_alternative<std::string>(value.content)) {
    feature.text = read_text(value);
  } else {
    const auto* list = std::get_if<TomlList>(&value.content);
    if (list == nullptr || list->values.size() != 2 || !std::holds_alternative<std::string>(list->values[1].content))
      return std::nullopt;
    feature.text = read_text(list->values[1]);
    where = list->values[1].where;
    if (std::holds_alternative<std::string>(list->values[0].content))
      feature.model = read_text(list->values[0]);
    else
      feature.model = read_whole(list->values[0], 0);
  }
  parse_feature(feature.text, where);
  return feature;
}

std::vector<LocatedText> each_word(const TomlValue& value) {
  std::vector<LocatedText> texts;
  if (std::holds_alternative<std::string>(value.content)) {
    const std::string text = checked_text(value);
    for (std::string_view word : split(text, ',')) {
      while (word.starts_with(' ')) word.remove_prefix(1);
      while (word.ends_with(' ')) word.remove_suffix(1);
      texts.push_back({std::string(word), value.where});
    }
  } else {
    for (const TomlValue& element : content_of<TomlList>(value).values)
      texts.push_back({read_text(element), element.where});
  }
  if (texts.empty() || (texts.size() == 1 && texts[0]->empty())) refuse(value, "is empty", "omit it, or give a value");
  if (std::any_of(texts.begin(), texts.end(), [](const LocatedText& text) { return text->empty(); }))
    refuse(value, "has an empty element", "omit it, or give a value");
  return texts;
}

const TomlTable& table_of(const TomlValue& value) { return content_of<TomlTable>(value); }

std::vector<const TomlValue*> tables_of(const TomlValue& value) {
  std::vector<const TomlValue*> tables;
  if (const auto* list = std::get_if<TomlList>(&value.content))
    for (const TomlValue& element : list->values) tables.push_back(&element);
  else
    tables.push_back(&value);
  for (const TomlValue* table : tables) table_of(*table);
  return tables;
}

}  // namespace epura::scene
