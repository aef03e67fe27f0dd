// SPDX-License-Identifier: Apache-2.0
// SVG documents as their readers see them.
#pragma once

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support.hpp"

namespace epura {

inline pugi::xml_document parse_svg(const std::string& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_buffer(svg.data(), svg.size()));
  return document;
}

/// What its ids and classes begin with.
inline std::string prefix_of(const pugi::xml_document& document) {
  return document.child("svg").attribute("id").value();
}

/// A piece of a path: its command, where it ends (y down) and its other numbers.
struct SvgPiece {
  char command;
  Vec2 to;
  std::vector<double> others;
};

/// Reads the data of a path: M, l, h, v, q, A and Z, repeated without their letter where SVG allows it.
class SvgPathReader {
 public:
  explicit SvgPathReader(std::string_view data) : data_(data) {}

  std::vector<SvgPiece> pieces() {
    std::vector<SvgPiece> pieces;
    char command = 0;
    for (skip_spaces(); !data_.empty(); skip_spaces()) {
      const bool named = std::string_view("MlhvqAZ").find(data_[0]) != std::string_view::npos;
      EXPECT_TRUE(named || (command != 'M' && command != 'Z' && command != 0)) << data_;
      if (named) command = take();
      pieces.push_back(piece(command));
    }
    return pieces;
  }

 private:
  char take() {
    const char c = data_[0];
    data_.remove_prefix(1);
    return c;
  }

  void skip_spaces() {
    while (!data_.empty() && data_[0] == ' ') take();
  }

  SvgPiece piece(char command) {
    SvgPiece read{command, {}, {}};
    for (int more = command == 'q' ? 2 : command == 'A' ? 5 : 0; more > 0; --more) read.others.push_back(number());
    if (command == 'Z') here_ = start_;
    if (command == 'M' || command == 'A') here_ = {0, 0};
    if (command != 'v' && command != 'Z') here_.x += number();
    if (command != 'h' && command != 'Z') here_.y += number();
    if (command == 'M') start_ = here_;
    read.to = here_;
    return read;
  }

  double number() {
    skip_spaces();
    std::size_t end = 0;
    bool point = false;
    for (; end < data_.size(); ++end) {
      const char c = data_[end];
      const bool belongs = (c >= '0' && c <= '9') || (c == '-' && end == 0) || (c == '.' && !point);
      if (!belongs) break;
      point = point || c == '.';
    }
    const double value = number_in(data_.substr(0, end));
    data_.remove_prefix(end);
    return value;
  }

  std::string_view data_;
  Vec2 here_{0, 0}, start_{0, 0};
};

/// The lines of a path without curves.
inline std::vector<Ink> ink_of(std::string_view path, double height) {
  std::vector<Ink> lines;
  for (const SvgPiece& piece : SvgPathReader(path).pieces()) {
    if (piece.command == 'M') lines.emplace_back();
    if (piece.command == 'Z') {
      lines.back().closed = true;
    } else {
      lines.back().points.emplace_back(piece.to.x, height - piece.to.y);
    }
  }
  return lines;
}

inline std::vector<Ink> ink_of(const pugi::xml_node& layer, double height) {
  std::vector<Ink> lines;
  for (const pugi::xml_node path : layer.children("path"))
    for (Ink& line : ink_of(std::string_view(path.attribute("d").value()), height)) lines.push_back(std::move(line));
  return lines;
}

/// The layers that hold lines, in order of the document: those inside of a view's, or those without a view.
inline std::vector<pugi::xml_node> layers_of(const pugi::xml_document& document) {
  std::vector<pugi::xml_node> layers;
  for (const pugi::xml_node outer : document.child("svg").children("g")) {
    if (outer.attribute("class")) layers.push_back(outer);
    for (const pugi::xml_node inner : outer.children("g")) layers.push_back(inner);
  }
  return layers;
}

}  // namespace epura
