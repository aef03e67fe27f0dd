// SPDX-License-Identifier: Apache-2.0
#include "drawing/strands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// Up to these numbers, strands are compared, which is faster than dividing them.
constexpr std::size_t few_strands = 24, few_ends = 4;
// From this number, another direction is tried if one does not help.
constexpr std::size_t many_strands = 96;

// The undirected direction of a line, from 0 to 2, measured upwards around a square instead of a circle: it changes by
// no more than the angle in radians, and by no less than half of that.
constexpr int half_turn = 2;

double direction_of(const Piece& p) {
  Vec2 along = p.to - p.from;
  if (along.y < 0 || (along.y == 0 && along.x < 0)) along = -along;
  return along.x >= 0 ? along.y / (along.x + along.y) : 1 - along.x / (along.y - along.x);
}

// Converts to coordinates along a direction and across it.
Strand turned(Strand s, const Vec2& along) {
  const auto turn = [&](const Vec2& p) { return Vec2(glm::dot(along, p), cross(along, p)); };
  s.from = turn(s.from);
  s.to = turn(s.to);
  if (s.from.x > s.to.x) {
    std::swap(s.from, s.to);
    std::swap(s.begins, s.ends);
  }
  return s;
}

struct Load {
  std::size_t strands = 0, ends = 0;

  void add_ends(const Strand& s) { ends += std::size_t{s.begins} + std::size_t{s.ends}; }
  [[nodiscard]] double work() const { return static_cast<double>(strands) * static_cast<double>(ends); }
};

Load load_of(const Strands& strands) {
  Load load{strands.size()};
  for (const Strand& s : strands) load.add_ends(s);
  return load;
}

/// How strands are separated: by position, or by the height at which they leave the cell at one of its sides. An
/// overlap that begins in the cell continues as far as both strands do: if both leave by one side, they overlap there.
enum class Measure { x, y, on_the_left, on_the_right };

/// Where strands are separated: at a value of a measure, with a margin on both sides.
struct Cut {
  Measure by;
  double margin;
  double side;  ///< x of the left or right side
  double at = 0;
  Load below{}, above{};

  [[nodiscard]] double work() const { return below.work() + above.work(); }
  [[nodiscard]] int axis() const { return by == Measure::x ? 0 : 1; }
  [[nodiscard]] bool is_by_place() const { return by == Measure::x || by == Measure::y; }

  /// Infinite for strands that do not reach the side.
  [[nodiscard]] std::array<double, 2> range(const Strand& s) const {
    constexpr std::array<double, 2> all{-HUGE_VAL, HUGE_VAL};
    if (by == Measure::on_the_left) return s.begins || s.from.x > side + margin ? all : std::array{s.from.y, s.from.y};
    if (by == Measure::on_the_right) return s.ends || s.to.x < side - margin ? all : std::array{s.to.y, s.to.y};
    return {std::min(s.from[axis()], s.to[axis()]), std::max(s.from[axis()], s.to[axis()])};
  }

  [[nodiscard]] bool has_below(double x) const { return x <= at + margin; }
  [[nodiscard]] bool has_above(double x) const { return x >= at - margin; }

  void count(const Strand& s) {
    const auto [low, high] = range(s);
    const std::array ends = is_by_place() ? std::array{s.from[axis()], s.to[axis()]} : std::array{low, low};
    const std::array tops = is_by_place() ? ends : std::array{high, high};
    below.strands += std::size_t{has_below(low)};
    above.strands += std::size_t{has_above(high)};
    below.ends += std::size_t{s.begins && has_below(ends[0])} + std::size_t{s.ends && has_below(ends[1])};
    above.ends += std::size_t{s.begins && has_above(tops[0])} + std::size_t{s.ends && has_above(tops[1])};
  }

  // Cuts off what lies beyond the margin, which is true of one end at most.
  [[nodiscard]] Strand part_of(const Strand& s, bool is_below) const {
    const double border = is_below ? at + margin : at - margin;
    const auto lies_beyond = [&](double x) { return is_below ? x > border : x < border; };
    Strand part = s;
    const bool is_from = lies_beyond(s.from[axis()]);
    if (!is_by_place() || (!is_from && !lies_beyond(s.to[axis()]))) return part;
    Vec2& end = is_from ? part.from : part.to;
    end = s.from + (border - s.from[axis()]) / (s.to[axis()] - s.from[axis()]) * (s.to - s.from);
    end[axis()] = border;
    (is_from ? part.begins : part.ends) = false;
    return part;
  }
};

// A value between two ends, or between two places where strands leave, near the middle. A sample represents all
// strands.
std::optional<double> place_of_cut(const Strands& strands, const Cut& cut) {
  constexpr std::size_t max_samples = 16;
  const std::size_t step = strands.size() / max_samples + 1;
  std::array<double, 2 * max_samples> samples{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < strands.size(); i += step) {
    const Strand& s = strands[i];
    if (cut.is_by_place()) {
      if (s.begins) samples[count++] = s.from[cut.axis()];
      if (s.ends) samples[count++] = s.to[cut.axis()];
    } else if (const double y = cut.range(s)[0]; y > -HUGE_VAL)
      samples[count++] = y;
  }
  check(count <= samples.size(), "there is room for both ends of each sample");
  std::sort(samples.begin(), samples.begin() + count);
  std::optional<double> best;
  std::size_t distance = count;
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t from_middle = std::max(i, count / 2) - std::min(i, count / 2);
    if (samples[i] - samples[i - 1] <= 4 * cut.margin || from_middle >= distance) continue;
    best = (samples[i - 1] + samples[i]) / 2;
    distance = from_middle;
  }
  return best;
}

