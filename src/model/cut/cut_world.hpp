// SPDX-License-Identifier: Apache-2.0
// Cuts a world by a plane or a stepped surface, or by planes whose remainders are then turned into one. The remainder
// is again a world, closed by cut faces, so that later stages need no special treatment of cuts.
//
// Each vertex has a sign for its side of the plane: a vertex within rounding of the plane is on it, for all of its
// triangles. Decisions based only on these signs are consistent between neighbours, and each edge is cut once for all
// of its triangles. Its vertices are then moved onto the surfaces of recognised faces (cut/true_outline.hpp).
// Outlines of cut faces are taken just behind the plane, where vertices on the plane count as in front; faces that lie
// in the plane and bound the remainder are faces, not cuts.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "cut/cutting_surface.hpp"
#include "world/world.hpp"

namespace epura::cut {

/// An area in which the surface cuts through material.
struct WorldCutFace {
  int model, body;                      ///< if cavities are bodies of the file, the number of the body around them
  std::vector<std::vector<int>> rings;  ///< outlines as vertices of the cut world, even-odd rule
};

/// A body whose cut has an open outline. There is no cut face for this outline, only for the other outlines of the
/// body.
struct OpenOutline {
  int model, body;
  Vec3 end;  ///< a point where it ends or branches
};

/// Gaps in outlines of a body that tessellation and rounding explain: the cut faces of the body extend across them.
struct BridgedGaps {
  int model, body;
  int count;
  double widest;  ///< in units of the world
  Vec3 place;     ///< position of the widest one
};

/// Two bodies that overlap in the cut. The face of the second one is only what is outside of the first.
struct OverlappingBodies {
  int model, body;              ///< the inner one, as a screw
  int under_model, under_body;  ///< the one around it
  double area;                  ///< of what they have in common there
  Vec3 place;
};

struct CutWorld {
  /// Vertices of the files keep their numbers, and are followed by those that the plane creates; likewise triangles of
  /// cut faces and their polygons come last. The box is that of the uncut world. Of an aligned section, the world has
  /// all models once for each plane (Placed::copy_of), in the order of the path, and the box that of turned parts, too.
  world::World world;
  std::vector<WorldCutFace> faces;   ///< sorted by model and body
  std::vector<OpenOutline> open;     ///< likewise
  std::vector<BridgedGaps> bridged;  ///< likewise
  std::vector<OverlappingBodies> overlaps;
  /// Triangles of bodies that the surface passes through and leaves whole (World::styles), by region of the surface.
  std::vector<std::vector<int>> uncut;
  double moved = 0;  ///< largest distance between outlines on recognised surfaces and those of their facets
};

/// Throws Error{input} if the surface neither cuts nor removes anything, or removes everything; and OutOfTime. There
/// are no faces along steps, which are seen edge-on in the sections for which they are made.
CutWorld cut_world(const world::World& world, const CuttingSurface& surface, const Progress& progress = {});

inline CutWorld cut_world(const world::World& world, const scene::CuttingPlane& plane, const Progress& progress = {}) {
  return cut_world(world, plane_surface(plane), progress);
}

}  // namespace epura::cut
