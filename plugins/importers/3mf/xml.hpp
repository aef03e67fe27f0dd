// SPDX-License-Identifier: Apache-2.0
// Tags of an XML text, one after the other. Meshes of 3MF are long: nothing but the text is kept, and nothing in it can
// take more memory than its length.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace epura::plugin::threemf {

/// A start tag. Prefixes of namespaces are left out: names of 3MF and its extensions do not meet.
struct Tag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool is_empty = false;  ///< "<name/>": no end follows

  /// As it stands there; empty if there is none.
  [[nodiscard]] std::string_view raw(std::string_view attribute) const;
  /// With the characters that its entities stand for.
  [[nodiscard]] std::string text(std::string_view attribute) const;
};

class Xml {
 public:
  explicit Xml(std::string_view text) : text_(text) {}

  /// Moves to the next start tag; returns false at the end. Comments, declarations and instructions are skipped. Throws
  /// std::runtime_error with the line if the text is no XML or is cut short.
  bool next();
  [[nodiscard]] const Tag& tag() const { return tag_; }
  /// How many elements the tag stands in.
  [[nodiscard]] std::size_t depth() const { return depth_; }
  /// The characters behind the tag, up to the next one.
  [[nodiscard]] std::string content() const;
  /// From 0 to 1.
  [[nodiscard]] double done() const { return static_cast<double>(place_) / static_cast<double>(text_.size() + 1); }

 private:
  void read_tag();
  void read_end();
  void skip_to(std::string_view end);
  [[noreturn]] void fail(const std::string& sentence) const;

  std::string_view text_;
  std::size_t place_ = 0;  ///< behind the last tag
  std::size_t depth_ = 0;
  std::vector<std::string_view> open_;
  Tag tag_;
};

}  // namespace epura::plugin::threemf
