// SPDX-License-Identifier: Apache-2.0
// Finds screw threads that are modelled as helical faces, which drawings show as cylinders with the lines of ISO
// 6410-1.
#pragma once

#include <optional>
#include <vector>

#include "base/range.hpp"
#include "mesh/mesh.hpp"
#include "scene/threads.hpp"
#include "surfaces/recognise.hpp"

namespace epura::features {

/// Lengths and positions are in units of the file, but for those of `thread`.
struct HelicalThread {
  Vec3 origin, axis;  ///< of the helix; the axis is a unit vector
  bool internal;
  double crest;                ///< radius of the cylinder through the crests
  double low, high;            ///< heights of its ends, from the origin
  Range full;                  ///< heights between which it has its full depth; beyond, it runs out
  scene::Thread thread;        ///< size of ISO 261 with this pitch
  std::vector<int> triangles;  ///< ascending
};

/// A helix whose pitch ISO 261 does not have for its diameter, at the crests; mm.
struct OtherHelix {
  double diameter, pitch;
};

struct HelicalForms {
  std::vector<HelicalThread> threads;
  std::vector<OtherHelix> others{};
};

/// Free forms around the axis of another round face, with vertices between two cylinders, are a thread if turning them
/// by an angle moves them along the axis in proportion, by a pitch that ISO 261 has for their diameter, over at least
/// two turns. `unit` is the length of the file's unit in mm.
HelicalForms find_helical_threads(const mesh::Mesh& mesh, const surfaces::PartFaces& part, double unit);

/// A mesh with a cylinder in the place of a thread.
struct WithCylinder {
  mesh::Mesh mesh;
  std::vector<int> face_of_triangle;  ///< numbered as in the part, with the cylinder after the others
};

/// Puts the cylinder through its crests in the place of a thread: the faces at both ends are continued to its circles,
/// or end there. Returns nothing where they cannot be continued: the triangles of a thread have to end in two closed
/// lines around its axis.
std::optional<WithCylinder> with_cylinder(const mesh::Mesh& mesh, const surfaces::PartFaces& part,
                                          const HelicalThread& thread);

}  // namespace epura::features
