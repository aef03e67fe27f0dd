// SPDX-License-Identifier: Apache-2.0
// Who refers to whom among the requirements of a STEP file.
#pragma once

#include <map>
#include <vector>

#include "step_graph.hpp"

namespace occt {

using References = std::map<EntityNumber, std::vector<EntityNumber>>;

/// Each table leads from the number of one entity to those of others.
struct RequirementIndex {
  References items;            ///< of a shape aspect: faces, edges and points
  References parts;            ///< of a shape aspect: aspects of which it consists
  References features;         ///< of a datum: its features and targets
  References datums;           ///< of a feature or target
  References representations;  ///< of a dimension or a property
  References properties;       ///< of a target: the property whose representation has its place and size; of others
  References property_parts;   ///< of a property: those related to it
  References shown;            ///< of an annotation or a callout: what it shows
  References bounds;           ///< of a dimension: TOLERANCE_VALUE, LIMITS_AND_FITS
  References zones;            ///< of a tolerance: TOLERANCE_ZONE
  References definitions;      ///< of a zone: what says more of it
  References above;            ///< of a tolerance: the one in whose frame it stands below
  References qualifiers;       ///< of a measure
  References identities;       ///< of anything: what gives it an identity that outlasts the file
};

RequirementIndex index_of(const StepGraph& graph);

/// Those to which a table leads; none if it does not have the number.
const std::vector<EntityNumber>& listed(const References& table, EntityNumber number);

/// The items of an aspect and of all its parts, each once, in the order in which they are found. Aspects that contain
/// themselves are followed once. Each aspect and each item takes one of `left`; with none left, the rest is left out.
std::vector<EntityNumber> items_of(const RequirementIndex& index, EntityNumber aspect, std::size_t& left);

}  // namespace occt
