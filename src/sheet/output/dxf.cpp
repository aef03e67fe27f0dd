// SPDX-License-Identifier: Apache-2.0
// DXF: the shapes, fills and texts of a sheet as entities in millimetres.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "output/dxf_annotations.hpp"
#include "output/dxf_entities.hpp"
#include "output/dxf_shapes.hpp"
#include "output/dxf_tables.hpp"
#include "output/dxf_writer.hpp"
#include "output/write.hpp"

namespace epura::output {

namespace {

struct LayerInFile {
  const sheet::Layer& layer;  ///< where its block has its origin
  std::string name;
  std::vector<std::size_t> dimensions{}, tables{};  ///< numbers of the blocks with their ink
};

/// What all layers share.
struct Drawn {
  const VectorOptions& options;
  const std::vector<DxfBlock>& blocks;
  const DxfHandles& handles;
};

void add_shape(DxfWriter& dxf, const Place& place, const BulgedLine& line) {
  const auto& corners = line.corners;
  if (corners.size() == 2 && !line.closed && corners[0].bulge == 0) {
    begin_entity(dxf, place, "LINE", "AcDbLine");
    dxf.add(10, corners[0].at);
    dxf.add(11, corners[1].at);
    return;
  }
  constexpr int is_closed = 1, dashes_run_through_corners = 128;
  begin_entity(dxf, place, "LWPOLYLINE", "AcDbPolyline");
  dxf.add(90, static_cast<int>(corners.size()));
  dxf.add(70, (line.closed ? is_closed : 0) + (place.dashed ? dashes_run_through_corners : 0));
  for (const BulgedCorner& corner : corners) {
    dxf.add(10, corner.at);
    if (corner.bulge != 0) dxf.add(42, corner.bulge);
  }
}

void add_circle(DxfWriter& dxf, const Place& place, const EllipseArc& arc) {
  begin_entity(dxf, place, arc.whole() ? "CIRCLE" : "ARC", "AcDbCircle");
  dxf.add(10, arc.centre);
  dxf.add(40, glm::length(arc.major));
  if (arc.whole()) return;
  const double turned = std::atan2(arc.major.y, arc.major.x);
  dxf.add(100, "AcDbArc");
  dxf.add(50, (turned + arc.from) * degrees);
  dxf.add(51, (turned + arc.to) * degrees);
}

void add_shape(DxfWriter& dxf, const Place& place, const EllipseArc& arc) {
  if (arc.ratio == 1) return add_circle(dxf, place, arc);
  begin_entity(dxf, place, "ELLIPSE", "AcDbEllipse");
  dxf.add(10, arc.centre);
  dxf.add(30, 0);
  dxf.add(11, arc.major);
  dxf.add(31, 0);
  dxf.add(40, arc.ratio);
  dxf.add(41, arc.whole() ? 0 : arc.from);
  dxf.add(42, arc.whole() ? 360 / degrees : arc.to);
}

void add_text(DxfWriter& dxf, const Place& place, const sheet::Text& text) {
  begin_entity(dxf, place, "TEXT", "AcDbText");
  dxf.add(10, text.at);
  dxf.add(40, text.height);
  dxf.add(1, dxf_text(text.text, dxf.version()));
  dxf.add(50, text.angle);
  dxf.add(7, dxf_text_style);
  dxf.add(72, static_cast<int>(text.align));
  if (text.align != sheet::Align::left) dxf.add(11, text.at);
  dxf.add(100, "AcDbText");
}

void add_stroke(DxfWriter& dxf, int owner, const LayerInFile& layer, DxfArcs arcs, const sheet::Stroke& stroke) {
  if (stroke.points.size() < 2) return;
  const bool continuous = !(stroke.dashes.dash > 0) && stroke.pattern.empty();
  const Place place{owner, layer.name, layer.layer.style.dashes.dash > 0, continuous};
  for (const DxfShape& shape : dxf_shapes(place.dashed && !continuous ? with_arcs(stroke) : stroke, arcs))
    std::visit([&](const auto& kind) { add_shape(dxf, place, kind); }, shape);
}

void add_fill(DxfWriter& dxf, int owner, const LayerInFile& layer, const sheet::Fill& fill) {
  if (!fill.rings.empty()) add_solid(dxf, {owner, layer.name, false, true}, fill);
}

/// Ink of a layer that entities stand for.
struct Replaced {
  std::vector<sheet::InkRange> strokes{}, fills{}, texts{};

