// SPDX-License-Identifier: Apache-2.0
// Models that several models of a scene, or several runs, share, so that each file is read once.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "foreign/parameters.hpp"
#include "importer/read_model.hpp"

namespace epura::pipeline {

/// What makes two readings of a file equal: its name, the importer's parameters, and both bounds for facets.
using ReadingKey = std::tuple<std::string, foreign::Assignments, double, double>;

struct KeptModel {
  std::shared_ptr<const mesh::Mesh> mesh;
  importer::ReadModel rest{};  ///< without the mesh
};

/// Not to be used by several threads at once.
struct KeptModels {
  std::map<ReadingKey, KeptModel> models{};
};

}  // namespace epura::pipeline
