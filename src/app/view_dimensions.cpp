#include "app/view_dimensions.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/dimensions/overall.hpp"

namespace epura {

namespace {

bool is_open(const DimensionDescription& dimension) {
  return dimension.type.text == "overall" && !dimension.direction.given();
}

const std::string& view_of(const DimensionDescription& dimension, const SceneDescription& scene) {
  return dimension.view.given() ? dimension.view.text : scene.views.front().name.text;
}

// A section may have cut off an end of the models: it shows their size only where no other view does.
std::vector<NamedProjection> views_to_measure(std::span<const ViewDescription> views, std::span<const View> seen) {
  std::vector<NamedProjection> whole, cut;
  for (std::size_t i = 0; i < seen.size(); ++i)
    (views[i].section.given() ? cut : whole).push_back({views[i].name.text, seen[i].projection});
  whole.insert(whole.end(), cut.begin(), cut.end());
  return whole;
}

}  // namespace

DimensionsByView dimensions_by_view(const SceneDescription& scene, int sheet, std::span<const ViewDescription> views,
                                    std::span<const View> seen) {
  const std::vector<NamedProjection> projections = views_to_measure(views, seen);
  const auto here = [&views](const std::string& name) {
    return std::find_if(views.begin(), views.end(), [&](const ViewDescription& v) { return v.name.text == name; });
  };
  DimensionsByView dimensions(views.size());
  const auto add = [&](const DimensionDescription& dimension) {
    const auto view = here(view_of(dimension, scene));
    if (view != views.end()) dimensions[std::size_t(view - views.begin())].push_back(dimension);
  };
  for (const DimensionDescription& dimension : scene.dimensions) {
    if (!is_open(dimension)) {
      add(dimension);
    } else if (dimension.view.given() ? here(dimension.view.text) != views.end() : sheet == 0) {
      for (const DimensionDescription& one : overall_dimensions(dimension, projections)) add(one);
    }
  }
  return dimensions;
}

void expect_views_of_dimensions(const SceneDescription& scene) {
  std::vector<std::string> names;
  for (const ViewDescription& view : scene.views) names.push_back(view.name.text);
  for (const DimensionDescription& dimension : scene.dimensions)
    if (dimension.view.given() && std::count(names.begin(), names.end(), dimension.view.text) == 0)
      throw Error(Trouble::input, dimension.view.where, "there is no view '" + dimension.view.text + "'",
                  did_you_mean(dimension.view.text, names));
}

}  // namespace epura
