// SPDX-License-Identifier: Apache-2.0
// What options of a run may be, for the command line and for other programs alike.
#pragma once

#include "definition/rules.hpp"
#include "scene/scene_values.hpp"

namespace epura::pipeline {

scene::ValueKind<double> contact_distance();  ///< units of the world
scene::ValueKind<double> arc_tolerance();     ///< mm on paper
scene::ValueKind<double> max_error();         ///< mm on paper
scene::ValueKind<double> time_limit();        ///< seconds
scene::ValueKind<int> verify_samples();
scene::ValueKind<int> thread_count();  ///< 0: all cores
scene::ValueKind<definition::RuleSet> applied_rules();

}  // namespace epura::pipeline
