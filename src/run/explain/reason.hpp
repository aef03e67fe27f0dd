// SPDX-License-Identifier: Apache-2.0
// Explains in words why an edge is drawn or not.
#pragma once

#include <optional>
#include <string>

#include "explain/subject.hpp"

namespace epura::explain {

/// Numbers and positions in sentences.
std::string format_value(double number);
std::string format_value(const Vec2& p);
std::string format_value(const Vec3& p);

/// Returns the angle in degrees between the two triangles at an edge, or between the faces that cross there; nothing
/// for any other number of triangles.
std::optional<double> angle_at(const ExplainInput& drawn_view, const Subject& subject);

/// Returns one line, such as "drawn as crease: faces 0:1 and 0:2 turn by 90 degrees; a crease turns by 30 or more".
std::string reason_of(const ExplainInput& drawn_view, const Subject& subject);

}  // namespace epura::explain
