// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace epura::drawing {

namespace {

// Lines that differ by less run along each other: facets of rims with eight corners and more do.
constexpr double least_cosine = 0.9063;  // 25 degrees
// In distances:
constexpr double with_direction = 4;  // so long are lines that have a direction of their own
constexpr double longest_gap = 3;     // so much of a polyline goes with the near stretches beside it
constexpr double shortest_run = 5;    // and so long a stretch counts by itself
// Where lines meet at an angle of 1.2 degrees and more, or an arc meets its tangent that has up to 1250 as its radius,
// none is taken for the other.
constexpr double farthest_contact = 50;
// How wide the finest cells are in which ink is looked for.
constexpr double cell = 2;
// Of so many others, some may be left out where what is found covers the whole.
constexpr int many_others = 4;

using Range = std::array<double, 2>;

// Leaves of a range of u what has min <= value + u slope <= max.
void limit(Range& range, double value, double slope, double min, double max) {
  if (slope == 0) {
    if (value < min || value > max) range = {1, 0};
    return;
  }
  const double a = (min - value) / slope, b = (max - value) / slope;
  range = {std::max(range[0], std::min(a, b)), std::min(range[1], std::max(a, b))};
}

// The parameters of a line, 0 at a and 1 at b, where it is within a distance of the line p, q: that of a convex set.
Range part_around(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q, double distance) {
  const Vec2 step = b - a;
  Range all{1, 0};
  const auto add = [&](const Range& range) {
    if (!(range[0] <= range[1])) return;
    all = all[0] <= all[1] ? Range{std::min(all[0], range[0]), std::max(all[1], range[1])} : range;
  };
  for (const Vec2& centre : {p, q}) {
    const double a2 = glm::dot(step, step), half = glm::dot(step, centre - a);
    const double root = half * half - a2 * (glm::dot(centre - a, centre - a) - distance * distance);
    if (root >= 0) add({std::max((half - std::sqrt(root)) / a2, 0.0), std::min((half + std::sqrt(root)) / a2, 1.0)});
  }
  if (p != q) {
    const Ruler line(p, q);
    const Vec2 from = line.local(a), along = line.local(b) - from;
    Range beside{0, 1};
    limit(beside, from.x, along.x, 0, line.length);
    limit(beside, from.y, along.y, -distance, distance);
    add(beside);
  }
  return all;
}

// A line and another one along it, seen in a direction in which both go.
struct Beside {
  Range range{1, 0};            ///< the part of the line, 0 at its start, that has the other within the distance
  double value = 0, slope = 0;  ///< how far to the left of the other it lies, from its start on

  Beside(const Vec2& along, const Vec2& step, const Vec2& p, const Vec2& q, double distance) {
    const auto turned = [&](const Vec2& d) { return Vec2(glm::dot(along, d), along.x * d.y - along.y * d.x); };
    const Vec2 line = turned(step), from = turned(p), other = turned(q) - from;
    if (std::abs(other.y) > 2 * std::abs(other.x)) return;
    const double begin = std::min(from.x, from.x + other.x), end = std::max(from.x, from.x + other.x);
    if (end <= std::min(line.x, 0.0) || begin >= std::max(line.x, 0.0)) return;
    const double rise = other.y / other.x;
    value = rise * from.x - from.y;
    slope = line.y - rise * line.x;
    // Most lines pass by.
    if (value > distance && distance - value <= slope) return;
    if (value < -distance && -distance - value >= slope) return;
    range = {0, 1};
    limit(range, 0, line.x, begin, end);
    limit(range, value, slope, -distance, distance);
  }
};

std::array<Vec2, 2> box_of(const std::vector<Piece>& pieces) {
  std::array<Vec2, 2> box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const Piece& p : pieces)
    box = {glm::min(box[0], glm::min(p.from, p.to)), glm::max(box[1], glm::max(p.from, p.to))};
  return box;
}

}  // namespace

NearSearch::NearSearch(const std::vector<Piece>& pieces, double distance, double touching)
    : pieces_(pieces),
      distance_(distance),
      touching_(touching),
      kept_(pieces, box_of(pieces)[0], box_of(pieces)[1], cell * distance),
      taken_{kept_} {}

void NearSearch::begin(std::span<const End> polyline) {
  members_.clear();
  near_.clear();
  contacts_.clear();
  runs_.clear();
  gap_.clear();
  is_apart_ = false;
  double at = 0;
  for (const End end : polyline) {
    const double from = at;
    at += length_of(pieces_[line_of(end)]);
    members_.push_back({end, from, at});
  }
}

Vec2 NearSearch::place(std::size_t member, double x) const {
  const InkPart part = part_of({member, x, x});
  return place_on(pieces_[part.piece], part.from);
}

std::size_t NearSearch::member_at(double x) const {
  const auto found = std::upper_bound(members_.begin(), members_.end(), x,
                                      [](double value, const Member& member) { return value < member.to; });
  return std::min(static_cast<std::size_t>(found - members_.begin()), members_.size() - 1);
}

