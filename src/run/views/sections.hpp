// SPDX-License-Identifier: Apache-2.0
// Cuts the sections of a scene.
#pragma once

#include <map>
#include <string>

#include "cut/cut_world.hpp"
#include "scene/description.hpp"
#include "view/projected_scene.hpp"
#include "views/messages.hpp"

namespace epura::pipeline {

struct CutSection {
  cut::CuttingSurface surface;
  cut::CutWorld cut;
};

/// Warns of open outlines. Throws Error{input} if the surface cuts nothing, and OutOfTime.
CutSection cut_section(const world::World& world, const cut::CuttingSurface& surface, const Messages& messages,
                       const Progress& progress = {});

/// Sections shown by some view, by name.
using CutSections = std::map<std::string, CutSection>;
/// Throws Error{input} for sections that cut nothing, and OutOfTime.
CutSections cut_sections(const world::World& world, const scene::SceneDescription& scene, const Messages& messages,
                         const Progress& progress = {});

/// Surfaces of sections by name.
using SectionSurfaces = std::map<std::string, cut::CuttingSurface>;
void add_surfaces(SectionSurfaces& surfaces, const CutSections& sections);

/// The section shown by a view; null if it shows the whole.
const CutSection* section_of(const CutSections& sections, const scene::ViewDescription& view);

/// The cut world has no faces along steps and where turned parts end, which a section must not show: throws
/// Error{input} if a view does.
void expect_steps_edge_on(const CutSection& section, const view::ProjectedScene& seen,
                          const scene::ViewDescription& view);

/// Warns if a view sees the section from behind: it would look like one of the whole, and the arrows of the section
/// would contradict it.
void warn_if_unseen(const Messages& messages, const CutSection& section, const view::ProjectedScene& seen,
                    const std::string& view);

}  // namespace epura::pipeline
