#include "app/compose.hpp"

#include <iterator>
#include <string>
#include <utility>

#include "sheet/dimensions/dimensions.hpp"
#include "sheet/partial_mark.hpp"
#include "sheet/view_lines.hpp"

namespace epura {

namespace {

std::string title_of(const SheetDescription& sheet) {
  for (const auto& [name, text] : sheet.title_block)
    if (name == "title") return text.text;
  return {};
}

void append(std::vector<Layer>& layers, std::vector<Layer> more) {
  std::move(more.begin(), more.end(), std::back_inserter(layers));
}

// A drawing that lacks lines may lack its ends: its overall dimensions are left out.
std::vector<Layer> dimensions_of(const World& world, const ViewResult& view,
                                 std::vector<DimensionDescription> dimensions, const LineWidths& widths,
                                 double text_height) {
  if (view.partial) std::erase_if(dimensions, [](const auto& one) { return one.type.text == "overall"; });
  if (dimensions.empty()) return {};
  return {dimension_layer(world, view.drawing, dimensions, Lettering(), widths.narrow, text_height)};
}

}  // namespace

FinishedSheet compose(const World& world, const SceneDescription& scene, const SheetPlan& plan,
                      std::vector<ViewResult>& views, std::span<const ViewWish> wishes,
                      const DimensionsByView& dimensions, int sheet) {
  FinishedSheet finished;
  finished.scale = plan.scale;
  finished.sheet = {plan.paper.width, plan.paper.height, title_of(scene.sheets[std::size_t(sheet)]), {}};
  const LineWidths widths = line_widths(plan.paper);
  const double text_height = dimension_text_height(plan.paper, views.size());
  bool partial = false;
  for (std::size_t i = 0; i < views.size(); ++i) {
    append(finished.sheet.layers, view_layers(views[i].drawing, widths, wishes[i].looks));
    views[i].drawing.chains = {};  // the sheet has them
    append(finished.sheet.layers, dimensions_of(world, views[i], dimensions[i], widths, text_height));
    partial = partial || views[i].partial;
    finished.drawings.push_back(std::move(views[i].drawing));
  }
  if (partial) finished.sheet.layers.push_back(partial_mark(plan.paper));
  return finished;
}

}  // namespace epura
