// SPDX-License-Identifier: Apache-2.0
// Parts that are found again from the numbers of their dimensions alone.
#include "sizes/rebuilt_part.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "dimensioned_part.hpp"
#include "grooved_parts.hpp"
#include "known_parts.hpp"
#include "sloped_parts.hpp"
#include "turned_parts.hpp"

namespace epura::test::rebuilt_part_test {

TEST(RebuiltPart, IsThePart) {
  const auto found = DimensionedPart(sloped_block).rebuilt();
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_defined());
  EXPECT_GT(found->perturbed, 0.3) << "1 % of 72 mm";
  EXPECT_LT(found->deviation, 1e-6);
  EXPECT_NEAR(found->of_part, 60 * 40 * 10 - 40 * 10 * 6 / 2, 1e-6);
  EXPECT_NEAR(found->volume, found->of_part, 1e-3);
}

TEST(RebuiltPart, StaysOffWithoutOneDimension) {
  const DimensionedPart part(sloped_block);
  for (std::size_t i = 0; i < part.texts.size(); ++i) {
    const auto less = part.rebuilt(i);
    ASSERT_TRUE(less);
    EXPECT_FALSE(less->is_defined()) << "without " << part.texts[i];
    EXPECT_GT(less->spread, 1e-3);
    ASSERT_FALSE(less->free.empty());
    EXPECT_GE(less->free.front().off, less->free.back().off);
  }
}

// Newton's method on the surfaces themselves agrees with the rank of linear terms, which it does not know.
TEST(RebuiltPart, AgreesWithTheRankOfTheEquations) {
  std::size_t parts = 0, removed = 0;
  for (const auto& family :
       {v_notches(), planes_between_slopes(), slopes_to_rounded_corners(), rounded_trapezia(), round_ends(), tongues(),
        links(), wedges_with_holes(), uneven_pitch_circles(), plates_with_conical_bosses(), channels(),
        plates_with_turned_holes(), plates_with_dimples(), blocks_with_grooves(), bases_with_ribs(),
        bosses_with_ring_grooves(), bases_with_lugs()})
    for (std::size_t i = 0; i < family.size(); i += 2, ++parts) {
      const DimensionedPart part(family[i].obj);
      const std::string_view name = family[i].name;
      const auto found = part.rebuilt();
      ASSERT_TRUE(found) << name;
      EXPECT_TRUE(found->is_defined()) << name << ": " << found->spread << " "
                                       << (found->free.empty() ? "" : found->free.front().name);
      EXPECT_LT(found->deviation, 0.02) << name << ": half the last digit of texts, and what follows from it";
      EXPECT_NEAR(found->volume / found->of_part, 1, 2e-3) << name;
      const std::size_t without = i % part.texts.size();
      const bool is_free = !part.free_without(without).free.empty();
      EXPECT_EQ(part.rebuilt(without)->is_defined(), !is_free) << name << " without " << part.texts[without];
      if (is_free) ++removed;
    }
  EXPECT_GE(parts, 170U);
  EXPECT_GE(removed, 140U);
}

}  // namespace epura::test::rebuilt_part_test
