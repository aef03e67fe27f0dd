// SPDX-License-Identifier: Apache-2.0
#include "output/dxf_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "output/dxf_entities.hpp"
#include "scene/line_roles.hpp"

namespace epura::output {

namespace {

// Calls `add_entries` with the handle of the table, which owns the entries.
template <class AddEntries>
void add_table(DxfWriter& dxf, std::string_view name, std::size_t entries, const AddEntries& add_entries) {
  dxf.add(0, "TABLE");
  dxf.add(2, name);
  const int table = dxf.next_handle();
  dxf.add_handle(5, table);
  dxf.add_handle(330, 0);
  dxf.add(100, "AcDbSymbolTable");
  dxf.add(70, static_cast<int>(entries));
  if (name == "DIMSTYLE") dxf.add(100, "AcDbDimStyleTable");
  add_entries(table);
  dxf.add(0, "ENDTAB");
}

int begin_entry(DxfWriter& dxf, std::string_view type, int table, std::string_view second_class,
                std::string_view name) {
  const int handle = dxf.begin(type, table, "AcDbSymbolTableRecord", second_class);
  dxf.add(2, name);
  dxf.add(70, 0);
  return handle;
}

// The whole sheet in the window.
void add_viewports(DxfWriter& dxf, const sheet::Sheet& sheet) {
  add_table(dxf, "VPORT", 1, [&](int table) {
    begin_entry(dxf, "VPORT", table, "AcDbViewportTableRecord", "*ACTIVE");
    dxf.add(10, Vec2(0, 0));
    dxf.add(11, Vec2(1, 1));
    dxf.add(12, Vec2(sheet.width, sheet.height) * 0.5);
    dxf.add(40, std::max({sheet.height, sheet.width / 1.5, 1.0}) * 1.05);
    dxf.add(41, 1.5);
  });
}

struct LineType {
  sheet::Dashes dashes;
  std::string name;
};

// One line type for each pattern of the sheet, the finest first. LibreCAD ignores the table and draws its own patterns
// of these names: those of DASHEDTINY and DASHED2 are close to the lengths for narrow and wide lines in millimetres,
// that of DASHED is four times as long.
std::vector<LineType> line_types(const sheet::Sheet& sheet) {
  std::vector<LineType> types;
  for (const sheet::Layer& layer : sheet.layers) {
    const sheet::Dashes& dashes = layer.style.dashes;
    const auto same = [&](const LineType& type) { return type.dashes == dashes; };
    if (dashes.dash > 0 && std::none_of(types.begin(), types.end(), same)) types.push_back({dashes, {}});
  }
  std::stable_sort(types.begin(), types.end(), [](const LineType& a, const LineType& b) {
    return std::pair(a.dashes.dots, a.dashes.dash) < std::pair(b.dashes.dots, b.dashes.dash);
  });
  std::map<std::string_view, int> named;
  for (LineType& type : types) {
    type.name = scene::type_with_dots(type.dashes.dots).dxf;
    const int number = ++named[scene::type_with_dots(type.dashes.dots).dxf];
    type.name += number == 1 ? "TINY" : std::to_string(number);
  }
  return types;
}

std::string line_type_of(const std::vector<LineType>& types, const sheet::Dashes& dashes) {
  for (const LineType& type : types)
    if (type.dashes == dashes) return type.name;
  return scene::continuous_line.dxf;
}

void add_line_type(DxfWriter& dxf, int table, std::string_view name, std::string_view remark,
                   const std::vector<double>& lengths) {
  begin_entry(dxf, "LTYPE", table, "AcDbLinetypeTableRecord", name);
  dxf.add(3, remark);
  dxf.add(72, 65);
  dxf.add(73, static_cast<int>(lengths.size()));
  double period = 0;
  for (const double length : lengths) period += std::abs(length);
  dxf.add(40, period);
  for (const double length : lengths) {
    dxf.add(49, length);
    dxf.add(74, 0);
  }
}

// Gaps are negative.
std::vector<double> lengths_of(const sheet::Dashes& dashes) {
  std::vector<double> lengths = {dashes.dash, -dashes.gap};
  for (int i = 0; i < dashes.dots; ++i) lengths.insert(lengths.end(), {dashes.dot, -dashes.gap});
  return lengths;
}

void add_line_types(DxfWriter& dxf, const std::vector<LineType>& types) {
  add_table(dxf, "LTYPE", types.size() + 3, [&](int table) {
    for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"}) add_line_type(dxf, table, name, "", {});
    for (const LineType& type : types) add_line_type(dxf, table, type.name, "ISO 128-2", lengths_of(type.dashes));
  });
}

// Hundredths of a millimetre. DXF allows only these.
int line_weight(double width) {
  constexpr std::array weights = {0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                  53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
  const auto distance = [&](int weight) { return std::abs(weight - 100 * width); };
  return *std::min_element(weights.begin(), weights.end(), [&](int a, int b) { return distance(a) < distance(b); });
}

struct Look {
  int colour, weight;
};

// A colour of AutoCAD's index with its number.
Colour indexed_colour(int number) {
  if (number >= 250) {
    const int grey = 51 * (number - 250);
    return {grey, grey, grey};
  }
  // From 10 on: 24 hues of 15 degrees, each in five values, of which every second is mixed with white in equal parts.
  constexpr std::array<int, 5> values = {255, 165, 127, 76, 38};
  const double hue = (number / 10 - 1) / 4.0;  // of six sides of the colour circle
  const int value = values[static_cast<std::size_t>(number % 10 / 2)];
  const auto part = [&](double peak) {
    const double apart = std::min(std::abs(hue - peak), 6 - std::abs(hue - peak));
    const double full = std::clamp(2 - apart, 0.0, 1.0);
    return static_cast<int>(value * (number % 2 == 0 ? full : (1 + full) / 2));
  };
  return {part(0), part(2), part(4)};
}

// The number of the nearest colour of AutoCAD's index; version 2000 has no others. Black is 7: black on white, white on
// black.
int colour_number(const Colour& colour) {
  if (colour == Colour{}) return 7;
  const auto distance = [&](int number) {
    const Colour one = indexed_colour(number);
    const int red = one.red - colour.red, green = one.green - colour.green, blue = one.blue - colour.blue;
    return red * red + green * green + blue * blue;
  };
  constexpr int last = 254;  // 255 is white, which some programs print black
  int best = 10;
  for (int number = 10; number <= last; ++number)
    if (distance(number) < distance(best)) best = number;
  return best;
}

void add_layer(DxfWriter& dxf, int table, std::string_view name, std::string_view line_type, const Look& look) {
  begin_entry(dxf, "LAYER", table, "AcDbLayerTableRecord", name);
  dxf.add(62, look.colour);
  dxf.add(6, line_type);
  dxf.add(370, look.weight);
}

void add_layers(DxfWriter& dxf, const sheet::Sheet& sheet, const std::vector<std::string>& names,
                const std::vector<LineType>& types) {
  add_table(dxf, "LAYER", names.size() + 1, [&](int table) {
    add_layer(dxf, table, "0", "CONTINUOUS", {colour_number({}), 25});
    for (std::size_t i = 0; i < names.size(); ++i) {
      const sheet::LineStyle& style = sheet.layers[i].style;
      add_layer(dxf, table, names[i], line_type_of(types, style.dashes),
                {colour_number(style.colour), line_weight(style.width)});
    }
  });
}

// Returns the handle of the style of the sheet.
int add_text_styles(DxfWriter& dxf, const std::string& file) {
  int handle = 0;
  const auto add = [&](int table, std::string_view name, std::string_view font) {
    handle = begin_entry(dxf, "STYLE", table, "AcDbTextStyleTableRecord", name);
    dxf.add(40, 0);  // each text has its own height
    dxf.add(41, 1);
    dxf.add(50, 0);
    dxf.add(71, 0);
    dxf.add(42, 3.5);
    dxf.add(3, font);
    dxf.add(4, "");
  };
  add_table(dxf, "STYLE", 2, [&](int table) {
    add(table, "STANDARD", "txt");
    add(table, dxf_text_style, file.empty() ? "osifont.ttf" : dxf_text(file, dxf.version()));
  });
  return handle;
}

// Dimensions that are entities.
std::vector<const sheet::DimensionObject*> dimensions_in(const sheet::Sheet& sheet,
                                                         const std::vector<DxfBlock>& blocks) {
  const auto is_dimension = [](const DxfBlock& block) { return block.kind == DxfBlockKind::dimension; };
  std::vector<const sheet::DimensionObject*> dimensions;
  if (std::none_of(blocks.begin(), blocks.end(), is_dimension)) return dimensions;
  for (const sheet::Layer& layer : sheet.layers)
    for (const sheet::DimensionObject& dimension : layer.dimensions) dimensions.push_back(&dimension);
  return dimensions;
}

/// A variable of dimension styles.
struct DimensionVariable {
  const char* name;  ///< in the header
  int code;          ///< in the table
  double value;
  bool is_length = true;
};

std::vector<DimensionVariable> dimension_variables(const sheet::DimensionObject& dimension, double factor) {
  return {{"$DIMSCALE", 40, 1},
          {"$DIMASZ", 41, dimension.arrow},
          {"$DIMEXO", 42, dimension.gap},
          {"$DIMEXE", 44, dimension.overshoot},
          {"$DIMTXT", 140, dimension.text_height},
          {"$DIMLFAC", 144, factor},
          {"$DIMGAP", 147, dimension.above},
          {"$DIMTIH", 73, 0, false},  // texts along the dimension line
          {"$DIMTOH", 74, 0, false},
          {"$DIMTAD", 77, 1, false}};  // and above it
}

// Lengths are real numbers, choices whole ones.
void add_variable(DxfWriter& dxf, int code, const DimensionVariable& variable) {
  if (variable.is_length)
    dxf.add(code, variable.value);
  else
    dxf.add(code, static_cast<int>(variable.value));
}

// That of tolerance frames: they are two heights of their texts high.
void add_frame_style(DxfWriter& dxf, int table, double text_height, int text_style) {
  begin_entry(dxf, "DIMSTYLE", table, "AcDbDimStyleTableRecord", dxf_frame_style);
  dxf.add(40, 1.0);
  dxf.add(140, text_height);
  dxf.add(147, text_height / 2);
  dxf.add_handle(340, text_style);
}

// The one of factor 1, which is always there, more of dimensions at other scales, and that of frames of this height.
void add_dimension_styles(DxfWriter& dxf, const std::vector<const sheet::DimensionObject*>& dimensions,
                          double frame_text, int text_style) {
  std::map<double, const sheet::DimensionObject*> styles{{1, dimensions.empty() ? nullptr : dimensions.front()}};
  for (const sheet::DimensionObject* dimension : dimensions) styles.emplace(factor_of(*dimension), dimension);
  add_table(dxf, "DIMSTYLE", styles.size() + (frame_text > 0 ? 1 : 0), [&](int table) {
    for (const auto& [factor, dimension] : styles) {
      begin_entry(dxf, "DIMSTYLE", table, "AcDbDimStyleTableRecord", dxf_dimension_style(factor));
      if (dimension == nullptr) continue;
      for (const DimensionVariable& variable : dimension_variables(*dimension, factor))
        add_variable(dxf, variable.code, variable);
      dxf.add_handle(340, text_style);
    }
    if (frame_text > 0) add_frame_style(dxf, table, frame_text, text_style);
  });
}

// The model space comes first.
std::vector<DxfBlock> with_spaces(const std::vector<DxfBlock>& blocks) {
  std::vector<DxfBlock> all{{"*Model_Space", Vec2(0)}, {"*Paper_Space", Vec2(0)}};
  all.insert(all.end(), blocks.begin(), blocks.end());
  return all;
}

// Returns the handle of the model space.
int add_block_records(DxfWriter& dxf, const std::vector<DxfBlock>& blocks) {
  int model_space = 0;
  add_table(dxf, "BLOCK_RECORD", blocks.size(), [&](int table) {
    for (const DxfBlock& block : blocks) {
      const int handle = dxf.begin("BLOCK_RECORD", table, "AcDbSymbolTableRecord", "AcDbBlockTableRecord");
      dxf.add(2, block.name);
      if (model_space == 0) model_space = handle;
    }
  });
  return model_space;
}

// `add_entities` is called with the index of each block.
void add_blocks(DxfWriter& dxf, int model_space, const std::vector<DxfBlock>& blocks,
                const std::function<void(std::size_t, int)>& add_entities) {
  dxf.add(0, "SECTION");
  dxf.add(2, "BLOCKS");
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const int owner = model_space + static_cast<int>(i);  // handles are consecutive
    dxf.begin("BLOCK", owner, "AcDbEntity");
    dxf.add(8, "0");
    dxf.add(100, "AcDbBlockBegin");
    dxf.add(2, blocks[i].name);
    constexpr int anonymous = 1;
    dxf.add(70, blocks[i].name.starts_with("*D") || blocks[i].name.starts_with("*T") ? anonymous : 0);
    dxf.add(10, Vec2(0, 0));  // FreeCAD and OpenSCAD take no other one into account
    dxf.add(30, 0);
    dxf.add(3, blocks[i].name);
    dxf.add(1, "");
    add_entities(i, owner);
    dxf.begin("ENDBLK", owner, "AcDbEntity");
    dxf.add(8, "0");
    dxf.add(100, "AcDbBlockEnd");
  }
  dxf.add(0, "ENDSEC");
}

}  // namespace

std::string dxf_dimension_style(double factor) {
  return factor == 1 ? "STANDARD" : "TIMES-" + format_rounded(factor, 9);
}

void add_dxf_tables(DxfWriter& dxf, const DxfParts& parts, DxfHandles& handles,
                    const std::function<void(std::size_t, int)>& add_entities) {
  const sheet::Sheet& sheet = parts.sheet;
  const std::vector<LineType> types = line_types(sheet);
  dxf.add(0, "SECTION");
  dxf.add(2, "TABLES");
  add_viewports(dxf, sheet);
  add_line_types(dxf, types);
  add_layers(dxf, sheet, parts.layers, types);
  handles.text_style = add_text_styles(dxf, sheet.font.file.filename().string());
  for (const char* empty : {"VIEW", "UCS"}) add_table(dxf, empty, 0, [](int) {});
  add_table(dxf, "APPID", 1, [&](int table) { begin_entry(dxf, "APPID", table, "AcDbRegAppTableRecord", "ACAD"); });
  add_dimension_styles(dxf, dimensions_in(sheet, parts.blocks), parts.frame_text, handles.text_style);
  const std::vector<DxfBlock> all = with_spaces(parts.blocks);
  const std::size_t spaces = all.size() - parts.blocks.size();
  handles.model_space = add_block_records(dxf, all);
  handles.first_block = handles.model_space + static_cast<int>(spaces);
  dxf.add(0, "ENDSEC");
  add_blocks(dxf, handles.model_space, all, [&](std::size_t block, int owner) {
    if (block >= spaces) add_entities(block - spaces, owner);
  });
}

std::string dxf_header(const sheet::Sheet& sheet, const std::vector<DxfBlock>& blocks, int handles,
                       DxfVersion version) {
  DxfWriter dxf(version);
  dxf.add(999, "epura");
  if (!sheet.title.empty()) dxf.add(999, dxf_text(sheet.title, version));
  dxf.add(0, "SECTION");
  dxf.add(2, "HEADER");
  const auto variable = [&](std::string_view name, int code, const auto& value) {
    dxf.add(9, name);
    dxf.add(code, value);
  };
  variable("$ACADVER", 1, version == DxfVersion::r2007 ? "AC1021" : "AC1015");
  variable("$DWGCODEPAGE", 3, "ANSI_1252");
  variable("$EXTMIN", 10, Vec2(0, 0));
  dxf.add(30, 0);
  variable("$EXTMAX", 10, Vec2(sheet.width, sheet.height));
  dxf.add(30, 0);
  variable("$LIMMIN", 10, Vec2(0, 0));
  variable("$LIMMAX", 10, Vec2(sheet.width, sheet.height));
  // LibreCAD takes the size of the paper from these.
  variable("$PLIMMIN", 10, Vec2(0, 0));
  variable("$PLIMMAX", 10, Vec2(sheet.width, sheet.height));
  variable("$LTSCALE", 40, 1.0);
  variable("$CELTSCALE", 40, 1.0);
  variable("$MEASUREMENT", 70, 1);  // metric
  variable("$INSUNITS", 70, 4);     // millimetres
  variable("$LUNITS", 70, 2);       // decimal
  variable("$LWDISPLAY", 290, 1);
  if (const auto dimensions = dimensions_in(sheet, blocks); !dimensions.empty())
    for (const DimensionVariable& one : dimension_variables(*dimensions.front(), 1)) {
      dxf.add(9, one.name);
      add_variable(dxf, one.is_length ? 40 : 70, one);
    }
  dxf.add(9, "$HANDSEED");
  dxf.add_handle(5, handles + 1);
  dxf.add(0, "ENDSEC");
  return dxf.take();
}

}  // namespace epura::output
