// SPDX-License-Identifier: Apache-2.0
// Writes groups of a DXF file, two lines each, and encodes text for them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "output/vector_options.hpp"

namespace epura::output {

/// Appends groups: a code, which determines the type of the value, and the value.
class DxfWriter {
 public:
  explicit DxfWriter(DxfVersion version) : version_(version) {}

  [[nodiscard]] DxfVersion version() const { return version_; }
  /// `text` is one line: see dxf_text and dxf_names.
  void add(int code, std::string_view text);
  void add(int code, int value);
  void add(int code, double value);
  /// x under `code`, y under `code` + 10.
  void add(int code, const Vec2& point);
  /// The same with the height 0 under `code` + 20.
  void add_point(int code, const Vec2& point);

  /// Adds the handle under `code`, in hexadecimal digits like all handles.
  void add_handle(int code, int handle);
  /// Returns an unused handle: 1, 2 ...
  int next_handle() { return ++handles_; }
  [[nodiscard]] int handles() const { return handles_; }

  /// Adds "0 type", a new handle under 5, the owner and the names of the classes. Returns the handle.
  int begin(std::string_view type, int owner, std::string_view first_class, std::string_view second_class = {});
  /// The same with a handle that something refers to already.
  void begin_as(int handle, std::string_view type, int owner, std::string_view first_class,
                std::string_view second_class = {});

  std::string take() { return std::move(text_); }

 private:
  void add_code(int code);

  DxfVersion version_;
  std::string text_;
  int handles_ = 0;
};

/// One line that DXF programs display as `text`: UTF-8, or for version 2000 ASCII with other characters as \U+XXXX
/// (those above U+FFFF as U+FFFD); control characters as spaces, and nothing that would be read as a code that begins
/// with %%, ^ or a backslash. At most 256 characters, the limit of a TEXT.
std::string dxf_text(std::string_view text, DxfVersion version);

/// The same for a text of several lines, in which backslashes and braces are commands.
std::string dxf_paragraph(std::string_view text, DxfVersion version);

/// Names for a symbol table: without characters that DXF forbids, unique regardless of case, and at most 200 characters
/// long. `taken` are in the table already.
std::vector<std::string> dxf_names(const std::vector<std::string>& names, const std::vector<std::string>& taken,
                                   DxfVersion version);

}  // namespace epura::output