Vec2 NearSearch::place(double x) const { return place(member_at(x), x); }

InkPart NearSearch::part_of(const Stretch& stretch) const {
  const Member& member = members_[stretch.member];
  const auto u = [&](double x) {
    return x <= member.from ? 0.0 : x >= member.to ? 1.0 : (x - member.from) / (member.to - member.from);
  };
  const double from = u(stretch.from), to = u(stretch.to);
  if (member.end % 2 == 0) return {line_of(member.end), from, to};
  return {line_of(member.end), 1 - to, 1 - from};
}

Vec2 NearSearch::direction_of(std::size_t member) const {
  const Member& own = members_[member];
  const Vec2 step = place(member, own.to) - place(member, own.from);
  const double half = with_direction / 2 * distance_, middle = (own.from + own.to) / 2;
  if (own.to - own.from >= 2 * half) return glm::normalize(step);
  const Vec2 around = place(std::min(middle + half, length())) - place(std::max(middle - half, 0.0));
  return glm::normalize(glm::dot(around, around) > touching_ * touching_ ? around : step);
}

visibility::Spans NearSearch::near_parts(std::size_t member) {
  const Member& own = members_[member];
  const Vec2 a = place(member, own.from), b = place(member, own.to), along = direction_of(member);
  const double size = own.to - own.from, touching = touching_ / size;
  const auto x = [&](double u) { return u >= 1 ? own.to : own.from + u * size; };
  visibility::Spans spans;
  int others = 0;
  const int current = members_before_++;
  const auto is_near = [&](int number, const Candidate& other) {
    if (!(std::abs(other.direction[0] * along.x + other.direction[1] * along.y) >= least_cosine)) return false;
    const auto [p, q] = kept_.line(number);
    const Beside beside(along, b - a, p - a, q - a, distance_);
    const auto [from, to] = beside.range;
    if (!(to - from > touching)) return false;
    near_.push_back({{member, x(from), x(to)}, number});
    visibility::add_span(spans, {x(from), x(to)});
    for (const double u : {from, to})
      if (std::abs(beside.value + u * beside.slope) <= touching_) contacts_.push_back(x(u));
    const double crossing = -beside.value / beside.slope;
    if (crossing > from && crossing < to) contacts_.push_back(x(crossing));
    return true;
  };
  const auto visit = [&](int number) {
    Candidate& other = candidates_[static_cast<std::size_t>(number)];
    if (std::exchange(other.member, current) != current) other.is_near = is_near(number, other);
    return !other.is_near || ++others < many_others || !visibility::covers(spans, own.from, own.to);
  };
  kept_.visit(a, b, distance_, visit, sectors_around(along));
  return spans;
}

void NearSearch::add(std::span<const End> polyline, bool is_closed) {
  begin(polyline);
  for (std::size_t member = 0; member < members_.size(); ++member) {
    double at = members_[member].from;
    for (const auto& span : near_parts(member)) {
      if (span[0] > at) add_apart({member, at, span[0]});
      add_near(span);
      at = span[1];
    }
    if (members_[member].to > at) add_apart({member, at, members_[member].to});
  }
  end_gap(!runs_.empty());
  settle(is_closed);
}

void NearSearch::add_near(const Run& run) {
  end_gap(true);
  if (!runs_.empty() && runs_.back()[1] >= run[0])
    runs_.back()[1] = run[1];
  else
    runs_.push_back(run);
}

// Longer stretches stay whatever comes.
void NearSearch::add_apart(const Stretch& stretch) {
  if (is_apart_) return keep(stretch);
  gap_.push_back(stretch);
  if (stretch.to - gap_.front().from <= longest_gap * distance_) return;
  is_apart_ = true;
  for (const Stretch& one : gap_) keep(one);
  gap_.clear();
}

// `is_near`: there is a near stretch at one end of the gap at least.
void NearSearch::end_gap(bool is_near) {
  is_apart_ = false;
  if (gap_.empty()) return;
  const Run run{gap_.front().from, gap_.back().to};
  const bool is_taken =
      is_near && !is_bridge(place(gap_.front().member, run[0]), place(gap_.back().member, run[1])) &&
      std::all_of(gap_.begin(), gap_.end(), [&](const Stretch& stretch) { return has_ink_around(stretch); });
  if (!is_taken)
    for (const Stretch& one : gap_) keep(one);
  else if (!runs_.empty() && runs_.back()[1] >= run[0])
    runs_.back()[1] = run[1];
  else
    runs_.push_back(run);
  gap_.clear();
}

// -1 where there is none.
int NearSearch::nearest_kept(const Vec2& place) const {
  const double reach = std::numbers::sqrt2 * distance_;
  std::pair<double, int> best{reach, -1};
  kept_.visit(place, place, reach, [&](int number) {
    const std::array<Vec2, 2>& line = kept_.line(number);
    if (!may_be_within(line, place, best.first)) return true;
    const double distance = glm::distance(nearest_on(line, place), place);
    best = std::min(best, std::pair(distance, number));
    return true;
  });
  return best.second;
}

