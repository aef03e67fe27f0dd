// SPDX-License-Identifier: Apache-2.0
// Converts values to bytes, to send them from one process of the program to another.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/utf8.hpp"

namespace epura::foreign {

template <class Value>
concept Flat = std::is_trivially_copyable_v<Value>;

class Packer {
 public:
  template <Flat Value>
  void operator()(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  void operator()(const std::filesystem::path& path) { (*this)(path.native()); }
  template <class Item>
  void operator()(const std::vector<Item>& items) {
    (*this)(items.size());
    if constexpr (Flat<Item>)
      bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
    else
      for (const Item& item : items) (*this)(item);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Extracts values in the order in which they were packed. Throws Error{plugin} if the bytes end too early, as the
/// other process may have been damaged.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  template <Flat Value>
  void operator()(Value& value) {
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
  }
  /// The text is made safe for display.
  void operator()(std::string& text) { text = one_line(take(count(1))); }
  void operator()(std::filesystem::path& path) { path = take(count(1)); }
  template <class Item>
  void operator()(std::vector<Item>& items) {
    items.resize(count(Flat<Item> ? sizeof(Item) : sizeof(std::size_t)));
    if constexpr (Flat<Item>)
      take(items.size() * sizeof(Item)).copy(reinterpret_cast<char*>(items.data()), items.size() * sizeof(Item));
    else
      for (Item& item : items) (*this)(item);
  }

  /// Returns how many items follow, each of at least `min_bytes`.
  std::size_t count(std::size_t min_bytes) {
    std::size_t count = 0;
    (*this)(count);
    if (count > rest_.size() / min_bytes) refuse();
    return count;
  }

 private:
  std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) refuse();
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }
  [[noreturn]] static void refuse() { throw Error(ErrorKind::plugin, "", "corrupts its process"); }

  std::string_view rest_;
};

}  // namespace epura::foreign
