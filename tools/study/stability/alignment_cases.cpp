// SPDX-License-Identifier: Apache-2.0
// Views along which lines coincide.
#include <cmath>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

// The rear corner lies exactly behind the front corner, and rear edges behind diagonals of triangles.
Measured cube_along_its_diagonal(const Lab& lab, double cells) {
  Measured measured;
  for (const bool other : {false, true}) {
    const Result result = lab.draw(lab.world_of(fine_cube(static_cast<int>(cells), other)), {orthographic(diagonal)});
    append(measured, lengths(result, 9 * isometric_edge, 3 * isometric_edge));
    measured.push_back(count("visible pieces", 9 * cells, result.pieces(true)));
  }
  return measured;
}

Measured cube_face_on(const Lab& lab, double cells) {
  Measured measured;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0)}) {
    const Result result = lab.draw(lab.world_of(fine_cube(static_cast<int>(cells))), {orthographic(axis)});
    append(measured, lengths(result, 4, 0));
    measured.push_back(count("hidden pieces", 0, result.pieces(false)));
  }
  return measured;
}

Measured cube_and_its_copy(const Lab& lab, double d) {
  Shape both = box({0, 0, 0}, {2, 2, 2});
  both.add(box({d, d, d}, {2 + d, 2 + d, 2 + d}));
  const Result result = lab.draw(lab.world_of(both), {orthographic(diagonal)}, {.intersection = false});
  return lengths(result, 18 * isometric_edge, 6 * isometric_edge);
}

Measured turned_cube(const Lab& lab, double angle) {
  const Result result = lab.draw(lab.world_of(box({0, 0, 0}, {1, 1, 1})), {orthographic({1 + angle, 1, 1 - angle})});
  // Lengths on the page change by less than three times the angle.
  return lengths(result, 9 * isometric_edge, 3 * isometric_edge, guaranteed_part + 3 * angle);
}

// There must be one step where the larger plate is no longer in contact, but never dangles.
Measured plate_under_a_plate(const Lab& lab, double e) {
  const world::World world = lab.world_of({plate(-0.5, -0.5, 0.5, 0.5, 0), plate(-1, -1, 1, 1, e)});
  const Result result = lab.draw(world, {from_above()});
  const bool hidden = e > result.view.contact.touching / result.view.map.unit * result.unit;
  Measured measured = lengths(result, hidden ? 8 : 12, hidden ? 4 : 0);
  measured.push_back(count("pieces", 8, result.pieces(true) + result.pieces(false)));
  return measured;
}

// Waves of slope 1 along x, seen from above at a slope of 1/2: each crest hides the next valley.
Measured zigzag(const Lab& lab, double waves) {
  Shape sheet;
  for (int i = 0; i <= 2 * static_cast<int>(waves); ++i) {
    const double z = i % 2 == 0 ? 0.0 : 0.5;
    sheet.points.push_back({0.5 * i, 0, z});
    sheet.points.push_back({0.5 * i, 1, z});
    if (i > 0) sheet.faces.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  const edges::EdgeOptions folds{.contour = true, .boundary = false, .crease = true, .intersection = false};
  return lengths(lab.draw(lab.world_of(sheet), {orthographic({2, 0, 1})}, folds), waves, waves - 1);
}

}  // namespace

std::vector<Case> alignment_cases() {
  return {
      {"V1", "cube along its diagonal", "cells a side", {1, 2, 3, 5, 8, 13, 21, 34}, cube_along_its_diagonal},
      {"V2", "cube face on", "cells a side", {1, 2, 3, 5, 8, 13, 21, 34}, cube_face_on},
      {"V3",
       "cube and its copy exactly behind it",
       "shift",
       {1, 1e1, 1e2, 1e3, 1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12},
       cube_and_its_copy},
      {"V10",
       "plate close under a larger plate",
       "gap",
       {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15},
       plate_under_a_plate},
      {"V11", "zigzag sheet: each crest hides a valley", "waves", {1, 2, 3, 5, 8, 13, 34, 100}, zigzag},
      {"V12",
       "cube turned out of its alignment",
       "radians",
       {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16},
       turned_cube},
  };
}

}  // namespace epura::stability
