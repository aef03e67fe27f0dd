#include "app/compose.hpp"

#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "sheet/cutting_plane_line.hpp"
#include "sheet/hatch.hpp"
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

std::vector<const Drawing*> drawings_of(const std::vector<ViewResult>& views) {
  std::vector<const Drawing*> drawings;
  for (const ViewResult& view : views) drawings.push_back(&view.drawing);
  return drawings;
}

// Each section is marked in the first view of the whole that sees its plane edge-on.
std::vector<Layer> cutting_plane_lines(const std::vector<ViewResult>& views, const LineWidths& widths) {
  std::map<std::string, Layer> marks;
  for (const ViewResult& cut : views)
    for (const ViewResult& parent : views) {
      if (!cut.section || parent.section || marks.contains(cut.section->name)) continue;
      if (auto mark = cutting_plane_line(parent.drawing, *cut.section, widths))
        marks.emplace(cut.section->name, std::move(*mark));
    }
  std::vector<Layer> layers;
  for (auto& [name, layer] : marks) layers.push_back(std::move(layer));
  return layers;
}

}  // namespace

FinishedSheet compose(const SceneDescription& scene, const SheetPlan& plan, std::vector<ViewResult>& views,
                      std::span<const ViewWish> wishes, int sheet) {
  FinishedSheet finished;
  finished.scale = plan.scale;
  finished.sheet = {plan.paper.width, plan.paper.height, title_of(scene.sheets[std::size_t(sheet)]), {}};
  const LineWidths widths = line_widths(plan.paper);
  const std::vector<Hatching> hatching = choose_hatching(drawings_of(views));
  std::vector<Layer> marks = cutting_plane_lines(views, widths);
  bool partial = false;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!views[i].drawing.cut_faces.empty())
      finished.sheet.layers.push_back(hatch_layer(views[i].drawing, hatching, widths));
    append(finished.sheet.layers, view_layers(views[i].drawing, widths, wishes[i].looks));
    views[i].drawing.chains = {};  // the sheet has them
    partial = partial || views[i].partial;
    finished.drawings.push_back(std::move(views[i].drawing));
  }
  append(finished.sheet.layers, std::move(marks));
  if (partial) finished.sheet.layers.push_back(partial_mark(plan.paper));
  return finished;
}

}  // namespace epura
