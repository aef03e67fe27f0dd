// SPDX-License-Identifier: Apache-2.0
#include "scene/view_names.hpp"

#include <map>
#include <set>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::scene {

void expect_few_views(std::size_t views, const std::string& where) {
  constexpr std::size_t max = 1000;
  if (views > max)
    throw Error(ErrorKind::input, where,
                "requests " + std::to_string(views) + " views; a drawing can have at most " + std::to_string(max),
                "draw them in several runs");
}

void name_views(std::vector<ViewDescription>& views) {
  if (!views.empty()) expect_few_views(views.size(), views.back().projection.where);
  std::set<std::string> taken;
  for (const ViewDescription& view : views)
    if (view.name.given()) taken.insert(*view.name);
  std::map<std::string, int> numbers;
  for (ViewDescription& view : views) {
    if (view.name.given()) continue;
    const std::string usual = view.detail.given() ? "detail-" + *view.detail : view.projection->name;
    int& number = numbers[usual];
    do {
      ++number;
      view.name.value = number == 1 ? usual : usual + "-" + std::to_string(number);
    } while (!taken.insert(*view.name).second);
  }
}

}  // namespace epura::scene
