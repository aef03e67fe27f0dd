// SPDX-License-Identifier: Apache-2.0
#include "scene/view_names.hpp"

#include <algorithm>
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

const ViewDescription& whole_view(const LocatedText& name, const std::string& where,
                                  const std::vector<ViewDescription>& views) {
  const auto is_it = [&](const ViewDescription& view) {
    return name.given() ? *view.name == *name : !view.detail.given();
  };
  const auto found = std::find_if(views.begin(), views.end(), is_it);
  const std::string& place = name.given() ? name.where : where;
  if (found == views.end()) {
    std::vector<std::string> names;
    for (const ViewDescription& view : views)
      if (!view.detail.given()) names.push_back(*view.name);
    throw Error(ErrorKind::input, place, "there is no view '" + *name + "'", did_you_mean(*name, names));
  }
  if (found->detail.given())
    throw Error(ErrorKind::input, place, "view '" + *found->name + "' shows a detail",
                "name the view that it enlarges, or another view of the whole");
  return *found;
}

}  // namespace epura::scene