  template <class Objects>
  void add(bool wanted, const Objects& objects) {
    if (!wanted) return;
    for (const auto& object : objects) {
      strokes.push_back(object.strokes);
      if constexpr (requires { object.fills; }) fills.push_back(object.fills);
      if constexpr (requires { object.texts; }) texts.push_back(object.texts);
    }
  }
};

Replaced replaced_ink(const sheet::Layer& layer, const DxfEntities& wanted) {
  Replaced replaced;
  replaced.add(wanted.dimensions, layer.dimensions);
  replaced.add(wanted.hatches, layer.hatched);
  replaced.add(wanted.leaders, layer.leaders);
  replaced.add(wanted.tolerances, layer.tolerances);
  replaced.add(wanted.tables, layer.tables);
  return replaced;
}

template <class Ink, class Add>
void each_outside(const std::vector<Ink>& ink, std::vector<sheet::InkRange> ranges, const Add& add) {
  std::ranges::sort(ranges, {}, &sheet::InkRange::begin);
  auto range = ranges.begin();
  for (std::size_t i = 0; i < ink.size(); ++i) {
    while (range != ranges.end() && range->end <= i) ++range;
    if (range == ranges.end() || i < range->begin) add(ink[i]);
  }
}

int head_of(const sheet::LeaderObject& leader, const Drawn& drawn) {
  const char* name = leader.end == LeaderEnd::dot ? dxf_dot_head : leader.end == LeaderEnd::arrow ? "" : dxf_no_head;
  const auto block = std::ranges::find(drawn.blocks, name, &DxfBlock::name);
  return block == drawn.blocks.end() ? 0 : drawn.handles.block(static_cast<std::size_t>(block - drawn.blocks.begin()));
}

void add_objects(DxfWriter& dxf, const Place& place, const LayerInFile& layer, const Drawn& drawn) {
  const DxfEntities& wanted = drawn.options.dxf_entities;
  if (wanted.dimensions)
    for (std::size_t i = 0; i < layer.dimensions.size(); ++i)
      add_dimension(dxf, place, layer.layer.dimensions[i], drawn.blocks[layer.dimensions[i]].name);
  if (wanted.leaders)
    for (const sheet::LeaderObject& leader : layer.layer.leaders)
      add_leader(dxf, place, leader, head_of(leader, drawn), drawn.handles);
  if (wanted.tolerances)
    for (const sheet::ToleranceObject& tolerance : layer.layer.tolerances)
      if (!tolerance.rows.empty()) add_tolerance(dxf, place, tolerance);
  if (wanted.tables)
    for (std::size_t i = 0; i < layer.tables.size(); ++i)
      add_table(dxf, place, layer.layer.tables[i],
                {drawn.blocks[layer.tables[i]].name, drawn.handles.block(layer.tables[i])}, drawn.handles);
}

// The ink of a layer outside its objects, and these.
void add_layer(DxfWriter& dxf, int owner, const LayerInFile& layer, const Drawn& drawn, const Progress& progress) {
  const Replaced replaced = replaced_ink(layer.layer, drawn.options.dxf_entities);
  const Place place{owner, layer.name, false, true};
  each_outside(layer.layer.fills, replaced.fills, [&](const sheet::Fill& fill) { add_fill(dxf, owner, layer, fill); });
  if (drawn.options.dxf_entities.hatches)
    for (const sheet::HatchedFace& face : layer.layer.hatched) add_hatch(dxf, place, face);
  each_outside(layer.layer.strokes, replaced.strokes, [&](const sheet::Stroke& stroke) {
    progress.expect_time();
    progress.advance(1);
    add_stroke(dxf, owner, layer, drawn.options.dxf_arcs, stroke);
  });
  each_outside(layer.layer.texts, replaced.texts, [&](const sheet::Text& text) { add_text(dxf, place, text); });
  add_objects(dxf, place, layer, drawn);
}

void add_insert(DxfWriter& dxf, int model_space, const DxfBlock& block) {
  const std::string layer = "0";
  begin_entity(dxf, {model_space, layer, false, true}, "INSERT", "AcDbBlockReference");
  dxf.add(2, block.name);
  dxf.add(10, block.place);
}

/// An object of a layer, whose ink is a block.
struct OwnerOfInk {
  std::size_t layer, number;
};

/// The blocks of the file: views, then what dimensions and tables look like, then arrowheads.
struct Blocks {
  std::vector<DxfBlock> blocks{};
  std::size_t views = 0;
  std::vector<int> of_layer{};        ///< the view that is a block; -1: none
  std::vector<OwnerOfInk> objects{};  ///< of the blocks after the views
};

void add_views(Blocks& result, const sheet::Sheet& sheet, DxfVersion version) {
  std::vector<std::string> names;
  for (const sheet::ViewFrame& view : sheet.views) names.push_back(view.name);
  const std::vector<std::string> in_file = dxf_names(names, {}, version);
  for (std::size_t v = 0; v < sheet.views.size(); ++v) {
    result.blocks.push_back({in_file[v], (sheet.views[v].min + sheet.views[v].max) * 0.5});
    for (std::size_t i = 0; i < sheet.layers.size(); ++i)
      if (result.of_layer[i] < 0 && sheet.layers[i].name.starts_with(names[v] + "/"))
        result.of_layer[i] = static_cast<int>(v);
  }
  result.views = result.blocks.size();
}

// Anonymous ones are numbered.
template <class Object>
void add_objects(Blocks& result, const sheet::Sheet& sheet, std::vector<Object> sheet::Layer::*objects,
                 const DxfBlock& like) {
  int count = 0;
  for (std::size_t i = 0; i < sheet.layers.size(); ++i)
    for (std::size_t k = 0; k < (sheet.layers[i].*objects).size(); ++k) {
      result.objects.push_back({i, k});
      result.blocks.push_back({like.name + std::to_string(++count), Vec2(0), like.kind});
    }
}

Blocks blocks_of(const sheet::Sheet& sheet, const VectorOptions& options) {
  Blocks result;
  result.of_layer.assign(sheet.layers.size(), -1);
  if (options.dxf_blocks) add_views(result, sheet, options.dxf_version);
  if (options.dxf_entities.dimensions)
    add_objects(result, sheet, &sheet::Layer::dimensions, {"*D", Vec2(0), DxfBlockKind::dimension});
  if (options.dxf_entities.tables)
    add_objects(result, sheet, &sheet::Layer::tables, {"*T", Vec2(0), DxfBlockKind::table});
  if (options.dxf_entities.leaders)
    for (const char* head : {dxf_dot_head, dxf_no_head})
      result.blocks.push_back({head, Vec2(0), DxfBlockKind::arrowhead});
  return result;
}

void move(sheet::Stroke& stroke, const Vec2& by) {
  for (Vec2& point : stroke.points) point += by;
  for (drawing::CurvePart& curve : stroke.curves) curve.centre += by;
}

void move(sheet::Fill& fill, const Vec2& by) {
  for (auto& ring : fill.rings)
    for (Vec2& point : ring) point += by;
}

void move(sheet::HatchedFace& hatched, const Vec2& by) {
  move(hatched.face, by);
  for (sheet::HatchLines& lines : hatched.lines) {
    const double angle = lines.angle / degrees;
    lines.start += glm::dot(by, Vec2(-portable_sin(angle), portable_cos(angle)));
  }
}

void move(sheet::DimensionObject& dimension, const Vec2& by) {
  for (Vec2& point : dimension.points) point += by;
  dimension.text_middle += by;
}

void move(sheet::LeaderObject& leader, const Vec2& by) {
  for (Vec2& point : leader.points) point += by;
  leader.text_corner += by;
}

sheet::Layer moved(sheet::Layer layer, const Vec2& by) {
  for (sheet::Stroke& stroke : layer.strokes) move(stroke, by);
  for (sheet::Fill& fill : layer.fills) move(fill, by);
  for (sheet::Text& text : layer.texts) text.at += by;
  for (sheet::HatchedFace& hatched : layer.hatched) move(hatched, by);
  for (sheet::DimensionObject& dimension : layer.dimensions) move(dimension, by);
  for (sheet::LeaderObject& leader : layer.leaders) move(leader, by);
  for (sheet::ToleranceObject& tolerance : layer.tolerances) tolerance.at += by;
  for (sheet::TableObject& table : layer.tables) table.corner += by;
  return layer;
}

/// An object of a layer, whose ink is a block.
struct NumberedObject {
  DxfBlockKind kind;
  std::size_t number;
};

// What an entity looks like, for programs that do not draw it themselves: a dimension in the coordinates of its layer,
// a table with its upper left corner at the origin.
void add_ink_of(DxfWriter& dxf, int owner, const LayerInFile& layer, const NumberedObject& object, DxfArcs arcs) {
  sheet::Layer ink{layer.layer.name, layer.layer.style, {}};
  const auto take = [](auto& part, const auto& all, const sheet::InkRange& range) {
    part.assign(all.begin() + static_cast<std::ptrdiff_t>(range.begin),
                all.begin() + static_cast<std::ptrdiff_t>(range.end));
  };
  const auto take_ink_of = [&](const auto& one, const sheet::InkRange& fills) {
    take(ink.fills, layer.layer.fills, fills);
    take(ink.strokes, layer.layer.strokes, one.strokes);
    take(ink.texts, layer.layer.texts, one.texts);
  };
  if (object.kind == DxfBlockKind::table) {
    const sheet::TableObject& table = layer.layer.tables[object.number];
    take_ink_of(table, {});
    ink = moved(std::move(ink), -table.corner);
  } else {
    const sheet::DimensionObject& dimension = layer.layer.dimensions[object.number];
    take_ink_of(dimension, dimension.fills);
  }
  const LayerInFile own{ink, layer.name};
  for (const sheet::Fill& fill : ink.fills) add_fill(dxf, owner, own, fill);
  for (const sheet::Stroke& stroke : ink.strokes) add_stroke(dxf, owner, own, arcs, stroke);
  for (const sheet::Text& text : ink.texts) add_text(dxf, {owner, layer.name, false, true}, text);
}

// Height of the texts in tolerance frames; 0 if there are none.
double text_of_frames(const sheet::Sheet& sheet) {
  for (const sheet::Layer& layer : sheet.layers)
    for (const sheet::ToleranceObject& tolerance : layer.tolerances)
      if (!tolerance.rows.empty()) return tolerance.text_height;
  return 0;
}

// Layers of blocks have the coordinates of these.
std::vector<sheet::Layer> layers_in_blocks(std::vector<sheet::Layer> layers, const Blocks& blocks) {
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (const int view = blocks.of_layer[i]; view >= 0)
      layers[i] = moved(std::move(layers[i]), -blocks.blocks[static_cast<std::size_t>(view)].place);
  return layers;
}

std::vector<LayerInFile> layers_of(const std::vector<sheet::Layer>& in_blocks, const Blocks& blocks,
                                   DxfVersion version) {
  std::vector<std::string> names;
  for (const sheet::Layer& layer : in_blocks) names.push_back(layer.name);
  names = dxf_names(names, {"0"}, version);
  std::vector<LayerInFile> layers;
  for (std::size_t i = 0; i < names.size(); ++i) layers.push_back({in_blocks[i], names[i]});
  for (std::size_t k = 0; k < blocks.objects.size(); ++k) {
    const std::size_t block = blocks.views + k;
    LayerInFile& layer = layers[blocks.objects[k].layer];
    (blocks.blocks[block].kind == DxfBlockKind::table ? layer.tables : layer.dimensions).push_back(block);
  }
  return layers;
}

}  // namespace

std::string to_dxf(const sheet::Sheet& sheet, const VectorOptions& options, const Progress& progress) {
  const Blocks blocks = blocks_of(sheet, options);
  const std::vector<sheet::Layer> in_blocks =
      blocks.views == 0 ? std::vector<sheet::Layer>() : layers_in_blocks(sheet.layers, blocks);
  const std::vector<LayerInFile> layers =
      layers_of(blocks.views == 0 ? sheet.layers : in_blocks, blocks, options.dxf_version);
  DxfWriter dxf(options.dxf_version);
  const DxfEntities& entities = options.dxf_entities;
  DxfHandles handles;
  if (entities.leaders) handles.leader_style = dxf.next_handle();
  if (entities.tables) handles.table_style = dxf.next_handle();
  const auto add_layers_of = [&](int view, int owner) {
    for (std::size_t i = 0; i < layers.size(); ++i)
      if (blocks.of_layer[i] == view) add_layer(dxf, owner, layers[i], {options, blocks.blocks, handles}, progress);
  };
  const auto add_block = [&](std::size_t block, int owner) {
    if (block < blocks.views) return add_layers_of(static_cast<int>(block), owner);
    if (blocks.blocks[block].name == dxf_dot_head) return add_dot_head(dxf, owner);
    if (blocks.blocks[block].kind == DxfBlockKind::arrowhead) return;
    const auto& [layer, number] = blocks.objects[block - blocks.views];
    add_ink_of(dxf, owner, layers[layer], {blocks.blocks[block].kind, number}, options.dxf_arcs);
  };
  std::vector<std::string> names;
  for (const LayerInFile& layer : layers) names.push_back(layer.name);
  const double frame_text = entities.tolerances ? text_of_frames(sheet) : 0;
  add_dxf_tables(dxf, {sheet, names, blocks.blocks, frame_text}, handles, add_block);
  dxf.add(0, "SECTION");
  dxf.add(2, "ENTITIES");
  for (std::size_t view = 0; view < blocks.views; ++view) add_insert(dxf, handles.model_space, blocks.blocks[view]);
  add_layers_of(-1, handles.model_space);
  dxf.add(0, "ENDSEC");
  add_dxf_objects(dxf, handles);
  DxfWriter classes(options.dxf_version);
  add_dxf_classes(classes, entities);
  return dxf_header(sheet, blocks.blocks, dxf.handles(), options.dxf_version) + classes.take() + dxf.take();
}

}  // namespace epura::output
