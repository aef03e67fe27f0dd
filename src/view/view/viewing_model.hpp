// SPDX-License-Identifier: Apache-2.0
// A projected scene in the terms of seed document 003: the viewing model of PHIGS, from the world to the viewport.
// Numbers in brackets are its equations; column vectors: p' = M p.
#pragma once

#include <vector>

#include "projection/matrices.hpp"
#include "view/paper_map.hpp"

namespace epura::view {

struct ViewingStep {
  const char* symbol;    ///< as in the document, e.g. "N_par"
  const char* equation;  ///< number there
  const char* maps;      ///< from which coordinates to which
  Mat4 matrix;
};

struct ViewingModel {
  Vec3 vrp, vpn, vup;              ///< view reference point, view plane normal, view up vector, world (3.30)-(3.32)
  projection::ViewVolume volume;   ///< in view reference coordinates: window, VPD, F, B, PRP
  projection::Window viewport;     ///< mm
  Mat4 plane;                      ///< M_par (3.20) or M_per (3.10), in world coordinates
  std::vector<ViewingStep> steps;  ///< VOM, N, M in normalised coordinates if central, M_wv, in this order
  Mat4 product;                    ///< of all steps: world -> viewport
};

/// The window and the depths are those of the scene, unless the projection limits them; a window or depth without
/// extent is a unit wide. `scale`: mm of the viewport per unit of the model on the plane; `corner`: its lower left one.
ViewingModel viewing_model(const ProjectedScene& view, const Box& scene, double scale, const Vec2& corner = Vec2(0));

/// Returns the map to the viewport of `viewing_model` with the corner (0, 0), in the way in which drawings are made.
PaperMap viewport_map(const ProjectedScene& view, double scale);

}  // namespace epura::view
