// SPDX-License-Identifier: Apache-2.0
// Counts the faces of the models, and those whose size and place dimensions give.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "features/face_owners.hpp"
#include "sizes/coverage.hpp"
#include "sizes/hexagon_chamfers.hpp"
#include "sizes/round_ends.hpp"
#include "sizes/turned_prisms.hpp"

namespace epura::sheet {

/// A circle of a feature, and whether its size is given.
struct SizedCircle {
  Vec3 centre, axis;
  double radius;
  bool is_given;
};

/// A turned prism, and whether its sides and their angle are given.
struct KnownPrism {
  TurnedPrism prism;
  bool is_given;
};

/// Whether the size of a feature is given, by its kind and number.
using GivenOwners = std::map<std::pair<features::OwnerKind, int>, bool>;

/// What dimensions give.
struct GivenSizes {
  std::function<bool(int, double)> has_place;                        ///< along an axis of the world
  std::function<bool(const surfaces::PartFace&)> has_doubly_curved;  ///< a sphere or torus
  std::span<const char> held{};                                      ///< as of find_coverage
  std::vector<SizedCircle> circles{};                                ///< of all features that have any
  std::vector<double> radii{};                                       ///< that are given somewhere
  std::vector<KnownPrism> prisms{};
  std::vector<HexagonChamfer> hexagon_chamfers{};  ///< given where their bevel is
  GivenOwners owners{};                            ///< without bevels
  std::vector<bool> bevels{};                      ///< in the order of the PartFeatures
};

/// What is known of all faces but free forms and walls of letters.
struct FaceCoverage {
  std::vector<report::SizeCount> counts;  ///< of kinds that there are
  std::vector<std::string> unaccounted;   ///< faces without a size that belong to no feature which would be missed
};

/// None for an assembly, whose drawing gives the places of its parts alone.
FaceCoverage cover_faces(const DimensionSubject& subject, std::span<const RoundEnd> ends, const GivenSizes& given,
                         const Notation& notation);

}  // namespace epura::sheet
