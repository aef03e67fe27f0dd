// SPDX-License-Identifier: Apache-2.0
// Lengths that are arranged together: parallel dimension lines, a chain, or one line with a common origin. ISO 129-1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/length_reach.hpp"
#include "dimensions/straight.hpp"

namespace epura::sheet {

namespace {

constexpr int row_levels = 24;
constexpr int levels_of_shifted = 6;
constexpr double common_origin_radius = 0.35;  // of the circle at a common origin, in lengths of an arrow
constexpr double line_of_text = 1.5;           // between texts beside each other, in their heights
constexpr double dot_below = 1.2;              // between arrows, in their lengths: nearer ones are dots

// Positions of things of these sizes along a line, in order and as near to their wishes as they can be without
// touching: isotonic regression by pooling neighbours.
std::vector<double> spread(const std::vector<double>& wishes, const std::vector<double>& sizes) {
  struct Pool {
    double sum;
    std::size_t count;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  std::vector<double> offsets{0};
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    if (i > 0) offsets.push_back(offsets.back() + (sizes[i - 1] + sizes[i]) / 2);
    pools.push_back({wishes[i] - offsets[i], 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].count += pools.back().count;
      pools.pop_back();
    }
  }
  std::vector<double> positions;
  for (const Pool& pool : pools)
    for (std::size_t i = 0; i < pool.count; ++i) positions.push_back(pool.mean() + offsets[positions.size()]);
  check(positions.size() == wishes.size(), "every text of a row has a place");
  return positions;
}

/// A row whose dimension lines are on one side of the view.
class RowDrawer {
 public:
  /// `distance`: of the first dimension line to the left of `along`, from the first place. `shift`: of the texts of a
  /// common origin along the row, beside the line through the origin, from which an overall size may be measured, too.
  RowDrawer(const MeasuredRow& row, const std::vector<Vec2>& places, double distance, const DimensionStyle& style,
            std::optional<double> shift = std::nullopt)
      : row_(row),
        places_(places),
        style_(style),
        across_(left_of(row.along)),
        away_(distance < 0 ? -1 : 1),
        distance_(distance),
        shift_(shift) {
    for (const DimensionText& text : row.texts) height_ = std::max(height_, style.height(text));
  }

  PlacedDimension draw() && {
    middles_.assign(row_.texts.size(), Vec2(0));
    switch (row_.arrangement) {
      case DimensionArrangement::baseline:
        draw_baseline();
        break;
      case DimensionArrangement::chain:
        draw_chain();
        break;
      case DimensionArrangement::ordinate:
        draw_ordinate();
        break;
    }
    return std::move(drawn_);
  }

 private:
  // Where the extension line of a place meets the dimension line of this level.
  [[nodiscard]] Vec2 foot(std::size_t place, int level = 0) const {
    const double distance = distance_ + away_ * level * dimension_step(height_);
    return places_[place] + (distance - glm::dot(places_[place] - places_.front(), across_)) * across_;
  }
  [[nodiscard]] double at(std::size_t place) const { return glm::dot(places_[place], row_.along); }
  void extend(std::size_t place, int level = 0) {
    add_extension_line(drawn_, places_[place], foot(place, level), style_);
  }

  // Writes the text of a number in the row.
  void letter(std::size_t number, const TextPosition& at) {
    set_text(drawn_, row_.texts[number], at, style_);
    middles_[number] = drawn_.text_boxes.back().centre;
  }

  // As one thing: a length between two places, or the distance of a place from the origin.
  void add_object(std::size_t number, DimensionShape shape, std::vector<Vec2> points) {
    DimensionObject& object = drawn_.objects.emplace_back(DimensionObject{shape, std::move(points)});
    object.angle = std::abs(row_.along.x) > std::abs(row_.along.y) ? 0 : 90;
    object.text = row_.texts[number].line();
    object.value = row_.values[number];
    object.text_middle = middles_[number];
  }

  [[nodiscard]] DimensionLine line(const Vec2& from, const Vec2& to) const {
    const bool swaps = glm::dot(to - from, row_.along) < 0;
    return {swaps ? to : from, swaps ? from : to, row_.along, std::abs(glm::dot(to - from, row_.along))};
  }

  // Short ones inside. A text that does not fit is on the side of the origin, where no extension line crosses it.
  void draw_baseline() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (i != row_.origin) order.push_back(i);
    const auto length = [this](std::size_t i) { return std::abs(at(i) - at(row_.origin)); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
    int level = 0;
    for (const std::size_t i : order) {
      const Vec2 origin = foot(row_.origin, level), end = foot(i, level);
      const DimensionLine base = line(origin, end);
      add_dimension_line(drawn_, base, row_.texts[i], base.low == origin ? 1 : 0, style_);
      middles_[i] = drawn_.text_boxes.back().centre;
      add_object(i, DimensionShape::linear, {places_[row_.origin], places_[i], end});
      extend(i, level++);
    }
    extend(row_.origin, level - 1);
  }

