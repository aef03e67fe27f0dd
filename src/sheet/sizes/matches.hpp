// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of which a scene says more by their text: `match = "⌀8"`, `tolerance = "H7"`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "sheet/notation.hpp"
#include "sizes/named_projection.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// A size with the text of a wish that asks for another view, type or direction.
struct OtherMatch {
  std::string where;  ///< of the wish
  std::string view;   ///< of the size
};

struct Matches {
  std::vector<scene::DimensionDescription> matched;  ///< with what the scene says of them
  std::vector<std::string> met;                      ///< where it says so
  std::vector<std::string> sizes;                    ///< the texts of all automatic dimensions
  std::vector<OtherMatch> others;
};

/// Takes those out of the automatic dimensions of a view that match one of the wishes, the last one of which counts;
/// places of rows that are measured from one origin become dimensions of their own. Patterns are those of fnmatch
/// (POSIX) for the whole text or for the value with its sign; "Ø" is "⌀", "x" is "×", and a comma is a point there. A
/// tolerance takes auxiliary sizes out of their brackets.
Matches take_matches(std::vector<scene::DimensionDescription>& automatic,
                     std::span<const scene::DimensionDescription> wishes, const world::World& world,
                     std::span<const NamedProjection> views, Notation notation);

}  // namespace epura::sheet
