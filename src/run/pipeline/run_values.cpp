// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_values.hpp"

#include <cmath>

namespace epura::pipeline {

scene::ValueKind<double> contact_distance() { return scene::number_between(0, HUGE_VAL, ""); }

scene::ValueKind<double> arc_tolerance() {
  scene::ValueKind<double> tolerance = scene::number_between(1e-6, 1, "mm").shown_as("MM");
  tolerance.form.implied = "0.01";
  return tolerance;
}

scene::ValueKind<double> max_error() { return scene::number_between(1e-12, 1e6, "mm").shown_as("MM"); }

scene::ValueKind<double> time_limit() { return scene::number_between(0, HUGE_VAL, "s").shown_as("S"); }

scene::ValueKind<int> verify_samples() { return scene::whole_number(1, 10'000'000); }

scene::ValueKind<int> thread_count() { return scene::whole_number(0, 1024); }

}  // namespace epura::pipeline
