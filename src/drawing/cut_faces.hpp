// SPDX-License-Identifier: Apache-2.0
// Cut faces as seen in a view.
#pragma once

#include <vector>

#include "drawing/drawing.hpp"
#include "scene/cut_world.hpp"
#include "view/paper_map.hpp"

namespace epura::drawing {

/// The cut faces that are seen, on paper. Seen from in front of the plane, where all is removed, nothing hides them;
/// seen from behind it, none is seen, and the result is empty. `view` is of the cut world.
std::vector<CutFace> cut_faces_on_paper(const std::vector<scene::WorldCutFace>& faces, const scene::CuttingPlane& plane,
                                        view::ProjectedScene& view, const view::PaperMap& paper);

}  // namespace epura::drawing
