#include "scene/view_names.hpp"

#include <map>
#include <set>
#include <string>

#include "base/text.hpp"

namespace epura {

void name_views(std::vector<ViewDescription>& views) {
  std::set<std::string> taken;
  for (const ViewDescription& view : views)
    if (view.name.given()) taken.insert(view.name.text);
  std::map<std::string, int> numbers;
  for (ViewDescription& view : views) {
    if (view.name.given()) continue;
    const std::string projection(split(view.projection.text, ':').front());
    int& number = numbers[projection];
    do {
      ++number;
      view.name.text = number == 1 ? projection : projection + "-" + std::to_string(number);
    } while (!taken.insert(view.name.text).second);
  }
}

}  // namespace epura
