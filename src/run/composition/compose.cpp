// SPDX-License-Identifier: Apache-2.0
#include "composition/compose.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "annotations/cutting_plane_line.hpp"
#include "annotations/hatch.hpp"
#include "annotations/limit_lines.hpp"
#include "annotations/view_labels.hpp"
#include "composition/annotation_layers.hpp"
#include "composition/centre_layers.hpp"
#include "composition/detail_layers.hpp"
#include "construction/figure.hpp"
#include "drawing/chains.hpp"
#include "drawing/drawing.hpp"
#include "report/format.hpp"
#include "sheet/captions.hpp"
#include "sheet/label_positions.hpp"
#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/sheet_layers.hpp"
#include "sheet/standard_scale.hpp"
#include "sheet/view_lines.hpp"
#include "views/constructions.hpp"

namespace epura::pipeline {

namespace {

void append(std::vector<sheet::Layer>& layers, std::vector<sheet::Layer> more) {
  std::move(more.begin(), more.end(), std::back_inserter(layers));
}

// Names of sections, and scales that differ from the sheet's.
std::vector<sheet::Text> labels_of(const SheetInput& input, const std::vector<ViewResult>& views) {
  const DecimalSign sign = input.sheet().decimal_sign.value_or(DecimalSign::point);
  std::vector<sheet::Text> labels;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const scene::ViewDescription& view = input.views.descriptions[i];
    const drawing::ViewDrawing& drawing = views[i].drawing;
    std::string name = view.label.value_or("");
    if (name.empty() && view.section.given() && !drawing.shown.detail && views.size() > 1)
      name = *view.section + "-" + *view.section;
    if (name.empty() && drawing.shown.detail) name = drawing.shown.detail->name;
    const auto scale = drawing.projection.central ? std::nullopt : std::optional(drawing.scale);
    const std::string label = sheet::view_label(name, scale, drawing.shown.detail ? 0 : input.plan.scale, sign);
    const Vec2 past(
        0, drawing.shown.limits.empty() ? 0 : sheet::limit_room(sheet::line_widths(input.plan.furniture.paper)));
    if (!label.empty()) labels.push_back(sheet::label_above(label, {drawing.box.min, drawing.box.max + past}));
  }
  return labels;
}

// A line of text above the title block, if there is one.
std::optional<sheet::Text> note_above_block(const SheetInput& input, const std::string& words, double raised) {
  const sheet::SheetFurniture& furniture = input.plan.furniture;
  if (!sheet::title_block_box(*furniture.title_block, furniture.paper)) return std::nullopt;
  const auto box = sheet::block_boxes(furniture).all;
  constexpr double height = 2.5, above = 2.5;
  // On portrait A4, the block is as wide as the drawing area, whose frame the words must not touch; that of a form may
  // be below it.
  const sheet::Rectangle area = sheet::drawing_area(furniture.paper);
  const double from_frame = box->min.x > area.min.x ? 0 : 1;
  const Vec2 corner(std::max(box->min.x, area.min.x), std::max(box->max.y, area.min.y));
  return sheet::Text{words, corner + Vec2(from_frame, above + raised), height, 0, sheet::Align::left, "note"};
}

// The unit of all dimensions, once, above the title block. ISO 129-1.
std::optional<sheet::Text> unit_note(const SheetInput& input) {
  const bool has_dimensions = std::any_of(input.annotations.begin(), input.annotations.end(),
                                          [](const Annotations& one) { return !one.dimensions.empty(); });
  if (!has_dimensions || !input.plan.furniture.title_block) return std::nullopt;
  const Unit unit = input.sheet().dimension_unit.value_or(Unit::mm);
  return note_above_block(input, std::string(sheet::caption(scene::word_of(unit), input.sheet().field("language"))), 0);
}

// How far lines may be from those of the part, above the statement of the unit.
std::optional<sheet::Text> error_note(const SheetInput& input, const std::vector<ViewResult>& results, bool below) {
  const sheet::SheetFurniture& furniture = input.plan.furniture;
  if (!input.views.states_error || !furniture.title_block) return std::nullopt;
  double largest = 0;
  for (const ViewResult& result : results)
    if (result.error) largest = std::max(largest, result.error->total());
  if (!(largest > 0)) return std::nullopt;
  const DecimalSign sign = input.sheet().decimal_sign.value_or(DecimalSign::point);
  const std::string words = std::string(sheet::caption("error", input.sheet().field("language"))) + " " +
                            sheet::with_decimal_sign(report::rounded_up(largest), sign) + " mm";
  constexpr double line = 4;  // mm
  return note_above_block(input, words, below ? line : 0);
}

std::vector<sheet::ViewFrame> frames_of(const std::vector<ViewResult>& views) {
  std::vector<sheet::ViewFrame> frames;
  for (const ViewResult& view : views) {
    const drawing::ViewDrawing& drawing = view.drawing;
    const std::string scale = drawing.projection.central ? "" : sheet::ratio_text(drawing.scale);
    frames.push_back({drawing.name, drawing.projection.name, scale, drawing.box.min, drawing.box.max});
  }
  return frames;
}

// The fields of the title block except the title, for the metadata of files, which call the creator of a drawing its
// author.
std::vector<std::pair<std::string, std::string>> facts_of(const scene::SheetDescription& sheet) {
  std::vector<std::pair<std::string, std::string>> facts;
  for (const auto& [name, text] : sheet.title_block)
    if (name != "title" && !text->empty()) facts.emplace_back(name == "creator" ? "author" : name, *text);
  return facts;
}

// Without frame and labels there is no text, and no font is opened.
sheet::FurnitureLayers furniture_layers(const sheet::SheetFurniture& furniture) {
  if (furniture.frame == FrameKind::none && furniture.labels.empty() && !furniture.parts_list && !furniture.revisions)
    return {};
  return sheet::sheet_layers(furniture, sheet::Lettering(furniture.font));
}

// A detail is hatched like the view that it enlarges.
std::vector<std::size_t> views_to_hatch(const std::vector<ViewResult>& views) {
  const auto is_here = [&views](const std::string& name) {
    return std::any_of(views.begin(), views.end(), [&](const ViewResult& view) { return view.drawing.name == name; });
  };
  std::vector<std::size_t> hatched;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!views[i].drawing.shown.detail || !is_here(views[i].drawing.shown.detail->parent)) hatched.push_back(i);
  return hatched;
}

