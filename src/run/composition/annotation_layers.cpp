// SPDX-License-Identifier: Apache-2.0
#include "composition/annotation_layers.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "annotations/balloons.hpp"
#include "annotations/cutting_plane_line.hpp"
#include "annotations/detail_marks.hpp"
#include "annotations/sight_arrows.hpp"
#include "annotations/target_areas.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/construction_layers.hpp"
#include "composition/occupied_room.hpp"
#include "composition/tell.hpp"
#include "dimensions/dimensions.hpp"
#include "drawing/drawing.hpp"
#include "sheet/captions.hpp"
#include "sheet/frame.hpp"
#include "sheet/free_rectangles.hpp"
#include "sheet/projection_symbol.hpp"
#include "views/details.hpp"

namespace epura::pipeline {

namespace {

// A drawing that lacks lines may lack its ends, so its overall dimensions are omitted.
struct WantedDimensions {
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<std::size_t> numbers;                        ///< in the annotations
  std::vector<std::vector<scene::FeatureCircle>> equal{};  ///< as in these
  std::size_t found = 0;                                   ///< how many of them, the first ones, nobody asked for
};
WantedDimensions dimensions_of(const Annotations& annotations, const ViewResult& view) {
  WantedDimensions wanted;
  for (std::size_t i = 0; i < annotations.dimensions.size(); ++i) {
    const scene::DimensionDescription& one = annotations.dimensions[i];
    if (!view.partial.stages.empty() && one.type.value == DimensionType::overall) continue;
    wanted.dimensions.push_back(one);
    wanted.numbers.push_back(i);
    if (i < annotations.equal.size()) wanted.equal.push_back(annotations.equal[i]);
    if (i < annotations.found) ++wanted.found;
  }
  return wanted;
}

// Unless the view leaves this place out.
void add_gravity(std::vector<sheet::Layer>& marks, const drawing::ViewDrawing& drawing, const Vec3& centre,
                 const sheet::LineWidths& widths) {
  constexpr double radius = 2;  // mm
  const Vec4 mapped = drawing.world_to_page * Vec4(centre, 1);
  const Vec2 whole = Vec2(mapped) / mapped.w;
  if (!(mapped.w > 0) || !drawing.shown.breaks.keeps(whole)) return;
  if (drawing.shown.detail) {
    const auto& [middle, half, round] = drawing.shown.detail->boundary;
    const Vec2 off = glm::abs(whole - middle);
    if (round ? glm::length(off) > half.x : off.x > half.x || off.y > half.y) return;
  }
  sheet::Layer layer = sheet::empty_layer(drawing.name, scene::SheetLine::symbol, widths);
  sheet::add_gravity_symbol(layer, drawing.shown.breaks.moved(whole), radius);
  marks.push_back(std::move(layer));
}

// Sorted by the names of their sections.
std::vector<sheet::Layer> marks_of(std::span<const Annotations> annotations, std::span<const ViewResult> views,
                                   const sheet::LineWidths& widths) {
  std::map<std::string, sheet::Layer> by_name;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::vector<cut::CuttingSurface>& planes = annotations[i].planes;
    std::vector<std::optional<sheet::Layer>> lines = sheet::cutting_plane_lines(views[i].drawing, planes, widths);
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
      if (lines[plane]) by_name.emplace(planes[plane].plane.name, std::move(*lines[plane]));
  }
  std::vector<sheet::Layer> marks;
  for (auto& [name, mark] : by_name) marks.push_back(std::move(mark));
  for (std::size_t i = 0; i < views.size(); ++i) {
    const drawing::ViewDrawing& drawing = views[i].drawing;
    std::vector<sheet::SightArrow> arrows;
    for (const ViewArrow& arrow : annotations[i].arrows)
      arrows.push_back({arrow.letter, arrow.sight, (drawing.box.min + drawing.box.max) / 2.0});
    if (!arrows.empty()) marks.push_back(sheet::sight_arrows(drawing, arrows, widths));
    if (annotations[i].centre_of_gravity) add_gravity(marks, drawing, *annotations[i].centre_of_gravity, widths);
  }
  return marks;
}

// The lines around details in the views that they enlarge.
sheet::Layer boundaries_of(std::span<const Annotations> annotations, std::span<const ViewResult> views) {
  sheet::Layer layer;
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const scene::DetailDescription& detail : annotations[i].details)
      layer.strokes.push_back(sheet::boundary_line(boundary_on_page(detail, views[i].drawing)));
  return layer;
}

