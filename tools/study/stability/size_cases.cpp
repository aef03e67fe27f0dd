// SPDX-License-Identifier: Apache-2.0
// Meshes of many parts.
#include <algorithm>
#include <cmath>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

// A number of parts, scaled by the size of the lab.
int many(const Lab& lab, double number, int min) {
  return std::max(min, static_cast<int>(std::lround(number * lab.size)));
}

Measured strips(const Lab& lab, double n) { return strips_over_strips(lab, many(lab, n, 1), many(lab, n, 1), 0.3); }

Measured plates(const Lab& lab, double n) {
  Measured measured = stack_of_plates(lab, many(lab, n, 2), 1e-6);
  append(measured, plates_along_a_line(lab, many(lab, n, 2), 1e-6));
  return measured;
}

Measured slivers(const Lab& lab, double n) { return sliver_plate(lab, many(lab, n, 1)); }

Measured without_area(const Lab& lab, double cells) { return triangles_without_area(lab, many(lab, cells, 1), 4); }

Measured hub(const Lab& lab, double n) { return fan_over_chords(lab, many(lab, n, 5)); }

Measured copies(const Lab& lab, double n) { return stacked_copies(lab, many(lab, n, 1)); }

Measured stadium(const Lab& lab, double width) { return sphere_in_a_stadium(lab, 64, 32, width); }

Measured crossing_needles(const Lab& lab, double n) { return needles(lab, many(lab, n, 2)); }

}  // namespace

std::vector<Case> size_cases() {
  const std::vector<double> numbers{5, 10, 100, 300, 1000, 3000, 10000, 30000};
  return {
      {"M8", "strips over as many strips", "strips", {1, 2, 4, 8, 16, 32, 64, 100}, strips},
      {"M9", "stack of shifted plates", "plates", {2, 5, 10, 30, 100, 300, 1000, 3000}, plates},
      {"M11", "plate of slivers over a line", "slivers", numbers, slivers},
      {"M12", "triangles without area in edges", "cells a side", {1, 2, 3, 4, 6, 8, 12, 16}, without_area},
      {"M13", "fan with a hub of many sides over chords", "triangles", numbers, hub},
      {"M25", "copies of a line one below the other", "copies", {1, 10, 30, 100, 300, 1000, 3000, 10000}, copies},
      {"M26", "sphere in a stadium", "width of the stadium", {50, 100, 200, 500, 1e3, 2e3, 5e3, 1e4}, stadium},
      {"M27", "needles across each other", "needles", {5, 10, 20, 40, 60, 80, 100, 150}, crossing_needles},
  };
}

}  // namespace epura::stability
