// SPDX-License-Identifier: Apache-2.0
// Preserves the floating-point environment across foreign code.
#pragma once

#include <cfenv>
#include <cfloat>

namespace epura {

/// Restores the rounding mode, the traps and the treatment of denormal numbers when it is destroyed. Libraries built
/// with -ffast-math change them as soon as they are loaded.
class KeptArithmetic {
 public:
  KeptArithmetic() { std::fegetenv(&before_); }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;
  ~KeptArithmetic() { std::fesetenv(&before_); }

  /// Whether arithmetic gives other results than before.
  [[nodiscard]] bool is_changed() const { return std::fegetround() != rounding_ || has_tiny_numbers() != had_tiny_; }

 private:
  // Evaluated at run time, whatever the compiler knows.
  static bool has_tiny_numbers() {
    const volatile double min = DBL_MIN;
    return min / 2 > 0;
  }

  std::fenv_t before_{};
  int rounding_ = std::fegetround();
  bool had_tiny_ = has_tiny_numbers();
};

}  // namespace epura
