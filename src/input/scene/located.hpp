// SPDX-License-Identifier: Apache-2.0
// Values that the user gives, with the places where they are given.
#pragma once

#include <optional>
#include <string>

namespace epura::scene {

/// A value and its location: an option such as "--scale", or "scene.toml:12:9".
template <class Value>
struct Located {
  std::optional<Value> value{};
  std::string where{};

  [[nodiscard]] bool given() const { return value.has_value(); }
  /// Returns the value, or `usual` if none is given.
  [[nodiscard]] Value value_or(const Value& usual) const { return value.value_or(usual); }
  const Value& operator*() const { return *value; }
  const Value* operator->() const { return &*value; }
};

using LocatedText = Located<std::string>;

}  // namespace epura::scene
