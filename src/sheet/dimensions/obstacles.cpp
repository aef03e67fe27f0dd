// SPDX-License-Identifier: Apache-2.0
#include "dimensions/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double size_of_arrow = 3.5;  // mm

bool any_of(const std::vector<TurnedBox>& boxes, const auto& test) {
  return std::any_of(boxes.begin(), boxes.end(), test);
}

std::vector<TurnedBox> boxes_of_leaders(const PlacedDimension& dimension) {
  std::vector<TurnedBox> boxes;
  for (const LeaderLine& leader : dimension.leaders) boxes.push_back(line_box(leader.tip, leader.elbow));
  return boxes;
}

// Where leaders end: others that come there seem to be one with them.
TurnedBox arrow_of(const LeaderLine& leader) {
  const Vec2 end = leader.tip + leader.before * glm::normalize(leader.tip - leader.elbow);
  return turned_box(Rectangle{end, end}.grown(nearest_lines / 2));
}

std::vector<TurnedBox> arrows_of(const PlacedDimension& dimension) {
  std::vector<TurnedBox> boxes;
  for (const LeaderLine& leader : dimension.leaders) boxes.push_back(arrow_of(leader));
  return boxes;
}

}  // namespace

std::vector<Disc> discs_of(const drawing::ViewDrawing& drawing) {
  constexpr std::size_t fewest = 8;   // points; fewer are a polygon
  constexpr double off_round = 0.02;  // of the radius
  std::vector<Disc> discs;
  for (const drawing::Chain& chain : drawing.chains) {
    if (!chain.closed || !chain.visible || chain.points.size() < fewest) continue;
    Rectangle box{chain.points.front(), chain.points.front()};
    for (const Vec2& p : chain.points) box = united(box, {p, p});
    const Disc disc{box.centre(), box.size().x / 2};
    if (std::all_of(chain.points.begin(), chain.points.end(), [&](const Vec2& p) {
          return std::abs(glm::distance(p, disc.centre) - disc.radius) <= off_round * disc.radius;
        }))
      discs.push_back(disc);
  }
  return discs;
}

