// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include "compare/comparison.hpp"

namespace epura::compare {

namespace {

using report::RequirementRow;

// "diameter " of "diameter 5 H7 mm": what is required, without how much.
std::string words_before_number(const std::string& sentence) {
  return sentence.substr(0, sentence.find_first_of("0123456789"));
}

// Takes pairs for which `match(one, other)` holds out of both lists, and calls take(one, other) for each.
template <class Match, class Take>
void take_pairs(std::vector<RequirementRow>& before, std::vector<RequirementRow>& after, const Match& match,
                const Take& take) {
  std::vector<RequirementRow> left;
  for (RequirementRow& one : before) {
    const auto other =
        std::find_if(after.begin(), after.end(), [&](const RequirementRow& row) { return match(one, row); });
    if (other == after.end()) {
      left.push_back(std::move(one));
      continue;
    }
    take(one, *other);
    after.erase(other);
  }
  before = std::move(left);
}

}  // namespace

std::vector<RequirementChange> compare_requirements(std::vector<RequirementRow> before,
                                                    std::vector<RequirementRow> after) {
  std::vector<RequirementChange> changes;
  const auto are_equal = [](const RequirementRow& one, const RequirementRow& other) { return one.what == other.what; };
  const auto are_alike = [](const RequirementRow& one, const RequirementRow& other) {
    return one.kind == other.kind && words_before_number(one.what) == words_before_number(other.what);
  };
  take_pairs(before, after, are_equal, [](const RequirementRow&, const RequirementRow&) {});
  const auto take = [&](const RequirementRow& one, const RequirementRow& other) {
    changes.push_back({one.what, other.what});
  };
  take_pairs(
      before, after,
      [&](const RequirementRow& one, const RequirementRow& other) {
        return one.id == other.id && are_alike(one, other);
      },
      take);
  take_pairs(before, after, are_alike, take);
  for (const RequirementRow& one : before) changes.push_back({one.what, {}});
  for (const RequirementRow& one : after) changes.push_back({{}, one.what});
  return changes;
}

}  // namespace epura::compare
