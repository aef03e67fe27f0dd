// SPDX-License-Identifier: Apache-2.0
// Entities of a DXF file for leaders, tolerance frames and tables, and the objects that these refer to.
#pragma once

#include <string>

#include "output/dxf_entities.hpp"
#include "output/dxf_tables.hpp"
#include "output/dxf_writer.hpp"
#include "output/vector_options.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// Names and ink of arrowheads other than the usual one, for arrows of length 1.
inline constexpr const char* dxf_dot_head = "_DotSmall";
inline constexpr const char* dxf_no_head = "_None";
void add_dot_head(DxfWriter& dxf, int owner);

/// A MULTILEADER; `head` is the handle of the block of its arrowhead, 0 for the usual one.
void add_leader(DxfWriter& dxf, const Place& place, const sheet::LeaderObject& leader, int head,
                const DxfHandles& handles);

/// A TOLERANCE.
void add_tolerance(DxfWriter& dxf, const Place& place, const sheet::ToleranceObject& tolerance);

/// An ACAD_TABLE whose `block` has its ink.
struct BlockOfTable {
  std::string name;
  int handle;
};
void add_table(DxfWriter& dxf, const Place& place, const sheet::TableObject& table, const BlockOfTable& block,
               const DxfHandles& handles);

/// The section that declares these entities.
void add_dxf_classes(DxfWriter& dxf, const DxfEntities& wanted);

/// Adds the sections after the entities: the objects.
void add_dxf_objects(DxfWriter& dxf, const DxfHandles& handles);

}  // namespace epura::output
