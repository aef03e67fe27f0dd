// SPDX-License-Identifier: Apache-2.0
// Dimensions of screw threads: "4× M6 ↧12". ISO 6410-1.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "features/part_features.hpp"
#include "scene/description.hpp"
#include "sheet/notation.hpp"
#include "sizes/overall.hpp"

namespace epura::sheet {

/// What a hole is called in a note: "<>", which stands for its diameter, or the thread in it.
std::string name_in_note(const std::optional<features::ThreadFeature>& thread);
/// What it is called in a table or sentence: "⌀8", or the thread.
std::string size_in_words(const std::optional<features::ThreadFeature>& thread, double diameter,
                          const Notation& notation);

/// Dimensions of the threads that have one of their own: of holes in a view along the axis, of shafts in one across it.
/// Throws Error{input} for a given view that does not show the thread so.
std::vector<scene::DimensionDescription> thread_dimensions(std::span<const scene::ThreadDescription> threads,
                                                           std::span<const NamedProjection> views,
                                                           const features::PartFeatures& features,
                                                           const Notation& notation);

}  // namespace epura::sheet
