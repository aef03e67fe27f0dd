// SPDX-License-Identifier: Apache-2.0
// Triangles that coincide with two others, as in copies of a part in one position.
#pragma once

#include <span>
#include <vector>

#include "base/groups.hpp"
#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "scene/scene.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// To the last bit such a triangle hides what its copies hide: the first stands for it, and the second for the edges
/// that are the first one's own. But edges that begin at one of its corners are decided more sharply by the triangle
/// itself (Contact::joined).
class ThirdCopies {
 public:
  /// Throws OutOfTime.
  ThirdCopies(const scene::World& world, const view::ProjectedScene& view, const Progress& progress);

  /// Of the view, ascending: all triangles but those.
  [[nodiscard]] std::vector<int> others() const;

  /// The same of edges, which run through the same cells as their copies. Throws OutOfTime.
  [[nodiscard]] std::vector<int> other_edges(const view::ProjectedScene& view,
                                             const std::vector<edges::FeatureEdge>& edges,
                                             const Progress& progress) const;

  /// Those that have this vertex of the view as a corner, ascending.
  [[nodiscard]] std::span<const int> around(int vertex) const {
    return at_.size() == 0 ? std::span<const int>() : at_[static_cast<std::size_t>(vertex)];
  }

 private:
  std::vector<char> is_third_;  ///< by triangle
  Groups<int> at_;              ///< by vertex; without groups where there are none
};

}  // namespace epura::visibility
