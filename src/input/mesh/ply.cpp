// SPDX-License-Identifier: Apache-2.0
// Reads PLY: text and binary in both byte orders, elements and properties in any order.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/error.hpp"
#include "mesh/bytes.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/read.hpp"
#include "mesh/text_cursor.hpp"

namespace epura::mesh {

namespace {

// Both sources return numbers as doubles, which represent every 32-bit index exactly.

class BinarySource {
 public:
  BinarySource(std::string_view bytes, std::size_t offset, std::endian order, std::string_view name)
      : bytes_(bytes), at_(offset), order_(order), name_(name) {}

  /// Calls `take(number)` for the next `count` numbers.
  template <class Take>
  void numbers(PlyType type, long long count, const Take& take) {
    switch (type) {
      case PlyType::int8:
        return numbers_of<std::int8_t>(count, take);
      case PlyType::uint8:
        return numbers_of<std::uint8_t>(count, take);
      case PlyType::int16:
        return numbers_of<std::int16_t>(count, take);
      case PlyType::uint16:
        return numbers_of<std::uint16_t>(count, take);
      case PlyType::int32:
        return numbers_of<std::int32_t>(count, take);
      case PlyType::uint32:
        return numbers_of<std::uint32_t>(count, take);
      case PlyType::int64:
        return numbers_of<std::int64_t>(count, take);
      case PlyType::uint64:
        return numbers_of<std::uint64_t>(count, take);
      case PlyType::float32:
        return numbers_of<float>(count, take);
      case PlyType::float64:
        return numbers_of<double>(count, take);
    }
  }

  static constexpr bool is_binary = true;

  void begin_property(const PlyProperty&) const {}
  void end_element() const {}
  [[nodiscard]] static std::size_t min_bytes(PlyType type) { return size_of(type); }
  [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t place() const { return at_; }
  [[noreturn]] void fail(const std::string& reason, std::size_t place) const {
    throw Error(ErrorKind::input, std::string(name_) + ": byte " + std::to_string(place), reason);
  }

 private:
  template <class Number, class Take>
  void numbers_of(long long count, const Take& take) {
    if (bytes_left() / sizeof(Number) < static_cast<std::size_t>(count)) fail("the file ends too early", bytes_.size());
    for (long long k = 0; k < count; ++k) {
      const auto number = static_cast<double>(load<Number>(bytes_.data() + at_, order_));
      at_ += sizeof(Number);
      take(number);
    }
  }

  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
  std::string_view name_;
};

class TextSource {
 public:
  TextSource(std::string_view text, std::string_view name, std::size_t first_line)
      : text_(text, name, first_line), name_(name) {}

  static constexpr bool is_binary = false;

  void begin_property(const PlyProperty& property) { property_ = &property; }

  template <class Take>
  void numbers(PlyType, long long count, const Take& take) {
    for (long long k = 0; k < count; ++k) {
      double number = 0;
      if (!text_.take(number)) number = text_.number(next_word());
      if (row_line_ == 0) row_line_ = text_.line();
      take(number);
    }
  }

  void end_element() {
    const std::string_view word = text_.word();
    if (!word.empty() && missing_ != nullptr) fail_short_row();
    if (!word.empty()) text_.fail(quoted(word) + " exceeds the properties of this element");
    text_.next_line();
    row_line_ = 0;
    missing_ = nullptr;
  }
  [[nodiscard]] static std::size_t min_bytes(PlyType) { return 1; }
  [[nodiscard]] std::size_t bytes_left() const { return text_.bytes_left(); }
  [[nodiscard]] std::size_t place() const { return text_.line(); }
  [[noreturn]] void fail(const std::string& reason, std::size_t place) const {
    TextCursor("", name_, place).fail(reason);
  }

 private:
  // An element may continue on the next line; but if that line holds more numbers, or the file ends, the element's own
  // line was too short.
  std::string_view next_word() {
    std::string_view word = text_.word();
    if (word.empty()) {
      if (row_line_ != 0 && missing_ == nullptr) missing_ = property_;
      word = text_.word_of_any_line();
      if (word.empty() && missing_ != nullptr) fail_short_row();
      if (word.empty()) text_.fail("the file ends too early");
    }
    return word;
  }

  [[noreturn]] void fail_short_row() const {
    fail("the row ends too early: a number of '" + missing_->name + "' is missing", row_line_);
  }

