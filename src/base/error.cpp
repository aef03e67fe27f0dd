// SPDX-License-Identifier: Apache-2.0
#include "base/error.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace epura {

namespace {

std::string sentence_of(const std::string& where, const std::string& what) {
  return where.empty() ? what : where + ": " + what;
}

}  // namespace

Error::Error(ErrorKind kind, std::string where, std::string what, std::string hint)
    : std::runtime_error(sentence_of(where, what)), trouble_(kind), where_(std::move(where)), hint_(std::move(hint)) {}

void check(bool condition, const char* sentence) {
  if (condition) return;
  std::fprintf(stderr, "epura: internal error: %s\n", sentence);
  std::abort();
}

}  // namespace epura
