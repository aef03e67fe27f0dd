// SPDX-License-Identifier: Apache-2.0
// Sections of the rounded edges of turned parts, where a view shows their radius.
#pragma once

#include <optional>

#include "features/part_features.hpp"
#include "scene/description.hpp"
#include "sheet/dimensions/view_choice.hpp"

namespace epura::sheet {

/// A section of a rounded edge, and the view on whose outline it lies.
struct SeenSection {
  const NamedProjection* view;
  scene::FeatureCircle circle;
};

/// The first view that shows a section in its true form; otherwise, beside a slot along the view, one that shortens it
/// by a twenty-fifth at most. Nothing if there is none.
std::optional<SeenSection> seen_section(const features::RoundFeature& round, const ViewChoice& views);

}  // namespace epura::sheet
