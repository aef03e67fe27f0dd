// SPDX-License-Identifier: Apache-2.0
// Sections in the words of a view, without a section of a scene file: --views 'front:section=y@20,top'.
#pragma once

#include <string>
#include <string_view>

#include "scene/description.hpp"

namespace epura::scene {

/// Takes the words `section=...` out of the projections of the views: the name of a section, or a plane, for which a
/// section with the next free letter is added.
/// - `y@20`: the plane y = 20; what lies before it as the view is seen is removed. `+y@20` and `-y@20` say which side.
/// - `y@20/x@5`: a half section: the same, but only where x is above 5, or below it with `-x@5`; for views from the
///   left, which is above is exchanged, as is for y in views from the back and for z in those from below.
/// Throws Error{input} with the place of the view.
void take_view_sections(SceneDescription& scene);

/// Writes the name of its view into each broken-out section. Views have names, and details their parents. Throws
/// Error{input} for sections without a closed line or with two, and for views that do not exist, show a detail, or show
/// another section.
void complete_broken_outs(SceneDescription& scene);

}  // namespace epura::scene
