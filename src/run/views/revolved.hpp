// SPDX-License-Identifier: Apache-2.0
// Revolved sections of the views of a scene.
#pragma once

#include <vector>

#include "cut/revolved.hpp"
#include "drawing/drawing.hpp"
#include "projection/projection.hpp"

namespace epura::pipeline {

struct RevolvedSection {
  scene::RevolvedDescription description;
  cut::FaceAtPoint face;
};

/// The revolved sections of a view. Throws Error{input} for perspectives, for views that do not see the cutting plane
/// edge-on, and as scene::cut_face_at_point does.
std::vector<RevolvedSection> cut_revolved(const world::World& world, const scene::SceneDescription& scene,
                                          const scene::ViewDescription& view, const projection::Projection& projection);

/// The cut face, turned into the picture about the line in which its plane passes through the point: what pointed
/// along the normal then points to the viewer. On paper, or in the plane of the view, as `map` maps the world there.
drawing::RevolvedFace turned_face(const RevolvedSection& section, const projection::Projection& projection,
                                  const Mat4& map);

/// Adds revolved sections to a finished view, where they are after parts are left out. Throws Error{input} for points
/// that are left out.
void add_revolved(drawing::ViewDrawing& drawing, const std::vector<RevolvedSection>& sections);

}  // namespace epura::pipeline
