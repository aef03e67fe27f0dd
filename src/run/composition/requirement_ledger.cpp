// SPDX-License-Identifier: Apache-2.0
#include "composition/requirement_ledger.hpp"

#include <algorithm>
#include <string_view>

#include "base/text.hpp"
#include "composition/requirement_words.hpp"
#include "composition/stated_dimensions.hpp"
#include "composition/tell.hpp"
#include "scene/body_styles.hpp"
#include "scene/choices.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementKind;

constexpr const char* no_value = "a value";  // ModelRequirement::missing of dimensions without one

bool is_wanted(RequirementKind kind, Pmi wanted) {
  if (wanted == Pmi::dimensions) return kind == RequirementKind::dimension;
  if (wanted == Pmi::tolerances) return kind != RequirementKind::dimension;
  return wanted == Pmi::all;
}

using RowsByKey = std::multimap<std::string, report::RequirementRow*, std::less<>>;

RowsByKey drawn_rows(std::vector<FileRequirements>& files) {
  RowsByKey rows;
  for (FileRequirements& file : files)
    for (std::size_t i = 0; i < file.rows.size(); ++i)
      if (file.rows[i].is_drawn()) rows.emplace(key_of(file, i), &file.rows[i]);
  return rows;
}

// The rows that a dimension or callout draws, by its keys.
template <class Visit>
void for_each_row(const RowsByKey& rows, const std::string& keys, const Visit& visit) {
  for (const std::string_view key : split(keys, ' ')) {
    const auto [first, end] = rows.equal_range(key);
    std::for_each(first, end, [&visit](const auto& row) { visit(*row.second); });
  }
}

}  // namespace

std::string key_of(const FileRequirements& file, std::size_t i) {
  return std::to_string(file.model) + ":" + std::to_string(i);
}

bool is_all_over(const ModelRequirement& one) {
  const std::vector<std::string> modifiers = items_of(one.modifiers, ", ");
  return std::ranges::find(modifiers, "all over") != modifiers.end();
}

bool is_of_all(const ModelRequirement& one) {
  const bool may_be =
      one.kind == RequirementKind::note || one.kind == RequirementKind::surface_texture || is_all_over(one);
  return may_be && one.faces.empty();
}

std::optional<std::string> why_unknown(const ModelRequirement& one) {
  if (!one.missing.empty() && (one.missing != no_value || one.faces.empty())) return "not read: " + one.missing;
  if (one.faces.empty() && !is_of_all(one)) return "it belongs to no face of the model";
  return std::nullopt;
}

Pmi wanted_requirements(const scene::SceneDescription& scene, const scene::ModelDescription& model) {
  const bool is_annotated = !scene.dimensions.empty() || !scene.callouts.empty() || !scene.requirements.empty();
  return model.pmi.value_or(is_annotated ? Pmi::all : Pmi::none);
}

void begin_ledger(FileRequirements& file, const scene::SceneDescription& scene) {
  const scene::ModelDescription& model = scene.models[static_cast<std::size_t>(file.model)];
  const Pmi wanted = wanted_requirements(scene, model);
  const std::vector<int> characteristics = characteristic_numbers(file.all);
  for (std::size_t i = file.rows.size(); i < file.all.size(); ++i) {
    const ModelRequirement& one = file.all[i];
    report::RequirementRow& row = file.rows.emplace_back();
    row.characteristic = characteristics[i];
    row.model = scene::name_of(model);
    row.id = one.id;
    row.kind = importer::requirement_kind_names[static_cast<std::size_t>(one.kind)];
    row.what = requirement_sentence(one);
    row.wanted = i >= file.by_scene || is_wanted(one.kind, wanted);
    if (!row.wanted)
      row.why = model.pmi.given() ? "--pmi " + std::string(scene::word_of(wanted)) + " leaves it out"
                                  : "the sheets have no dimensions and symbols";
    else
      row.why = why_unknown(one).value_or(not_seen);
  }
}

void take_back(std::vector<FileRequirements>& files, const std::vector<std::string>& keys) {
  const RowsByKey rows = drawn_rows(files);
  for (const std::string& list : keys)
    for_each_row(rows, list, [](report::RequirementRow& row) {
      row.view.clear();
      row.sheet = 0;
      row.why = "there is no place for it in the view";
    });
}

std::map<std::string, int> numbered_characteristics(const std::vector<FileRequirements>& files) {
  std::map<std::string, int> numbers;
  for (const FileRequirements& file : files)
    for (std::size_t i = 0; i < file.rows.size(); ++i)
      if (const int number = file.rows[i].characteristic; number > 0) numbers.emplace(key_of(file, i), number);
  return numbers;
}

void warn_of_no_characteristics(const Messages& messages, const std::vector<FileRequirements>& files) {
  if (numbered_characteristics(files).empty())
    messages.warn(
        "the models state nothing to be measured that is read, so no characteristic has a balloon\n  hint: "
        "epura requirements lists what a file requires");
}

void set_zones(std::vector<FileRequirements>& files, const std::vector<std::pair<std::string, std::string>>& zones) {
  const RowsByKey rows = drawn_rows(files);
  for (const auto& [list, zone] : zones)
    for_each_row(rows, list, [&zone = zone](report::RequirementRow& row) { row.zone = zone; });
}

std::vector<report::RequirementRow> end_ledger(const std::vector<FileRequirements>& files, const Messages& messages,
                                               bool allow_missing) {
  std::vector<report::RequirementRow> rows;
  for (const FileRequirements& file : files) rows.insert(rows.end(), file.rows.begin(), file.rows.end());
  tell_of_requirements(messages, rows, allow_missing);
  if (allow_missing)
    for (report::RequirementRow& row : rows) row.wanted = false;
  return rows;
}

}  // namespace epura::pipeline
