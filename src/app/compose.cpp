#include "app/compose.hpp"

#include <iterator>
#include <string>
#include <utility>

#include "app/choose.hpp"
#include "sheet/centre_lines.hpp"
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

}  // namespace

SheetPlan plan_sheet(const SheetDescription& sheet, std::span<const ViewDescription> views,
                     std::span<const Window> boxes) {
  const bool portrait = choose<bool>(sheet.orientation, {{"landscape", false}, {"portrait", true}});
  const Paper paper = parse_paper(sheet.size.given() ? sheet.size.text : "A4", portrait, sheet.size.where);
  const auto scale = sheet.scale.given() ? parse_scale(sheet.scale.text, sheet.scale.where) : std::nullopt;
  const Placement placement = place_ink(boxes.front().least, boxes.front().most, scale, paper);
  SheetPlan plan{placement.paper, {}, placement.scale, placement.inside};
  for (std::size_t i = 0; i < views.size(); ++i) plan.places.push_back({placement.scale, placement.shift});
  return plan;
}

FinishedSheet compose(const SceneDescription& scene, const SheetPlan& plan, std::vector<ViewResult>& views,
                      std::span<const ViewWish> wishes, int sheet) {
  FinishedSheet finished;
  finished.scale = plan.scale;
  finished.sheet = {plan.paper.width, plan.paper.height, title_of(scene.sheets[std::size_t(sheet)]), {}};
  const LineWidths widths = line_widths(plan.paper);
  bool partial = false;
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::vector<Layer> lines = view_layers(views[i].drawing, widths, wishes[i].looks);
    if (wishes[i].centre_lines)
      finished.sheet.layers.push_back(centre_lines(views[i].drawing, views[i].circles, widths, wishes[i].looks, lines));
    append(finished.sheet.layers, std::move(lines));
    // The sheet has them; JSON asks for their curves.
    std::erase_if(views[i].drawing.chains, [](const Chain& chain) { return chain.curves.empty(); });
    views[i].drawing.chains.shrink_to_fit();
    partial = partial || views[i].partial;
    finished.drawings.push_back(std::move(views[i].drawing));
  }
  if (partial) finished.sheet.layers.push_back(partial_mark(plan.paper));
  return finished;
}

}  // namespace epura
