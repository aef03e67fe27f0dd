// SPDX-License-Identifier: Apache-2.0
// Reads the header of a PLY file: which elements follow, how many, and how each of their properties is stored.
// Format: Greg Turk, The PLY Polygon File Format, 1994, with the type names of both generations (float, float32).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace epura::mesh {

enum class PlyEncoding { text, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Returns the number of bytes of a number of this type.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< for a list
};

struct PlyElement {
  std::string name;
  long long count;
  std::size_t line;  ///< line of its declaration
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::size_t data_offset;  ///< first byte after the header
  std::size_t data_line;    ///< line of this byte
};

PlyHeader read_ply_header(std::string_view bytes, std::string_view name);

}  // namespace epura::mesh
