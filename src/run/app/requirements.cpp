// SPDX-License-Identifier: Apache-2.0
// `epura requirements`: the ledger of what model files require of their parts.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands.hpp"
#include "app/requirement_words.hpp"
#include "base/csv.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
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

// Why no sheet shows it.
std::string reason_of(const ModelRequirement& requirement) {
  const std::string reason = "requirements of files are not drawn yet";
  return requirement.missing.empty() ? reason : reason + "; not read: " + requirement.missing;
}

std::vector<std::string> listed(std::string_view text, std::string_view separator) {
  std::vector<std::string> items;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    items.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
  return items;
}

std::string faces_text(const ModelRequirement& requirement) {
  std::string text;
  for (const int face : requirement.faces) text += (text.empty() ? "" : " ") + std::to_string(face);
  return text;
}

// JSON.

std::string json_of(const ModelRequirement& one) {
  const auto text = [](const char* key, const std::string& words) {
    return std::string(", \"") + key + "\": " + (words.empty() ? "null" : json_string(words));
  };
  std::string json = "{\"id\": " + json_string(one.id) + ", \"kind\": " +
                     json_string(importer::requirement_kind_names[static_cast<std::size_t>(one.kind)]) +
                     text("type", one.type) + text("name", one.name);
  json += ", \"value\": " + json_number(one.value) + ", \"lower\": " + json_number(one.lower) +
          ", \"upper\": " + json_number(one.upper) +
          ", \"bounds\": " + json_string(importer::requirement_bounds_names[static_cast<std::size_t>(one.bounds)]);
  json += std::string(", \"is_angle\": ") + (one.is_angle ? "true" : "false") +
          ", \"unit\": " + (one.unit > 0 ? json_number(one.unit) : "null") +
          ", \"decimals\": " + (one.decimals < 0 ? "null" : std::to_string(one.decimals));
  json += text("fit", one.fit) + ", \"modifiers\": " + json_list(listed(one.modifiers, ", "), json_string) +
          text("zone", one.zone) + ", \"datums\": " + json_list(listed(one.datums, " | "), json_string) +
          text("above", one.above);
  json += ", \"faces\": " + json_list(one.faces, [](int face) { return std::to_string(face); });
  return json + ", \"drawn\": false, \"reason\": " + json_string(reason_of(one)) + text("missing", one.missing) + "}";
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

// CSV (RFC 4180).

std::string csv_number(double value) { return std::isfinite(value) ? format_number(value) : std::string(); }

std::string csv_of(const std::vector<Ledger>& ledgers) {
  std::string csv =
      "model,id,kind,type,name,value,lower,upper,bounds,is_angle,unit,decimals,fit,modifiers,zone,datums,above,faces,"
      "drawn,reason,missing\r\n";
  for (const Ledger& ledger : ledgers) {
    for (const ModelRequirement& one : ledger.requirements) {
      const std::vector<std::string> fields{
          ledger.model,
          one.id,
          std::string(importer::requirement_kind_names[static_cast<std::size_t>(one.kind)]),
          one.type,
          one.name,
          csv_number(one.value),
          csv_number(one.lower),
          csv_number(one.upper),
          std::string(importer::requirement_bounds_names[static_cast<std::size_t>(one.bounds)]),
          one.is_angle ? "yes" : "no",
          one.unit > 0 ? csv_number(one.unit) : "",
          one.decimals < 0 ? "" : std::to_string(one.decimals),
          one.fit,
          one.modifiers,
          one.zone,
          one.datums,
          one.above,
          faces_text(one),
          "no",
          reason_of(one),
          one.missing};
      for (std::size_t i = 0; i < fields.size(); ++i) csv += (i == 0 ? "" : ",") + csv_field(fields[i]);
      csv += "\r\n";
    }
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
    text += "  " + id + one_line(requirement_sentence(one));
    text += one.faces.empty() ? "; no face" : (one.faces.size() == 1 ? "; face " : "; faces ") + faces_text(one);
    if (!one.missing.empty()) text += "; not read: " + one_line(one.missing);
    text += "\n";
  }
  return text + "  " + importer::counted_requirements(ledger.requirements) + "; none is drawn yet\n";
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
