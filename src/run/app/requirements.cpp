// SPDX-License-Identifier: Apache-2.0
// `epura requirements`: the ledger of what model files and scenes require of their parts.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "app/describe.hpp"
#include "app/ledger.hpp"
#include "base/csv.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "compare/read_pictures.hpp"
#include "composition/requirement_words.hpp"
#include "importer/read_model.hpp"
#include "output/json_text.hpp"
#include "pipeline/find_features.hpp"
#include "pipeline/targets.hpp"
#include "report/report.hpp"

namespace epura {

namespace {

using importer::ModelRequirement;
using output::json_list;
using output::json_number;
using output::json_string;

/// What drawings show, by the id and the words of the requirement; those of equal ones in their order.
using ShownRequirements = std::multimap<std::pair<std::string, std::string>, report::RequirementRow>;

ShownRequirements shown_in(const std::vector<std::string>& drawings) {
  ShownRequirements shown;
  for (const std::string& drawing : drawings)
    for (report::RequirementRow& row : compare::requirements_of_json(read_file(drawing), drawing))
      shown.emplace(std::pair{row.id, row.what}, std::move(row));
  return shown;
}

void find_shown(Ledger& ledger, ShownRequirements& shown) {
  for (LedgerRow& one : ledger.requirements) {
    const std::string words = pipeline::requirement_sentence(one);
    const auto row = shown.find({one.id, words});
    if (row == shown.end())
      throw Error(ErrorKind::input, ledger.model, "the drawing does not have requirement " + one.id + ", " + words,
                  "give --drawing the JSON that 'epura draw' writes for this file, and draw again if that has changed");
    one.shown = std::move(shown.extract(row).mapped());
  }
}

std::vector<LedgerRow> numbered_rows(std::vector<ModelRequirement> all) {
  const std::vector<int> characteristics = pipeline::characteristic_numbers(all);
  std::vector<LedgerRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i) rows.push_back({std::move(all[i]), characteristics[i]});
  return rows;
}

Ledger ledger_of(const std::string& model, const RequirementsOptions& options) {
  const importer::ModelRequest request = importer::parse_model_request(model);
  importer::ReadModel read =
      importer::read_model(request.path, request.parameters, {.plugin_path = options.plugin_path});
  std::string counts = importer::counted_requirements(read.requirements);
  return {request.path, std::move(counts),     numbered_rows(std::move(read.requirements)),
          read.part,    read.unit.value_or(1), read.standard};
}

// Of each model of a scene that has any; of a scene without, one of the scene.
std::vector<Ledger> ledgers_of_scene(const std::string& file, const RequirementsOptions& options) {
  DrawOptions draw;
  draw.models = {file};
  draw.run.plugin_path = options.plugin_path;
  const scene::SceneDescription scene = describe(draw);
  std::vector<Ledger> ledgers;
  for (pipeline::FileRequirements& one : pipeline::requirements_of_scene(scene, draw.run, pipeline::silent_messages()))
    if (std::string counts = importer::counted_requirements(one.all); !counts.empty())
      ledgers.push_back({*scene.models[static_cast<std::size_t>(one.model)].file, std::move(counts),
                         numbered_rows(std::move(one.all)), one.part, one.unit, one.standard});
  if (ledgers.empty()) ledgers.push_back({file, "", {}});
  return ledgers;
}

std::vector<Ledger> ledgers_of(const std::string& file, const RequirementsOptions& options) {
  if (is_scene_file(file)) return ledgers_of_scene(file, options);
  return {ledger_of(file, options)};
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
  FieldValue (*value)(const LedgerRow& one);
};

const std::vector<Field>& fields() {
  using One = const LedgerRow&;
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
      {"text", [](One one) { return given(one.text); }},
      {"characteristic",
       [](One one) { return one.characteristic > 0 ? given(double(one.characteristic)) : FieldValue(); }},
      {"faces", [](One one) { return FieldValue(one.faces); }},
      {"view", [](One one) { return given(one.shown.view); }},
      {"sheet", [](One one) { return one.shown.sheet > 0 ? given(double(one.shown.sheet)) : FieldValue(); }},
      {"sheet_zone", [](One one) { return given(one.shown.zone); }},
      {"reason", [](One one) { return given(one.shown.why); }},
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

std::string json_of(const LedgerRow& one) {
  std::string json;
  for (const Field& field : fields())
    json += (json.empty() ? "{" : ", ") + json_string(field.name) + ": " + std::visit(JsonValue{}, field.value(one));
  return json + "}";
}

std::string json_of(const std::vector<Ledger>& ledgers) {
  const auto write = [](const Ledger& ledger) {
    return "{\"name\": " + json_string(ledger.model) +
           (ledger.standard.empty() ? "" : ", \"standard\": " + json_string(ledger.standard)) + ", \"requirements\": " +
           output::json_lines(
               ledger.requirements, [](const LedgerRow& one) { return json_of(one); }, "\n    ") +
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
    for (const LedgerRow& one : ledger.requirements) {
      csv += csv_field(ledger.model);
      for (const Field& field : fields()) csv += "," + std::visit(CsvValue{}, field.value(one));
      csv += "\r\n";
    }
  return csv;
}

/// A column of form 3 of AS9102, with its number there.
struct FormColumn {
  std::string_view heading;
  std::string (*text)(const Ledger& ledger, const LedgerRow& one);
};

std::string left_blank(const Ledger&, const LedgerRow&) { return {}; }

const std::vector<FormColumn>& form_columns() {
  using One = const LedgerRow&;
  using In = const Ledger&;
  static const std::vector<FormColumn> all{
      {"5. Char. No.", [](In, One one) { return std::to_string(one.characteristic); }},
      {"6. Reference Location", reference_location},
      {"7. Characteristic Designator", left_blank},
      {"8. Requirement", [](In, One one) { return pipeline::requirement_sentence(one); }},
      {"9. Results", left_blank},
      {"10. Designed / Qualified Tooling", left_blank},
      {"11. Nonconformance Number", left_blank},
      {"12. Additional Data / Comments", [](In, One one) { return comments_on(one); }}};
  return all;
}

std::string form_of(const std::vector<Ledger>& ledgers) {
  std::string form;
  for (const FormColumn& column : form_columns())
    form.append(form.empty() ? "" : ",").append(csv_field(std::string(column.heading)));
  form += "\r\n";
  for (const Ledger& ledger : ledgers)
    for (const LedgerRow& one : ledger.requirements) {
      if (one.characteristic == 0) continue;
      for (const FormColumn& column : form_columns())
        form += (&column == form_columns().data() ? "" : ",") + csv_field(column.text(ledger, one));
      form += "\r\n";
    }
  return form;
}

/// What the ledger can be written as.
struct LedgerFormat {
  std::string RequirementsOptions::*file;
  std::string (*text)(const std::vector<Ledger>& ledgers);
};

const std::vector<LedgerFormat>& ledger_formats() {
  static const std::vector<LedgerFormat> all{
      {&RequirementsOptions::json, [](const std::vector<Ledger>& all) { return json_of(all); }},
      {&RequirementsOptions::csv, csv_of},
      {&RequirementsOptions::as9102, form_of},
      {&RequirementsOptions::qif, qif_of}};
  return all;
}

// For people.

std::string text_of(const Ledger& ledger) {
  std::string text = one_line(ledger.model) + "\n";
  if (ledger.requirements.empty()) return text + "  the file states no requirements that are read\n";
  for (const LedgerRow& one : ledger.requirements) {
    std::string id = one.id;
    id.resize(std::max<std::size_t>(8, id.size() + 1), ' ');
    text += "  " + id + one_line(pipeline::requirement_sentence(one));
    text += one.faces.empty() ? "; no face" : (one.faces.size() == 1 ? "; face " : "; faces ") + faces_text(one.faces);
    if (one.shown.is_drawn()) text += "; " + one_line(reference_location(ledger, one));
    if (const std::string more = comments_on(one); !more.empty()) text += "; " + one_line(more);
    text += "\n";
  }
  if (!ledger.standard.empty()) text += "  by " + one_line(ledger.standard) + "\n";
  return text + "  " + ledger.counts + "\n";
}

bool is_incomplete(const Ledger& ledger) {
  return std::any_of(ledger.requirements.begin(), ledger.requirements.end(),
                     [](const LedgerRow& one) { return !one.missing.empty(); });
}

}  // namespace

std::string reference_location(const Ledger& ledger, const LedgerRow& row) {
  if (!row.shown.is_drawn()) return std::filesystem::path(ledger.model).filename().string() + " " + row.id;
  return "sheet " + std::to_string(row.shown.sheet) + (row.shown.zone.empty() ? "" : ", zone " + row.shown.zone) +
         (row.shown.view.empty() ? ", notes" : ", view " + row.shown.view);
}

std::string comments_on(const LedgerRow& row) {
  const std::string unread = row.missing.empty() ? std::string() : "not read: " + row.missing;
  const std::string undrawn =
      row.shown.is_drawn() || row.shown.why.empty() ? std::string() : "not drawn: " + row.shown.why;
  return unread + (unread.empty() || undrawn.empty() ? "" : "; ") + undrawn;
}

int requirements(const RequirementsOptions& options) {
  std::vector<std::string> files;
  for (const LedgerFormat& format : ledger_formats())
    if (const std::string& file = options.*format.file; !file.empty()) files.push_back(file);
  std::vector<std::string> read = options.models;
  read.insert(read.end(), options.drawings.begin(), options.drawings.end());
  if (!files.empty()) pipeline::refuse_overwriting(files, read);
  ShownRequirements shown = shown_in(options.drawings);
  std::vector<Ledger> ledgers;
  for (const std::string& model : options.models)
    for (Ledger& ledger : ledgers_of(model, options)) {
      if (!options.drawings.empty()) find_shown(ledger, shown);
      ledgers.push_back(std::move(ledger));
    }
  for (const LedgerFormat& format : ledger_formats())
    if (const std::string& file = options.*format.file; !file.empty())
      pipeline::write({file, format.text(ledgers)}, {});
  if (std::find(files.begin(), files.end(), "-") == files.end())
    for (const Ledger& ledger : ledgers) std::fputs(text_of(ledger).c_str(), stdout);
  return std::any_of(ledgers.begin(), ledgers.end(), is_incomplete) ? found_wrong_exit_code : 0;
}

}  // namespace epura
