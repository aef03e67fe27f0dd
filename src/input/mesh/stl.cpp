// SPDX-License-Identifier: Apache-2.0
// Reads STL: binary (80 arbitrary bytes, a count, 50 bytes per triangle) and text (solid, facet, vertex).
#include <array>
#include <cstdint>

#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/bytes.hpp"
#include "mesh/read.hpp"
#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

std::uint64_t announced_bytes(std::string_view bytes) {
  return header_bytes + triangle_bytes * std::uint64_t{load<std::uint32_t>(bytes.data() + 80, std::endian::little)};
}

Soup read_binary(std::string_view bytes, std::string_view name, const Progress& progress) {
  const auto fail = [&](std::size_t at, const std::string& reason) {
    throw Error(ErrorKind::input, std::string(name) + ": byte " + std::to_string(at), reason, "is the file complete?");
  };
  if (bytes.size() < header_bytes) fail(bytes.size(), "the file ends inside the header of a binary STL");
  const std::uint64_t count = (announced_bytes(bytes) - header_bytes) / triangle_bytes;
  if (bytes.size() < announced_bytes(bytes))
    fail(bytes.size(), "the file ends at triangle " +
                           std::to_string((bytes.size() - header_bytes) / triangle_bytes + 1) + " of " +
                           std::to_string(count));

  Soup soup;
  if (bytes.size() > announced_bytes(bytes))
    soup.notes.push_back("ignored " + std::to_string(bytes.size() - announced_bytes(bytes)) +
                         " bytes after the last triangle");
  soup.single_precision = true;
  soup.points.resize(3 * count);
  Pace pace(progress, bytes.size());
  for (std::size_t corner = 0; corner < soup.points.size(); ++corner) {
    pace.left(bytes.size() - corner / 3 * triangle_bytes);
    // A triangle consists of its normal, three corners and two bytes of attributes.
    const char* const from = bytes.data() + header_bytes + corner / 3 * triangle_bytes + 12 * (1 + corner % 3);
    for (std::size_t axis = 0; axis < 3; ++axis)
      soup.points[corner][axis] = static_cast<double>(load<float>(from + 4 * axis, std::endian::little));
  }
  soup.face_ends.reserve(count);
  for (std::uint64_t f = 1; f <= count; ++f) soup.face_ends.push_back(static_cast<int>(3 * f));
  return soup;
}

class TextReader {
 public:
  TextReader(std::string_view bytes, std::string_view name, const Progress& progress)
      : text_(bytes, name), pace_(progress, bytes.size()) {}

  Soup read() {
    // Programs write text STL from floats, regardless of the number of digits.
    soup_.single_precision = true;
    soup_.printed = true;
    for (std::string_view word = text_.word_of_any_line(); !word.empty(); word = text_.word_of_any_line()) {
      // Nearly all programs write small letters.
      if (!statement(word) && !statement(to_lower(word))) text_.fail(quoted(word) + " does not belong in a text STL");
      pace_.left(text_.bytes_left());
    }
    if (in_facet_) text_.fail("the file ends inside a facet", "is the file complete?");
    if (soup_.body_names.size() < 2) {
      soup_.body_names.clear();
      soup_.face_body.clear();
    }
    return std::move(soup_);
  }

 private:
  // Returns whether it is one.
  bool statement(std::string_view keyword) {
    if (keyword == "vertex")
      vertex();
    else if (keyword == "facet")
      begin_facet();
    else if (keyword == "endfacet")
      end_facet();
    else if (keyword == "solid")
      begin_solid();
    else if (keyword == "endsolid")
      text_.rest_of_line();
    else
      return keyword == "outer" || keyword == "loop" || keyword == "endloop";
    return true;
  }

  void begin_solid() {
    const std::string_view name = text_.rest_of_line();
    soup_.body_names.push_back(name.empty() ? "solid " + std::to_string(soup_.body_names.size() + 1)
                                            : std::string(name));
  }

  void begin_facet() {
    if (in_facet_) text_.fail("a facet begins inside a facet");
    in_facet_ = true;
    // "normal x y z" need not be numbers: the corners determine the orientation of a facet.
    for (int i = 0; i < 4; ++i) text_.word();
  }

  void vertex() {
    if (!in_facet_) text_.fail("a vertex outside a facet");
    soup_.points.push_back(text_.point());
  }

  void end_facet() {
    if (!in_facet_) text_.fail("'endfacet' without a facet");
    in_facet_ = false;
    if (soup_.body_names.empty()) soup_.body_names.emplace_back("solid 1");
    soup_.face_ends.push_back(static_cast<int>(soup_.points.size()));
    soup_.face_body.push_back(static_cast<int>(soup_.body_names.size()) - 1);
  }

  TextCursor text_;
  Pace pace_;
  Soup soup_;
  bool in_facet_ = false;
};

}  // namespace

StlKind stl_kind(std::string_view bytes) {
  if (bytes.size() >= header_bytes && bytes.size() == announced_bytes(bytes)) return StlKind::binary;
  TextCursor text(bytes, "");
  const std::string first = to_lower(text.word_of_any_line().substr(0, 6));
  if (first != "solid" && first != "facet") return StlKind::neither;
  // Binary files may begin with "solid" as well; only text then has "facet" near the beginning.
  const std::string_view beginning = bytes.substr(0, 65536);
  const auto holds = [&](std::string_view word) { return beginning.find(word) != std::string_view::npos; };
  const bool text_words = holds("facet") || holds("FACET") || holds("endsolid") || holds("ENDSOLID");
  return text_words || bytes.size() < header_bytes ? StlKind::text : StlKind::neither;
}

Soup read_stl(std::string_view bytes, std::string_view name, const Progress& progress) {
  Soup soup =
      stl_kind(bytes) == StlKind::text ? TextReader(bytes, name, progress).read() : read_binary(bytes, name, progress);
  soup.format = "stl";
  soup.corners_repeat_points = true;
  soup.corners.resize(soup.points.size());
  for (std::size_t i = 0; i < soup.corners.size(); ++i) soup.corners[i] = static_cast<int>(i);
  return soup;
}

}  // namespace epura::mesh
