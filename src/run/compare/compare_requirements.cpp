// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.hpp"

namespace epura::compare {

namespace {

using report::RequirementRow;

// "diameter " of "diameter 5 H7 mm": what is required, without how much.
std::string words_before_number(const std::string& sentence) {
  return sentence.substr(0, sentence.find_first_of("0123456789"));
}

using Key = std::string (*)(const RequirementRow& row);

// Takes pairs with one key out of both lists, in their order, and returns them.
std::vector<RequirementChange> take_pairs(std::vector<RequirementRow>& before, std::vector<RequirementRow>& after,
                                          Key key_of) {
  std::map<std::string, std::deque<std::size_t>> others;
  for (std::size_t i = 0; i < after.size(); ++i) others[key_of(after[i])].push_back(i);
  std::vector<RequirementChange> pairs;
  std::vector<char> is_taken(after.size(), 0);
  std::erase_if(before, [&](const RequirementRow& one) {
    const auto found = others.find(key_of(one));
    if (found == others.end() || found->second.empty()) return false;
    const std::size_t other = found->second.front();
    found->second.pop_front();
    is_taken[other] = 1;
    pairs.push_back({one.what, after[other].what});
    return true;
  });
  std::size_t next = 0;
  std::erase_if(after, [&](const RequirementRow&) { return is_taken[next++] != 0; });
  return pairs;
}

}  // namespace

std::vector<RequirementChange> compare_requirements(std::vector<RequirementRow> before,
                                                    std::vector<RequirementRow> after) {
  take_pairs(before, after, [](const RequirementRow& row) { return row.what; });
  const auto alike = [](const RequirementRow& row) { return row.kind + "\n" + words_before_number(row.what); };
  std::vector<RequirementChange> changes = take_pairs(before, after, [](const RequirementRow& row) {
    return row.id + "\n" + row.kind + "\n" + words_before_number(row.what);
  });
  for (RequirementChange& change : take_pairs(before, after, alike)) changes.push_back(std::move(change));
  for (const RequirementRow& one : before) changes.push_back({one.what, {}});
  for (const RequirementRow& one : after) changes.push_back({{}, one.what});
  return changes;
}

}  // namespace epura::compare
