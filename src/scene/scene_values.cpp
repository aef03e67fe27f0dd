// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

constexpr std::array<std::string_view, std::variant_size_v<TomlContent>> kinds = {
    "a text", "a number", "true or false", "a date", "a time", "a list", "a table"};

template <class Content>
std::string kind_name() {
  return std::string(kinds[TomlContent(Content()).index()]);
}

[[noreturn]] void refuse_kind(const TomlValue& value, const std::string& wanted) {
  const std::string found(kinds[value.content.index()]);
  const bool loose =  // a word that lacks its quotes
      wanted == kind_name<std::string>() && value.content.index() < TomlContent(TomlList()).index();
  refuse(value, "is " + found + ", " + wanted + " is wanted", loose ? "put it in quotes" : "");
}

template <class Content>
const Content& content_of(const TomlValue& value) {
  const auto* content = std::get_if<Content>(&value.content);
  if (content == nullptr) refuse_kind(value, kind_name<Content>());
  return *content;
}

Given checked_text(const TomlValue& value) {
  const auto& text = content_of<std::string>(value);
  if (std::any_of(text.begin(), text.end(), is_control))
    refuse(value, "has a line break or another control character", "write it on one line");
  return {text, value.where};
}

Given read_text(const TomlValue& value) {
  Given text = checked_text(value);
  if (!text.given()) refuse(value, "is empty", "leave it out, or say something");
  return text;
}

Given read_field(const TomlValue& value) {
  const auto* date = std::get_if<TomlDate>(&value.content);
  return date != nullptr ? Given{date->text, value.where} : checked_text(value);
}

double read_number(const TomlValue& value) {
  const double number = content_of<double>(value);
  if (!std::isfinite(number)) refuse(value, "is no finite number");
  return number;
}

[[noreturn]] void refuse_range(const TomlValue& value, double number, double least, double most) {
  const std::string range = std::isfinite(most) ? " to " + format_number(most) : " or more";
  refuse(value, "is " + format_number(number) + ", allowed is " + format_number(least) + range);
}

int read_whole(const TomlValue& value, int least) {
  constexpr int most = std::numeric_limits<int>::max();
  const double number = read_number(value);
  if (number != std::floor(number)) refuse(value, "is " + format_number(number) + ", a whole number is wanted");
  if (number < least) refuse_range(value, number, least, HUGE_VAL);
  if (number > most) refuse_range(value, number, least, most);
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

std::string joined(const std::vector<Given>& parts) {
  std::string text;
  for (const Given& part : parts) text += (text.empty() ? "" : ",") + part.text;
  return text;
}

// A value of a projection's parameter, as on the command line.
std::string read_parameter(const TomlValue& value) {
  if (const auto* flag = std::get_if<bool>(&value.content)) return *flag ? "true" : "false";
  if (std::holds_alternative<std::string>(value.content)) return read_text(value).text;
  if (!std::holds_alternative<TomlList>(value.content)) return format_number(read_number(value));
  std::string text;
  for (const TomlValue& element : std::get<TomlList>(value.content).values)
    text += (text.empty() ? "" : ",") + format_number(read_number(element));
  return text;
}

Given read_projection(const TomlValue& value) {
  const auto* table = std::get_if<TomlTable>(&value.content);
  if (table == nullptr) return read_text(value);
  std::string name, parameters;
  for (const TomlValue& entry : table->values) {
    if (entry.key == "name")
      name = read_text(entry).text;
    else
      parameters += ":" + entry.key + "=" + read_parameter(entry);
  }
  if (name.empty()) refuse(value, "lacks 'name'", "{name = \"look-at\", eye = [4, -9, 5]}");
  return {name + parameters, value.where};
}

AnchorWords read_vertex(const TomlValue& value, const std::vector<TomlValue>& elements) {
  if (elements.size() != 2)
    refuse(value, "has " + std::to_string(elements.size()) + " elements, [model, vertex] is wanted",
           "a point of the world is {point = [x, y, z]}");
  AnchorWords anchor{value.where, {}, read_whole(elements[1], 0), {}};
  if (std::holds_alternative<std::string>(elements[0].content))
    anchor.model = read_text(elements[0]).text;
  else
    anchor.model = read_whole(elements[0], 0);
  return anchor;
}

AnchorWords read_anchor(const TomlValue& value) {
  if (const auto* list = std::get_if<TomlList>(&value.content)) return read_vertex(value, list->values);
  const auto* table = std::get_if<TomlTable>(&value.content);
  if (table == nullptr) refuse_kind(value, "[model, vertex] or {point = [x, y, z]}");
  if (table->values.size() != 1 || table->values[0].key != "point")
    refuse(value, "is no anchor", "[model, vertex] or {point = [x, y, z]}");
  return {value.where, {}, -1, read_vector<Vec3>(table->values[0])};
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + ", " + unit;
}

}  // namespace

void refuse(const TomlValue& value, const std::string& reason, const std::string& hint) {
  throw Error(Trouble::input, value.where, "'" + value.key + "' " + reason, hint);
}

ValueKind<Given> any_text() { return {"text", read_text}; }

ValueKind<Given> field_text() { return {"text or date", read_field}; }

ValueKind<Given> words() {
  return {"list of texts", [](const TomlValue& value) -> Given { return {joined(each_word(value)), value.where}; }};
}

ValueKind<Given> projection_text() { return {"text or table", read_projection}; }

ValueKind<bool> truth() { return {"true or false", content_of<bool>}; }

ValueKind<int> whole_number(int least) {
  return {"whole number", [least](const TomlValue& value) { return read_whole(value, least); }};
}

ValueKind<double> any_number(const std::string& unit) { return {with_unit("number", unit), read_number}; }

ValueKind<double> number_between(double least, double most, const std::string& unit) {
  const auto read = [least, most](const TomlValue& value) {
    const double number = read_number(value);
    if (number < least || number > most) refuse_range(value, number, least, most);
    return number;
  };
  return {with_unit(format_number(least) + " to " + format_number(most), unit), read};
}

ValueKind<Vec2> pair_of_numbers(const std::string& unit) { return {with_unit("[x, y]", unit), read_vector<Vec2>}; }

ValueKind<Vec3> triple_of_numbers(const std::string& unit) { return {with_unit("[x, y, z]", unit), read_vector<Vec3>}; }

ValueKind<Vec3> direction() { return {"[x, y, z]", read_direction}; }

ValueKind<AnchorWords> anchor() { return {"anchor", read_anchor}; }

std::vector<Given> each_word(const TomlValue& value) {
  std::vector<Given> texts;
  if (std::holds_alternative<std::string>(value.content)) {
    const Given text = read_text(value);
    for (const std::string_view word : split(text.text, ',')) texts.push_back({std::string(word), text.where});
  } else {
    for (const TomlValue& element : content_of<TomlList>(value).values) texts.push_back(read_text(element));
  }
  const auto given = [](const Given& text) { return text.given(); };
  if (texts.empty() || !std::all_of(texts.begin(), texts.end(), given))
    refuse(value, texts.empty() ? "is empty" : "has an empty word", "leave it out, or say something");
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

}  // namespace epura
