// SPDX-License-Identifier: Apache-2.0
// Groups of a DXF file, two lines each, and text encoded for them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/vec.hpp"

namespace epura::output {

/// Appends groups: a code, which determines the type of the value, and the value.
class DxfWriter {
 public:
  /// `text` is one line: see dxf_text and dxf_names.
  void add(int code, std::string_view text);
  void add(int code, int value);
  void add(int code, double value);
  /// x under `code`, y under the code ten above.
  void add(int code, const Vec2& point);

  /// Under `code`, in hexadecimal digits, as all handles are written.
  void add_handle(int code, int handle);
  /// A handle that nothing has yet: 1, 2 ...
  int next_handle() { return ++handles_; }
  [[nodiscard]] int handles() const { return handles_; }

  /// "0 type", its new handle under 5, its owner and the names of its classes. Returns the handle.
  int begin(std::string_view type, int owner, std::string_view first_class, std::string_view second_class = {});

  std::string take() { return std::move(text_); }

 private:
  void add_code(int code);

  std::string text_;
  int handles_ = 0;
};

/// One line of ASCII that DXF programs show as `text`: other characters as \U+XXXX (those past U+FFFF as U+FFFD),
/// control characters as spaces, and nothing that would be read as %%-code or ^-code. At most 256 characters, which is
/// all that a TEXT takes.
std::string dxf_text(std::string_view text);

/// Names of a symbol table: no character that DXF forbids, each one once whatever the case of its letters, at most 200
/// characters long. `taken` are in the table already.
std::vector<std::string> dxf_names(const std::vector<std::string>& names, const std::vector<std::string>& taken);

}  // namespace epura::output
