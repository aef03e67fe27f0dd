// SPDX-License-Identifier: Apache-2.0
// Finds items with exactly the same key, by hashing.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/groups.hpp"
#include "base/parallel.hpp"

namespace epura {

struct HashedItem {
  std::uint64_t hash;
  int item;

  auto operator<=>(const HashedItem&) const = default;
};

template <std::size_t size>
std::uint64_t hash_of(const std::array<double, size>& key) {
  std::uint64_t hash = 0;
  for (const double value : key) {
    // The addition makes negative zeros positive, since both are equal. The mixer is that of splitmix64.
    hash += std::bit_cast<std::uint64_t>(value + 0.0) + 0x9e3779b97f4a7c15;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111eb;
    hash ^= hash >> 31;
  }
  return hash;
}

/// Visits items with one hash, which nearly always have the same key as well.
template <class KeyOf, class Visit>
void visit_same_hash(std::vector<int>& items, const KeyOf& key_of, const Visit& visit) {
  const auto differs = [&](int item) { return key_of(item) != key_of(items[0]); };
  if (std::any_of(items.begin() + 1, items.end(), differs))
    std::stable_sort(items.begin(), items.end(), [&](int a, int b) { return key_of(a) < key_of(b); });
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    while (end < items.size() && key_of(items[end]) == key_of(items[begin])) ++end;
    if (end - begin > 1) visit(std::span<const int>(items).subspan(begin, end - begin));
  }
}

/// Calls `visit(items)` for the items of [0, count), ascending, that share their key with others. `key_of(item)` is an
/// array of finite doubles. Calls may be concurrent, in no particular order. Throws OutOfTime.
template <class KeyOf, class Visit>
void visit_same_keys(int count, const KeyOf& key_of, const Progress& progress, const Visit& visit) {
  std::vector<std::uint64_t> hashes(static_cast<std::size_t>(count));
  parallel_for(hashes.size(), grain::light, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) hashes[i] = hash_of(key_of(static_cast<int>(i)));
  });
  // Groups by the first bits of hashes, small enough for the items of a group to fit in the cache.
  const std::size_t groups = std::bit_ceil(hashes.size() / 64 + 2);
  const int shift = 64 - std::countr_zero(groups);
  Groups<HashedItem> grouped(groups, [&](const auto& add) {
    parallel_for(hashes.size(), grain::light, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) add(hashes[i] >> shift, HashedItem{hashes[i], static_cast<int>(i)});
    });
  });
  parallel_for(groups, grain::heavy, progress, [&](std::size_t begin, std::size_t end) {
    std::vector<int> items;
    for (std::size_t group = begin; group < end; ++group) {
      const std::span<HashedItem> hashed = grouped[group];
      std::sort(hashed.begin(), hashed.end());
      for (std::size_t i = 0; i < hashed.size();) {
        const std::uint64_t hash = hashed[i].hash;
        items.clear();
        for (; i < hashed.size() && hashed[i].hash == hash; ++i) items.push_back(hashed[i].item);
        if (items.size() > 1) visit_same_hash(items, key_of, visit);
      }
    }
  });
}

/// Returns for each item of [0, count) whether two items before it have the same key. Throws OutOfTime.
template <class KeyOf>
std::vector<char> mark_third_copies(int count, const KeyOf& key_of, const Progress& progress) {
  std::vector<char> is_third(static_cast<std::size_t>(count), 0);
  visit_same_keys(count, key_of, progress, [&](std::span<const int> same) {
    for (const int item : same.subspan(2)) is_third[item] = 1;
  });
  return is_third;
}

}  // namespace epura