// Dimensions are placed around labels, centre lines without regard to them.
void clear_labels(FinishedSheet& finished, const sheet::SheetFurniture& furniture) {
  const auto is_label = [](const sheet::Text& text) { return text.role == "label"; };
  if (std::none_of(furniture.labels.begin(), furniture.labels.end(), is_label)) return;
  const sheet::Paper& paper = furniture.paper;
  const sheet::Rectangle area = furniture.frame == FrameKind::none
                                    ? sheet::Rectangle{{0, 0}, {paper.width, paper.height}}
                                    : sheet::drawing_area(paper);
  sheet::clear_labels(finished.sheet, area, sheet::Lettering(furniture.font));
}

// The boxes of the texts of some layers. Without texts, no font is opened.
std::vector<sheet::TurnedBox> text_boxes(std::span<const sheet::Layer> layers, const sheet::Font& font) {
  std::vector<sheet::TurnedBox> boxes;
  std::optional<sheet::Lettering> lettering;
  for (const sheet::Layer& layer : layers)
    for (const sheet::Text& text : layer.texts) {
      if (!lettering) lettering.emplace(font);
      boxes.push_back(sheet::box_of(text, *lettering));
    }
  return boxes;
}

// One layer for each view, but none for views without cut faces. Hatching is interrupted at the texts of layers
// `beside`.
std::vector<std::vector<sheet::Layer>> hatch_layers(const SheetInput& input, const std::vector<ViewResult>& results,
                                                    std::span<const sheet::Layer> beside,
                                                    const sheet::LineWidths& widths, const Progress& progress) {
  const auto styles = [&](std::size_t view) -> const sheet::BodyStyles& {
    return input.views.plans[view].options.styles;
  };

  std::size_t faces = 0;
  for (const ViewResult& view : results) faces += view.drawing.cuts.faces.size();
  progress.begin("hatching", faces);
  const std::vector<std::size_t> hatched = views_to_hatch(results);
  std::vector<const drawing::ViewDrawing*> drawings;
  for (const std::size_t view : hatched) drawings.push_back(&results[view].drawing);
  const auto wish = [&](std::size_t drawing, int model, int body) {
    return styles(hatched[drawing])(model, body).hatch;
  };
  const std::vector<sheet::Hatching> hatching = sheet::choose_hatching(drawings, wish, progress);
  std::vector<sheet::TurnedBox> texts;
  if (faces > 0) texts = text_boxes(beside, input.plan.furniture.font);
  std::vector<std::vector<sheet::Layer>> layers(results.size());
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!results[i].drawing.cuts.faces.empty())
      layers[i].push_back(sheet::hatch_layer({results[i].drawing, styles(i), texts}, hatching, widths, progress));
  return layers;
}

