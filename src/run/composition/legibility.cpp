// SPDX-License-Identifier: Apache-2.0
#include "composition/legibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "drawing/ink_cells.hpp"
#include "scene/line_roles.hpp"
#include "sheet/boxes.hpp"
#include "sheet/lettering.hpp"
#include "sheet/marks.hpp"

namespace epura::pipeline {

namespace {

using sheet::TurnedBox;

constexpr double touching = 0.1;   // mm: descenders reach as deep into the dimension line below
constexpr double on_line = 0.001;  // mm

// Whose ink something is: a dimension of a layer, or the rest of it.
struct Owner {
  std::size_t layer;
  int dimension;  // -1: none

  bool operator==(const Owner&) const = default;
};

struct ReadText {
  TurnedBox box;
  Owner owner;
  std::string_view text;
};

struct DrawnLine {
  Vec2 from, to;
  Owner owner;
  const sheet::Stroke* stroke;  // null: the border of an area
};

// The ink of a text; nothing if it has none.
std::optional<TurnedBox> ink_of(const sheet::Text& text, const sheet::Lettering& lettering) {
  Vec2 low(HUGE_VAL), high(-HUGE_VAL);
  for (const sheet::GlyphOutline& outline : lettering.outlines(text.text, text.height))
    for (const auto& curve : outline.curves) {
      low = glm::min(low, curve.end);
      high = glm::max(high, curve.end);
    }
  if (low.x > high.x) return std::nullopt;
  const TurnedBox whole = sheet::box_of(text, lettering);
  const Vec2 corner = whole.centre - whole.half.x * whole.along - whole.half.y * left_of(whole.along);
  const Vec2 middle = (low + high) / 2.0;
  return TurnedBox{corner + middle.x * whole.along + middle.y * left_of(whole.along), whole.along,
                   glm::max(Vec2(0), (high - low) / 2.0 - touching)};
}

bool is_in(std::size_t number, const sheet::InkRange& range) { return number >= range.begin && number < range.end; }

// The dimension of a layer that has a piece of ink; of several that are drawn together, the first.
int dimension_of(const sheet::Layer& layer, std::size_t number, sheet::InkRange sheet::DimensionObject::*ink) {
  for (std::size_t i = 0; i < layer.dimensions.size(); ++i)
    if (is_in(number, layer.dimensions[i].*ink)) return static_cast<int>(i);
  return -1;
}

std::vector<ReadText> texts_of(const sheet::Sheet& sheet, const sheet::Lettering& lettering) {
  std::vector<ReadText> texts;
  for (std::size_t k = 0; k < sheet.layers.size(); ++k)
    for (std::size_t i = 0; i < sheet.layers[k].texts.size(); ++i) {
      const sheet::Text& text = sheet.layers[k].texts[i];
      const int dimension = dimension_of(sheet.layers[k], i, &sheet::DimensionObject::texts);
      if (const auto box = ink_of(text, lettering)) texts.push_back({*box, {k, dimension}, text.text});
    }
  return texts;
}

// Of strokes, and of the borders of areas, such as arrows.
std::vector<DrawnLine> lines_of(const sheet::Sheet& sheet) {
  std::vector<DrawnLine> lines;
  const auto add = [&lines](const std::vector<Vec2>& points, bool is_closed, const Owner& owner,
                            const sheet::Stroke* stroke) {
    for (std::size_t i = 1; i < points.size(); ++i) lines.push_back({points[i - 1], points[i], owner, stroke});
    if (is_closed && points.size() > 2) lines.push_back({points.back(), points.front(), owner, stroke});
  };
  for (std::size_t k = 0; k < sheet.layers.size(); ++k) {
    const sheet::Layer& layer = sheet.layers[k];
    for (std::size_t i = 0; i < layer.strokes.size(); ++i)
      add(layer.strokes[i].points, layer.strokes[i].closed,
          {k, dimension_of(layer, i, &sheet::DimensionObject::strokes)}, &layer.strokes[i]);
    for (std::size_t i = 0; i < layer.fills.size(); ++i)
      for (const std::vector<Vec2>& ring : layer.fills[i].rings)
        add(ring, true, {k, dimension_of(layer, i, &sheet::DimensionObject::fills)}, nullptr);
  }
  return lines;
}

std::string view_of(const sheet::Layer& layer) {
  const std::size_t slash = layer.name.rfind('/');
  return slash == std::string::npos ? "" : layer.name.substr(0, slash);
}

/// Collects findings of a sheet, each once.
class Found {
 public:
  explicit Found(const sheet::Sheet& sheet) : sheet_(sheet) {}

  void add(const Owner& in, std::string what) {
    report::Finding finding{report::FindingKind::crossing, view_of(sheet_.layers[in.layer]), std::move(what)};
    if (known_.insert(finding.view + "\n" + finding.what).second) findings_.push_back(std::move(finding));
  }