// Whether the lines that stay at the ends of a gap do not meet one another: then it is the gap that joins them.
bool NearSearch::is_bridge(const Vec2& from, const Vec2& to) const {
  const int one = nearest_kept(from), other = nearest_kept(to);
  if (one < 0 || other < 0) return true;
  if (one == other) return false;
  const auto a = kept_.line(one), b = kept_.line(other);
  const auto near = [&](const Vec2& p, const std::array<Vec2, 2>& line) {
    return glm::distance(nearest_on(line, p), p) <= touching_;
  };
  return !(near(a[0], b) || near(a[1], b) || near(b[0], a) || near(b[1], a));
}

bool NearSearch::has_ink_around(const Stretch& stretch) {
  const double reach = std::numbers::sqrt2 * distance_, size = stretch.to - stretch.from;
  if (size <= touching_) return true;
  const Vec2 a = place(stretch.member, stretch.from), b = place(stretch.member, stretch.to);
  visibility::Spans spans;
  kept_.visit(a, b, reach, [&](int number) {
    const auto [p, q] = kept_.line(number);
    const auto [from, to] = part_around(a, b, p, q, reach);
    if (!(to > from)) return true;
    near_.push_back({{stretch.member, stretch.from + from * size, stretch.from + to * size}, number});
    visibility::add_span(spans, {from, to});
    return !visibility::covers(spans, 0, 1);
  });
  return visibility::covers(spans, 0, 1);
}

void NearSearch::keep(const Stretch& stretch) {
  if (!(stretch.to - stretch.from > touching_)) return specks_.push_back(part_of(stretch));
  const Vec2 along = direction_of(stretch.member);
  kept_.add(part_of(stretch), sector_of(along));
  candidates_.push_back({{static_cast<float>(along.x), static_cast<float>(along.y)}});
}

void NearSearch::keep(const Run& run) {
  if (!(run[1] > run[0])) return;
  for (std::size_t member = member_at(run[0]); member < members_.size() && members_[member].from < run[1]; ++member) {
    const Stretch part{member, std::max(run[0], members_[member].from), std::min(run[1], members_[member].to)};
    if (part.to > part.from) keep(part);
  }
}

// Whether the polyline goes on beyond the ends of a run, with ink that stays.
std::array<bool, 2> NearSearch::goes_on(const Run& run, bool is_closed) const {
  const bool is_first = run[0] <= 0, is_last = run[1] >= length();
  if (!is_closed) return {!is_first, !is_last};
  return {!(is_first && runs_.back()[1] >= length()), !(is_last && runs_.front()[0] <= 0)};
}

NearSearch::Run NearSearch::between_contacts(const Run& run, const std::array<bool, 2>& goes_on) const {
  Run part = run;
  const double far = farthest_contact * distance_;
  if (goes_on[0]) {
    const auto first = std::lower_bound(contacts_.begin(), contacts_.end(), run[0]);
    if (first != contacts_.end() && *first <= std::min(run[1], run[0] + far)) part[0] = *first;
  }
  if (goes_on[1]) {
    const auto beyond = std::upper_bound(contacts_.begin(), contacts_.end(), run[1]);
    if (beyond != contacts_.begin() && *(beyond - 1) >= std::max(run[0], run[1] - far)) part[1] = *(beyond - 1);
  }
  return part;
}

void NearSearch::settle(bool is_closed) {
  std::sort(contacts_.begin(), contacts_.end());
  std::vector<Run> settled;
  for (const Run& run : runs_) {
    const std::array<bool, 2> on = goes_on(run, is_closed);
    const Run part = between_contacts(run, on);
    if ((on[0] || on[1]) && !(part[1] - part[0] >= shortest_run * distance_)) {
      keep(run);
      continue;
    }
    keep(Run{run[0], part[0]});
    keep(Run{part[1], run[1]});
    settled.push_back(part);
  }
  take_away(settled);
}

void NearSearch::take_away(const std::vector<Run>& runs) {
  const auto order = [](const Near& near) { return std::pair(near.stretch.member, near.by); };
  std::sort(near_.begin(), near_.end(), [&](const Near& a, const Near& b) { return order(a) < order(b); });
  for (const Run& run : runs) {
    if (!(run[1] > run[0])) continue;
    for (std::size_t member = member_at(run[0]); member < members_.size() && members_[member].from < run[1]; ++member) {
      const Stretch part{member, std::max(run[0], members_[member].from), std::min(run[1], members_[member].to)};
      if (!(part.to > part.from)) continue;
      taken_.parts.add(part_of(part));
      auto near = std::lower_bound(near_.begin(), near_.end(), member,
                                   [](const Near& one, std::size_t number) { return one.stretch.member < number; });
      for (int last = -1; near != near_.end() && near->stretch.member == member; ++near)
        if (near->by != std::exchange(last, near->by)) taken_.by.push_back(near->by);
      taken_.last.push_back(taken_.by.size());
    }
  }
}

}  // namespace epura::drawing