  // Between lines that are near each other, arrows have no room: a dot ends both lengths.
  void draw_chain() {
    const std::size_t last = places_.size() - 1;
    const Vec2 read = row_.along;
    std::vector<Vec2> feet;
    for (std::size_t i = 0; i <= last; ++i) {
      extend(i);
      feet.push_back(foot(i));
    }
    const auto span = [&](std::size_t i) { return glm::dot(feet[i + 1] - feet[i], read); };
    const auto has_arrows = [&](std::size_t i) { return span(i) >= arrows_inside * style_.arrow(); };
    double begin = 0, end = glm::dot(feet[last] - feet[0], read);
    for (std::size_t i = 0; i <= last; ++i) {
      const bool before = i > 0 && has_arrows(i - 1), after = i < last && has_arrows(i);
      if (before) drawn_.arrows.push_back(arrow_at(feet[i], read, style_));
      if (after) drawn_.arrows.push_back(arrow_at(feet[i], -read, style_));
      if (before || after) continue;
      if (i > 0 && i < last) {
        drawn_.arrows.push_back(dot_at(feet[i]));
        continue;
      }
      drawn_.arrows.push_back(arrow_at(feet[i], i == 0 ? read : -read, style_));
      (i == 0 ? begin : end) += (i == 0 ? -2 : 2) * style_.arrow();
    }
    std::vector<std::size_t> beyond;
    std::vector<double> middles;
    for (std::size_t i = 0; i < last; ++i) {
      const DimensionText& text = row_.texts[i];
      const double middle = glm::dot(feet[i] - feet[0], read) + span(i) / 2;
      if (style_.width(text) + style_.above() <= span(i)) {
        letter(i, {feet[0] + middle * read, read, style_.above()});
      } else if (i == 0 || i + 1 == last) {
        add_outside(i, feet[0], i == 0, begin, end);
      } else {
        beyond.push_back(i);
        middles.push_back(middle);
      }
    }
    add_beyond(beyond, middles, feet[0]);
    check(drawn_.text_boxes.size() == last, "every step of a chain has its text");
    finish_line(feet[0], begin, end);
    for (std::size_t i = 0; i < last; ++i)
      add_object(i, DimensionShape::linear, {places_[i], places_[i + 1], feet[i + 1]});
  }

  // Beyond the end of a row.
  void add_outside(std::size_t number, const Vec2& first, bool at_begin, double& begin, double& end) {
    const Vec2 read = row_.along;
    const double width = style_.width(row_.texts[number]), gap = 2 * style_.above();
    const double middle = at_begin ? begin - gap - width / 2 : end + gap + width / 2;
    letter(number, {first + middle * read, read, style_.above()});
    (at_begin ? begin : end) += (at_begin ? -1 : 1) * (gap + width + style_.above());
  }

  // Texts that do not fit between their extension lines: in a row of their own past the ends of these and the other
  // texts, with leaders to the middles of their lengths.
  void add_beyond(const std::vector<std::size_t>& numbers, const std::vector<double>& middles, const Vec2& first) {
    const Vec2 read = row_.along, out = away_ * across_;
    std::vector<double> widths;
    check(middles.size() == numbers.size(), "every text of a row belongs to a length");
    for (const std::size_t i : numbers) widths.push_back(style_.width(row_.texts[i]) + 2 * style_.above());
    const std::vector<double> positions = spread(middles, widths);
    const bool is_up = glm::dot(out, left_of(read)) > 0;
    const double straight = std::max(style_.overshoot(), is_up ? height_ + 2 * style_.above() : 0);
    const double near = straight + style_.text;  // edge of the texts
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Vec2 on_line = first + middles[i] * read, bend = on_line + straight * out;
      const Vec2 end = first + positions[i] * read + near * out;
      drawn_.strokes.emplace_back().points = {on_line, bend, end};
      drawn_.lines.push_back(line_box(on_line, bend));
      drawn_.lines.push_back(line_box(bend, end));
      const double rise = is_up ? style_.above() : -style_.above() - style_.height(row_.texts[numbers[i]]);
      letter(numbers[i], {end, read, rise});
      drawn_.zones.push_back(drawn_.text_boxes.back());
    }
  }

