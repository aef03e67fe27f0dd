// SPDX-License-Identifier: Apache-2.0
// What a test of a plugin found.
#pragma once

#include <functional>
#include <string>

namespace epura::foreign {

enum class Verdict { passed, failed, skipped };

struct CheckResult {
  std::string name;  ///< one word
  std::string what;  ///< what was looked at, as a sentence that should be true
  Verdict verdict;   ///< skipped: an earlier check failed that this one builds on
  std::string fault;
};

/// Told each result when it is there, for code that may crash in the next.
using TellResult = std::function<void(const CheckResult&)>;

}  // namespace epura::foreign