  TextCursor text_;
  std::string_view name_;
  const PlyProperty* property_ = nullptr;  // currently read
  const PlyProperty* missing_ = nullptr;   // first property missing from the line where the element begins
  std::size_t row_line_ = 0;               // number of that line; 0 before the element
};

template <class Source>
class PlyReader {
 public:
  PlyReader(Source source, std::string_view name, const Progress& progress)
      : source_(source), name_(name), pace_(progress, source.bytes_left()) {
    soup_.format = "ply";
  }

  Soup read(const std::vector<PlyElement>& elements) {
    for (const PlyElement& element : elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element);
      } else if (element.name == "edge") {
        read_edges(element);
      } else {
        read_rows(
            element, [](std::size_t, double) {}, [](std::size_t) {});
      }
    }
    if (largest_ >= static_cast<long long>(soup_.points.size()))
      source_.fail(largest_of_ + " refers to vertex " + std::to_string(largest_) + ", but there are " +
                       std::to_string(soup_.points.size()),
                   largest_place_);
    return std::move(soup_);
  }

 private:
  // A wrong count must not exhaust the memory.
  void check_count(const PlyElement& element) const {
    std::size_t min_bytes = 0;
    for (const PlyProperty& property : element.properties)
      min_bytes += Source::min_bytes(property.count_type.value_or(property.type));
    if (min_bytes == 0 || static_cast<unsigned long long>(element.count) <= source_.bytes_left() / min_bytes) return;
    TextCursor("", name_, element.line)
        .fail("the file is too short for the " + std::to_string(element.count) + " elements '" + element.name +
                  "' that its header announces",
              "is the file complete?");
  }

