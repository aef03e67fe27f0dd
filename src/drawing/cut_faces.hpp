// SPDX-License-Identifier: Apache-2.0
// Cut faces as they appear in a view.
#pragma once

#include <vector>

#include "drawing/drawing.hpp"
#include "scene/cut_world.hpp"
#include "view/paper_map.hpp"

namespace epura::drawing {

/// Returns the visible cut faces, on paper. Seen from in front of the plane, where everything is removed, nothing hides
/// them; seen from behind it, none is visible, and the result is empty. `view` is the view of the cut world.
std::vector<CutFace> cut_faces_on_paper(const std::vector<scene::WorldCutFace>& faces, const scene::CuttingPlane& plane,
                                        view::ProjectedScene& view, const view::PaperMap& paper);

}  // namespace epura::drawing
