// SPDX-License-Identifier: Apache-2.0
// Preserves the floating-point environment across foreign code.
#pragma once

#include <cfenv>
#include <cfloat>

namespace epura {

/// Gives back at its end the rounding mode, the traps and the treatment of tiny numbers that there were at its
/// beginning. Libraries built with -ffast-math already change them when they are loaded.
class KeptArithmetic {
 public:
  KeptArithmetic() { std::fegetenv(&before_); }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;
  ~KeptArithmetic() { std::fesetenv(&before_); }

  /// Whether results of arithmetic are others than before.
  [[nodiscard]] bool is_changed() const { return std::fegetround() != rounding_ || has_tiny_numbers() != had_tiny_; }

 private:
  // At run time, whatever the compiler knows.
  static bool has_tiny_numbers() {
    const volatile double min = DBL_MIN;
    return min / 2 > 0;
  }

  std::fenv_t before_{};
  int rounding_ = std::fegetround();
  bool had_tiny_ = has_tiny_numbers();
};

}  // namespace epura
