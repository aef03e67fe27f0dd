// SPDX-License-Identifier: Apache-2.0
// Entities of a DXF file that stand for several lines: hatches and dimensions.
#pragma once

#include <string>
#include <string_view>

#include "output/dxf_writer.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// The owner of an entity, its layer and its line type.
struct Place {
  int owner;
  const std::string& layer;
  bool dashed;      ///< whether the layer has a dashed line type
  bool continuous;  ///< whether this line is continuous, regardless of its layer
};

void begin_entity(DxfWriter& dxf, const Place& place, std::string_view type, std::string_view entity_class);

/// A face filled by the even-odd rule.
void add_solid(DxfWriter& dxf, const Place& place, const sheet::Fill& fill);

/// A face with a pattern: named as in AutoCAD, and with the lines that it has on the sheet.
void add_hatch(DxfWriter& dxf, const Place& place, const sheet::HatchedFace& face);

/// What the lengths of a dimension in the file are multiplied by to give what it says; 1 for angles.
double factor_of(const sheet::DimensionObject& dimension);

/// A dimension whose `block` has its ink. Its text is the one on the sheet.
void add_dimension(DxfWriter& dxf, const Place& place, const sheet::DimensionObject& dimension,
                   const std::string& block);

}  // namespace epura::output
