// SPDX-License-Identifier: Apache-2.0
#include "annotations/detail_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "sheet/box_index.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

constexpr double gap = 1;  // mm between a letter and all ink
constexpr double detail_leader_step = 3, longest_leader = 45;
// Preferred directions first: up to the right, as a reader expects it.
constexpr std::array<int, 16> letter_directions = {45,  135, 315, 225, 30, 60, 120, 150,
                                                   330, 300, 210, 240, 0,  90, 180, 270};
constexpr int corners_of_circle = 360;

// Distance from the centre to the boundary in a direction.
double reach_of(const drawing::Boundary& boundary, const Vec2& direction) {
  if (boundary.round) return boundary.half.x;
  double reach = HUGE_VAL;
  for (const int axis : {0, 1})
    if (std::abs(direction[axis]) > 1e-12) reach = std::min(reach, boundary.half[axis] / std::abs(direction[axis]));
  return reach;
}

/// What letters must not touch. All details share it: each may try some hundred places.
class LetterObstacles {
 public:
  LetterObstacles(const LetterRoom& room, std::span<const Stroke> boundaries, const Lettering& lettering)
      : area_(room.area) {
    for (const Layer& layer : room.drawn) {
      for (const Stroke& stroke : layer.strokes) add(stroke);
      Layer rest;
      rest.fills = layer.fills;
      rest.texts = layer.texts;
      add(boxes_of(rest, lettering));
    }
    for (const Stroke& boundary : boundaries) add(boundary);
    add(room.reserved);
  }

  void add(std::span<const TurnedBox> boxes) {
    boxes_.add(boxes);
    count_ += static_cast<int>(boxes.size());
  }

  /// How many obstacles a letter would touch, counted no further once they are more than `most`; being outside the
  /// area counts most.
  [[nodiscard]] int touched_by(const TurnedBox& letter, double most = HUGE_VAL) const {
    const int outside = area_.holds(around(letter)) ? 0 : count_ + 1;
    TurnedBox wide = letter;
    wide.half += gap;
    return outside + (outside <= most ? boxes_.overlaps(wide, most - outside) : 0);
  }

 private:
  void add(const Stroke& stroke) {
    std::vector<TurnedBox> lines;
    const std::size_t count = stroke.points.size();
    for (std::size_t i = stroke.closed ? 0 : 1; i < count; ++i)
      lines.push_back(line_box(stroke.points[(i + count - 1) % count], stroke.points[i]));
    add(lines);
  }

  Rectangle area_;
  BoxIndex boxes_{};
  int count_ = 0;
};

struct LetterPlace {
  Vec2 from;      ///< the boundary, where a leader begins
  double leader;  ///< its length, mm; 0: none
  TurnedBox letter;
};

LetterPlace place_at(const drawing::Boundary& boundary, int degrees, double leader, const Vec2& half) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec2 direction(portable_cos(angle), portable_sin(angle));
  const Vec2 from = boundary.centre + reach_of(boundary, direction) * direction;
  const double to_middle = std::abs(direction.x) * half.x + std::abs(direction.y) * half.y + gap;
  return {from, leader, {from + (leader + to_middle) * direction, {1, 0}, half}};
}

// The nearest free place, or the one that touches least.
LetterPlace best_place(const drawing::Boundary& boundary, const Vec2& half, const LetterObstacles& obstacles) {
  LetterPlace best = place_at(boundary, letter_directions[0], 0, half);
  int touched = obstacles.touched_by(best.letter);
  for (double leader = 0; touched > 0 && leader <= longest_leader; leader += detail_leader_step)
    for (const int degrees : letter_directions) {
      const LetterPlace place = place_at(boundary, degrees, leader, half);
      const int here = obstacles.touched_by(place.letter, touched);
      if (here < touched) {
        best = place;
        touched = here;
      }
    }
  return best;
}

}  // namespace

Stroke boundary_line(const drawing::Boundary& boundary) {
  if (!boundary.round) return outline(box_of(boundary));
  Stroke circle;
  circle.closed = true;
  const double radius = boundary.half.x;
  for (int i = 0; i < corners_of_circle; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners_of_circle;
    circle.points.push_back(boundary.centre + radius * Vec2(portable_cos(angle), portable_sin(angle)));
  }
  circle.curves = {{0, corners_of_circle, boundary.centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi}};
  return circle;
}

Layer detail_marks(const std::string& view, std::span<const DetailMark> marks, const LetterRoom& room,
                   const Lettering& lettering, const LineWidths& widths) {
  Layer layer = empty_layer(view, scene::SheetLine::detail, widths);
  const double height = letter_widths * widths.narrow;
  std::vector<Stroke> boundaries;
  for (const DetailMark& mark : marks) boundaries.push_back(boundary_line(mark.boundary));
  LetterObstacles obstacles(room, boundaries, lettering);
  for (const DetailMark& mark : marks) {
    const Vec2 half = Vec2(lettering.width(mark.name, height), height) / 2.0;
    const LetterPlace place = best_place(mark.boundary, half, obstacles);
    if (place.leader > 0) {
      const Vec2 direction = glm::normalize(place.letter.centre - place.from);
      layer.strokes.push_back(line(place.from, place.from + place.leader * direction));
    }
    layer.texts.push_back({mark.name, place.letter.centre - Vec2(0, height / 2), height, 0, Align::middle, "detail"});
    obstacles.add({&place.letter, 1});
  }
  append(layer.strokes, std::move(boundaries));
  check(layer.texts.size() == marks.size() && layer.strokes.size() <= 2 * marks.size(),
        "a detail has a boundary, a letter, and a leader at most");
  return layer;
}

}  // namespace epura::sheet
