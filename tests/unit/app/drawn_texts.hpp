// SPDX-License-Identifier: Apache-2.0
// The texts of drawings as SVG: which dimensions there are, and where they stand.
#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "known_parts.hpp"
#include "sheet/boxes.hpp"
#include "sheet/lettering.hpp"
#include "svg/path.hpp"

namespace epura::test {

using Words = std::vector<std::string>;

/// The transform that lint proposes; empty if it does not.
inline std::string proposed_transform(const std::string& out) {
  const std::string before = "--transform '";
  const std::size_t begin = out.find(before);
  return begin == std::string::npos
             ? ""
             : out.substr(begin + before.size(), out.find('\'', begin + before.size()) - begin - before.size());
}

inline Words sorted(Words texts) {
  std::sort(texts.begin(), texts.end());
  return texts;
}

// The layers of dimensions of a drawing, one after the other.
inline std::string dimension_layers(const std::string& svg) {
  std::string layers;
  const std::string begin = "inkscape:label=\"dimensions\"";
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1))
    layers += svg.substr(at, svg.find("<g id=", at) - at);
  return layers;
}

// The texts of all dimensions of a drawing.
inline Words dimensions_in(const std::string& svg) {
  Words texts;
  static const std::regex text("aria-label=\"([^\"]*)\"");
  const std::string layers = dimension_layers(svg);
  for (std::sregex_iterator it(layers.begin(), layers.end(), text), end; it != end; ++it)
    texts.push_back((*it)[1].str());
  return texts;
}

// The boxes of all texts of a drawing with `--svg-text text`, measured with the font itself; y is down.
inline std::vector<std::pair<std::string, sheet::TurnedBox>> boxes_in(const std::string& svg) {
  static const std::regex text(
      "<text[^>]* x=\"([^\"]*)\" y=\"([^\"]*)\" font-size=\"([^\"]*)\"(?: text-anchor=\"([a-z]*)\")?"
      "(?: transform=\"rotate\\(([^ ]*) [^>]*)?>([^<]*)</text>");
  static const sheet::Lettering lettering;  // it reads the font
  std::vector<std::pair<std::string, sheet::TurnedBox>> boxes;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    const std::smatch& m = *it;
    const auto number = [&](std::size_t i) { return m[i].matched ? *parse_number(m[i].str()) : 0; };
    const double height = number(3) / lettering.em(), width = lettering.width(m[6].str(), height);
    const Vec2 along(cosine(number(5)), sine(number(5))), up(along.y, -along.x);
    const double shift = m[4] == "middle" ? 0 : m[4] == "end" ? -width / 2 : width / 2;
    boxes.push_back(
        {m[6].str(), {Vec2(number(1), number(2)) + shift * along + height / 2 * up, along, {width / 2, height / 2}}});
  }
  return boxes;
}

// The straight lines of all paths of a drawing, as boxes without width; y is down. Dashes are not told apart.
inline std::vector<sheet::TurnedBox> lines_in(const std::string& svg) {
  static const std::regex path("<path[^>]* d=\"([^\"]*)\"/>");
  std::vector<sheet::TurnedBox> lines;
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
    svg::PieceRoom room(svg.size(), "a drawing");
    const svg::Path read = svg::read_path((*it)[1].str(), room).value();
    for (const svg::Line& line : read.lines)
      for (std::size_t i = 1; i < line.points.size(); ++i)
        lines.push_back(sheet::line_box(line.points[i - 1], line.points[i]));
  }
  return lines;
}

}  // namespace epura::test
