// SPDX-License-Identifier: Apache-2.0
// Cut faces as they appear in a view.
#pragma once

#include <vector>

#include "cut/cut_world.hpp"
#include "drawing/drawing.hpp"
#include "view/paper_map.hpp"

namespace epura::drawing {

/// Returns the visible cut faces, on paper. Seen from in front of the plane, where everything is removed, nothing hides
/// them; seen from behind it, none is visible, and the result is empty. `world` is what `view` shows: the cut world, or
/// that with more vertices behind those of each model (refine/refine_world.hpp).
std::vector<CutFace> cut_faces_on_paper(const cut::CutWorld& cut, const scene::CuttingPlane& plane,
                                        const world::World& world, view::ProjectedScene& view,
                                        const view::PaperMap& paper);

/// Whether the viewer looks at the side of the cut faces.
bool is_seen(const scene::CuttingPlane& plane, const projection::Projection& projection);

/// Returns what the triangles `uncut` of the cut world, by region, have in front of the surface, on paper. A viewer
/// among them sees nothing of those that reach behind the eye.
std::vector<PaperTriangle> before_cuts_on_paper(const world::World& world, const std::vector<std::vector<int>>& uncut,
                                                const cut::CuttingSurface& surface, const Mat4& world_to_page);

}  // namespace epura::drawing
