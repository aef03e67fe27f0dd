// SPDX-License-Identifier: Apache-2.0
// What an element of artwork is given: its place in the file, and its style, transform and colours.
#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.hpp"
#include "svg/affine_map.hpp"
#include "svg/gradients.hpp"
#include "svg/style.hpp"

namespace epura::svg {

/// The text of a file, for messages.
struct Source {
  std::string where;                        ///< name of the file
  std::vector<std::ptrdiff_t> line_ends{};  ///< ascending

  Source(std::string_view bytes, std::string file);

  /// "frame.svg:12", given the offset of a byte.
  [[nodiscard]] std::string line_at(std::ptrdiff_t offset) const;
  [[nodiscard]] std::string line_of(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

  /// Throws Error{input} with the line of a node.
  [[noreturn]] void refuse(const pugi::xml_node& at, const std::string& what, const std::string& hint = {}) const;

  /// An attribute in user units, 0 if there is none. Throws Error{input}.
  [[nodiscard]] double length_in(const pugi::xml_node& node, const char* name) const;
};

/// What all elements may refer to.
struct Definitions {
  Source source;
  Rules rules{};
  Gradients gradients{};
};

/// Deepest groups in groups.
inline constexpr int deepest = 100;

/// The rules of style sheets in a node. Throws Error{input} for selectors that are not read.
Rules style_sheets_in(const pugi::xml_node& node, const Source& source, int depth = 0);

/// What a group passes on to its content.
struct Context {
  Style style{};
  AffineMap map{};
  double alpha = 1;  ///< of the group as a whole
  int depth = 0;
};

/// The context of an element in that of its parent. Throws Error{input} for effects that are not drawn and for scripts.
Context inside(const pugi::xml_node& element, const Context& parent, const Definitions& all);

/// A colour on white paper, and whether it is drawn otherwise than it is meant.
struct Painted {
  std::optional<Colour> colour{};  ///< nothing if it is not seen
  bool graded = false;             ///< it is in the middle of a gradient
  bool transparent = false;
};

/// The property "fill" or "stroke" of an element; `usual` is its value where it is not set. Throws Error{input}.
Painted paint_of(const pugi::xml_node& element, const Context& context, const Definitions& all,
                 const std::string& property, std::string_view usual);

}  // namespace epura::svg
