// SPDX-License-Identifier: Apache-2.0
// Finds which lines continue each other where several straight lines meet in a point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "base/same_key.hpp"
#include "base/vec.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

/// One end of a line: 2 * line + (0 for its start, 1 for its end).
using End = int;
inline constexpr End no_end = -1;

constexpr int line_of(End end) { return end / 2; }
constexpr End other(End end) { return end ^ 1; }

/// A position on the page as a number, different for both ends of level and of upright lines. It decides where nothing
/// else does, so that the numbering of faces in a file does not.
inline double order_on_page(const Vec2& place) { return place.x + std::numbers::phi * place.y; }

/// Lines whose ends are to be joined. `place(end)` is the position of an end, mm; `look(end)` an array of doubles that
/// two ends must have in common; `kind(end)` tells which of them belong together most.
template <class Place, class Look, class Kind>
struct LineEnds {
  int lines;
  Place place;
  Look look;
  Kind kind;
};
template <class Place, class Look, class Kind>
LineEnds(int, Place, Look, Kind) -> LineEnds<Place, Look, Kind>;

/// How far apart ends may be that meet, mm.
struct Gaps {
  double touching = 0;  ///< lines touch there
  double unseen = 0;    ///< nobody sees the gap between two ends that meet no nearer one
};

/// Which lines are joined where only those are left that turn back there.
enum class TurningBack { left_apart, joined };

/// Which of the ends that meet are joined.
struct Joining {
  TurningBack turning_back;
  double farthest = HUGE_VAL;  ///< ends are no farther apart, mm
};

/// The direction in which a line leaves an end.
template <class Ends>
Vec2 leaving(const Ends& lines, End end) {
  return glm::normalize(lines.place(other(end)) - lines.place(end));
}

/// Joins the only two ends that meet in a point. Returns false if they turn back there and are to be left apart.
template <class Ends>
bool pair_up(const Ends& lines, End a, End b, const Joining& rule, std::vector<End>& continuation) {
  if (a == other(b) || glm::distance(lines.place(a), lines.place(b)) > rule.farthest) return true;
  if (rule.turning_back == TurningBack::left_apart && glm::dot(leaving(lines, a), leaving(lines, b)) > turning_back)
    return false;
  continuation[a] = b;
  continuation[b] = a;
  return true;
}

/// Joins ends that meet in one point, while there are two left: first those that go on in nearly the same direction,
/// as facets of a curve do, then those of one kind; the straightest pair first. Of pairs that are about as straight,
/// one of one kind is preferred: a curve that touches another leaves it a little straighter than it goes on itself.
/// Returns false if some are left that turn back there.
template <class Ends>
bool pair_up(const Ends& lines, std::span<const End> ends, const Joining& rule, std::vector<End>& continuation) {
  if (ends.size() > max_ends_at_a_point) return true;
  std::vector<std::pair<End, Vec2>> left;  // with the direction in which the line leaves that end
  for (const End end : ends)
    if (continuation[end] == no_end) left.emplace_back(end, leaving(lines, end));
  const auto order = [&](End end) { return order_on_page(lines.place(other(end))); };
  using Pair = std::tuple<int, float, float, End, End>;  // floats, so that rounding does not decide
  while (left.size() >= 2) {
    Pair best{3, HUGE_VALF, HUGE_VALF, no_end, no_end};
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t j = i + 1; j < left.size(); ++j) {
        const auto& [a, direction_a] = left[i];
        const auto& [b, direction_b] = left[j];
        const double straightness = glm::dot(direction_a, direction_b);
        const bool differ = lines.kind(a) != lines.kind(b);
        const int turn = straightness > turning_back ? 2 : straightness > -turning_back && differ ? 1 : 0;
        if (a == other(b) || glm::distance(lines.place(a), lines.place(b)) > rule.farthest) continue;
        const double bent = straightness + (differ ? about_as_straight : 0);
        best = std::min(best, Pair(turn, static_cast<float>(bent), static_cast<float>(order(a) + order(b)), a, b));
      }
    const End a = std::get<3>(best), b = std::get<4>(best);
    if (a == no_end) return true;
    if (std::get<0>(best) == 2 && rule.turning_back == TurningBack::left_apart) return false;
    check(continuation[a] == no_end && continuation[b] == no_end && a != b, "an end has one continuation");
    continuation[a] = b;
    continuation[b] = a;
    std::erase_if(left, [a, b](const auto& l) { return l.first == a || l.first == b; });
  }
  return true;
}