// Faults of the dimensions of one view on paper.
void note_faults(std::vector<report::Finding>& findings, const std::string& view, const sheet::PlacedLayer& placed,
                 const sheet::Paper& paper) {
  for (const std::string& fan : placed.fans)
    findings.push_back({report::FindingKind::fan, view, "too many ordinates on one side: '" + fan + "'"});
  for (const sheet::Text& text : placed.layer.texts)
    if (text.height < sheet::smallest_lettering)
      findings.push_back({report::FindingKind::small_text, view, "'" + text.text + "'"});
  if (!sheet::on_paper(placed.layer, {paper.width, paper.height}))
    findings.push_back({report::FindingKind::off_sheet, view, "dimensions extend beyond the sheet"});
}

std::vector<std::string> captions_of(const SheetInput& input) {
  const std::string language = input.sheet().field("language");
  return {std::string(sheet::caption("hole", language)), "X", "Y", std::string(sheet::caption("hole_size", language))};
}

// Of objects, only tables are in both.
void append(sheet::Layer& layer, sheet::Layer more) {
  for (sheet::TableObject& table : more.tables) {
    table.strokes = {table.strokes.begin + layer.strokes.size(), table.strokes.end + layer.strokes.size()};
    table.texts = {table.texts.begin + layer.texts.size(), table.texts.end + layer.texts.size()};
    layer.tables.push_back(std::move(table));
  }
  std::move(more.strokes.begin(), more.strokes.end(), std::back_inserter(layer.strokes));
  std::move(more.fills.begin(), more.fills.end(), std::back_inserter(layer.fills));
  std::move(more.texts.begin(), more.texts.end(), std::back_inserter(layer.texts));
}

// Adds a table of holes where the sheet is free, in as few blocks of rows as fit; returns false if there is no room.
bool add_table(sheet::Layer& layer, const sheet::HoleTable& table, const std::vector<std::string>& captions,
               const sheet::Rectangle& room, const std::vector<sheet::Rectangle>& taken,
               const sheet::DimensionStyle& style) {
  constexpr int max_blocks = 6;
  for (int blocks = 1; blocks <= max_blocks; ++blocks) {
    const sheet::TableDrawing drawing(sheet::text_table(table, captions), blocks, style);
    const auto corner = sheet::free_corner(room, taken, drawing.size());
    if (corner) drawing.draw(layer, *corner, "dimension");
    if (corner) return true;
  }
  return false;
}

void tell_left_out(AnnotationLayers& result, const sheet::HoleTable& table) {
  result.warnings.push_back("the sheet has no room for the table of the holes in the view '" + table.view +
                            "'\n  hint: use a larger sheet or a smaller scale");
  result.without_room += table.rows.size();
  for (const sheet::HoleRow& row : table.rows)
    result.findings.push_back({report::FindingKind::undimensioned, table.view,
                               "there is no room for the table with '" + row.label + "', " + row.size});
}

