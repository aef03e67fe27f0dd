// SPDX-License-Identifier: Apache-2.0
// What equations leave free, and which of them say the same.
#pragma once

#include <span>
#include <vector>

#include "definition/unknowns.hpp"

namespace epura::definition {

struct NullSpace {
  std::vector<Row> vectors;  ///< tidy; each has one unknown, with factor 1, that no other one has
  bool is_certain = true;    ///< no singular value is near zero but not zero: the number of vectors is right
};

/// All combinations of `count` unknowns for which the rows, which are equal to zero, hold. They are of length 1, or
/// what is left of rows of length 1 in terms of fewer unknowns. Rows of one or two unknowns replace one by the other;
/// what is left falls into groups without common unknowns, whose ranks are found by singular values: `surely_zero` and
/// `surely_not_zero` are the borders of the gap that proves them.
NullSpace null_space(int count, std::span<const Row> rows);

/// A row that is the sum of factor · row over others, which all come before it and are independent.
struct DependentRow {
  int row;
  Row others;  ///< their unknowns are numbers of rows; none for a row of nothing
};

/// All that follow from others.
std::vector<DependentRow> dependent_rows(std::span<const Row> rows);

/// The sum of factor · vector over the terms of a row, whose unknowns are numbers of vectors.
Row combined(const Row& row, std::span<const Row> vectors);

}  // namespace epura::definition
