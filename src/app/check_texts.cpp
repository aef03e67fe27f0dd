// SPDX-License-Identifier: Apache-2.0
#include "app/check_texts.hpp"

#include <cstdio>

#include "base/utf8.hpp"

namespace epura {

namespace {

const char* word(foreign::Verdict verdict) {
  switch (verdict) {
    case foreign::Verdict::passed:
      return "passed";
    case foreign::Verdict::failed:
      return "FAILED";
    case foreign::Verdict::skipped:
      return "skipped";
  }
  return "";
}

}  // namespace

void print_check(const foreign::CheckResult& result) {
  std::printf("  %-11s %-8s %s\n", result.name.c_str(), word(result.verdict), printable(result.what).c_str());
  if (!result.fault.empty()) std::printf("  %-20s %s\n", "", printable(result.fault).c_str());
  std::fflush(stdout);
}

}  // namespace epura
