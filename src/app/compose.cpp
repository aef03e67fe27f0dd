#include "app/compose.hpp"

#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "sheet/centre_lines.hpp"
#include "sheet/cutting_plane_line.hpp"
#include "sheet/dimensions/dimensions.hpp"
#include "sheet/hatch.hpp"
#include "sheet/lettering.hpp"
#include "sheet/partial_mark.hpp"
#include "sheet/sheet_layers.hpp"
#include "sheet/standard_scale.hpp"
#include "sheet/view_labels.hpp"
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

// Names of sections, and scales where they differ from the sheet's.
std::vector<Text> labels_of(const SheetPlan& plan, std::span<const ViewDescription> descriptions,
                            const std::vector<ViewResult>& views) {
  std::vector<Text> labels;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ViewDescription& view = descriptions[i];
    const Drawing& drawing = views[i].drawing;
    std::string name = view.label.text;
    if (name.empty() && view.section.given() && views.size() > 1) name = view.section.text + "-" + view.section.text;
    const auto scale = drawing.projection.central ? std::nullopt : std::optional(drawing.scale);
    const std::string label = view_label(name, scale, plan.scale);
    if (!label.empty()) labels.push_back(label_above(label, {drawing.least, drawing.most}));
  }
  return labels;
}

std::vector<ViewFrame> frames_of(const std::vector<ViewResult>& views) {
  std::vector<ViewFrame> frames;
  for (const ViewResult& view : views) {
    const Drawing& drawing = view.drawing;
    const std::string scale = drawing.projection.central ? "" : ratio_text(drawing.scale);
    frames.push_back({drawing.name, drawing.projection.name, scale, drawing.least, drawing.most});
  }
  return frames;
}

// The fields of the title block but the title, for the metadata of files. The creator of a drawing is its author there.
std::vector<std::pair<std::string, std::string>> facts_of(const SheetDescription& sheet) {
  std::vector<std::pair<std::string, std::string>> facts;
  for (const auto& [name, text] : sheet.title_block)
    if (name != "title" && text.given()) facts.emplace_back(name == "creator" ? "author" : name, text.text);
  return facts;
}

// Nothing is written where there is no frame and no label: then no font is opened.
FurnitureLayers furniture_layers(const SheetFurniture& furniture) {
  if (furniture.frame == FrameKind::none && furniture.labels.empty()) return {};
  return sheet_layers(furniture, Lettering());
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

// A drawing that lacks lines may lack its ends: its overall dimensions are left out.
void add_dimensions(FinishedSheet& finished, const World& world, const ViewResult& view,
                    std::vector<DimensionDescription> dimensions, double line_width, double text_height) {
  if (view.partial) std::erase_if(dimensions, [](const auto& one) { return one.type.text == "overall"; });
  if (dimensions.empty()) return;
  Layer layer = dimension_layer(world, view.drawing, dimensions, Lettering(), line_width, text_height);
  if (!on_paper(layer, {finished.sheet.width, finished.sheet.height}))
    finished.warnings.push_back("dimensions of the view '" + view.drawing.name +
                                "' reach beyond the paper\n  hint: use a smaller scale or a larger sheet");
  finished.sheet.layers.push_back(std::move(layer));
}

std::vector<Layer> centre_layers(const ViewResult& view, const ViewWish& wish, const LineWidths& widths,
                                 const std::vector<Layer>& lines) {
  if (!wish.centre_lines) return {};
  return {centre_lines(view.drawing, view.circles, widths, wish.looks, lines)};
}

// The sheet has the lines; JSON asks for their curves.
void keep_curves(std::vector<Chain>& chains) {
  std::erase_if(chains, [](const Chain& chain) { return chain.curves.empty(); });
  chains.shrink_to_fit();
}

}  // namespace

FinishedSheet compose(const World& world, const SceneDescription& scene, const SheetOfViews& views,
                      const SheetPlan& plan, std::vector<ViewResult>& results, const DimensionsByView& dimensions) {
  const SheetDescription& sheet = scene.sheets[static_cast<std::size_t>(views.sheet)];
  const Paper& paper = plan.furniture.paper;
  SheetFurniture furniture = plan.furniture;
  furniture.labels = labels_of(plan, views.descriptions, results);
  FurnitureLayers around = furniture_layers(furniture);
  FinishedSheet finished{
      {paper.width, paper.height, title_of(sheet), std::move(around.layers), frames_of(results), facts_of(sheet)},
      plan.scale,
      {},
      std::move(around.warnings)};
  const LineWidths widths = line_widths(paper);
  const double text_height = dimension_text_height(paper, results.size());
  const std::vector<Hatching> hatching = choose_hatching(drawings_of(results));
  std::vector<Layer> marks = cutting_plane_lines(results, widths);
  bool partial = false;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].drawing.cut_faces.empty())
      finished.sheet.layers.push_back(hatch_layer(results[i].drawing, hatching, widths));
    std::vector<Layer> lines = view_layers(results[i].drawing, widths, views.plans[i].wish.looks);
    append(finished.sheet.layers, centre_layers(results[i], views.plans[i].wish, widths, lines));
    append(finished.sheet.layers, std::move(lines));
    keep_curves(results[i].drawing.chains);
    add_dimensions(finished, world, results[i], dimensions[i], widths.narrow, text_height);
    partial = partial || results[i].partial;
    finished.drawings.push_back(std::move(results[i].drawing));
  }
  append(finished.sheet.layers, std::move(marks));
  if (partial) finished.sheet.layers.push_back(partial_mark(paper));
  return finished;
}

}  // namespace epura