  // Lines from the origin, each with an arrow; numbers in line with the extension lines.
  void draw_ordinate() {
    const Vec2 first = foot(0), out = away_ * across_;
    const std::size_t parted = ordinates_before_line();
    const std::vector<double> shifted = ordinate_positions(parted);
    std::array<double, 2> jogs{};  // of the texts on either side of the line through the origin
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (std::abs(shifted[i] - at(i)) > 1e-9)
        jogs[i < parted ? 0 : 1] = style_.text + std::abs(shift_.value_or(0)) / 4;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      extend(i);
      const double jog = jogs[i < parted ? 0 : 1];
      const Vec2 end = foot(i) + style_.overshoot() * out;
      const Vec2 begin_of_text = end + jog * out + (shifted[i] - at(i)) * row_.along;
      if (jog > 0) add_crossable_line(drawn_, end, begin_of_text);
      const double width = style_.width(row_.texts[i]);
      const Vec2 middle = begin_of_text + (style_.above() + width / 2) * out;
      letter(i, {middle, reading_direction(out), -style_.text / 2});
      add_object(i, DimensionShape::ordinate, {places_[row_.origin], places_[i], begin_of_text});
      drawn_.zones.push_back(drawn_.text_boxes.back());
      if (i != row_.origin) add_arrow(i);
    }
    check(drawn_.text_boxes.size() == places_.size(), "every place of a row has its text");
    const double radius = common_origin_radius * style_.arrow();
    drawn_.strokes.push_back(circle_at(foot(row_.origin), radius));
    const double origin = at(row_.origin) - at(0), end = at(places_.size() - 1) - at(0);
    for (const auto& [from, to] : {std::array{0.0, origin - radius}, {origin + radius, end}})
      if (from < to) add_line(drawn_, first + from * row_.along, first + to * row_.along);
    add_zone(first, -radius, end + radius);
  }

  // How many texts are before the line through the origin, if none is on it. The text of the origin goes to the side
  // with fewer others.
  [[nodiscard]] std::size_t ordinates_before_line() const {
    const std::size_t before = row_.origin, after = places_.size() - 1 - before;
    return shift_ ? before + (before > after ? 0 : 1) : 0;
  }

  // Of the texts, along the row.
  [[nodiscard]] std::vector<double> ordinate_positions(std::size_t parted) const {
    const double step = line_of_text * style_.text, line = at(row_.origin);
    const std::size_t count = places_.size();
    std::vector<double> positions;
    for (const auto& [from, to] : {std::pair(std::size_t{0}, parted), {parted, count}}) {
      std::vector<double> wishes;
      for (std::size_t i = from; i < to; ++i) wishes.push_back(at(i));
      const std::vector<double> part = spread(wishes, std::vector<double>(wishes.size(), step));
      positions.insert(positions.end(), part.begin(), part.end());
    }
    for (std::size_t i = 0; i < count && shift_; ++i) {
      const double nearest = line + step * (static_cast<double>(i) - static_cast<double>(parted) + 0.5);
      positions[i] = i < parted ? std::min(positions[i] + *shift_, nearest) : std::max(positions[i] + *shift_, nearest);
    }
    return positions;
  }

  void add_arrow(std::size_t place) {
    const bool is_after = place > row_.origin;
    const std::size_t before = is_after ? place - 1 : place + 1;
    if (std::abs(at(place) - at(before)) < dot_below * style_.arrow())
      drawn_.arrows.push_back(dot_at(foot(place)));
    else
      drawn_.arrows.push_back(arrow_at(foot(place), is_after ? row_.along : -row_.along, style_));
  }

  // The dimension line of a chain, mm from its lower end, and the place that it takes up with arrows and texts.
  void finish_line(const Vec2& first, double begin, double end) {
    add_line(drawn_, first + begin * row_.along, first + end * row_.along);
    add_zone(first, begin, end);
  }
  void add_zone(const Vec2& first, double begin, double end) {
    const double below = style_.above(), top = 2 * style_.above() + height_;
    drawn_.zones.push_back({first + (begin + end) / 2 * row_.along + (top - below) / 2 * across_,
                            row_.along,
                            {(end - begin) / 2, (top + below) / 2}});
  }

  const MeasuredRow& row_;
  const std::vector<Vec2>& places_;
  const DimensionStyle& style_;
  Vec2 across_;
  double away_, distance_, height_ = 0;
  std::optional<double> shift_;
  PlacedDimension drawn_;
  std::vector<Vec2> middles_;  ///< of texts
};