  [[nodiscard]] const sheet::DimensionObject* dimension(const Owner& owner) const {
    return owner.dimension < 0 ? nullptr
                               : &sheet_.layers[owner.layer].dimensions[static_cast<std::size_t>(owner.dimension)];
  }

  // "a line of '30'", "a centre line"
  [[nodiscard]] std::string name_of_line(const Owner& owner) const {
    if (const sheet::DimensionObject* of = dimension(owner)) return "a line of '" + of->text + "'";
    std::string style = sheet_.layers[owner.layer].style.name;
    std::replace(style.begin(), style.end(), '-', ' ');
    return "a " + style + " line";
  }

  std::vector<report::Finding> take() { return std::move(findings_); }

 private:
  const sheet::Sheet& sheet_;
  std::vector<report::Finding> findings_;
  std::set<std::string> known_;
};

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

// Calls visit(i, j), i < j, for all whose boxes meet.
template <class Visit>
void visit_meeting(const std::vector<sheet::Rectangle>& boxes, const Visit& visit) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].min.x; });
  for (auto one = order.begin(); one != order.end(); ++one)
    for (auto other = one + 1; other != order.end() && boxes[*other].min.x <= boxes[*one].max.x; ++other)
      if (boxes[*one].min.y <= boxes[*other].max.y && boxes[*other].min.y <= boxes[*one].max.y)
        visit(std::min(*one, *other), std::max(*one, *other));
}

sheet::Rectangle box_of(const DrawnLine& line) { return {glm::min(line.from, line.to), glm::max(line.from, line.to)}; }

void find_lines_through_texts(Found& found, const std::vector<DrawnLine>& lines, const std::vector<ReadText>& texts) {
  if (lines.empty()) return;
  constexpr double cell = 1;  // mm
  sheet::Rectangle all = box_of(lines.front());
  for (const DrawnLine& line : lines) all = sheet::united(all, box_of(line));
  drawing::InkCells cells(all.min, all.max, cell);
  for (const DrawnLine& line : lines) cells.add(line.from, line.to);
  for (const ReadText& text : texts) {
    const Vec2 half = text.box.half.x * text.box.along;
    for (const int number : cells.find(text.box.centre - half, text.box.centre + half, text.box.half.y)) {
      const DrawnLine& line = lines[static_cast<std::size_t>(number)];
      if (sheet::overlap(text.box, sheet::line_box(line.from, line.to)))
        found.add(text.owner, in_quotes(text.text) + " and " + found.name_of_line(line.owner));
    }
  }
}

void find_texts_on_texts(Found& found, const std::vector<ReadText>& texts) {
  std::vector<sheet::Rectangle> boxes;
  for (const ReadText& text : texts) boxes.push_back(sheet::around(text.box));
  visit_meeting(boxes, [&](std::size_t i, std::size_t j) {
    if (sheet::overlap(texts[i].box, texts[j].box))
      found.add(texts[i].owner, in_quotes(texts[i].text) + " and " + in_quotes(texts[j].text));
  });
}

bool is_straight(const sheet::DimensionObject& object) {
  return object.shape == sheet::DimensionShape::linear && object.points.size() == 3;
}

// Whether a line lies on the dimension line of a length.
bool is_on_dimension_line(const DrawnLine& line, const sheet::DimensionObject& object) {
  if (!is_straight(object)) return false;
  const Vec2 across = left_of(sheet::turned_to(object.angle * full_turn / 360));
  return std::abs(glm::dot(line.from - object.points[2], across)) <= on_line &&
         std::abs(glm::dot(line.to - object.points[2], across)) <= on_line;
}

// Whether each goes on to both sides of where they meet.
bool do_cross(const DrawnLine& a, const DrawnLine& b) {
  const Vec2 one = a.to - a.from, other = b.to - b.from;
  const double turn = cross(one, other), lengths = glm::length(one) * glm::length(other);
  if (std::abs(turn) <= 1e-3 * lengths) return false;
  const double s = cross(b.from - a.from, other) / turn, t = cross(b.from - a.from, one) / turn;
  const double s_slack = touching / glm::length(one), t_slack = touching / glm::length(other);
  return s > s_slack && s < 1 - s_slack && t > t_slack && t < 1 - t_slack;
}

// Whether a line is part of a leader, which bends into a shoulder below its text.
bool is_of_leader(const DrawnLine& line, const sheet::Layer& layer) {
  constexpr std::array layers{scene::SheetLine::dimension, scene::SheetLine::note, scene::SheetLine::symbol};
  const bool is_there =
      std::ranges::any_of(layers, [&](scene::SheetLine one) { return layer.style.name == scene::row_of(one).name; });
  return is_there && line.stroke != nullptr && !line.stroke->closed && line.stroke->points.size() == 3 &&
         line.stroke->curves.empty();
}

