// SPDX-License-Identifier: Apache-2.0
// What a dimension says of places along the axes of the world.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sizes/coverage.hpp"
#include "sizes/feature_table.hpp"

namespace epura::sheet {

/// Two places, of which one gives the other.
struct PlaceJoin {
  int axis;
  double from, to;
  int parts = 0;       ///< equal lengths between them that are written; 0: it follows, as from a diameter
  std::string name{};  ///< of a length: what is said twice if others give it, too; may be empty
};

/// Whether a text is in brackets (ISO 129-1) or a reference (ASME Y14.5), and the dimension thus auxiliary.
bool is_auxiliary(const AnchoredDimension& dimension);

/// The direction in the world along which a dimension in a view measures a length; nothing if it measures none, or if
/// an aligned section shows it elsewhere.
std::optional<Vec3> measured_along(const AnchoredDimension& dimension, const DimensionsInView& view);

/// The hexagons whose width across flats a dimension gives: those at which it is, and for "2×" all equal ones.
std::vector<std::size_t> hexagons_of(const AnchoredDimension& dimension, const DimensionsInView& view,
                                     const DimensionSubject& subject);

/// A diameter joins the middle of a circle with its sides, the note of a chamfer its ends, a label the axis of its hole
/// with the ends of the models. None for an auxiliary dimension.
std::vector<PlaceJoin> joins_of(const AnchoredDimension& dimension, const DimensionsInView& view,
                                const DimensionSubject& subject, const FeatureTable& table, const Notation& notation);

/// The radius of a round end gives the distance from its centre to the end of the models.
std::vector<PlaceJoin> joins_of_round_ends(std::span<const double> radii, const DimensionSubject& subject,
                                           const FeatureTable& table);

}  // namespace epura::sheet
