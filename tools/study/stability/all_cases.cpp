// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text.hpp"
#include "study/stability/case.hpp"

namespace epura::stability {

namespace {

// By family, then by number.
std::pair<std::size_t, long long> place_of(const std::string& id) {
  return {families.find(id.front()), parse_integer(std::string_view(id).substr(1)).value_or(0)};
}

}  // namespace

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (auto* family : {projection_cases, viewer_cases, alignment_cases, line_cases, body_cases, surface_cases,
                       size_cases, number_cases, modeller_cases, section_cases, recognition_cases, dimension_cases}) {
    std::vector<Case> cases = family();
    std::move(cases.begin(), cases.end(), std::back_inserter(all));
  }
  std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return place_of(a.id) < place_of(b.id); });
  return all;
}

}  // namespace epura::stability