// In the layers of the dimensions, when everything else is in place.
void add_tables(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  const auto captions = captions_of(input);
  std::vector<sheet::Layer> of_views(views.size());
  const auto for_all = [&](const auto& act) {
    for (std::size_t i = 0; i < views.size(); ++i)
      for (const sheet::HoleTable& table : input.annotations[i].tables) act(i, table);
  };
  for_all([&](std::size_t i, const sheet::HoleTable& table) {
    sheet::draw_origin(of_views[i], table, views[i].drawing, style);
    add_boxes(around.boxes, of_views[i], style.lettering);
  });
  for_all([&](std::size_t i, const sheet::HoleTable& table) {
    sheet::Layer own;
    if (!add_table(own, table, captions, *around.paper, taken_by(around, views), style)) tell_left_out(result, table);
    add_boxes(around.boxes, own, style.lettering);
    append(of_views[i], std::move(own));
  });
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::string& name = views[i].drawing.name;
    const auto layer = std::find_if(result.layers.begin(), result.layers.end(),
                                    [&name](const sheet::Layer& one) { return one.name.starts_with(name + "/"); });
    if (layer != result.layers.end()) append(*layer, std::move(of_views[i]));
  }
}

// Notes and symbols on this sheet without leaders.
std::vector<scene::CalloutDescription> callouts_of_sheet(const SheetInput& input) {
  const auto is_texture = [](const ViewCallout& callout) {
    return std::holds_alternative<scene::SurfaceTexture>(callout.description.content);
  };
  const bool has_textures =
      std::any_of(input.annotations.begin(), input.annotations.end(), [&is_texture](const Annotations& view) {
        return std::any_of(view.callouts.begin(), view.callouts.end(), is_texture);
      });
  std::vector<scene::CalloutDescription> callouts;
  for (const scene::CalloutDescription& one : input.scene.callouts) {
    if (one.to.given() || one.dimension.given() || one.sheet.value_or(1) != input.views.sheet + 1) continue;
    callouts.push_back(one);
    if (auto* texture = std::get_if<scene::SurfaceTexture>(&callouts.back().content)) texture->others = has_textures;
  }
  return callouts;
}

void tell_left_out(AnnotationLayers& result, const std::string& what, const std::string& hint) {
  result.warnings.push_back("the sheet has no room for " + what + "\n  hint: " + hint);
  result.findings.push_back({report::FindingKind::off_sheet, "", "there is no room for " + what});
  ++result.without_room;
}

std::string table_name(const scene::TableDescription& table) {
  return table.title.given() ? "the table '" + *table.title + "'" : std::string("the table");
}

std::vector<scene::TableDescription> tables_of_sheet(const SheetInput& input) {
  std::vector<scene::TableDescription> tables = input.scene.tables;
  std::erase_if(tables, [&](const auto& table) { return table.sheet.value_or(1) != input.views.sheet + 1; });
  return tables;
}

sheet::TableDrawing table_drawing(const scene::TableDescription& table, const sheet::DimensionStyle& style) {
  return {{table.title.value_or(""), table.header, table.rows}, 1, style};
}

/// What has a given position on the sheet.
struct Reserved {
  std::size_t view;  ///< to which it belongs; of what belongs to none, their number
  sheet::TurnedBox box;
};

// Throws Error{input} for positions beyond the sheet.
std::vector<Reserved> reserved_for(const SheetInput& input, const sheet::DimensionStyle& style) {
  const sheet::Paper& paper = input.plan.furniture.paper;
  const sheet::Rectangle whole{{0, 0}, {paper.width, paper.height}};
  std::vector<Reserved> all;
  const auto reserve = [&](std::size_t view, const sheet::Rectangle& box, const std::string& name,
                           const std::string& where) {
    if (!whole.holds(box))
      throw Error(ErrorKind::input, where, name + " does not fit on the sheet at this position",
                  "it is " + format_rounded(box.size().x, 4) + " by " + format_rounded(box.size().y, 4) +
                      " mm large, below and on the right of its position; the sheet has " +
                      format_rounded(paper.width, 4) + " by " + format_rounded(paper.height, 4) + " mm");
    all.push_back({view, sheet::turned_box(box)});
  };
  const auto add = [&](std::size_t view, const scene::CalloutDescription& callout) {
    if (callout.at.given())
      reserve(view, sheet::box_at(drawn(callout, style), *callout.at), name_of(callout), callout.at.where);
  };
  const std::size_t none = input.annotations.size();
  for (std::size_t view = 0; view < none; ++view)
    for (const ViewCallout& callout : input.annotations[view].callouts) add(view, callout.description);
  for (const scene::CalloutDescription& callout : callouts_of_sheet(input)) add(none, callout);
  for (const scene::TableDescription& table : tables_of_sheet(input)) {
    if (!table.at.given()) continue;
    const Vec2 size = table_drawing(table, style).size();
    reserve(none, {*table.at - Vec2(0, size.y), *table.at + Vec2(size.x, 0)}, table_name(table), table.at.where);
  }
  return all;
}

