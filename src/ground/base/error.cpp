// SPDX-License-Identifier: Apache-2.0
#include "base/error.hpp"

#include <algorithm>
#include <utility>

#include "base/broken.hpp"

namespace epura {

namespace {

// what() ends at the first NUL, of which texts of the user may have some.
std::string sentence_of(const std::string& where, const std::string& what) {
  std::string sentence = where.empty() ? what : where + ": " + what;
  std::replace(sentence.begin(), sentence.end(), '\0', ' ');
  return sentence;
}

}  // namespace

Error::Error(ErrorKind kind, std::string where, std::string what, std::string hint)
    : std::runtime_error(sentence_of(where, what)), trouble_(kind), where_(std::move(where)), hint_(std::move(hint)) {}

void refuse_input(const std::string& where, const std::string& reason, const std::string& hint) {
  throw Error(ErrorKind::input, where, reason, hint);
}

void check(bool condition, const char* sentence) {
  if (!condition) [[unlikely]]
    throw Broken(sentence);
}

}  // namespace epura
