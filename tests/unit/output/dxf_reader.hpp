// SPDX-License-Identifier: Apache-2.0
// DXF files as groups of codes and values.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support.hpp"

namespace epura {

/// What stands between one group 0 and the next.
struct DxfRecord {
  std::string type;
  std::vector<std::pair<int, std::string>> groups;

  [[nodiscard]] std::vector<std::string> all(int code) const {
    std::vector<std::string> values;
    for (const auto& [found, value] : groups)
      if (found == code) values.push_back(value);
    return values;
  }
  /// The last one; empty where there is none.
  [[nodiscard]] std::string text(int code) const { return all(code).empty() ? "" : all(code).back(); }
  [[nodiscard]] double number(int code) const { return number_in(text(code)); }
  [[nodiscard]] Vec2 point(int code) const { return {number(code), number(code + 10)}; }
};

inline std::vector<DxfRecord> dxf_records(const std::string& dxf) {
  std::vector<DxfRecord> records(1);
  const std::vector<std::string_view> lines = split(dxf, '\n');
  EXPECT_EQ(lines.size() % 2, 1u);  // the last line ends
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    const auto code = parse_integer(lines[i]);
    EXPECT_TRUE(code) << lines[i];
    if (code == 0) {
      records.push_back({std::string(lines[i + 1]), {}});
    } else {
      records.back().groups.emplace_back(static_cast<int>(code.value_or(-1)), lines[i + 1]);
    }
  }
  return records;
}

/// Those of a layer in the model space.
inline std::vector<DxfRecord> entities_of(const std::string& dxf, const std::string& layer) {
  std::vector<DxfRecord> entities;
  for (const DxfRecord& record : dxf_records(dxf)) {
    const bool block = record.type == "BLOCK" || record.type == "ENDBLK";
    if (!block && record.text(100) != "AcDbLayerTableRecord" && record.text(8) == layer) entities.push_back(record);
  }
  return entities;
}

inline std::vector<DxfRecord> table_of(const std::string& dxf, const std::string& type) {
  std::vector<DxfRecord> entries;
  for (const DxfRecord& record : dxf_records(dxf))
    if (record.type == type) entries.push_back(record);
  return entries;
}

/// Lines and polylines, without their bulges.
inline std::vector<Ink> ink_of(const std::vector<DxfRecord>& entities) {
  std::vector<Ink> lines;
  for (const DxfRecord& entity : entities) {
    Ink& line = lines.emplace_back();
    if (entity.type == "LINE") line.points = {entity.point(10), entity.point(11)};
    if (entity.type != "LWPOLYLINE") continue;
    const auto x = entity.all(10), y = entity.all(20);
    for (std::size_t i = 0; i < x.size(); ++i) line.points.emplace_back(number_in(x[i]), number_in(y[i]));
    line.closed = (static_cast<int>(entity.number(70)) & 1) != 0;
  }
  return lines;
}

}  // namespace epura
