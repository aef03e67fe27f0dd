// SPDX-License-Identifier: Apache-2.0
// `epura requirements`: the ledger of what model files require of their parts.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "base/csv.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "composition/requirement_words.hpp"
#include "importer/read_model.hpp"
#include "output/json_text.hpp"
#include "pipeline/targets.hpp"

namespace epura {

namespace {

using importer::ModelRequirement;
using output::json_list;
using output::json_number;
using output::json_string;

/// The ledger of one model.
struct Ledger {
  std::string model;
  std::vector<ModelRequirement> requirements;
};

Ledger ledger_of(const std::string& model, const RequirementsOptions& options) {
  const importer::ModelRequest request = importer::parse_model_request(model);
  return {request.path,
          importer::read_model(request.path, request.parameters, {.plugin_path = options.plugin_path}).requirements};
}

std::string faces_text(const std::vector<int>& faces) {
  std::string text;
  for (const int face : faces) text += (text.empty() ? "" : " ") + std::to_string(face);
  return text;
}

/// A list that is one text, and what separates its items there.
struct TextList {
  std::string text;
  std::string_view separator;
};

/// Nothing where the file does not say.
using FieldValue = std::variant<std::monostate, std::string, double, bool, TextList, std::vector<int>>;

FieldValue given(const std::string& text) { return text.empty() ? FieldValue() : FieldValue(text); }
FieldValue given(double number) { return std::isfinite(number) ? FieldValue(number) : FieldValue(); }

/// A field of JSON and a column of CSV.
struct Field {
  std::string_view name;
  FieldValue (*value)(const ModelRequirement& one);
};

const std::vector<Field>& fields() {
  using One = const ModelRequirement&;
  static const std::vector<Field> all{
      {"id", [](One one) { return given(one.id); }},
      {"kind",
       [](One one) { return FieldValue(std::string(importer::requirement_kind_names[std::size_t(one.kind)])); }},
      {"type", [](One one) { return given(one.type); }},
      {"name", [](One one) { return given(one.name); }},
      {"value", [](One one) { return given(one.value); }},
      {"lower", [](One one) { return given(one.lower); }},
      {"upper", [](One one) { return given(one.upper); }},
      {"bounds",
       [](One one) { return FieldValue(std::string(importer::requirement_bounds_names[std::size_t(one.bounds)])); }},
      {"is_angle", [](One one) { return FieldValue(one.is_angle != 0); }},
      {"unit", [](One one) { return one.unit > 0 ? given(one.unit) : FieldValue(); }},
      {"decimals", [](One one) { return one.decimals >= 0 ? given(double(one.decimals)) : FieldValue(); }},
      {"fit", [](One one) { return given(one.fit); }},
      {"modifiers",
       [](One one) {
         return FieldValue(TextList{one.modifiers, ", "});
       }},
      {"zone", [](One one) { return given(one.zone); }},
      {"datums",
       [](One one) {
         return FieldValue(TextList{one.datums, " | "});
       }},
      {"above", [](One one) { return given(one.above); }},
      {"faces", [](One one) { return FieldValue(one.faces); }},
      {"missing", [](One one) { return given(one.missing); }}};
  return all;
}

struct JsonValue {
  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(const std::string& text) const { return json_string(text); }
  std::string operator()(double number) const { return json_number(number); }
  std::string operator()(bool is_so) const { return is_so ? "true" : "false"; }
  std::string operator()(const TextList& list) const {
    return json_list(pipeline::items_of(list.text, list.separator), json_string);
  }
  std::string operator()(const std::vector<int>& numbers) const {
    return json_list(numbers, [](int number) { return std::to_string(number); });
  }
};

std::string json_of(const ModelRequirement& one) {
  std::string json;
  for (const Field& field : fields())
    json += (json.empty() ? "{" : ", ") + json_string(field.name) + ": " + std::visit(JsonValue{}, field.value(one));
  return json + "}";
}

std::string json_of(const std::vector<Ledger>& ledgers) {
  const auto write = [](const Ledger& ledger) {
    return "{\"name\": " + json_string(ledger.model) + ", \"requirements\": " +
           output::json_lines(
               ledger.requirements, [](const ModelRequirement& one) { return json_of(one); }, "\n    ") +
           "}";
  };
  return "{\"epura_requirements\": 1, \"models\": " + output::json_lines(ledgers, write, "\n  ") + "}\n";
}

struct CsvValue {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const std::string& text) const { return csv_field(text); }
  std::string operator()(double number) const { return format_number(number); }
  std::string operator()(bool is_so) const { return is_so ? "yes" : "no"; }
  std::string operator()(const TextList& list) const { return csv_field(list.text); }
  std::string operator()(const std::vector<int>& numbers) const { return faces_text(numbers); }
};

std::string csv_of(const std::vector<Ledger>& ledgers) {
  std::string csv = "model";
  for (const Field& field : fields()) csv.append(",").append(field.name);
  csv += "\r\n";
  for (const Ledger& ledger : ledgers)
    for (const ModelRequirement& one : ledger.requirements) {
      csv += csv_field(ledger.model);
      for (const Field& field : fields()) csv += "," + std::visit(CsvValue{}, field.value(one));
      csv += "\r\n";
    }
  return csv;
}

// For people.

std::string text_of(const Ledger& ledger) {
  std::string text = one_line(ledger.model) + "\n";
  if (ledger.requirements.empty()) return text + "  the file states no requirements that are read\n";
  for (const ModelRequirement& one : ledger.requirements) {
    std::string id = one.id;
    id.resize(std::max<std::size_t>(8, id.size() + 1), ' ');
    text += "  " + id + one_line(pipeline::requirement_sentence(one));
    text += one.faces.empty() ? "; no face" : (one.faces.size() == 1 ? "; face " : "; faces ") + faces_text(one.faces);
    if (!one.missing.empty()) text += "; not read: " + one_line(one.missing);
    text += "\n";
  }
  return text + "  " + importer::counted_requirements(ledger.requirements) + "\n";
}

bool is_incomplete(const Ledger& ledger) {
  return std::any_of(ledger.requirements.begin(), ledger.requirements.end(),
                     [](const ModelRequirement& one) { return !one.missing.empty(); });
}

}  // namespace

int requirements(const RequirementsOptions& options) {
  std::vector<std::string> files;
  for (const std::string& file : {options.json, options.csv})
    if (!file.empty()) files.push_back(file);
  if (!files.empty()) pipeline::refuse_overwriting(files, options.models);
  std::vector<Ledger> ledgers;
  for (const std::string& model : options.models) ledgers.push_back(ledger_of(model, options));
  if (!options.json.empty()) pipeline::write({options.json, json_of(ledgers)}, {});
  if (!options.csv.empty()) pipeline::write({options.csv, csv_of(ledgers)}, {});
  if (options.json != "-" && options.csv != "-")
    for (const Ledger& ledger : ledgers) std::fputs(text_of(ledger).c_str(), stdout);
  return std::any_of(ledgers.begin(), ledgers.end(), is_incomplete) ? found_wrong_exit_code : 0;
}

}  // namespace epura
