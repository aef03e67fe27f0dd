// SPDX-License-Identifier: Apache-2.0
// What rays meet that are cast from the viewer at the surfaces of parts, in closed form where a face has one.
//
// A ray meets a face where it goes through the surface of the face, near facets of the face. Of free forms, and of
// models without faces, it meets the facets.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// A short line across the page, mm.
struct Band {
  Vec2 middle, across;  ///< `across` has length 1
  double half;          ///< to either side of the middle
};

/// Whether what rays meet changes from one side of a band to the other: begins, ends, jumps in depth or folds.
struct SeenAcross {
  bool front_changes = false;  ///< what is seen
  bool any_changes = false;    ///< the same, or anything behind it
  double at = 0;               ///< where what is seen changes, nearest to the middle: along `across`, mm
};

/// Facets within `error` mm of a ray tell where faces end. Throws OutOfTime.
std::vector<SeenAcross> see_across(const VerifyInput& input, const edges::EdgeOptions& options, double error,
                                   const std::vector<Band>& bands, const Progress& progress = {});

}  // namespace epura::verify
