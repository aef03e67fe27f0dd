// SPDX-License-Identifier: Apache-2.0
// Dimensions that somebody asked for and that give the size of an automatic one, in whose place they stand: those with
// a tolerance, for example.
#pragma once

#include <span>
#include <vector>

#include "features/part_features.hpp"
#include "scene/description.hpp"
#include "sizes/anchors.hpp"
#include "sizes/named_projection.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// In which a length is measured; length 1.
Vec3 direction_of(const AnchoredDimension& dimension, const NamedProjection& view);

/// Removes automatic dimensions whose size others give: a length between the same places, a diameter or radius of the
/// circle of the same feature or of an equal hole, or a diameter as a length across it. One without a text takes over
/// that of the automatic one, as "4× <> ↧12"; a text that counts other features than the automatic one is no
/// replacement, and requirements of files are one only for all of its features together. Rows stay. All name their
/// views.
void replace_twins(std::vector<scene::DimensionDescription>& automatic,
                   std::span<scene::DimensionDescription* const> given, const world::World& world,
                   const features::PartFeatures& features, std::span<const NamedProjection> views);

/// The circles of features which are equal to that of an automatic note, and of which no given dimension says the size:
/// the note may stand at any of them.
std::vector<scene::FeatureCircle> equal_circles(const scene::DimensionDescription& automatic,
                                                std::span<const scene::DimensionDescription> given,
                                                const features::PartFeatures& features);

}  // namespace epura::sheet
