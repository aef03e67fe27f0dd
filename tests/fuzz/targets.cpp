// SPDX-License-Identifier: Apache-2.0
#include "targets.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura::fuzz {

const Target* target_named(std::string_view name) {
  for (const std::span<const Target> some : {readers(), drawings()})
    if (const auto found = std::find_if(some.begin(), some.end(), [&](const Target& t) { return t.name == name; });
        found != some.end())
      return &*found;
  return nullptr;
}

bool run(const Target& target, const std::string& bytes) {
  try {
    target.run(bytes);
    return true;
  } catch (const Error& error) {
    check(error.what() != std::string_view(), "an error says nothing");
    return false;
  }
}

}  // namespace epura::fuzz
