// SPDX-License-Identifier: Apache-2.0
// Facet crossings caused by tessellation, not by the bodies: facets of mating surfaces, such as a bolt in its hole,
// penetrate each other.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "edges/intersections.hpp"
#include "scene/scene.hpp"

namespace epura::edges {

enum class Contact : std::uint8_t {
  unjudged,  ///< for lack of time
  none,      ///< a real crossing
  contact
};

/// For each crossing. Two recognised faces of parts touch, or cross, as a whole: they touch where the vertices of one
/// lie on the surface of the other, to the height of arcs over their facets. Elsewhere facets are judged pair by pair:
/// they touch where they cross by no more than their surfaces turn from facet to facet, as far as folds below
/// `crease_angle` tell; free forms do where most of their crossings are such. `normalisation` is that of
/// find_intersections.
std::vector<Contact> judge_contacts(const scene::World& world, double normalisation, double crease_angle,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress);

}  // namespace epura::edges
