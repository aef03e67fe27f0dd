// SPDX-License-Identifier: Apache-2.0
#include "count_parts.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace epura::plugin::threemf {

namespace {

constexpr int deepest = 500;

/// Counts of an object with its components, including itself.
struct Held {
  std::size_t parts;
  int levels;
};

class Counter {
 public:
  explicit Counter(const Model& model) : model_(model), counts_(model.objects.size()) {}

  Held count(std::uint32_t object, int depth) {
    if (counts_[object]) return *counts_[object];
    Held held{1, 1};
    for (const Placed& component : model_.objects[object].components) {
      const Held one = depth < deepest ? count(component.object, depth + 1) : Held{0, deepest};
      held.parts += one.parts;
      held.levels = std::max(held.levels, one.levels + 1);
      expect(held.levels <= deepest,
             "has components in more than " + std::to_string(deepest) + " levels, or in a circle");
      expect_few(held.parts);
    }
    counts_[object] = held;
    return held;
  }

  static void expect_few(std::size_t parts) {
    expect(parts <= max_parts, "puts down more than " + std::to_string(max_parts) + " parts");
  }

 private:
  static void expect(bool is_so, const std::string& otherwise) {
    if (!is_so) throw std::runtime_error(otherwise);
  }

  const Model& model_;
  std::vector<std::optional<Held>> counts_;
};

}  // namespace

void expect_few_parts(const Model& model) {
  Counter counter(model);
  for (std::uint32_t object = 0; object < model.objects.size(); ++object) counter.count(object, 1);
  std::size_t parts = 0;
  for (const Placed& item : model.items) Counter::expect_few(parts += counter.count(item.object, 1).parts);
}

}  // namespace epura::plugin::threemf
