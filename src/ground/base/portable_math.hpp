// SPDX-License-Identifier: Apache-2.0
// Trigonometric functions with the same bits on every machine. For doubles, the C library has several versions,
// depending on the instructions of the processor (FMA), which differ in the last bit for one angle in a thousand; for
// long doubles it has one, whose results are rounded here.
#pragma once

#include <cmath>

namespace epura {

inline double portable_sin(double radians) { return static_cast<double>(std::sin(static_cast<long double>(radians))); }
inline double portable_cos(double radians) { return static_cast<double>(std::cos(static_cast<long double>(radians))); }
inline double portable_tan(double radians) { return static_cast<double>(std::tan(static_cast<long double>(radians))); }
inline double portable_atan2(double y, double x) {
  return static_cast<double>(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
}

}  // namespace epura
