// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_parts.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/parallel.hpp"
#include "visibility/spans.hpp"

namespace epura::drawing {

namespace {

// Width of the finest cells in which ink is searched for, as a multiple of the distance.
constexpr double cell = 2;
// After this many other lines, the rest may be left out if those found cover the whole member.
constexpr int many_others = 4;

std::array<Vec2, 2> box_of(const std::vector<Piece>& pieces) {
  std::array<Vec2, 2> box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const Piece& p : pieces)
    box = {glm::min(box[0], glm::min(p.from, p.to)), glm::max(box[1], glm::max(p.from, p.to))};
  return box;
}

// The parts that were found for a member.
class Found {
 public:
  Found(const std::vector<NearPart>& parts) : parts_(parts), first_(parts.size()) {}

  [[nodiscard]] bool has(int number) {
    // Most members have only a few.
    constexpr std::size_t few = 32;
    const auto is_it = [&](const NearPart& part) { return part.by == number; };
    const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(first_);
    if (parts_.size() - first_ <= few) return std::any_of(begin, parts_.end(), is_it);
    for (; known_ < parts_.size() - first_; ++known_) numbers_.insert(parts_[first_ + known_].by);
    return numbers_.contains(number);
  }

 private:
  const std::vector<NearPart>& parts_;
  std::size_t first_, known_ = 0;
  std::unordered_set<int> numbers_{};
};

}  // namespace

KeptInk::KeptInk(const std::vector<Piece>& pieces, const AlongLimits& limits)
    : limits_(limits), parts_(pieces, box_of(pieces)[0], box_of(pieces)[1], cell * limits.distance) {}

void KeptInk::add(const InkPart& part, const Vec2& direction) {
  parts_.add(part, sector_of(direction));
  directions_.push_back({static_cast<float>(direction.x), static_cast<float>(direction.y)});
}

void KeptInk::find_near(const MeasuredPolyline& polyline, std::size_t member, NearParts& near) const {
  const Member& own = polyline[member];
  const Vec2 a = polyline.place(member, own.from), b = polyline.place(member, own.to);
  const Vec2& along = own.direction;
  const double size = own.to - own.from, touching = limits_.touching / size;
  const auto x = [&](double u) { return u >= 1 ? own.to : own.from + u * size; };
  visibility::Spans spans;
  Found found(near.parts);
  int others = 0;
  const auto is_near = [&](int number) {
    const auto& [p, q] = parts_.line(number);
    const Beside beside(along, b - a, {p - a, q - a}, limits_.distance, AlongLimits::steepest);
    const auto [from, to] = beside.range;
    if (!(to - from > touching)) return false;
    const std::array<float, 2>& facing = directions_[static_cast<std::size_t>(number)];
    if (!(std::abs(facing[0] * along.x + facing[1] * along.y) >= AlongLimits::least_cosine)) return false;
    if (found.has(number)) return true;
    near.parts.push_back({{x(from), x(to)}, number});
    visibility::add_span(spans, near.parts.back().stretch);
    for (const double u : {from, to})
      if (std::abs(beside.value + u * beside.slope) <= limits_.touching) near.contacts.push_back(x(u));
    const double crossing = -beside.value / beside.slope;
    if (crossing > from && crossing < to) near.contacts.push_back(x(crossing));
    return true;
  };
  // A line is found in each cell that both lines run through.
  std::array<int, 64> apart;
  apart.fill(-1);
  const auto visit = [&](int number) {
    int& same = apart[static_cast<std::size_t>(number) % apart.size()];
    if (same == number) return true;
    if (is_near(number)) return ++others < many_others || !visibility::covers(spans, own.from, own.to);
    same = number;
    return true;
  };
  parts_.visit(a, b, limits_.distance, visit, sectors_around(along));
}

void NearAhead::look(const NearGlance& glance, const KeptInk& kept, std::size_t first, std::size_t last) {
  first_ = first;
  blocks_.resize((last - first + size - 1) / size);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Block& block = blocks_[i];
      block.near.clear();
      std::size_t turn = first + i * size, line = glance.line_at(turn);
      for (std::size_t k = 0; k < size && turn < last; ++k, ++turn) {
        if (turn == glance.first(line + 1)) ++line;
        const MeasuredPolyline polyline = glance[line];
        const std::size_t member = turn - glance.first(line);
        block.first[k] = {block.near.parts.size(), block.near.contacts.size()};
        if (polyline[member].after >= 0 && has_seen(polyline[member])) kept.find_near(polyline, member, block.near);
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
