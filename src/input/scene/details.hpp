// SPDX-License-Identifier: Apache-2.0
// Detail views: an enlarged part of another view. ISO 128-3.
#pragma once

#include <string>
#include <string_view>

#include "scene/description.hpp"

namespace epura::scene {

/// Half the size of a detail, in the unit of the world; of a circle, its radius twice.
Vec2 half_size(const DetailDescription& detail);

/// Throws Error{input} for a view that has neither a projection nor a detail.
void expect_projections(const SceneDescription& scene);

/// Returns the detail of this name, or null.
const DetailDescription* find_detail(const SceneDescription& scene, const std::string& name);

/// Gives detail views what they have in common with their parents: projection, section, and unless they have their own,
/// edges, style of lines and depths; gives details the names of their parents. Views must be named. Throws Error{input}
/// for details and parents that do not exist, for parents that are details, for details without or with two shapes, and
/// for detail views with a projection or section, or without a scale.
void complete_details(SceneDescription& scene);

/// Parses "X,Y,Z:RADIUS:SCALE": a circle of the first view, and the scale of the view that shows it. Throws
/// Error{input} with `where` as the location.
struct DetailRequest {
  Vec3 centre;
  double radius;
  ScaleChoice scale;
};
DetailRequest parse_detail(std::string_view text, const std::string& where);

}  // namespace epura::scene