// A row of some of the places, and of the origin.
MeasuredRow part_of(const MeasuredRow& row, const std::vector<bool>& taken, bool above) {
  MeasuredRow part{{}, 0, row.along, {}, row.arrangement};
  part.above = above;
  if (row.opposite) part.opposite.emplace();
  for (std::size_t i = 0; i < row.places.size(); ++i) {
    if (i == row.origin) part.origin = part.places.size();
    if (i != row.origin && !taken[i]) continue;
    part.places.push_back(row.places[i]);
    part.texts.push_back(row.texts[i]);
    if (i < row.values.size()) part.values.push_back(row.values[i]);
    if (row.opposite) part.opposite->push_back((*row.opposite)[i]);
  }
  return part;
}

// Whether texts of a row with a common origin are nearer to each other than they can be.
bool has_neighbours(const MeasuredRow& row, const DimensionStyle& style) {
  return std::adjacent_find(row.places.begin(), row.places.end(), [&](const Vec2& a, const Vec2& b) {
           return glm::dot(b - a, row.along) < line_of_text * style.text;
         }) != row.places.end();
}

}  // namespace

bool is_fan(const MeasuredRow& row, double room, const DimensionStyle& style) {
  constexpr std::size_t fewest = 4, max_on_a_side = 12;  // with the origin, and without it
  if (row.arrangement != DimensionArrangement::ordinate || row.places.size() < fewest) return false;
  return row.places.size() > max_on_a_side + 1 ||
         line_of_text * style.text * static_cast<double>(row.places.size() - 1) > room;
}

std::vector<MeasuredRow> on_two_sides(const MeasuredRow& row, const DimensionStyle& style) {
  if (!is_fan(row, row.size(), style)) return {row};
  std::vector<std::size_t> order;  // from below, or from the right; of places side by side, each second one above
  for (std::size_t i = 0; i < row.places.size(); ++i)
    if (i != row.origin) order.push_back(i);
  const auto rank = [&](std::size_t i) {
    return std::pair(std::round(glm::dot(row.places[i], left_of(row.along))), i % 2);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<bool> below(row.places.size(), false), above(row.places.size(), false);
  for (std::size_t k = 0; k < order.size(); ++k) (2 * k < order.size() ? below : above)[order[k]] = true;
  return {part_of(row, below, false), part_of(row, above, true)};
}

std::vector<ItemPlacement> placements_of(const MeasuredRow& row, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  const Vec2 across = left_of(row.along);
  const double upwards = sign_of_offset(across);
  std::vector<ItemPlacement> placements;
  // From the first place to the farthest one on this side.
  const auto reach_of_ends = [&](const std::vector<Vec2>& places, double side) {
    double reach = 0;
    for (const Vec2& place : places) reach = std::max(reach, side * glm::dot(place - places.front(), across));
    return reach;
  };
  if (measured.offset) {
    const double side = *measured.offset < 0 ? -upwards : upwards;
    const double distance = side * (reach_of_ends(row.places, side) + std::abs(*measured.offset));
    placements.push_back({RowDrawer(row, row.places, distance, style).draw(), 0});
    return placements;
  }
  const bool vertical = std::abs(row.along.y) > std::abs(row.along.x);
  const double first_side = vertical ? upwards : -upwards;
  for (const double side : {first_side, -first_side}) {
    if (row.above && *row.above != (side != first_side)) continue;
    const std::vector<Vec2>& places = side != first_side && row.opposite ? *row.opposite : row.places;
    const MeasuredLength ends{places.front(), places.back(), row.along, across};
    const Reach reach = reach_of_ink(ends, drawing);
    const double outline = side > 0 ? reach.max : -reach.min;
    double extensions = 0;
    for (const Vec2& place : places) extensions += outline - side * glm::dot(place - places.front(), across);
    for (int level = 0; level < row_levels; ++level) {
      const double distance = side * (outline + first_dimension + level * dimension_step(style.text));
      const double cost = cost_of_extension * extensions + cost_of_level * level;
      placements.push_back({RowDrawer(row, places, distance, style).draw(), cost});
      if (level >= levels_of_shifted || row.arrangement != DimensionArrangement::ordinate) continue;
      for (const double shift : {0, -10, 10, -20, 20, -30, 30, -40, 40})
        if (shift == 0 || has_neighbours(row, style))
          placements.push_back({RowDrawer(row, places, distance, style, shift).draw(),
                                cost + cost_of_shift * (line_of_text * style.text + std::abs(shift))});
    }
  }
  check(placements.size() >= (row.above ? std::size_t{1} : std::size_t{2}) * row_levels,
        "a row has places on its sides");
  return placements;
}

}  // namespace epura::sheet
