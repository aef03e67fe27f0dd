// SPDX-License-Identifier: Apache-2.0
// Dimensions of fillets and rounded corners, rounded edges, and spheres.
#pragma once

#include <optional>
#include <span>

#include "features/part_features.hpp"
#include "scene/description.hpp"
#include "sizes/planning.hpp"
#include "sizes/view_choice.hpp"

namespace epura::sheet {

/// Places of the centres of round ends and of open channels.
Planned arc_positions(const Planning& plan);

/// Places of the centres of spheres.
Planned ball_positions(const Planning& plan);

/// Equal radii have one note, whatever their axes: the view that shows most of them has it.
Planned arc_dimensions(const Planning& plan);

/// Rounded edges and spheres whose radius is not that of one of the dimensions so far, to which they belong.
Planned round_dimensions(const Planning& plan, std::span<const scene::DimensionDescription> so_far);
Planned ball_dimensions(const Planning& plan, std::span<const scene::DimensionDescription> so_far);

/// A section of a rounded edge, and the view on whose outline it lies.
struct SeenSection {
  const NamedProjection* view;
  scene::FeatureCircle circle;
};

/// The first view that shows a section in its true form; otherwise, beside a slot along the view, one that shortens it
/// by a twenty-fifth at most. Nothing if there is none.
std::optional<SeenSection> seen_section(const features::RoundFeature& round, const ViewChoice& views);

}  // namespace epura::sheet