// Those that have ink.
void add_layers(std::vector<sheet::Layer>& layers, sheet::Neighbours& around, sheet::CalloutLayers more,
                const sheet::Lettering& lettering) {
  add_boxes(around.boxes, more.notes, lettering);
  add_outlines(around.boxes, more.symbols);
  for (sheet::Layer* layer : {&more.notes, &more.symbols})
    if (!layer->strokes.empty() || !layer->texts.empty()) layers.push_back(std::move(*layer));
}

// Everything that is in the way of dimensions of a view.
sheet::Neighbours in_the_way(const sheet::Neighbours& around, const SheetInput& input,
                             std::span<const ViewResult> views, std::size_t view, const sheet::DimensionStyle& style) {
  sheet::Neighbours neighbours = with_other_views(around, views, view);
  for (const sheet::HoleTable& table : input.annotations[view].tables) {
    sheet::Layer origin;
    sheet::draw_origin(origin, table, views[view].drawing, style);
    add_boxes(neighbours.boxes, origin, style.lettering);
    for (const sheet::Text& letter : origin.texts) neighbours.letters.push_back(sheet::box_of(letter, style.lettering));
  }
  return neighbours;
}

void tell_left_out(AnnotationLayers& result, const sheet::PlacedLayer& placed, std::size_t count,
                   const std::string& view) {
  if (placed.left_out.empty()) return;
  result.warnings.push_back("the sheet has no room for " + std::to_string(placed.left_out.size()) + " of the " +
                            std::to_string(count) + " dimensions of the view '" + view +
                            "', which are left out: " + first_of(placed.texts_left_out) +
                            "\n  hint: use a larger sheet or a larger scale, more views, or --dimensions hole-table");
  for (const std::string& text : placed.texts_left_out)
    result.findings.push_back({report::FindingKind::undimensioned, view, "there is no room for '" + text + "'"});
}

void tell_unseen(AnnotationLayers& result, const sheet::PlacedLayer& placed, const std::string& view) {
  if (placed.unseen.empty()) return;
  result.unseen_warnings.push_back(
      "the view '" + view + "' does not show what " + std::to_string(placed.unseen.size()) +
      " of its dimensions would measure, which are left out: " + first_of(placed.texts_unseen) +
      "\n  hint: add a view along the axis, or a section through it");
  for (const std::string& text : placed.texts_unseen)
    result.findings.push_back({report::FindingKind::undimensioned, view, "it does not show '" + text + "'"});
}

/// A view whose dimensions and callouts are placed.
struct ViewToAnnotate {
  const SheetInput& input;
  std::span<const ViewResult> views;
  std::size_t view;
  std::span<const Reserved> reserved;
  std::vector<sheet::Callout> callouts{};
};

// Of a view: first datums and frames in line with dimension lines, which show that they mean an axis or median plane
// (ISO 5459).
std::vector<sheet::Callout> callouts_of(AnnotationLayers& result, const SheetInput& input, std::size_t view,
                                        const sheet::DimensionStyle& style) {
  const Annotations& annotations = input.annotations[view];
  std::vector<sheet::Callout> callouts;
  std::map<std::string, std::size_t> ends;
  for (const scene::CalloutDescription& one : annotations.attached) {
    sheet::Callout& callout = callouts.emplace_back(drawn(one, style));
    callout.dimension = *one.dimension;
    callout.end = ends[callout.dimension]++;
    callout.is_alone = annotations.attached.size() == 1;
  }
  for (std::size_t k = 0; k < annotations.callouts.size(); ++k) {
    const scene::CalloutDescription& description = annotations.callouts[k].description;
    if (!input.targets[view][k]) result.unplaced.push_back(description.requirement);
    if (!input.targets[view][k]) continue;
    callouts.push_back(drawn(description, style));
    callouts.back().target = input.targets[view][k];
  }
  return callouts;
}

