// SPDX-License-Identifier: Apache-2.0
// Features of a part in words, equal ones together, and which faces are theirs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "features/part_features.hpp"
#include "sheet/notation.hpp"
#include "sizes/feature_table.hpp"
#include "surfaces/recognise.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Features that one note can describe.
struct FeatureGroup {
  sheet::SizeKind kind;                 ///< of those that have faces of their own
  std::vector<std::size_t> features{};  ///< their numbers among those of the kind
  std::string words{};                  ///< of one: "diameter 8, through", of holes; otherwise "radius 5"
  bool are_holes = false;
};

/// Those of feature_table that have faces of their own, in its order; `language` as of phrases.
std::vector<FeatureGroup> feature_groups(const features::PartFeatures& features, const sheet::FeatureTable& table,
                                         const sheet::Notation& notation, std::string_view language);

/// "4 × radius 5"
std::string counted(std::size_t count, const std::string& what);

/// The group of each face of a model, by index; -1 for faces of none.
std::vector<int> groups_of_faces(const world::World& world, int model, const features::PartFeatures& features,
                                 const std::vector<FeatureGroup>& groups);

}  // namespace epura::pipeline