// The text nearest to a shoulder.
std::string text_at(const DrawnLine& leader, const std::vector<ReadText>& texts) {
  const Vec2 shoulder = (leader.stroke->points[1] + leader.stroke->points[2]) / 2.0;
  const auto distance = [&](const ReadText& text) {
    return text.owner.layer == leader.owner.layer ? glm::distance(text.box.centre, shoulder) : HUGE_VAL;
  };
  const auto nearest = std::ranges::min_element(texts, {}, distance);
  return nearest == texts.end() ? "" : std::string(nearest->text);
}

// Dimension lines with each other, and leaders.
void find_crossing_lines(Found& found, const sheet::Sheet& sheet, const std::vector<DrawnLine>& all,
                         const std::vector<ReadText>& texts) {
  struct Line {
    DrawnLine drawn;
    bool is_leader;
  };
  std::vector<Line> lines;
  for (const DrawnLine& line : all) {
    const sheet::Layer& layer = sheet.layers[line.owner.layer];
    const bool is_leader = is_of_leader(line, layer);
    bool is_length = false;
    if (const sheet::DimensionObject* first = found.dimension(line.owner)) {
      is_length = is_on_dimension_line(line, *first);
      // Those that are drawn together with the first one have no ink of their own.
      for (auto i = static_cast<std::size_t>(line.owner.dimension) + 1;
           i < layer.dimensions.size() && layer.dimensions[i].strokes.begin == layer.dimensions[i].strokes.end; ++i)
        is_length = is_length || is_on_dimension_line(line, layer.dimensions[i]);
    }
    if (is_leader || is_length) lines.push_back({line, is_leader});
  }
  const auto name_of = [&](const Line& line) {
    return in_quotes(line.is_leader ? text_at(line.drawn, texts) : found.dimension(line.drawn.owner)->text);
  };
  std::vector<sheet::Rectangle> boxes;
  for (const Line& line : lines) boxes.push_back(box_of(line.drawn));
  visit_meeting(boxes, [&](std::size_t i, std::size_t j) {
    const Line &one = lines[i], &other = lines[j];
    const bool are_one =
        one.drawn.stroke == other.drawn.stroke || (!one.is_leader && one.drawn.owner == other.drawn.owner);
    if (!are_one && one.is_leader == other.is_leader && do_cross(one.drawn, other.drawn))
      found.add(one.drawn.owner, name_of(one) + " and " + name_of(other));
  });
}

// Lengths of which one lies on the other: of ink that coincides only one is drawn.
void find_lengths_on_lengths(Found& found, const sheet::Sheet& sheet) {
  std::vector<Owner> owners;
  std::vector<sheet::TurnedBox> lines;
  std::vector<sheet::Rectangle> boxes;
  for (std::size_t k = 0; k < sheet.layers.size(); ++k)
    for (std::size_t i = 0; i < sheet.layers[k].dimensions.size(); ++i) {
      const sheet::DimensionObject& object = sheet.layers[k].dimensions[i];
      if (!is_straight(object) || object.oblique != 0) continue;
      const Vec2 along = sheet::turned_to(object.angle * full_turn / 360);
      const auto foot = [&](const Vec2& end) {
        return object.points[2] + glm::dot(end - object.points[2], along) * along;
      };
      sheet::TurnedBox line = sheet::line_box(foot(object.points[0]), foot(object.points[1]));
      line.half = {std::max(0.0, line.half.x - touching), on_line};
      owners.push_back({k, static_cast<int>(i)});
      lines.push_back(line);
      boxes.push_back(sheet::around(line));
    }
  visit_meeting(boxes, [&](std::size_t i, std::size_t j) {
    if (sheet::look_parallel(lines[i], lines[j]) && sheet::overlap(lines[i], lines[j]))
      found.add(owners[i],
                in_quotes(found.dimension(owners[i])->text) + " and " + in_quotes(found.dimension(owners[j])->text));
  });
}

// Texts of dimensions inside the ink of another view, as whose sizes they would be read.
void find_in_other_views(Found& found, const sheet::Sheet& sheet, const std::vector<ReadText>& texts) {
  for (const ReadText& text : texts) {
    if (text.owner.dimension < 0) continue;
    const std::string view = view_of(sheet.layers[text.owner.layer]);
    for (const sheet::ViewFrame& other : sheet.views)
      if (other.name != view && sheet::overlap(text.box, sheet::turned_box({other.min, other.max})))
        found.add(text.owner, in_quotes(text.text) + " and the view '" + other.name + "'");
  }
}

}  // namespace

std::vector<report::Finding> illegible_texts(const sheet::Sheet& sheet) {
  Found found(sheet);
  const sheet::Lettering lettering(sheet.font);
  const std::vector<ReadText> texts = texts_of(sheet, lettering);
  const std::vector<DrawnLine> lines = lines_of(sheet);
  find_lines_through_texts(found, lines, texts);
  find_texts_on_texts(found, texts);
  find_in_other_views(found, sheet, texts);
  find_crossing_lines(found, sheet, lines, texts);
  find_lengths_on_lengths(found, sheet);
  return found.take();
}

}  // namespace epura::pipeline