// Whether there is no end of a dimension line for a callout. Throws Error{input} if somebody asked for it.
bool lacks_end(const sheet::PlacedLayer& placed, const sheet::Callout& callout,
               std::span<const scene::CalloutDescription> attached) {
  if (callout.target) return false;
  const auto ends = placed.ends.find(callout.dimension);
  const bool lacks = ends == placed.ends.end() || ends->second.size() <= callout.end;
  if (!lacks || !callout.requirement.empty()) return lacks;
  const auto one = std::ranges::find_if(attached, [&](const auto& of) { return *of.dimension == callout.dimension; });
  throw Error(ErrorKind::input, one->dimension.where,
              "dimension '" + callout.dimension + "' has no free end of a straight dimension line for " + callout.name,
              "refer to a length, or to a diameter in a view across its axis, to which nothing else is attached");
}

void add_callouts(AnnotationLayers& result, sheet::Neighbours& around, const ViewToAnnotate& of,
                  const sheet::DimensionStyle& style, const sheet::PlacedLayer& placed) {
  const sheet::SheetFurniture& furniture = of.input.plan.furniture;
  const drawing::ViewDrawing& drawing = of.views[of.view].drawing;
  const std::vector<sheet::Callout>& callouts = of.callouts;
  sheet::CalloutLayers layers = sheet::callout_layers(drawing.name, style);
  const sheet::CalloutFaults faults = sheet::draw_callouts(layers, callouts, placed, style);
  for (const auto& [number, box] : faults.places) result.places.push_back({callouts[number].requirement, of.view, box});
  if (auto areas =
          sheet::target_areas(drawing, callouts, faults, sheet::line_widths(furniture.paper, furniture.styles)))
    result.layers.push_back(std::move(*areas));
  for (const std::size_t number : faults.without_place) {
    const std::string& name = callouts[number].name;
    result.unplaced.push_back(callouts[number].requirement);
    if (lacks_end(placed, callouts[number], of.input.annotations[of.view].attached)) continue;
    result.warnings.push_back("there is no place for " + name + " around the view '" + drawing.name +
                              "'\n  hint: use a larger sheet or a smaller scale, or give its position, 'at'");
    result.findings.push_back({report::FindingKind::off_sheet, drawing.name, "there is no place for " + name});
    ++result.without_room;
  }
  add_layers(result.layers, around, std::move(layers), style.lettering);
}