// Only of the longest lines if there is no time for all.
std::vector<sheet::Layer> line_layers(drawing::ViewDrawing& drawing, const sheet::LineWidths& widths,
                                      const sheet::BodyStyles& styles, const Budget& budget) {
  const auto make = [&](const Progress& progress) { return sheet::view_layers(drawing, widths, styles, progress); };
  const auto leave_out = [&](const std::string& stage) {
    budget.partial.add_stage(stage);
    budget.partial.undrawn +=
        static_cast<long long>(drawing::keep_longest_chains(drawing, fewer(drawing.chains.size())));
    return drawing.chains.size() <= few_lines;
  };
  constexpr double part = 0.6;  // of the remaining time; the rest is for writing
  return make_in_time(budget.run.with_part_of_the_time(part), budget.last(), make, leave_out);
}

// The sheet has the lines; JSON needs their curves, too.
void keep_curves(std::vector<drawing::Chain>& chains) {
  std::erase_if(chains, [](const drawing::Chain& chain) { return chain.curves.empty(); });
  chains.shrink_to_fit();
}

std::shared_ptr<const construction::Figure> unless_empty(construction::Figure figure) {
  return figure.empty() ? nullptr : std::make_shared<const construction::Figure>(std::move(figure));
}

// On paper, when the views are drawn. An épura has its figure in the elevation.
void construct(const SheetInput& input, std::vector<ViewResult>& results) {
  const SheetOfViews& views = input.views;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool in_epura = views.epura && (i == views.epura->elevation || i == views.epura->plan);
    if (!in_epura && views.descriptions[i].construction.given() && !results[i].drawing.shown.detail)
      results[i].drawing.aids.construction =
          unless_empty(figure_on_paper(input.world, views.descriptions[i], results[i].drawing));
  }
  if (!views.epura) return;
  drawing::ViewDrawing& elevation = results[views.epura->elevation].drawing;
  const drawing::ViewDrawing& plan = results[views.epura->plan].drawing;
  const auto plane = [](const drawing::ViewDrawing& drawing) {
    return construction::picture_plane(drawing.projection, drawing.world_to_page, drawing.scale);
  };
  const construction::Epura epura{
      plane(plan),
      plane(elevation),
      (plan.box.max.y + elevation.box.min.y) / 2,
      {std::min(plan.box.min.x, elevation.box.min.x), std::max(plan.box.max.x, elevation.box.max.x)}};
  const std::array descriptions{&views.descriptions[views.epura->elevation], &views.descriptions[views.epura->plan]};
  elevation.aids.construction = unless_empty(figure_of_epura(input.world, descriptions, epura));
}

}  // namespace

