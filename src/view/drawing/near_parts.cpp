// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/limits.hpp"
#include "visibility/spans.hpp"

namespace epura::drawing {

namespace {

std::array<Vec2, 2> box_of(const std::vector<Piece>& pieces) {
  std::array<Vec2, 2> box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const Piece& p : pieces)
    box = {glm::min(box[0], glm::min(p.from, p.to)), glm::max(box[1], glm::max(p.from, p.to))};
  return box;
}

}  // namespace

KeptInk::KeptInk(const std::vector<Piece>& pieces, const AlongLimits& limits)
    : limits_(limits),
      box_(box_of(pieces)),
      parts_(pieces, box_[0], box_[1], finest_cell * limits.distance),
      newer_(box_[0], box_[1], finest_cell * limits.distance) {}

void KeptInk::add(const InkPart& part, const Vec2& direction) {
  const int sector = sector_of(direction);
  parts_.add(part, sector);
  const auto [from, to] = parts_.line(static_cast<int>(directions_.size()));
  newer_.add(from, to, sector);
  directions_.push_back({static_cast<float>(direction.x), static_cast<float>(direction.y)});
}

void KeptInk::begin_newer() {
  newer_ = InkCells(box_[0], box_[1], finest_cell * limits_.distance);
  first_newer_ = static_cast<int>(directions_.size());
}

void KeptInk::find_near(const MeasuredPolyline& polyline, std::size_t member, NearParts& near) const {
  const auto [a, b] = polyline.ends_of(member);
  const Sectors around = sectors_around(polyline[member].direction);
  append(parts_.find(a, b, limits_.distance, around), polyline, member, {near.parts.size(), near});
}

void KeptInk::find_newer(const MeasuredPolyline& polyline, std::size_t member, NearParts& near) const {
  const auto [a, b] = polyline.ends_of(member);
  std::vector<int> numbers = newer_.find(a, b, limits_.distance, sectors_around(polyline[member].direction));
  for (int& number : numbers) number += first_newer_;
  append(numbers, polyline, member, {0, near});
}

void KeptInk::append(const std::vector<int>& numbers, const MeasuredPolyline& polyline, std::size_t member,
                     const Found& found) const {
  const Member& own = polyline[member];
  const auto [a, b] = polyline.ends_of(member);
  const Vec2& along = own.direction;
  const double size = own.to - own.from, touching = limits_.touching / size;
  const auto x = [&](double u) { return u >= 1 ? own.to : own.from + u * size; };
  auto& [parts, contacts] = found.near;
  // Ink whose ends meet has no gap between them, whatever rounding leaves.
  visibility::Spans spans;
  const auto cover = [&](const Interval& stretch) {
    visibility::add_span(spans, {stretch[0] - limits_.touching, stretch[1] + limits_.touching});
  };
  for (std::size_t i = found.first; i < parts.size(); ++i) cover(parts[i].stretch);
  for (const int number : numbers) {
    if (parts.size() >= found.first + many_near && visibility::covers(spans, own.from, own.to)) return;
    const auto& [p, q] = parts_.line(number);
    const Beside beside(along, b - a, {p - a, q - a}, limits_.distance, steepest_along);
    const auto [from, to] = beside.range;
    if (!(to - from > touching)) continue;
    const std::array<float, 2>& facing = directions_[static_cast<std::size_t>(number)];
    if (!(std::abs(facing[0] * along.x + facing[1] * along.y) >= along_cosine)) continue;
    const auto apart = [&](double u) { return std::abs(beside.value + u * beside.slope); };
    check(from >= 0 && to <= 1, "ink beside a line is beside a part of it");
    parts.push_back({{x(from), x(to)}, number, {apart(from), apart(to)}});
    cover(parts.back().stretch);
    for (const double u : {from, to})
      if (apart(u) <= limits_.touching) contacts.push_back(x(u));
    const double crossing = -beside.value / beside.slope;
    if (crossing > from && crossing < to) contacts.push_back(x(crossing));
  }
}

void NearAhead::look(const NearPrefilter& prefilter, KeptInk& kept, std::size_t first, std::size_t last) {
  kept.begin_newer();
  first_ = first;
  blocks_.resize((last - first + size - 1) / size);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Block& block = blocks_[i];
      block.near.clear();
      std::size_t turn = first + i * size, line = prefilter.line_at(turn);
      for (std::size_t k = 0; k < size && turn < last; ++k, ++turn) {
        if (turn == prefilter.first(line + 1)) ++line;
        check(turn >= prefilter.first(line) && turn < prefilter.first(line + 1),
              "a member is of the line that is looked at");
        const MeasuredPolyline polyline = prefilter[line];
        const std::size_t member = turn - prefilter.first(line);
        block.first[k] = {block.near.parts.size(), block.near.contacts.size()};
        if (polyline[member].after >= 0) kept.find_near(polyline, member, block.near);
        block.first[k + 1] = {block.near.parts.size(), block.near.contacts.size()};
      }
    }
  });
}

void NearAhead::append(std::size_t turn, NearParts& found) const {
  const Block& block = blocks_[(turn - first_) / size];
  const auto& [first, last] = std::array{block.first[(turn - first_) % size], block.first[(turn - first_) % size + 1]};
  const auto copy = [](const auto& from, std::size_t begin, std::size_t end, auto& to) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
              from.begin() + static_cast<std::ptrdiff_t>(end));
  };
  copy(block.near.parts, first[0], last[0], found.parts);
  copy(block.near.contacts, first[1], last[1], found.contacts);
}

}  // namespace epura::drawing