// Dimensions, notes and symbols, in layers of their own.
void add_annotations(AnnotationLayers& result, sheet::Neighbours& around, ViewToAnnotate of,
                     const sheet::DimensionStyle& style, const Budget& budget) {
  const drawing::ViewDrawing& drawing = of.views[of.view].drawing;
  const sheet::Paper& paper = of.input.plan.furniture.paper;
  const WantedDimensions wanted = dimensions_of(of.input.annotations[of.view], of.views[of.view]);
  of.callouts = callouts_of(result, of.input, of.view, style);
  if (wanted.dimensions.empty() && of.callouts.empty()) return;
  sheet::Neighbours neighbours = in_the_way(around, of.input, of.views, of.view, style);
  for (const Reserved& one : of.reserved)
    if (one.view != of.view) neighbours.boxes.push_back(one.box);
  const bool lacks_lines = !of.views[of.view].partial.stages.empty();
  const std::vector<sheet::ItemBeside> items = sheet::callout_items(of.callouts, drawing, style);
  sheet::PlacedLayer placed =
      sheet::place_dimensions({of.input.world, drawing, wanted.dimensions, wanted.found, lacks_lines, wanted.equal,
                               items, of.input.views.plans[of.view].options.turned.has_value()},
                              style, neighbours, budget.run.with_part_of_the_time(0.5));
  note_faults(result.findings, drawing.name, placed, paper);
  result.is_crowded = result.is_crowded || placed.has_conflicts;
  tell_left_out(result, placed, wanted.dimensions.size(), drawing.name);
  tell_unseen(result, placed, drawing.name);
  for (const std::size_t number : placed.left_out) result.left_out[of.view].push_back(wanted.numbers[number]);
  for (const std::size_t number : placed.unseen) result.unseen[of.view].push_back(wanted.numbers[number]);
  for (const std::size_t number : placed.undrawn(wanted.dimensions.size()))
    result.unplaced.push_back(wanted.dimensions[number].requirement);
  for (const auto& [number, box] : placed.places)
    result.places.push_back({wanted.dimensions[number].requirement, of.view, box});
  const std::size_t undrawn = wanted.dimensions.size() - placed.count;
  if (undrawn > 0) budget.partial.add_stage("placing dimensions");
  budget.partial.undrawn += static_cast<long long>(undrawn);
  if (!sheet::on_paper(placed.layer, {paper.width, paper.height}))
    result.warnings.push_back("dimensions of the view '" + drawing.name +
                              "' extend beyond the sheet\n  hint: use a smaller scale or a larger sheet");
  sheet::take_out_replaced(placed, of.callouts);
  add_boxes(around.boxes, placed.layer, style.lettering);
  around.zones.insert(around.zones.end(), placed.zones.begin(), placed.zones.end());
  for (const sheet::Text& text : placed.layer.texts) around.texts.push_back(sheet::box_of(text, style.lettering));
  if (!wanted.dimensions.empty()) result.layers.push_back(std::move(placed.layer));
  add_callouts(result, around, of, style, placed);
}

// Adds a callout in the free room nearest to a point; returns its box, or nothing if there is no room.
std::optional<sheet::Rectangle> add_near(sheet::CalloutLayers& layers, const sheet::Callout& callout,
                                         const sheet::Rectangle& room, std::span<const sheet::Rectangle> taken,
                                         const Vec2& towards) {
  const auto corner = sheet::nearest_free_position(room, taken, callout.size, towards);
  if (!corner) return std::nullopt;
  const Vec2 upper_left = *corner + Vec2(0, callout.size.y);
  sheet::draw_at(layers, callout, upper_left);
  return sheet::box_at(callout, upper_left);
}

Vec2 position_of(SheetCorner corner, const sheet::Rectangle& area) {
  const bool left = corner == SheetCorner::top_left || corner == SheetCorner::bottom_left;
  const bool top = corner == SheetCorner::top_left || corner == SheetCorner::top_right;
  return {left ? area.min.x : area.max.x, top ? area.max.y : area.min.y};
}

// Tables of texts: where they are told, or in the free room nearest to a corner.
void add_text_tables(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                     std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  sheet::Layer layer = sheet::empty_layer("sheet", scene::SheetLine::table,
                                          sheet::line_widths(input.plan.furniture.paper, input.plan.furniture.styles));
  const std::vector<scene::TableDescription> tables = tables_of_sheet(input);
  const auto add = [&](const scene::TableDescription& table, const Vec2& lower_left) {
    sheet::Layer own;
    const sheet::TableDrawing drawing = table_drawing(table, style);
    drawing.draw(own, lower_left + drawing.size(), "table");
    around.boxes.push_back(sheet::turned_box({lower_left, lower_left + drawing.size()}));
    append(layer, std::move(own));
  };
  for (const scene::TableDescription& table : tables)
    if (table.at.given()) add(table, *table.at - Vec2(0, table_drawing(table, style).size().y));
  for (const scene::TableDescription& table : tables) {
    if (table.at.given()) continue;
    std::vector<sheet::Rectangle> taken = taken_by(around, views);
    const Vec2 towards = position_of(table.corner.value_or(SheetCorner::top_right), *around.paper);
    if (const auto at = sheet::nearest_free_position(*around.paper, taken, table_drawing(table, style).size(), towards))
      add(table, *at);
    else
      tell_left_out(result, table_name(table), "use a larger sheet or a smaller scale");
  }
  if (!tables.empty()) result.layers.push_back(std::move(layer));
}

