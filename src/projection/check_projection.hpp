// SPDX-License-Identifier: Apache-2.0
// Tests of a projection that know nothing but its table: for authors of plugins, and for the ones built here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

enum class Verdict { passed, failed, skipped };

struct CheckResult {
  std::string name;  ///< one word
  std::string what;  ///< what was examined, as a sentence that should be true
  Verdict verdict;   ///< skipped: an earlier check failed that this one builds on
  std::string fault;
};

/// The checks in a fixed order; each result is told when it is there, for code that may crash in the next. Calls
/// foreign code some thousand times: with its defaults, with values of every parameter, at the ends of their ranges,
/// and for models of all sizes.
std::vector<CheckResult> check_projection(const ProjectionEntry& entry,
                                          const std::function<void(const CheckResult&)>& tell = {});

}  // namespace epura::projection
