// SPDX-License-Identifier: Apache-2.0
// DXF: the shapes, fills and texts of a sheet as entities in millimetres.
#include <cmath>
#include <cstddef>
#include <string_view>
#include <variant>

#include "base/error.hpp"
#include "output/dxf_shapes.hpp"
#include "output/dxf_tables.hpp"
#include "output/dxf_writer.hpp"
#include "output/write.hpp"

namespace epura::output {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

/// The owner of an entity, its layer and its line type.
struct Place {
  int owner;
  const std::string& layer;
  bool dashed;      ///< whether the layer has a dashed line type
  bool continuous;  ///< whether this line is continuous, regardless of its layer
};

void begin_entity(DxfWriter& dxf, const Place& place, std::string_view type, std::string_view entity_class) {
  dxf.begin(type, place.owner, "AcDbEntity");
  dxf.add(8, place.layer);
  if (place.dashed && place.continuous) dxf.add(6, "CONTINUOUS");
  dxf.add(100, entity_class);
}

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

// One hatch, with rings filled by the even-odd rule.
void add_fill(DxfWriter& dxf, const Place& place, const sheet::Fill& fill) {
  begin_entity(dxf, place, "HATCH", "AcDbHatch");
  dxf.add(10, Vec2(0, 0));
  dxf.add(30, 0);
  dxf.add(210, Vec2(0, 0));
  dxf.add(230, 1);
  dxf.add(2, "SOLID");
  dxf.add(70, 1);
  dxf.add(71, 0);
  dxf.add(91, static_cast<int>(fill.rings.size()));
  for (const auto& ring : fill.rings) {
    dxf.add(92, 3);  // a polyline, and external
    dxf.add(72, 0);  // without bulges
    dxf.add(73, 1);  // closed
    dxf.add(93, static_cast<int>(ring.size()));
    for (const Vec2& p : ring) dxf.add(10, p);
    dxf.add(97, 0);
  }
  dxf.add(75, 0);  // even-odd
  dxf.add(76, 1);
  dxf.add(98, 0);
}

void add_text(DxfWriter& dxf, const Place& place, const sheet::Text& text) {
  begin_entity(dxf, place, "TEXT", "AcDbText");
  dxf.add(10, text.at);
  dxf.add(40, text.height);
  dxf.add(1, dxf_text(text.text));
  dxf.add(50, text.angle);
  dxf.add(7, dxf_text_style);
  dxf.add(72, static_cast<int>(text.align));
  if (text.align != sheet::Align::left) dxf.add(11, text.at);
  dxf.add(100, "AcDbText");
}

void add_layer(DxfWriter& dxf, int owner, const std::string& name, const sheet::Layer& layer,
               const Progress& progress) {
  const bool dashed = layer.style.dashes.dash > 0;
  for (const sheet::Fill& fill : layer.fills)
    if (!fill.rings.empty()) add_fill(dxf, {owner, name, false, true}, fill);
  for (const sheet::Stroke& stroke : layer.strokes) {
    progress.expect_time();
    progress.advance(1);
    if (stroke.points.size() < 2) continue;
    const Place place{owner, name, dashed, !(stroke.dashes.dash > 0) && stroke.pattern.empty()};
    for (const DxfShape& shape : dxf_shapes(stroke))
      std::visit([&](const auto& kind) { add_shape(dxf, place, kind); }, shape);
  }
  for (const sheet::Text& text : layer.texts) add_text(dxf, {owner, name, false, true}, text);
}

void add_insert(DxfWriter& dxf, int model_space, const DxfBlock& block) {
  const std::string layer = "0";
  begin_entity(dxf, {model_space, layer, false, true}, "INSERT", "AcDbBlockReference");
  dxf.add(2, block.name);
  dxf.add(10, block.base);
}

/// The views that become blocks, and the index of the one that each layer belongs to; -1: none.
struct Blocks {
  std::vector<DxfBlock> blocks;
  std::vector<int> of_layer;
};

Blocks blocks_of(const sheet::Sheet& sheet, bool wanted) {
  Blocks result;
  result.of_layer.assign(sheet.layers.size(), -1);
  if (!wanted) return result;
  std::vector<std::string> names;
  for (const sheet::ViewFrame& view : sheet.views) names.push_back(view.name);
  const std::vector<std::string> in_file = dxf_names(names, {});
  for (std::size_t v = 0; v < sheet.views.size(); ++v) {
    result.blocks.push_back({in_file[v], (sheet.views[v].min + sheet.views[v].max) * 0.5});
    for (std::size_t i = 0; i < sheet.layers.size(); ++i)
      if (result.of_layer[i] < 0 && sheet.layers[i].name.starts_with(names[v] + "/"))
        result.of_layer[i] = static_cast<int>(v);
  }
  return result;
}

}  // namespace

std::string to_dxf(const sheet::Sheet& sheet, const VectorOptions& options, const Progress& progress) {
  std::vector<std::string> names;
  for (const sheet::Layer& layer : sheet.layers) names.push_back(layer.name);
  names = dxf_names(names, {"0"});
  const Blocks blocks = blocks_of(sheet, options.dxf_blocks);
  DxfWriter dxf;
  const auto add_layers_of = [&](int block, int owner) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (blocks.of_layer[i] == block) add_layer(dxf, owner, names[i], sheet.layers[i], progress);
  };
  const int model_space = add_dxf_tables(dxf, sheet, names, blocks.blocks, [&](std::size_t block, int owner) {
    add_layers_of(static_cast<int>(block), owner);
  });
  dxf.add(0, "SECTION");
  dxf.add(2, "ENTITIES");
  for (const DxfBlock& block : blocks.blocks) add_insert(dxf, model_space, block);
  add_layers_of(-1, model_space);
  dxf.add(0, "ENDSEC");
  add_dxf_objects(dxf);
  return dxf_header(sheet, dxf.handles()) + dxf.take();
}

}  // namespace epura::output