// Notes that belong to the whole sheet, numbered, in the free room nearest to its lower left corner.
bool add_general_notes(sheet::CalloutLayers& layers, const std::vector<std::vector<std::string>>& notes,
                       const std::string& heading, const sheet::Rectangle& room,
                       std::span<const sheet::Rectangle> taken, const sheet::DimensionStyle& style) {
  constexpr std::array<double, 4> widths{120, 90, 65, 180};  // mm, preferred first
  return std::any_of(widths.begin(), widths.end(), [&](double width) {
    return add_near(layers, sheet::general_notes(heading, notes, width, style), room, taken, room.min).has_value();
  });
}

// What stands on the sheet without a leader: where it is told, notes in a list, symbols beside the title block.
void add_free_callouts(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                       std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  sheet::CalloutLayers layers = sheet::callout_layers("sheet", style);
  std::vector<std::vector<std::string>> notes;
  std::vector<std::string> required;
  std::vector<scene::CalloutDescription> symbols;
  for (const scene::CalloutDescription& callout : callouts_of_sheet(input)) {
    const auto* note = std::get_if<scene::NoteText>(&callout.content);
    if (callout.at.given())
      sheet::draw_at(layers, drawn(callout, style), *callout.at);
    else if (note != nullptr)
      notes.push_back(note->lines), required.push_back(callout.requirement);
    else
      symbols.push_back(callout);
  }
  add_boxes(around.boxes, layers.notes, style.lettering);
  add_outlines(around.boxes, layers.symbols);
  std::vector<sheet::Rectangle> taken = taken_by(around, views);
  const auto warn = [&result](const std::string& what) {
    tell_left_out(result, what, "use a larger sheet or a smaller scale, or give its position, 'at'");
  };
  const sheet::Rectangle& room = *around.paper;
  for (const scene::CalloutDescription& symbol : symbols) {
    if (const auto box = add_near(layers, drawn(symbol, style), room, taken, {room.max.x, room.min.y}))
      taken.push_back(*box);
    else
      warn(name_of(symbol));
  }
  const std::string heading(sheet::caption("notes", input.sheet().field("language")));
  if (!notes.empty() && !add_general_notes(layers, notes, heading, room, taken, style))
    warn("the general notes"), std::ranges::copy(required, std::back_inserter(result.unplaced));
  add_layers(result.layers, around, std::move(layers), style.lettering);
}

// Beside the dimensions and symbols of a view that draw requirements.
std::vector<sheet::BalloonTarget> characteristics_in(std::span<const RequirementPlace> places, std::size_t view,
                                                     const std::map<std::string, int>& numbers) {
  std::vector<sheet::BalloonTarget> targets;
  for (const RequirementPlace& place : places)
    for (const std::string_view key :
         place.view == view ? split(place.requirement, ' ') : std::vector<std::string_view>())
      if (const auto found = numbers.find(std::string(key)); found != numbers.end())
        targets.push_back({std::to_string(found->second), place.box.centre, false, place.box});
  return targets;
}

