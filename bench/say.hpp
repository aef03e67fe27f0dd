// SPDX-License-Identifier: Apache-2.0
// Output of the benchmark programs on stderr, in the form of epura's --timings, so that one script can read it all.
#pragma once

#include <chrono>
#include <cstdio>

#include "base/text.hpp"

namespace epura::bench {

inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline void say_seconds(const char* stage, double seconds) {
  std::fprintf(stderr, "%-12s %8s s\n", stage, format_fixed(seconds, 4).c_str());
}

inline void say_count(const char* what, std::size_t count) { std::fprintf(stderr, "%-12s %8zu\n", what, count); }

}  // namespace epura::bench
