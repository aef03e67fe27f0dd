// SPDX-License-Identifier: Apache-2.0
// Triangles that coincide with two others, as in copies of a part in one position.
#pragma once

#include <span>
#include <vector>

#include "base/groups.hpp"
#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura::visibility {

/// Such a triangle hides exactly what its copies hide, to the last bit: the first copy represents it, and the second
/// one does so for the edges that belong to the first. But edges that begin at one of its corners are decided more
/// precisely by the triangle itself (Contact::joined).
class ThirdCopies {
 public:
  /// Throws OutOfTime.
  ThirdCopies(const world::World& world, const view::ProjectedScene& view, const Progress& progress);

  /// All triangles of the view except third copies, ascending.
  [[nodiscard]] std::vector<int> others() const;

  /// The same for edges, which run through the same cells as their copies. Throws OutOfTime.
  [[nodiscard]] std::vector<int> other_edges(const view::ProjectedScene& view,
                                             const std::vector<edges::FeatureEdge>& edges,
                                             const Progress& progress) const;

  /// The third copies that have this vertex of the view as a corner, ascending.
  [[nodiscard]] std::span<const int> around(int vertex) const {
    return at_.size() == 0 ? std::span<const int>() : at_[static_cast<std::size_t>(vertex)];
  }

 private:
  std::vector<char> is_third_;  ///< by triangle
  Groups<int> at_;              ///< by vertex; without groups if there are no third copies
};

}  // namespace epura::visibility
