// SPDX-License-Identifier: Apache-2.0
// Finds lines that triangles and surfaces require, but that have no ink.
#pragma once

#include <span>
#include <vector>

#include "report/verification.hpp"
#include "verify/ink_judge.hpp"
#include "verify/outline_faults.hpp"

namespace epura::verify {

/// A fault counts from this many times the error on: both ends of a line may be off by that much.
inline constexpr double least_errors = 2;

/// Edges that are joined are one fault, the longest first. `on` has the lines as they are written; `needs`: positions
/// that require a line; `error`: mm, how far ink may be from them. Throws OutOfTime.
std::vector<report::OutlineFault> missing_lines(const OutlineScan& on, const InkOptions& options, double error,
                                                std::span<const AskedLine> needs);

}  // namespace epura::verify
