// SPDX-License-Identifier: Apache-2.0
#include "definition/rebuild.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "made_parts.hpp"

namespace epura::definition::rebuild_test {
namespace {

// The arc tangent of a radius, of which Newton's method goes farther away from 0 with each step but the first beside
// it.
TEST(Rebuild, ComesToRestWhereNewtonsMethodDiverges) {
  constexpr double steepness = 20, off = 0.5;
  Part part{{sphere({0, 0, 0}, 10, 1000)}};
  part.size = 20;
  const Unknowns unknowns(part, find_directions(part.faces));
  const StateAll state_all = [&](const Unknowns& changed) {
    const double at = steepness * (changed.changed(0).radius - 10) / part.size;
    Row row = changed.growth(0, UnknownKind::radius);
    for (Term& term : row) term.factor *= steepness / (1 + at * at);
    row.back() = {unknowns.count(), std::atan(at)};
    return std::vector<Statement>{{"the radius", {row}}};
  };
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const Rebuilt found = rebuild(unknowns, {}, state_all, off, seed);
    EXPECT_TRUE(found.is_settled) << seed;
    EXPECT_NEAR(unknowns.changed_by(found.values).changed(0).radius, 10, 1e-6) << seed;
  }
}

}  // namespace
}  // namespace epura::definition::rebuild_test
