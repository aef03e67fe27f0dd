// SPDX-License-Identifier: Apache-2.0
// One target as libFuzzer runs it. Errors of the user are right answers; what ends the process is a finding.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "targets.hpp"

// epura ends by an exit code where a sentence does not hold; libFuzzer keeps only inputs that abort.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::set_terminate(std::abort);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static const std::optional<epura::fuzz::Target> target = epura::fuzz::target_named(EPURA_FUZZ_TARGET);
  epura::check(target.has_value(), "there is no target " EPURA_FUZZ_TARGET);
  epura::fuzz::run(*target, std::string(reinterpret_cast<const char*>(bytes), count));
  return 0;
}
