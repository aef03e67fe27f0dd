// SPDX-License-Identifier: Apache-2.0
// Constructions of the views on a sheet, in places of their own, and their legend.
#pragma once

#include <span>

#include "composition/annotation_layers.hpp"
#include "construction/figure.hpp"
#include "dimensions/dimensions.hpp"

namespace epura::pipeline {

/// Adds the constructions of each view to `result`, and what they take to `around`: other annotations, which come
/// later, keep clear of them.
void add_constructions(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                       std::span<const ViewResult> views, const sheet::DimensionStyle& style);

/// Room below a view for the legend of its constructions, if that is asked for; mm.
double legend_room(const construction::Figure& figure);

}  // namespace epura::pipeline
