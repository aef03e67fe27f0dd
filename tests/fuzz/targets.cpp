// SPDX-License-Identifier: Apache-2.0
#include "targets.hpp"

#include "base/error.hpp"

namespace epura::fuzz {

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const std::span<const Target> some : {readers(), plugins(), drawings(), sheets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::optional<Target> target_named(std::string_view name) {
  for (const Target& target : all_targets())
    if (target.name == name) return target;
  return std::nullopt;
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
