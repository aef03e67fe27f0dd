// SPDX-License-Identifier: Apache-2.0
// What dimensions of features leave free, and which dimensions of faces forbid it.
#pragma once

#include <span>

#include "sizes/dimensions_in_view.hpp"
#include "sizes/planning.hpp"

namespace epura::sheet {

struct FreeFaceDimensions {
  Planned planned{};
  bool are_all = false;  ///< with them, no face is free
};

/// For each thing that faces can do although all dimensions hold, by the rules of ISO, one that forbids it: a size
/// before a place, an angle, the place of an edge or a width, as a view shows it in true form. Nothing for assemblies,
/// for parts of more than `most_faces_planned`, which lack more than `max_of_a_kind`, or of which nobody can tell what
/// a dimension measures. Equal planes all over a part, as of teeth, have none, and are counted as left out.
FreeFaceDimensions dimensions_of_free_faces(const Planning& plan, std::span<const DimensionsInView> views);

/// Faces of a part whose dimensions are asked for what they leave free: some seconds at most.
inline constexpr std::size_t most_faces_planned = 1000;

}  // namespace epura::sheet
