// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "drawing/beside.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// Returns the parameters of a line, 0 at a and 1 at b, where it lies within a distance of the line p, q, a convex set.
Interval part_around(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q, double distance) {
  const Vec2 step = b - a;
  Interval all{1, 0};
  const auto add = [&](const Interval& range) {
    if (!(range[0] <= range[1])) return;
    all = all[0] <= all[1] ? Interval{std::min(all[0], range[0]), std::max(all[1], range[1])} : range;
  };
  for (const Vec2& centre : {p, q}) {
    const double a2 = glm::dot(step, step), half = glm::dot(step, centre - a);
    const double root = half * half - a2 * (glm::dot(centre - a, centre - a) - distance * distance);
    if (root >= 0) add({std::max((half - std::sqrt(root)) / a2, 0.0), std::min((half + std::sqrt(root)) / a2, 1.0)});
  }
  if (p != q) {
    const Ruler line(p, q);
    const Vec2 from = line.local(a), along = line.local(b) - from;
    Interval beside{0, 1};
    limit(beside, from.x, along.x, 0, line.length);
    limit(beside, from.y, along.y, -distance, distance);
    add(beside);
  }
  check(!(all[0] <= all[1]) || (all[0] >= 0 && all[1] <= 1), "a part of a line lies on it");
  return all;
}

}  // namespace

NearSearch::NearSearch(const std::vector<Piece>& pieces, const NearPrefilter& prefilter, const AlongLimits& limits)
    : prefilter_(prefilter), limits_(limits), kept_(pieces, limits), polyline_(pieces, {}) {}

void NearSearch::add_all(const Progress& progress) {
  const std::size_t members = prefilter_.first(prefilter_.size());
  Pace pace(progress, members);
  for (std::size_t line = 0, last = 0; line < prefilter_.size(); ++line) {
    if (line == last) {
      while (last < prefilter_.size() && prefilter_.first(last) - prefilter_.first(line) < looked_ahead) ++last;
      ahead_.look(prefilter_, kept_, prefilter_.first(line), prefilter_.first(last));
    }
    add(line);
    pace.left(members - prefilter_.first(line + 1));
  }
}

void NearSearch::add(std::size_t line) {
  polyline_ = prefilter_[line];
  near_.clear();
  contacts_.clear();
  runs_.clear();
  gap_.clear();
  is_apart_ = false;
  for (std::size_t member = 0; member < polyline_.size(); ++member) {
    double at = polyline_[member].from;
    for (const auto& span : near_parts(member, prefilter_.first(line) + member)) {
      if (span[0] > at) add_apart({member, at, span[0]});
      end_gap(true);
      add_run(span);
      at = span[1];
    }
    check(at >= polyline_[member].from, "near parts are in order");
    if (polyline_[member].to > at) add_apart({member, at, polyline_[member].to});
  }
  end_gap(!runs_.empty());
  settle(prefilter_.is_closed(line));
}

visibility::Spans NearSearch::near_parts(std::size_t member, std::size_t turn) {
  visibility::Spans spans;
  const Member& own = polyline_[member];
  if (own.after < 0) return spans;
  found_.clear();
  ahead_.append(turn, found_);
  if (!ahead_.has_seen(own)) kept_.find_newer(polyline_, member, found_);
  for (const NearPart& part : found_.parts) {
    near_.push_back({{member, part.stretch[0], part.stretch[1]}, part.by, part.apart});
    visibility::add_span(spans, part.stretch);
  }
  contacts_.insert(contacts_.end(), found_.contacts.begin(), found_.contacts.end());
  return spans;
}

// A run that begins where the last one ends is merged with it.
void NearSearch::add_run(const Run& run) {
  if (!runs_.empty() && runs_.back()[1] >= run[0])
    runs_.back()[1] = run[1];
  else
    runs_.push_back(run);
}

// Longer stretches stay in any case.
void NearSearch::add_apart(const Stretch& stretch) {
  if (is_apart_) return keep(stretch);
  gap_.push_back(stretch);
  if (stretch.to - gap_.front().from <= longest_gap * limits_.distance) return;
  is_apart_ = true;
  for (const Stretch& one : gap_) keep(one);
  gap_.clear();
}

// `is_near`: there is a near part on at least one side of the gap.
void NearSearch::end_gap(bool is_near) {
  is_apart_ = false;
  if (gap_.empty()) return;
  const Run run{gap_.front().from, gap_.back().to};
  const bool is_taken =
      is_near &&
      !is_bridge(polyline_.place(gap_.front().member, run[0]), polyline_.place(gap_.back().member, run[1])) &&
      std::all_of(gap_.begin(), gap_.end(), [&](const Stretch& stretch) { return has_ink_around(stretch); });
  if (is_taken)
    add_run(run);
  else
    for (const Stretch& one : gap_) keep(one);
  gap_.clear();
}

// Returns -1 if there is none.
int NearSearch::nearest_kept(const Vec2& place) const {
  const double reach = std::numbers::sqrt2 * limits_.distance;
  std::pair<double, int> best{reach, -1};
  for (const int number : kept_.parts().find_in_any_order(place, place, reach)) {
    const std::array<Vec2, 2>& line = kept_.parts().line(number);
    if (!may_be_within(line, place, best.first)) continue;
    const double distance = glm::distance(nearest_on(line, place), place);
    best = std::min(best, std::pair(distance, number));
  }
  return best.second;
}

