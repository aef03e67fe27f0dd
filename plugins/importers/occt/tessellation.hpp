// SPDX-License-Identifier: Apache-2.0
// Triangles for the faces of all parts, within a given distance of their surfaces.
#pragma once

#include <epura/importer_plugin.hpp>

#include "model.hpp"

namespace occt {

struct Extent {
  double diagonal;  ///< of the box of all positioned parts, mm
  double scale;     ///< the largest at which a part is positioned; at least 1
};

Extent extent_of(const Model& model);

/// Open CASCADE's edges deviate by half of the deflection that it is given, in all files measured; by at most 0.52 of
/// it.
inline constexpr double told_for_wanted = 1.9;

struct Fineness {
  double deflection;  ///< mm between surface and triangles
  double angle;       ///< maximum fold between neighbouring facets of a round face, degrees
  unsigned threads;
};

/// The same, or coarser if a free form would take more facets than Open CASCADE makes in about a minute: then a note
/// says so. Estimated from the surfaces before there is any facet.
Fineness affordable(Model& model, Fineness wanted);

/// The share of meshing in the work reported by Sink::progress.
inline constexpr double share_of_meshing = 0.4;

/// Stores the triangles in the faces. Adds notes about repairs.
void tessellate(Model& model, const Fineness& fineness, epura::plugin::Sink& sink);

}  // namespace occt
