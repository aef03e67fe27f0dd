// SPDX-License-Identifier: Apache-2.0
// Finds facet crossings that are caused by tessellation, not by the bodies: facets of mating surfaces, such as a bolt
// in its hole, penetrate each other.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "edges/intersections.hpp"
#include "world/world.hpp"

namespace epura::edges {

enum class Contact : std::uint8_t {
  unjudged,  ///< out of time
  none,      ///< a real intersection
  contact
};

/// Returns the contact of each crossing. Two recognised faces of parts either touch or cross as a whole: they touch if
/// the vertices of one lie on the surface of the other, within the height of arcs over their facets. Other facets are
/// judged pair by pair: they touch if the angle at which they cross does not exceed the turn of their surfaces from
/// facet to facet, which is taken from folds below `crease_angle`; free forms touch if most of their crossings do.
/// `normalisation` is the same as for find_intersections.
std::vector<Contact> judge_contacts(const world::World& world, double normalisation, double crease_angle,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress);

}  // namespace epura::edges
