// SPDX-License-Identifier: Apache-2.0
// Which lines and dimensions of a sheet are those of which feature, for people who do not see it.
#pragma once

#include <string_view>

#include "features/part_features.hpp"
#include "sheet/notation.hpp"
#include "sheet/sheet.hpp"
#include "sizes/feature_table.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Adds to a sheet the features that its views show, in the order of the table, and their numbers to lines and
/// dimensions. A line is that of the first feature whose faces are at all of its edges; a dimension is that of the
/// first one whose face it measures. `language` as of phrases.
void add_features(sheet::Sheet& sheet, const world::World& world, const features::PartFeatures& features,
                  const sheet::FeatureTable& table, const sheet::Notation& notation, std::string_view language);

}  // namespace epura::pipeline
