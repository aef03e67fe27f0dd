// SPDX-License-Identifier: Apache-2.0
// What is wrong in epura itself.
#pragma once

#include <stdexcept>

namespace epura {

/// A programming error: what a sentence of check() states does not hold. It is not an Error, so nothing that tolerates
/// wrong input tolerates it.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Exit code of a program that is broken (EX_SOFTWARE of sysexits.h).
inline constexpr int broken_exit_code = 70;

}  // namespace epura
