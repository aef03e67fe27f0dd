// SPDX-License-Identifier: Apache-2.0
// The results of testing a plugin.
#pragma once

#include <functional>
#include <string>

namespace epura::foreign {

enum class Verdict { passed, failed, skipped };

struct CheckResult {
  std::string name;  ///< one word
  std::string what;  ///< what was tested, as a statement that should be true
  Verdict verdict;   ///< skipped: an earlier check failed on which this one depends
  std::string fault;
};

/// Receives each result as soon as it is available, since code may crash in the next check.
using TellResult = std::function<void(const CheckResult&)>;

}  // namespace epura::foreign
