// SPDX-License-Identifier: Apache-2.0
// Broken-out sections of the views of a scene.
#pragma once

#include <vector>

#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"
#include "projection/projection.hpp"
#include "views/sections.hpp"

namespace epura::pipeline {

struct BrokenOutSection {
  scene::BrokenOutDescription description;
  CutSection section;
};

/// The broken-out sections of a view, or of the view that it enlarges. Throws Error{input} for perspectives, and for
/// planes that cut nothing; and OutOfTime.
std::vector<BrokenOutSection> cut_broken_outs(const world::World& world, const scene::SceneDescription& scene,
                                              const scene::ViewDescription& view,
                                              const projection::Projection& projection, const Messages& messages);

/// The freehand line around a broken-out section in a parallel view, before parts are left out. Throws Error{input} if
/// it encloses no area there, or overlaps another one of the view.
drawing::ClosedLine line_on_page(const scene::BrokenOutDescription& description, const drawing::ViewDrawing& drawing);

/// What a broken-out section removes inside and outside its line, on paper. Throws Error{input} if there is nothing
/// inside.
std::vector<drawing::PaperTriangle> removed_on_paper(const world::World& world, const BrokenOutSection& one,
                                                     const drawing::ClosedLine& line, const Mat4& world_to_page);

}  // namespace epura::pipeline
