// SPDX-License-Identifier: Apache-2.0
// Triangles for the faces of all parts, near enough to their surfaces.
#pragma once

#include <epura/importer_plugin.hpp>

#include "model.hpp"

namespace occt {

struct Extent {
  double diagonal;  ///< of the box of everything that stands somewhere, in mm
  double scale;     ///< the largest that a part stands in somewhere; at least 1
};

Extent extent_of(const Model& model);

/// Open CASCADE's edges are off by half of the deflection that it is told, on all files that were measured; by 0.52 of
/// it at most.
inline constexpr double told_for_wanted = 1.9;

struct Fineness {
  double deflection;  ///< mm between surface and triangles
  double angle;       ///< degrees that neighbouring facets of a round face fold by, at most
  unsigned threads;
};

/// The share of the work that it is, of the whole that Sink::progress tells.
inline constexpr double share_of_meshing = 0.4;

/// Leaves the triangles in the faces. Adds notes about what was repaired for it.
void tessellate(Model& model, const Fineness& fineness, epura::plugin::Sink& sink);

}  // namespace occt
