// SPDX-License-Identifier: Apache-2.0
// Models that several runs share, so that each is read once.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "foreign/parameters.hpp"
#include "importer/read_model.hpp"

namespace epura::pipeline {

/// What makes two readings of a file equal: its name, the importer's parameters, and both bounds for facets.
using ReadingKey = std::tuple<std::string, foreign::Assignments, double, double>;

/// Not to be used by several threads at once.
struct KeptModels {
  std::map<ReadingKey, importer::ReadModel> models{};
};

}  // namespace epura::pipeline