// The cut that leaves the least work, if that is little enough.
std::optional<Cut> best_cut(const Strands& strands, std::span<const Measure> measures, double margin, double work) {
  double left = HUGE_VAL, right = -HUGE_VAL;
  for (const Strand& s : strands) {
    left = std::min(left, s.from.x);
    right = std::max(right, s.to.x);
  }
  std::optional<Cut> best;
  for (const Measure by : measures) {
    Cut cut{by, margin, by == Measure::on_the_left ? left : right};
    const auto at = place_of_cut(strands, cut);
    if (!at) continue;
    cut.at = *at;
    for (const Strand& s : strands) cut.count(s);
    if (cut.work() <= (best ? best->work() : worth_dividing * work)) best = cut;
  }
  return best;
}

std::pair<Strands, Strands> parts_of(const Strands& strands, const Cut& cut) {
  std::pair<Strands, Strands> parts;
  parts.first.reserve(cut.below.strands);
  parts.second.reserve(cut.above.strands);
  for (const Strand& s : strands) {
    const auto [low, high] = cut.range(s);
    if (cut.has_below(low)) parts.first.push_back(cut.part_of(s, true));
    if (cut.has_above(high)) parts.second.push_back(cut.part_of(s, false));
  }
  return parts;
}

Strands along_longest(const Strands& strands) {
  const auto length = [](const Strand& s) { return glm::distance(s.from, s.to); };
  const auto longest = std::max_element(strands.begin(), strands.end(),
                                        [&](const Strand& a, const Strand& b) { return length(a) < length(b); });
  const Vec2 along = glm::normalize(longest->to - longest->from);
  Strands result;
  result.reserve(strands.size());
  for (const Strand& s : strands) result.push_back(turned(s, along));
  return result;
}

}  // namespace

std::optional<std::pair<Strands, Strands>> divide(const Strands& strands, double tolerance, bool go_along) {
  const Load load = load_of(strands);
  if (load.strands <= few_strands || load.ends <= few_ends) return std::nullopt;
  const double margin = 2 * tolerance;
  constexpr std::array places{Measure::x, Measure::y};
  constexpr std::array sides{Measure::on_the_left, Measure::on_the_right};
  if (const auto cut = best_cut(strands, places, margin, load.work())) return parts_of(strands, *cut);
  if (load.strands <= many_strands) return std::nullopt;
  if (go_along)
    if (const auto cut = best_cut(strands, sides, margin, load.work())) return parts_of(strands, *cut);
  const Strands others = along_longest(strands);
  if (const auto cut = best_cut(others, places, margin, load.work())) return parts_of(others, *cut);
  return std::nullopt;
}

DirectionClasses::DirectionClasses(const std::vector<Piece>& pieces, double spread, const Progress& progress)
    : pieces_(pieces),
      classes_(std::max<std::size_t>(static_cast<std::size_t>(half_turn / spread) / turns, 1)),
      members_(pieces.size()) {
  const std::size_t all = classes_ * turns;
  std::vector<std::size_t> turn(pieces.size());
  parallel_for(pieces.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    // Lines along the sides of the paper are in the middle of a turn.
    for (std::size_t i = begin; i < end; ++i)
      turn[i] = static_cast<std::size_t>(direction_of(pieces[i]) / half_turn * static_cast<double>(all) + 0.5) % all;
  });
  first_.assign(all + 1, 0);
  for (const std::size_t t : turn) ++first_[t + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) members_[next[turn[i]]++] = static_cast<int>(i);
}

Strands DirectionClasses::strands(std::size_t number) const {
  const auto members = [&](std::size_t from, std::size_t to) {
    return std::span(members_).subspan(first_[from], first_[to] - first_[from]);
  };
  const auto own = members(turns * number, turns * (number + 1));
  if (own.empty()) return {};
  const std::size_t next = (number + 1) % classes_ * turns;
  const auto guests = classes_ > 1 ? members(next, next + 1) : own.first(0);
  const auto shorter = [&](int a, int b) { return length_of(pieces_[a]) < length_of(pieces_[b]); };
  const Piece& longest = pieces_[*std::max_element(own.begin(), own.end(), shorter)];
  const Vec2 along = glm::normalize(longest.to - longest.from);
  Strands strands;
  strands.reserve(own.size() + guests.size());
  const auto add = [&](int piece, bool is_guest) {
    strands.push_back(turned({pieces_[piece].from, pieces_[piece].to, piece, true, true, is_guest}, along));
    strands.back().ends = !go_along();
    check(!(strands.back().from.x > strands.back().to.x), "lines of a class go along its longest one");
  };
  for (const int piece : own) add(piece, false);
  for (const int piece : guests) add(piece, true);
  return strands;
}

}  // namespace epura::drawing
