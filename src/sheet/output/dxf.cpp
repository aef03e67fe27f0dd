// SPDX-License-Identifier: Apache-2.0
// DXF: the shapes, fills and texts of a sheet as entities in millimetres.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
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
  std::vector<std::string> blocks;  ///< with the ink of its dimensions
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

// The ink of a layer outside its objects, and these.
void add_layer(DxfWriter& dxf, int owner, const LayerInFile& layer, const VectorOptions& options,
               const Progress& progress) {
  const DxfEntities& wanted = options.dxf_entities;
  const auto& dimensions = layer.layer.dimensions;
  const auto& hatched = layer.layer.hatched;
  const auto each_outside = [&](const auto& ink, const auto& of_dimension, const auto& add) {
    std::size_t dimension = wanted.dimensions ? 0 : dimensions.size(), hatch = wanted.hatches ? 0 : hatched.size();
    constexpr bool are_strokes = std::is_same_v<std::decay_t<decltype(ink[0])>, sheet::Stroke>;
    for (std::size_t i = 0; i < ink.size(); ++i) {
      while (dimension < dimensions.size() && of_dimension(dimensions[dimension]).end <= i) ++dimension;
      while (hatch < hatched.size() && hatched[hatch].strokes.end <= i) ++hatch;
      const bool in_dimension = dimension < dimensions.size() && of_dimension(dimensions[dimension]).begin <= i;
      const bool in_hatch = are_strokes && hatch < hatched.size() && hatched[hatch].strokes.begin <= i;
      if (!in_dimension && !in_hatch) add(ink[i]);
    }
  };
  each_outside(
      layer.layer.fills, [](const auto& one) { return one.fills; },
      [&](const sheet::Fill& fill) { add_fill(dxf, owner, layer, fill); });
  if (wanted.hatches)
    for (const sheet::HatchedFace& face : hatched) add_hatch(dxf, {owner, layer.name, false, true}, face);
  each_outside(
      layer.layer.strokes, [](const auto& one) { return one.strokes; },
      [&](const sheet::Stroke& stroke) {
        progress.expect_time();
        progress.advance(1);
        add_stroke(dxf, owner, layer, options.dxf_arcs, stroke);
      });
  each_outside(
      layer.layer.texts, [](const auto& one) { return one.texts; },
      [&](const sheet::Text& text) {
        add_text(dxf, {owner, layer.name, false, true}, text);
      });
  if (wanted.dimensions)
    for (std::size_t i = 0; i < dimensions.size(); ++i)
      add_dimension(dxf, {owner, layer.name, false, true}, dimensions[i], layer.blocks[i]);
}

// What a dimension looks like, for programs that do not draw dimensions themselves.
void add_ink_of(DxfWriter& dxf, int owner, const LayerInFile& layer, DxfArcs arcs,
                const sheet::DimensionObject& dimension) {
  for (std::size_t i = dimension.fills.begin; i < dimension.fills.end; ++i)
    add_fill(dxf, owner, layer, layer.layer.fills[i]);
  for (std::size_t i = dimension.strokes.begin; i < dimension.strokes.end; ++i)
    add_stroke(dxf, owner, layer, arcs, layer.layer.strokes[i]);
  for (std::size_t i = dimension.texts.begin; i < dimension.texts.end; ++i)
    add_text(dxf, {owner, layer.name, false, true}, layer.layer.texts[i]);
}

void add_insert(DxfWriter& dxf, int model_space, const DxfBlock& block) {
  const std::string layer = "0";
  begin_entity(dxf, {model_space, layer, false, true}, "INSERT", "AcDbBlockReference");
  dxf.add(2, block.name);
  dxf.add(10, block.place);
}

/// The blocks of the file: views, and then what dimensions look like.
struct Blocks {
  std::vector<DxfBlock> blocks{};
  std::size_t views = 0;
  std::vector<int> of_layer{};                             ///< the view that is a block; -1: none
  std::vector<std::array<std::size_t, 2>> of_dimension{};  ///< layer and number in it, for each block after the views
};

Blocks blocks_of(const sheet::Sheet& sheet, const VectorOptions& options) {
  Blocks result;
  result.of_layer.assign(sheet.layers.size(), -1);
  if (options.dxf_blocks) {
    std::vector<std::string> names;
    for (const sheet::ViewFrame& view : sheet.views) names.push_back(view.name);
    const std::vector<std::string> in_file = dxf_names(names, {}, options.dxf_version);
    for (std::size_t v = 0; v < sheet.views.size(); ++v) {
      result.blocks.push_back({in_file[v], (sheet.views[v].min + sheet.views[v].max) * 0.5});
      for (std::size_t i = 0; i < sheet.layers.size(); ++i)
        if (result.of_layer[i] < 0 && sheet.layers[i].name.starts_with(names[v] + "/"))
          result.of_layer[i] = static_cast<int>(v);
    }
  }
  result.views = result.blocks.size();
  if (!options.dxf_entities.dimensions) return result;
  for (std::size_t i = 0; i < sheet.layers.size(); ++i)
    for (std::size_t k = 0; k < sheet.layers[i].dimensions.size(); ++k) {
      result.of_dimension.push_back({i, k});
      result.blocks.push_back({"*D" + std::to_string(result.of_dimension.size()), Vec2(0), true});
    }
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

sheet::Layer moved(sheet::Layer layer, const Vec2& by) {
  for (sheet::Stroke& stroke : layer.strokes) move(stroke, by);
  for (sheet::Fill& fill : layer.fills) move(fill, by);
  for (sheet::Text& text : layer.texts) text.at += by;
  for (sheet::HatchedFace& hatched : layer.hatched) move(hatched, by);
  for (sheet::DimensionObject& dimension : layer.dimensions) move(dimension, by);
  return layer;
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
  for (std::size_t i = 0; i < names.size(); ++i) layers.push_back({in_blocks[i], names[i], {}});
  for (std::size_t k = 0; k < blocks.of_dimension.size(); ++k)
    layers[blocks.of_dimension[k][0]].blocks.push_back(blocks.blocks[blocks.views + k].name);
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
  const auto add_layers_of = [&](int view, int owner) {
    for (std::size_t i = 0; i < layers.size(); ++i)
      if (blocks.of_layer[i] == view) add_layer(dxf, owner, layers[i], options, progress);
  };
  const auto add_block = [&](std::size_t block, int owner) {
    if (block < blocks.views) return add_layers_of(static_cast<int>(block), owner);
    const auto [layer, number] = blocks.of_dimension[block - blocks.views];
    add_ink_of(dxf, owner, layers[layer], options.dxf_arcs, sheet.layers[layer].dimensions[number]);
  };
  std::vector<std::string> names;
  for (const LayerInFile& layer : layers) names.push_back(layer.name);
  const int model_space = add_dxf_tables(dxf, sheet, names, blocks.blocks, add_block);
  dxf.add(0, "SECTION");
  dxf.add(2, "ENTITIES");
  for (std::size_t view = 0; view < blocks.views; ++view) add_insert(dxf, model_space, blocks.blocks[view]);
  add_layers_of(-1, model_space);
  dxf.add(0, "ENDSEC");
  add_dxf_objects(dxf);
  return dxf_header(sheet, blocks.blocks, dxf.handles(), options.dxf_version) + dxf.take();
}

}  // namespace epura::output
