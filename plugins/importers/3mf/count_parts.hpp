// SPDX-License-Identifier: Apache-2.0
// Counts how often objects of a model contain each other: ten levels of ten components each would take hours, and a
// long chain overflow the stack.
#pragma once

#include <cstddef>

#include "model.hpp"

namespace epura::plugin::threemf {

/// Larger numbers are refused.
inline constexpr std::size_t max_parts = 1'000'000;

/// Throws std::runtime_error with a sentence if there are too many, or if they are nested too deeply or in a circle.
void expect_few_parts(const Model& model);

}  // namespace epura::plugin::threemf
