// SPDX-License-Identifier: Apache-2.0
// The reason why an edge is drawn.
#pragma once

#include <string_view>

#include "scene/choices.hpp"

namespace epura::edges {

/// Whether the surface continues smoothly across the edge: such lines are drawn narrow.
constexpr bool is_within_surface(EdgeKind kind) { return kind >= EdgeKind::tangent; }

/// Returns the first of the kinds whose lines look like those of this kind.
constexpr EdgeKind look_of(EdgeKind kind) { return kind <= EdgeKind::intersection ? EdgeKind::contour : kind; }

inline std::string_view name_of(EdgeKind kind) { return scene::word_of(kind); }

}  // namespace epura::edges
