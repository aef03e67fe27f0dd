// SPDX-License-Identifier: Apache-2.0
// The ledger of what model files require: a row for each requirement, and what becomes of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/requirements.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "surfaces/recognise.hpp"
#include "views/messages.hpp"

namespace epura::pipeline {

/// The requirements of a model, and what becomes of them.
struct FileRequirements {
  int model;
  std::vector<importer::ModelRequirement> all;        ///< of its file, then of the scene
  std::shared_ptr<const surfaces::PartFaces> part{};  ///< whose faces they name
  std::string standard{};                             ///< that the file names
  std::size_t by_scene = SIZE_MAX;                    ///< number of the first one of the scene, if there is one
  std::vector<report::RequirementRow> rows{};         ///< of each
  double unit = 1;                                    ///< of the part, mm
};

/// By which dimensions and callouts know what they draw.
std::string key_of(const FileRequirements& file, std::size_t i);

/// Whether one holds for all surfaces: of its faces, or without faces of the part. ISO 1101.
bool is_all_over(const importer::ModelRequirement& requirement);

/// Whether one is about the whole part: a note, a surface texture or a tolerance all over without faces.
bool is_of_all(const importer::ModelRequirement& requirement);

/// Why one cannot be drawn wherever it stands. A value that the file lacks is that of the model.
std::optional<std::string> why_unknown(const importer::ModelRequirement& requirement);

/// Which of them the scene wants to be drawn.
Pmi wanted_requirements(const scene::SceneDescription& scene, const scene::ModelDescription& model);

/// Adds the rows that are missing, with why those that are not wanted or not read are not drawn. What the scene itself
/// states is wanted.
void begin_ledger(FileRequirements& file, const scene::SceneDescription& scene);

/// Says of what dimensions and callouts of the scene draw, by their `requirement`, that the sheet has no room for it.
void take_back(std::vector<FileRequirements>& files, const std::vector<std::string>& keys);

/// The number of each characteristic, by the `requirement` of what draws it.
std::map<std::string, int> numbered_characteristics(const std::vector<FileRequirements>& files);

/// Tells if there are none.
void warn_of_no_characteristics(const Messages& messages, const std::vector<FileRequirements>& files);

/// Where on the sheet others are: the fields of its frame by their `requirement`.
void set_zones(std::vector<FileRequirements>& files, const std::vector<std::pair<std::string, std::string>>& zones);

/// All rows. Tells what is missing; if that is allowed, it is not wanted.
std::vector<report::RequirementRow> end_ledger(const std::vector<FileRequirements>& files, const Messages& messages,
                                               bool allow_missing);

}  // namespace epura::pipeline