  /// Calls `take(property, number)` for each number and `end(property)` after each property of all elements.
  template <class Take, class End>
  void read_rows(const PlyElement& element, const Take& take, const End& end) {
    if (element.properties.empty()) return;
    for (long long row = 0; row < element.count; ++row) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        source_.begin_property(property);
        const long long count = property.count_type ? list_length(*property.count_type) : 1;
        source_.numbers(property.type, count, [&](double number) { take(p, number); });
        end(p);
      }
      source_.end_element();
      pace_.left(source_.bytes_left());
    }
  }

  long long list_length(PlyType type) {
    const std::size_t place = source_.place();
    double length = 0;
    source_.numbers(type, 1, [&](double number) { length = number; });
    if (!(length >= 0) || length != std::floor(length) || length > static_cast<double>(source_.bytes_left()) + 1)
      source_.fail("a list has an invalid length", place);
    return static_cast<long long>(length);
  }

  void read_vertices(const PlyElement& element) {
    constexpr std::size_t none = 3;
    std::vector<std::size_t> axis(element.properties.size(), none);
    soup_.single_precision = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string wanted(1, "xyz"[a]);
      const auto found = std::find_if(element.properties.begin(), element.properties.end(), [&](const auto& property) {
        return property.name == wanted && !property.count_type;
      });
      if (found == element.properties.end())
        TextCursor("", name_, element.line).fail("the vertices have no property '" + wanted + "'");
      axis[static_cast<std::size_t>(found - element.properties.begin())] = a;
      soup_.single_precision = soup_.single_precision && found->type == PlyType::float32;
    }
    soup_.points.reserve(soup_.points.size() + static_cast<std::size_t>(element.count));
    std::array<double, 4> point{};  // the last one receives unused values
    std::size_t row = 0, last = 0;  // number of rows, and of those up to the last that is not all zeros
    read_rows(
        element,
        [&](std::size_t p, double value) {
          point[axis[p]] = value;
          if (value != 0) last = row + 1;
        },
        [&](std::size_t p) {
          if (p + 1 < axis.size()) return;
          soup_.points.push_back({point[0], point[1], point[2]});
          ++row;
        });
    if (Source::is_binary) expect_normals(element, last);
  }

  // Without the normals that a writer announces the vertices move up, and leave zeros behind them (vtk.js).
  void expect_normals(const PlyElement& element, std::size_t rows) const {
    std::size_t row = 0, normals = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.count_type) return;
      row += size_of(property.type);
      if (property.name == "nx" || property.name == "ny" || property.name == "nz") normals += size_of(property.type);
    }
    const auto announced = static_cast<std::size_t>(element.count);
    const std::size_t written = (announced * (row - normals) + row - 1) / row;
    if (normals == 0 || rows > written || rows + 2 > announced) return;
    TextCursor("", name_, element.line)
        .fail("the header announces normals that are not there: the last " + std::to_string(announced - rows) + " of " +
                  std::to_string(announced) + " vertices are nothing but zeros",
              "export the model with normals, or in another format");
  }

  void read_faces(const PlyElement& element) {
    const auto found = std::find_if(element.properties.begin(), element.properties.end(), [](const auto& property) {
      return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    });
    const auto wanted = static_cast<std::size_t>(found - element.properties.begin());
    const bool strips = element.name == "tristrips";
    std::vector<int> strip;
    if (!strips && found != element.properties.end()) {
      soup_.corners.reserve(3 * static_cast<std::size_t>(element.count));
      soup_.face_ends.reserve(static_cast<std::size_t>(element.count));
    }
    read_rows(
        element,
        [&](std::size_t p, double value) {
          if (p == wanted) (strips ? strip : soup_.corners).push_back(index(value, strips, "a face"));
        },
        [&](std::size_t p) {
          if (p != wanted) return;
          if (!strips) return end_face();
          add_strip(strip);
          strip.clear();
        });
  }

  // A face with two corners is a line.
  void end_face() {
    const auto first = static_cast<std::size_t>(soup_.face_ends.empty() ? 0 : soup_.face_ends.back());
    if (soup_.corners.size() == first + 2) {
      soup_.wires.push_back({soup_.corners[first], soup_.corners[first + 1]});
      soup_.corners.resize(first);
      ++soup_.wire_faces;
    }
    soup_.end_face();
  }

  void read_edges(const PlyElement& element) {
    std::array<std::size_t, 2> wanted{};
    for (std::size_t end = 0; end < 2; ++end) {
      const std::string name = "vertex" + std::to_string(end + 1);
      const auto found = std::find_if(element.properties.begin(), element.properties.end(), [&](const auto& property) {
        return property.name == name && !property.count_type;
      });
      wanted[end] = static_cast<std::size_t>(found - element.properties.begin());
    }
    std::array<int, 2> wire{};
    const bool is_wire = std::max(wanted[0], wanted[1]) < element.properties.size();
    read_rows(
        element,
        [&](std::size_t p, double value) {
          for (std::size_t end = 0; is_wire && end < 2; ++end)
            if (p == wanted[end]) wire[end] = index(value, false, "an edge");
        },
        [&](std::size_t p) {
          if (is_wire && p + 1 == element.properties.size()) soup_.wires.push_back(wire);
        });
  }

  /// Returns a vertex number; -1 ends a strip.
  int index(double value, bool may_end, const std::string& of) {
    if (value == -1 && may_end) return -1;
    if (!(value >= 0) || value != std::floor(value) || value > 2147483646.0)
      source_.fail(of + " refers to a vertex that does not exist", source_.place());
    const auto number = static_cast<long long>(value);
    if (number > largest_) {
      largest_ = number;
      largest_place_ = source_.place();
      largest_of_ = of;
    }
    return static_cast<int>(number);
  }

  /// Every further vertex of a strip forms a triangle with the two before it; every second triangle is reversed.
  void add_strip(const std::vector<int>& strip) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      if (strip[i] < 0) begin = i + 1;
      if (i < begin + 2 || strip[i] < 0) continue;
      std::array<int, 3> triangle{strip[i - 2], strip[i - 1], strip[i]};
      if ((i - begin) % 2 == 1) std::swap(triangle[0], triangle[1]);
      // Strips are connected by triangles that repeat a vertex; these are not faces.
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
      soup_.corners.insert(soup_.corners.end(), triangle.begin(), triangle.end());
      soup_.end_face();
    }
  }

  Source source_;
  std::string_view name_;
  Pace pace_;
  Soup soup_;
  long long largest_ = -1;         // largest vertex number, checked when all vertices are known
  std::size_t largest_place_ = 0;  // its position in the file
  std::string largest_of_;         // the element that has it
};

}  // namespace

Soup read_ply(std::string_view bytes, std::string_view name, const Progress& progress) {
  const PlyHeader header = read_ply_header(bytes, name);
  if (header.encoding == PlyEncoding::text) {
    const TextSource source(bytes.substr(header.data_offset), name, header.data_line);
    Soup soup = PlyReader(source, name, progress).read(header.elements);
    soup.printed = true;
    return soup;
  }
  const std::endian order = header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  const BinarySource source(bytes, header.data_offset, order, name);
  return PlyReader(source, name, progress).read(header.elements);
}

}  // namespace epura::mesh
