// SPDX-License-Identifier: Apache-2.0
// Tests a projection, knowing nothing but its table: for authors of plugins, and for the projections built here.
#pragma once

#include <string>
#include <vector>

#include "foreign/check_result.hpp"
#include "projection/catalogue.hpp"

namespace epura::projection {

using foreign::CheckResult;
using foreign::Verdict;

/// Returns the checks in a fixed order; each result is reported as soon as it is available, since code may crash in the
/// next check. Calls foreign code some thousand times: with its defaults, with values of every parameter, at the ends
/// of their ranges, and for models of all sizes.
std::vector<CheckResult> check_projection(const ProjectionEntry& entry, const foreign::TellResult& tell = {});

}  // namespace epura::projection
