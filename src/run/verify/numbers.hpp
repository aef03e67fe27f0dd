// SPDX-License-Identifier: Apache-2.0
// Two number types for the same formulas: doubles with error bounds, and exact rationals.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>

#include "base/vec.hpp"

namespace epura::verify {

/// A rational number of any size: sums, products and quotients of doubles without rounding.
using Exact = mpq_class;

/// A double that differs from the intended number by at most `error`; infinite or NaN if nothing is known. Each
/// operation adds its rounding, half a unit in the last place: |fl(a op b) - (a op b)| <= 2^-53 |fl(a op b)| (Higham,
/// Accuracy and Stability of Numerical Algorithms, 2002, section 2.2), and the possible loss by underflow.
struct Bounded {
  double value = 0;
  double error = 0;

  Bounded() = default;
  explicit Bounded(double exact) : value(exact) {}
  Bounded(double value_, double error_) : value(value_), error(error_) {}

  /// The result of an operation; the last factor covers the rounding of the bound itself. The loss by underflow is
  /// overestimated, so that products of bounds do not become denormal, which would be slow.
  static Bounded rounded(double value, double error) {
    return {value, (error + 0x1p-53 * std::abs(value)) * (1 + 0x1p-49) + 0x1p-500};
  }
};

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  return Bounded::rounded(a.value + b.value, a.error + b.error);
}

inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return Bounded::rounded(a.value - b.value, a.error + b.error);
}

inline Bounded operator*(const Bounded& a, const Bounded& b) {
  return Bounded::rounded(a.value * b.value,
                          std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}

inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double min = std::abs(b.value) - b.error;
  if (!(min > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double quotient = a.value / b.value;
  return Bounded::rounded(quotient, (a.error + std::abs(quotient) * b.error * (1 + 0x1p-49) + 0x1p-500) / min);
}

inline double value_of(const Bounded& number) { return number.value; }
inline double value_of(const Exact& number) { return number.get_d(); }
inline double value_of(double number) { return number; }

inline double error_of(const Bounded& number) { return number.error; }
inline double error_of(const Exact&) { return 0; }

template <class N>
struct Triple {
  N x, y, z;
};

template <class N>
Triple<N> triple(const Vec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

template <class N>
Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Returns a + t b.
template <class N>
Triple<N> along(const Triple<N>& a, const N& t, const Triple<N>& b) {
  return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

}  // namespace epura::verify