/// Joins those ends of a list that meet.
template <class Ends>
class EndPairing {
 public:
  EndPairing(const Ends& lines, const Progress& progress)
      : lines_(lines), progress_(progress), continuation_(static_cast<std::size_t>(lines.lines) * 2, no_end) {}

  /// Ends up to `touching` mm apart meet if they meet no nearer one. Returns those that turn back where they meet, if
  /// these are left apart.
  std::vector<End> join(std::vector<End> ends, double touching, const Joining& rule) {
    alone_ = std::move(ends);
    turns_back_.assign(continuation_.size(), 0);
    // Where lines of two faces coincide, parts of both are drawn, with ends that differ by rounding: about 1e-13 mm.
    join_in_cells(0x1p-30, Vec2(0), rule);
    if (touching > 0x1p-30)
      // Of four grids with cells of twice that distance, one has both ends in one cell.
      for (const double x : {0.0, 0.5})
        for (const double y : {0.0, 0.5}) join_in_cells(2 * touching, Vec2(x, y), rule);
    std::vector<End> left;
    for (End end = 0; end < static_cast<End>(continuation_.size()); ++end)
      if (turns_back_[end] != 0 && continuation_[end] == no_end) left.push_back(end);
    return left;
  }

  /// The ends that have no continuation yet.
  [[nodiscard]] std::vector<End> alone() const {
    std::vector<End> ends;
    for (End end = 0; end < static_cast<End>(continuation_.size()); ++end)
      if (continuation_[end] == no_end) ends.push_back(end);
    return ends;
  }

  [[nodiscard]] std::vector<End> continuations() && { return std::move(continuation_); }

 private:
  void join_in_cells(double cell, const Vec2& shift, const Joining& rule) {
    const auto key = [&](int number) {
      const auto look = lines_.look(alone_[number]);
      const Vec2 at = lines_.place(alone_[number]) / cell + shift;
      std::array<double, look.size() + 2> all{std::round(at.x), std::round(at.y)};
      std::copy(look.begin(), look.end(), all.begin() + 2);
      return all;
    };
    visit_same_keys(static_cast<int>(alone_.size()), key, progress_, [&](std::span<const int> numbers) {
      if (numbers.size() == 2 && pair_up(lines_, alone_[numbers[0]], alone_[numbers[1]], rule, continuation_)) return;
      std::vector<End> ends;
      for (const int number : numbers) ends.push_back(alone_[number]);
      if (pair_up(lines_, ends, rule, continuation_)) return;
      for (const End end : ends) turns_back_[end] = 1;
    });
    std::erase_if(alone_, [&](End end) { return continuation_[end] != no_end; });
  }

  const Ends& lines_;
  const Progress& progress_;
  std::vector<End> continuation_, alone_{};
  std::vector<char> turns_back_{};  ///< by end; calls for different points may be concurrent
};

/// Returns for each end the end that continues it, or none. Ends that touch meet if they meet no nearer one, and no
/// other that goes on there while the nearer one turns back. Throws OutOfTime.
template <class Ends>
std::vector<End> find_continuations(const Ends& lines, const Gaps& gaps, const Progress& progress) {
  EndPairing<Ends> pairing(lines, progress);
  std::vector<End> ends(static_cast<std::size_t>(lines.lines) * 2);
  std::iota(ends.begin(), ends.end(), 0);
  std::vector<End> left = pairing.join(std::move(ends), gaps.touching, {TurningBack::left_apart});
  pairing.join(std::move(left), gaps.touching, {TurningBack::joined});
  if (gaps.unseen > gaps.touching) pairing.join(pairing.alone(), gaps.unseen, {TurningBack::left_apart, gaps.unseen});
  return std::move(pairing).continuations();
}

}  // namespace epura::drawing