// Whether the lines that stay at the ends of a gap do not meet each other, so that the gap connects them.
bool NearSearch::is_bridge(const Vec2& from, const Vec2& to) const {
  const int one = nearest_kept(from), other = nearest_kept(to);
  if (one < 0 || other < 0) return true;
  if (one == other) return false;
  const auto a = kept_.parts().line(one), b = kept_.parts().line(other);
  const auto near = [&](const Vec2& p, const std::array<Vec2, 2>& line) {
    return glm::distance(nearest_on(line, p), p) <= limits_.touching;
  };
  return !(near(a[0], b) || near(a[1], b) || near(b[0], a) || near(b[1], a));
}

bool NearSearch::has_ink_around(const Stretch& stretch) {
  const double reach = std::numbers::sqrt2 * limits_.distance, size = stretch.to - stretch.from;
  if (size <= limits_.touching) return true;
  const Vec2 a = polyline_.place(stretch.member, stretch.from), b = polyline_.place(stretch.member, stretch.to);
  visibility::Spans spans;
  for (const int number : kept_.parts().find(a, b, reach)) {
    const auto [p, q] = kept_.parts().line(number);
    const auto [from, to] = part_around(a, b, p, q, reach);
    if (!(to > from)) continue;
    near_.push_back({{stretch.member, stretch.from + from * size, stretch.from + to * size}, number, {reach, reach}});
    visibility::add_span(spans, {from, to});
    if (visibility::covers(spans, 0, 1)) return true;
  }
  return false;
}

void NearSearch::keep(const Stretch& stretch) {
  const InkPart part = polyline_.part_of(stretch);
  if (!(stretch.to - stretch.from > limits_.touching)) return dangles_.push_back(part);
  kept_.add(part, polyline_[stretch.member].direction);
}

void NearSearch::keep(const Run& run) {
  polyline_.visit_stretches(run, [&](const Stretch& part) { keep(part); });
}

// Whether the polyline continues beyond the ends of a run with ink that stays.
std::array<bool, 2> NearSearch::goes_on(const Run& run, bool is_closed) const {
  const bool is_first = run[0] <= 0, is_last = run[1] >= polyline_.length();
  if (!is_closed) return {!is_first, !is_last};
  return {!(is_first && runs_.back()[1] >= polyline_.length()), !(is_last && runs_.front()[0] <= 0)};
}

// Returns where a line that bends towards another one and away again, as an arc beside its tangent, is closest to it;
// nothing if it does not leave the distance gradually at both ends.
std::optional<double> NearSearch::closest_approach(const Run& run) const {
  std::array<double, 2> at_ends{HUGE_VAL, HUGE_VAL};
  std::pair<double, double> closest{HUGE_VAL, 0};
  const auto from = [](const Near& near) { return near.stretch.from; };
  for (auto near = std::ranges::lower_bound(near_, run[0], {}, from); near != near_.end(); ++near) {
    const std::array<double, 2> places{near->stretch.from, near->stretch.to};
    if (places[0] > run[1]) break;
    if (places[1] > run[1]) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      if (places[end] == run[end]) at_ends[end] = std::min(at_ends[end], near->apart[end]);
      closest = std::min(closest, {near->apart[end], places[end]});
    }
  }
  const bool leaves = std::min(at_ends[0], at_ends[1]) >= apart_at_ends * limits_.distance;
  return leaves && closest.first <= close_between * limits_.distance ? std::optional(closest.second) : std::nullopt;
}

NearSearch::Run NearSearch::between_contacts(const Run& run, const std::array<bool, 2>& goes_on) const {
  Run part = run;
  const double far = farthest_contact * limits_.distance;
  if (goes_on[0] && goes_on[1] && run[1] - run[0] <= 2 * far)
    if (const auto closest = closest_approach(run)) return {*closest, *closest};
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
  std::ranges::sort(near_, {}, [](const Near& near) { return near.stretch.from; });
  std::vector<Run> settled;
  for (const Run& run : runs_) {
    const std::array<bool, 2> on = goes_on(run, is_closed);
    const Run part = between_contacts(run, on);
    check(part[0] >= run[0] && part[1] <= run[1], "what is taken away was near");
    if ((on[0] || on[1]) && !(part[1] - part[0] >= shortest_run * limits_.distance)) {
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
  const auto take = [&](const Stretch& part) {
    taken_.parts.push_back(polyline_.part_of(part));
    auto near = std::lower_bound(near_.begin(), near_.end(), part.member,
                                 [](const Near& one, std::size_t number) { return one.stretch.member < number; });
    for (int last = -1; near != near_.end() && near->stretch.member == part.member; ++near)
      if (near->by != std::exchange(last, near->by)) taken_.by.push_back(near->by);
    taken_.last.push_back(taken_.by.size());
  };
  for (const Run& run : runs) polyline_.visit_stretches(run, take);
  check(taken_.last.size() == taken_.parts.size(), "all ink that is taken has ink instead");
}

}  // namespace epura::drawing