FinishedSheet compose(const SheetInput& input, std::vector<ViewResult>& results, const Budget& budget) {
  const SheetPlan& plan = input.plan;
  const scene::SheetDescription& sheet = input.sheet();
  const sheet::Paper& paper = plan.furniture.paper;
  sheet::SheetFurniture furniture = plan.furniture;
  furniture.labels = labels_of(input, results);
  const auto unit = unit_note(input);
  if (unit) furniture.labels.push_back(*unit);
  if (const auto note = error_note(input, results, unit.has_value())) furniture.labels.push_back(*note);
  sheet::FurnitureLayers around = furniture_layers(furniture);
  FinishedSheet finished{{paper.width, paper.height, sheet.field("title"), std::move(around.layers), frames_of(results),
                          facts_of(sheet), furniture.font},
                         plan.scale,
                         {},
                         std::move(around.warnings),
                         paper};
  const sheet::LineWidths widths = sheet::line_widths(paper, furniture.styles);
  construct(input, results);
  AnnotationLayers beside = annotation_layers(input, results, furniture.labels, budget);
  finished.is_crowded = beside.is_crowded || !beside.warnings.empty();
  finished.without_room = beside.without_room;
  finished.unplaced = beside.unplaced;
  for (const RequirementPlace& place : beside.places)
    finished.zones.emplace_back(place.requirement, sheet::zone_at(paper, furniture.frame, place.box.centre));
  if (beside.leaves_out_more_than(input.max_left_out)) {
    finished.left_out = std::move(beside.left_out);
    return finished;
  }
  auto hatching =
      budget.or_nothing([&](const Progress& p) { return hatch_layers(input, results, beside.layers, widths, p); });
  hatching.resize(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    append(finished.sheet.layers, std::move(beside.constructions[i]));
    append(finished.sheet.layers, std::move(hatching[i]));
    std::vector<sheet::Layer> lines =
        line_layers(results[i].drawing, widths, input.views.plans[i].options.styles, budget);
    append(finished.sheet.layers, budget.or_nothing([&](const Progress& progress) {
      std::vector<sheet::Layer> centre =
          centre_layers(results[i], input.views.plans[i].options, widths, lines, progress);
      for (const auto& marks : sheet::cutting_plane_lines(results[i].drawing, input.annotations[i].planes, widths))
        for (sheet::Layer& layer : centre)
          if (marks) sheet::give_way(layer, *marks, widths);
      return centre;
    }));
    if (auto traces = sheet::trace_lines(results[i].drawing, widths))
      finished.sheet.layers.push_back(std::move(*traces));
    append(finished.sheet.layers, std::move(lines));
    if (auto limits = sheet::limit_lines(results[i].drawing, widths))
      finished.sheet.layers.push_back(std::move(*limits));
    if (auto revolved = sheet::revolved_lines(results[i].drawing, widths))
      finished.sheet.layers.push_back(std::move(*revolved));
    // If there is no time to write everything, chains determine which segments belong together.
    if (!budget.run.is_limited()) keep_curves(results[i].drawing.chains);
    finished.drawings.push_back(std::move(results[i].drawing));
  }
  append(finished.sheet.layers, std::move(beside.layers));
  add_details(finished.sheet.layers, input, finished.drawings);
  if (!widths.styles.empty()) sheet::restyle(finished.sheet.layers, widths);
  finished.findings = std::move(beside.findings);
  finished.left_out = std::move(beside.left_out);
  finished.unseen = std::move(beside.unseen);
  clear_labels(finished, furniture);
  for (std::vector<std::string>* told : {&beside.warnings, &beside.unseen_warnings})
    std::move(told->begin(), told->end(), std::back_inserter(finished.warnings));
  if (const std::string language = input.sheet().field("language"); !sheet::has_captions(language))
    finished.warnings.push_back("there are no captions in the language '" + language +
                                "': they are in English\n  hint: others are de, fr, es, pt and ja");
  return finished;
}

}  // namespace epura::pipeline
