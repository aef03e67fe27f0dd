// SPDX-License-Identifier: Apache-2.0
// A RapidJSON document with our own memory and stack: version 1.1 writes to where it got no memory, and its stack adds
// to a null pointer before the first allocation, which is undefined behaviour.
#pragma once

#include <rapidjson/document.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace epura::compare {

/// Memory of the C library, or std::bad_alloc. The names are those of rapidjson.
class JsonMemory {
 public:
  static constexpr bool kNeedFree = true;

  void* Malloc(std::size_t size) { return Realloc(nullptr, 0, size); }
  void* Realloc(void* old, std::size_t, std::size_t size) {
    if (size == 0) return Free(old), nullptr;
    void* const memory = std::realloc(old, size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  static void Free(void* old) { std::free(old); }
};

/// Selects that stack as a template argument of rapidjson.
struct JsonStackMemory : JsonMemory {};

}  // namespace epura::compare

/// The names are those of rapidjson.
template <>
class rapidjson::internal::Stack<epura::compare::JsonStackMemory> {
 public:
  Stack(epura::compare::JsonStackMemory*, std::size_t capacity) : bytes_(std::max<std::size_t>(capacity, 1)) {}

  template <class Item>
  void Reserve(std::size_t count = 1) {
    const std::size_t needed = filled_ + count * sizeof(Item);
    if (needed > bytes_.size()) bytes_.resize(std::max(needed, 2 * bytes_.size()));
  }
  template <class Item>
  Item* Push(std::size_t count = 1) {
    Reserve<Item>(count);
    return PushUnsafe<Item>(count);
  }
  template <class Item>
  Item* PushUnsafe(std::size_t count = 1) {
    Item* pushed = End<Item>();
    filled_ += count * sizeof(Item);
    return pushed;
  }
  template <class Item>
  Item* Pop(std::size_t count) {
    filled_ -= count * sizeof(Item);
    return End<Item>();
  }
  template <class Item>
  Item* Top() {
    return End<Item>() - 1;
  }
  template <class Item>
  Item* End() {
    return reinterpret_cast<Item*>(bytes_.data() + filled_);
  }
  template <class Item>
  Item* Bottom() {
    return reinterpret_cast<Item*>(bytes_.data());
  }
  void Clear() { filled_ = 0; }
  void ShrinkToFit() {}
  [[nodiscard]] bool HasAllocator() const { return false; }
  epura::compare::JsonStackMemory& GetAllocator() { return memory_; }
  [[nodiscard]] bool Empty() const { return filled_ == 0; }
  [[nodiscard]] std::size_t GetSize() const { return filled_; }

 private:
  std::vector<char> bytes_;
  std::size_t filled_ = 0;
  epura::compare::JsonStackMemory memory_{};
};

namespace epura::compare {

using JsonDocument =
    rapidjson::GenericDocument<rapidjson::UTF8<>, rapidjson::MemoryPoolAllocator<JsonMemory>, JsonStackMemory>;

}  // namespace epura::compare
