#include "scene/view_names.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace epura {

void name_views(std::vector<ViewDescription>& views) {
  const auto taken = [&views](const std::string& name) {
    return std::any_of(views.begin(), views.end(),
                       [&name](const ViewDescription& view) { return view.name.text == name; });
  };
  for (ViewDescription& view : views) {
    if (view.name.given()) continue;
    const std::string projection(split(view.projection.text, ':').front());
    std::string name = projection;
    for (int i = 2; taken(name); ++i) name = projection + "-" + std::to_string(i);
    view.name.text = std::move(name);
  }
}

}  // namespace epura
