// SPDX-License-Identifier: Apache-2.0
// Counts how often objects of a 3MF package contain each other. lib3mf follows components one by one: ten levels of ten
// components each take hours, and a long chain overflows its stack.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace epura::plugin::threemf {

/// Larger numbers are refused.
inline constexpr std::size_t most_parts = 1'000'000;

class Components {
 public:
  /// Finds the objects and components in a part of the package, if it is XML.
  void scan(const std::string& part, std::string_view text);
  /// Throws std::runtime_error with a sentence if there are too many, or if they are nested too deeply or in a circle.
  void expect_few() const;

 private:
  /// The part of the package and the number in it.
  using Id = std::pair<std::string, std::string>;
  /// Counts of an object with its components, including itself.
  struct Held {
    std::size_t parts;
    int levels;
  };
  struct Tag {
    std::string_view name, id, object, path;
  };

  static Tag tag_at(std::string_view text, std::size_t& place);
  Held count(const Id& id, int depth, std::map<Id, Held>& counts) const;

  std::map<Id, std::vector<Id>> components_;
};

}  // namespace epura::plugin::threemf
