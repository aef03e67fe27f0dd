// SPDX-License-Identifier: Apache-2.0
// A world cut by a plane. The remainder is a world of its own, closed by cut faces, so later stages need not know about
// cuts.
//
// Sides are signs of vertices: a vertex within rounding of the plane is on it, for all triangles. Decisions from signs
// alone are the same for neighbours; edges are cut once for all their triangles. Outlines of cut faces are taken just
// behind the plane, where vertices on it count as in front; faces that lie in the plane and bound the remainder are
// faces, not cuts.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/scene.hpp"

namespace epura::scene {

/// Where the plane cuts through material.
struct WorldCutFace {
  int model, body;                      ///< of a body with cavities that are bodies of the file: its own number
  std::vector<std::vector<int>> rings;  ///< outlines by vertices of the cut world, even-odd
};

/// A body whose cut has an outline that is not closed. What that would bound has no cut face; what other outlines of
/// the body bound has one.
struct OpenOutline {
  int model, body;
  Vec3 end;  ///< a place where it ends or branches
};

/// Gaps in outlines of a body that are narrower than what tessellation and rounding leave: its cut faces reach over
/// them.
struct BridgedGaps {
  int model, body;
  int count;
  double widest;  ///< in the world
  Vec3 place;     ///< of the widest
};

struct CutWorld {
  /// Vertices of the files keep their numbers, those that the plane makes follow them; so do triangles of cut faces and
  /// their polygons. Its box is still that of the whole.
  World world;
  std::vector<WorldCutFace> faces;   ///< in order of model and body
  std::vector<OpenOutline> open;     ///< likewise
  std::vector<BridgedGaps> bridged;  ///< likewise
  std::vector<int> uncut;  ///< triangles of bodies that the plane passes through and leaves whole (Placed::styles)
};

/// Throws Error{input} when the plane cuts no body, or leaves nothing; and OutOfTime.
CutWorld cut_world(const World& world, const CuttingPlane& plane, const Progress& progress = {});

}  // namespace epura::scene
