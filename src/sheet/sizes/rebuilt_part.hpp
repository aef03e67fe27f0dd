// SPDX-License-Identifier: Apache-2.0
// The proof that dimensions define a part: its faces are found again from their numbers.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "definition/rules.hpp"
#include "features/true_extents.hpp"
#include "sheet/notation.hpp"
#include "sizes/coverage.hpp"

namespace epura::sheet {

/// A face that does not come out where the part has it.
struct OffFace {
  std::string name;  ///< "plane face 12 of ..."
  int number;        ///< in scenes
  double off;        ///< the largest distance of its corners in the part from it, in units of the world
};

struct RebuiltPart {
  double perturbed = 0;             ///< the largest distance by which corners were off at the beginning
  double deviation = 0;             ///< the largest by which they are off in the end
  double spread = 0;                ///< by which faces differ that began elsewhere
  double volume = 0, of_part = 0;   ///< of the faces found, and of the part
  std::vector<OffFace> free;        ///< faces that depend on where they began, the worst first
  int faces = 0, by_model = 0;      ///< of all kinds; of free form, and walls of letters, which no numbers give
  std::vector<std::string> unread;  ///< dimensions of which nobody can tell what they measure
  bool is_settled = true;           ///< all equations came to rest

  /// Whether the numbers give one part.
  [[nodiscard]] bool is_defined() const { return is_settled && free.empty(); }
};

/// Faces are perturbed twice, by up to 1 % of the part and a tenth of its smallest radius, and found again by what
/// dimensions and rules that readers apply say where the surfaces are then; texts count as they are written. Nothing
/// for assemblies, and without recognised faces. Throws Error{input} for parts of too many faces.
std::optional<RebuiltPart> rebuild_part(std::span<const DimensionsInView> views, const world::World& world,
                                        const std::array<features::Extent, 3>& extents, const Notation& notation,
                                        const definition::RuleSet& rules);

}  // namespace epura::sheet
