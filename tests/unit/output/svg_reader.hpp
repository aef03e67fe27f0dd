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

/// Reads the data of a path: M, L, l, h, v, q (where it ends) and Z, repeated without their letter where SVG allows it.
class SvgPathReader {
 public:
  SvgPathReader(std::string_view data, double height) : data_(data), height_(height) {}

  std::vector<Ink> lines() {
    std::vector<Ink> lines;
    for (char command = 0; skip_spaces(), !data_.empty();) {
      const bool named = std::string_view("MLlhvqZ").find(data_[0]) != std::string_view::npos;
      if (named) command = take();
      if (command == 'M') lines.emplace_back();
      if (command == 'Z') {
        lines.back().closed = true;
        EXPECT_TRUE(named);
        continue;
      }
      step(command);
      if (command == 'M') command = 'L';
      lines.back().points.emplace_back(here_.x, height_ - here_.y);
    }
    return lines;
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

  void step(char command) {
    const bool absolute = command == 'M' || command == 'L';
    if (command == 'q') number(), number();  // the control point
    if (command != 'v') here_.x = number() + (absolute ? 0 : here_.x);
    if (command != 'h') here_.y = number() + (absolute ? 0 : here_.y);
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
  double height_;
  Vec2 here_{0, 0};
};

inline std::vector<Ink> ink_of(const pugi::xml_node& layer, double height) {
  std::vector<Ink> lines;
  for (const pugi::xml_node path : layer.children("path"))
    for (Ink& line : SvgPathReader(path.attribute("d").value(), height).lines()) lines.push_back(std::move(line));
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
