// SPDX-License-Identifier: Apache-2.0
// Auxiliary views by the reference arrow method, and letters of views. ISO 128-3.
#pragma once

#include <set>
#include <string>

#include "scene/description.hpp"

namespace epura::scene {

/// The letters of sections, details and labels.
std::set<std::string> letters_of(const SceneDescription& scene);

/// The first letter that is not taken, which then is.
std::string next_letter(std::set<std::string>& taken);

/// Gives views with a direction and a parent their projection. Must precede name_views. Throws Error{input} for a
/// direction without a parent or the reverse, and if the view has a projection or shows a detail.
void complete_directions(SceneDescription& scene);

/// Gives these views their letters as labels: the first ones that no section, detail or label has. Views must be named.
/// Throws Error{input} for parents that do not exist, or have a parent or a detail themselves.
void complete_letters(SceneDescription& scene);

}  // namespace epura::scene