// The space that arrows, marks of sections and dimensions leave around the views.
void add_balloons(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                  std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  const sheet::LineWidths widths = sheet::line_widths(input.plan.furniture.paper, input.plan.furniture.styles);
  const auto add = [&](std::size_t i, const std::vector<sheet::BalloonTarget>& targets, const std::string& what) {
    if (targets.empty()) return;
    const drawing::ViewDrawing& drawing = views[i].drawing;
    sheet::Layer layer = sheet::empty_layer(drawing.name, scene::SheetLine::balloon, widths);
    const sheet::Neighbours neighbours =  // those beside texts are amid lines
        targets.front().beside ? in_the_way(around, input, views, i, style) : with_other_views(around, views, i);
    for (const std::string& number : sheet::place_balloons(layer, targets, drawing, style, neighbours)) {
      const std::string missing = "there is no place for the balloon of " + what + " " + number;
      result.warnings.push_back(missing + " around the view '" + drawing.name +
                                "'\n  hint: use a larger sheet or a smaller scale");
      result.findings.push_back({report::FindingKind::off_sheet, drawing.name, missing});
      ++result.without_room;
    }
    add_boxes(around.boxes, layer, style.lettering);
    result.layers.push_back(std::move(layer));
  };
  for (std::size_t i = 0; i < input.balloons.size(); ++i) add(i, input.balloons[i], "item");
  for (std::size_t i = 0; i < views.size() && !input.characteristics.empty(); ++i)
    add(i, characteristics_in(result.places, i, input.characteristics), "characteristic");
}

// Besides dimensions.
bool has_lettering(const SheetInput& input, std::span<const ViewResult> views) {
  if (std::any_of(views.begin(), views.end(),
                  [](const auto& view) { return view.drawing.aids.construction != nullptr; }))
    return true;
  const auto is_given = [](const auto& view) { return !view.empty(); };
  return std::any_of(input.balloons.begin(), input.balloons.end(), is_given) ||
         std::any_of(input.targets.begin(), input.targets.end(), is_given) || !callouts_of_sheet(input).empty() ||
         !tables_of_sheet(input).empty();
}

}  // namespace

bool AnnotationLayers::leaves_out_more_than(const std::optional<std::size_t>& most) const {
  std::size_t count = 0;
  for (const std::vector<std::size_t>& of_view : left_out) count += of_view.size();
  return most && count > *most;
}

AnnotationLayers annotation_layers(const SheetInput& input, std::span<const ViewResult> views,
                                   const std::vector<sheet::Text>& labels, const Budget& budget) {
  const sheet::SheetFurniture& furniture = input.plan.furniture;
  const sheet::Paper& paper = furniture.paper;
  const sheet::LineWidths widths = sheet::line_widths(paper, furniture.styles);
  const sheet::Notation notation =
      notation_of(input.world, input.scene.sheets[static_cast<std::size_t>(input.views.sheet)]);
  AnnotationLayers result;
  std::vector<sheet::Layer> marks = marks_of(input.annotations, views, widths);
  std::optional<sheet::Lettering> lettering;
  sheet::Neighbours around;
  std::vector<Reserved> reserved;
  const auto style = [&] {
    return sheet::DimensionStyle{*lettering, widths.narrow, dimension_text_height(paper, views.size()), notation};
  };
  const auto open_font = [&] {
    if (lettering) return;
    around = neighbours_of(furniture, labels, marks, lettering.emplace(furniture.font));
    add_boxes(around.boxes, boundaries_of(input.annotations, views), *lettering);
    add_centre_lines(around.boxes, input, views, *lettering);
    reserved = reserved_for(input, style());
  };
  result.constructions.resize(views.size());
  if (has_lettering(input, views)) {
    open_font();
    add_constructions(result, around, input, views, style());
  }
  result.left_out.resize(views.size());
  result.unseen.resize(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (input.annotations[i].dimensions.empty() && input.annotations[i].callouts.empty()) continue;
    open_font();
    add_annotations(result, around, {input, views, i, reserved}, style(), budget);
    if (result.leaves_out_more_than(input.max_left_out)) return result;
  }
  if (lettering) {
    add_balloons(result, around, input, views, style());
    add_tables(result, around, input, views, style());
    add_text_tables(result, around, input, views, style());
    add_free_callouts(result, around, input, views, style());
  }
  std::move(marks.begin(), marks.end(), std::back_inserter(result.layers));
  return result;
}

}  // namespace epura::pipeline
