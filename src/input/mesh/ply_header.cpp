// SPDX-License-Identifier: Apache-2.0
#include "mesh/ply_header.hpp"

#include <array>
#include <utility>

#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 18> type_names{{{"char", PlyType::int8},
                                               {"int8", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"uint8", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"int16", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"uint16", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"int32", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"uint32", PlyType::uint32},
                                               {"int64", PlyType::int64},
                                               {"uint64", PlyType::uint64},
                                               {"float", PlyType::float32},
                                               {"float32", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"float64", PlyType::float64}}};

PlyType read_type(TextCursor& text) {
  const std::string_view word = text.word();
  for (const TypeName& candidate : type_names)
    if (candidate.name == word) return candidate.type;
  text.fail(quoted(word) + " is not a PLY type", "use char, uchar, short, ushort, int, uint, float, double");
}

PlyEncoding read_encoding(TextCursor& text) {
  const std::string_view word = text.word();
  if (word == "ascii") return PlyEncoding::text;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  text.fail(quoted(word) + " is not a PLY format", "use ascii, binary_little_endian or binary_big_endian");
}

PlyElement read_element(TextCursor& text) {
  PlyElement element{.name = std::string(text.word()), .count = 0, .line = text.line(), .properties = {}};
  element.count = text.integer(text.word(), "the number of elements");
  if (element.count < 0) text.fail("there cannot be " + std::to_string(element.count) + " elements");
  return element;
}

PlyProperty read_property(TextCursor& text) {
  PlyProperty property{};
  const TextCursor before = text;
  if (text.word() == "list") {
    property.count_type = read_type(text);
  } else {
    text = before;
  }
  property.type = read_type(text);
  property.name = text.word();
  if (property.name.empty()) text.fail("a property without a name");
  return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    default:
      return 8;
  }
}

PlyHeader read_ply_header(std::string_view bytes, std::string_view name) {
  TextCursor text(bytes, name);
  if (text.word() != "ply") text.fail("does not begin with 'ply'");
  // If lines end with CR alone, a byte 0x0A after the header belongs to the data.
  const bool carriage_returns = bytes.size() > 4 && bytes[3] == '\r' && bytes[4] != '\n';

  std::optional<PlyEncoding> encoding;
  PlyHeader header{};
  while (text.next_line()) {
    const std::string_view word = text.word();
    if (word == "format") {
      encoding = read_encoding(text);
    } else if (word == "element") {
      header.elements.push_back(read_element(text));
    } else if (word == "property") {
      if (header.elements.empty()) text.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(text));
    } else if (word == "end_header") {
      if (!encoding) text.fail("the header names no format");
      text.rest_of_line();
      const std::size_t line_end = bytes.size() - text.bytes_left();
      text.next_line();
      const std::size_t behind = bytes.size() - text.bytes_left();
      header.encoding = *encoding;
      header.data_offset = carriage_returns && behind == line_end + 2 ? line_end + 1 : behind;
      header.data_line = text.line();
      return header;
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      text.fail(quoted(word) + " does not belong in the header of a PLY file");
    }
  }
  text.fail("the header does not end", "is the file complete?");
}

}  // namespace epura::mesh
