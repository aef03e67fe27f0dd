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

/// In degrees.
struct ContactLimits {
  double crease_angle;  ///< least fold that is not the turn of a surface from facet to facet
  double part_angle;    ///< greatest angle between recognised surfaces that touch, as at a tangent border of a part
};

/// Returns the contact of each crossing. Two faces of parts either touch or cross as a whole, as most of the length of
/// their crossings does. Recognised surfaces, but for two planes, touch where they meet at no more than `part_angle`,
/// or not at all. Other facets touch if the angle at which they cross does not exceed the turn of their surfaces from
/// facet to facet. `normalisation` is the same as for find_intersections.
std::vector<Contact> judge_contacts(const world::World& world, double normalisation, const ContactLimits& limits,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress);

}  // namespace epura::edges