bool goes_through(const LeaderLine& leader, const Disc& disc) {
  const double off = glm::distance(leader.tip, disc.centre);
  if (off <= disc.radius + on_line) return off < disc.radius - on_line && 2 * disc.radius <= size_of_arrow;
  const Vec2 way = leader.elbow - leader.tip;
  const double part =
      std::clamp(glm::dot(disc.centre - leader.tip, way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
  return glm::distance(leader.tip + part * way, disc.centre) < disc.radius;
}

Obstacles::Obstacles(const drawing::ViewDrawing& drawing, const Neighbours& neighbours)
    : paper_(neighbours.paper),
      others_(neighbours.boxes),
      views_(neighbours.views),
      letters_(neighbours.letters),
      other_texts_(neighbours.texts),
      other_zones_(neighbours.zones),
      ink_(drawing),
      discs_(discs_of(drawing)),
      hatched_(drawing) {}

void Obstacles::add(const PlacedDimension& item) {
  zones_.add(item.zones);
  texts_.add(item.text_boxes);
  lines_.add(item.lines);
  leaders_.add(boxes_of_leaders(item));
  arrows_.add(arrows_of(item));
}

void Obstacles::remove(const PlacedDimension& item) {
  zones_.remove(item.zones);
  texts_.remove(item.text_boxes);
  lines_.remove(item.lines);
  leaders_.remove(boxes_of_leaders(item));
  arrows_.remove(arrows_of(item));
}

double Obstacles::cost_of_leader(const LeaderLine& leader) const {
  const auto through =
      std::count_if(discs_.begin(), discs_.end(), [&leader](const Disc& disc) { return goes_through(leader, disc); }) +
      hatched_.on_way(leader.tip, leader.elbow);
  const TurnedBox line = line_box(leader.tip, leader.elbow);
  const BoxIndex::LinesBeside others = others_.beside(line, on_line, nearest_lines),
                              own = lines_.beside(line, on_line, nearest_lines);
  return cost_of_other * static_cast<double>(through + others.on_it + others.near + own.on_it + zones_.overlaps(line) +
                                             other_zones_.overlaps(line)) +
         cost_of_letter * (leaders_.overlaps(line) + leaders_.overlaps(arrow_of(leader)) + arrows_.overlaps(line)) +
         cost_of_text * zones_.along(line);
}

namespace {

// What so many overlaps cost is computed no further once the sum exceeds `max`: above it whatever the rounding, for all
// but the ink is a sum of whole numbers, and a tie is computed to its end.
void add_overlaps(double& cost, double max, double each, const TurnedBox& box,
                  std::initializer_list<const BoxIndex*> indices) {
  for (const BoxIndex* index : indices)
    if (cost <= max) cost += each * index->overlaps(box, (max - cost) / each);
}

}  // namespace

double Obstacles::cost_of_line(const TurnedBox& line, double max) const {
  double cost = 0;
  add_overlaps(cost, max, cost_of_zone, line, {&views_});
  add_overlaps(cost, max, cost_of_text, line, {&texts_, &other_texts_});
  add_overlaps(cost, max, cost_of_letter, line, {&letters_});
  if (cost <= max) cost += cost_of_letter * lines_.beside(line, on_line, nearest_lines).near;
  add_overlaps(cost, max, cost_of_other, line, {&others_});
  add_overlaps(cost, max, cost_of_crossing, line, {&zones_, &others_, &other_zones_});
  return cost;
}

double Obstacles::cost_of_way(const LeaderLine& leader) const {
  return cost_of_line(line_box(leader.tip, leader.elbow), HUGE_VAL) + cost_of_leader(leader);
}

double Obstacles::cost(const PlacedDimension& item, double max) const {
  double cost = 0;
  // Rows have hundreds of boxes, and in a crowd each meets hundreds of others.
  const auto add_all = [&](const std::vector<TurnedBox>& boxes, const auto& add) {
    for (auto box = boxes.begin(); box != boxes.end() && cost <= max; ++box) add(*box);
  };
  add_all(item.text_boxes, [&](const TurnedBox& text) { add_overlaps(cost, max, cost_of_text, text, {&lines_}); });
  add_all(item.zones, [&](const TurnedBox& zone) {
    if (paper_ && !paper_->holds(around(zone))) cost += cost_of_zone;
    add_overlaps(cost, max, cost_of_zone, zone, {&zones_, &others_, &other_zones_});
    add_overlaps(cost, max, cost_of_crossing, zone, {&lines_});
  });
  add_all(item.lines, [&](const TurnedBox& line) { cost += cost_of_line(line, max - cost); });
  for (const LeaderLine& leader : item.leaders) cost += cost <= max ? cost_of_leader(leader) : 0;
  add_all(item.text_boxes, [&](const TurnedBox& text) { cost += ink_.in(text) > 0 ? cost_of_text : 0; });
  add_all(item.lines, [&](const TurnedBox& line) { cost += cost_of_ink * ink_.in(line); });
  check(cost >= 0, "nothing is better than free paper");
  return cost;
}

bool Obstacles::meets(const PlacedDimension& item) const {
  return any_of(item.text_boxes, [&](const TurnedBox& one) { return others_.meets(one) || other_zones_.meets(one); }) ||
         any_of(item.lines, [&](const TurnedBox& one) { return other_texts_.meets(one); });
}

bool Obstacles::is_in_other_view(const PlacedDimension& item) const {
  const auto is_there = [&](const TurnedBox& one) { return views_.meets(one); };
  return any_of(item.zones, is_there) || any_of(item.lines, is_there);
}

bool Obstacles::is_beyond(const PlacedDimension& item) const {
  const auto is_out = [&](const TurnedBox& one) { return !paper_->holds(around(one)); };
  return paper_ && (any_of(item.zones, is_out) || any_of(item.lines, is_out));
}

bool Obstacles::is_on_lines(const PlacedDimension& item) const {
  return any_of(item.text_boxes, [&](const TurnedBox& one) { return ink_.in(one) > 0; });
}

int Obstacles::faults(const PlacedDimension& item) const {
  return (is_beyond(item) ? 1 : 0) + (meets(item) ? 1 : 0) + (is_in_other_view(item) ? 1 : 0) +
         (is_on_lines(item) ? 1 : 0);
}

bool have_conflicts(const PlacedDimensions& placed, const Obstacles& obstacles) {
  for (auto one = placed.begin(); one != placed.end(); ++one) {
    if (!*one) continue;
    const auto conflicts_with = [&](const std::optional<PlacedDimension>& other) {
      return other && (do_cross(**one, *other) || have_crossing_leaders(**one, *other));
    };
    if (obstacles.is_in_other_view(**one) || obstacles.meets(**one) || obstacles.is_on_lines(**one) ||
        std::any_of(std::next(one), placed.end(), conflicts_with))
      return true;
  }
  return false;
}

namespace {

constexpr double min_cell = 1;  // mm

Rectangle box_of_ink(const drawing::ViewDrawing& drawing) {
  if (drawing.segments.empty()) return {Vec2(0), Vec2(0)};
  Rectangle box{drawing.segments.front().from, drawing.segments.front().from};
  for (const drawing::Segment& segment : drawing.segments)
    box = {glm::min(box.min, glm::min(segment.from, segment.to)),
           glm::max(box.max, glm::max(segment.from, segment.to))};
  return box;
}

}  // namespace

InkIndex::InkIndex(const drawing::ViewDrawing& drawing)
    : drawing_(drawing), cells_(box_of_ink(drawing).min, box_of_ink(drawing).max, min_cell) {
  for (const drawing::Segment& segment : drawing.segments) cells_.add(segment.from, segment.to);
}

// All of a box is within half its width of the line through its middle.
int InkIndex::in(const TurnedBox& box) const {
  const Vec2 half = box.half.x * box.along;
  const std::vector<int> near = cells_.find(box.centre - half, box.centre + half, box.half.y);
  return static_cast<int>(std::count_if(near.begin(), near.end(), [&](int number) {
    const drawing::Segment& segment = drawing_.segments[static_cast<std::size_t>(number)];
    return overlap(box, line_box(segment.from, segment.to));
  }));
}

}  // namespace epura::sheet
