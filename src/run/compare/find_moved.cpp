// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>

#include "compare/comparison.hpp"
#include "compare/differing_lines.hpp"
#include "drawing/ink.hpp"

namespace epura::compare {

namespace {

using Lines = std::vector<DifferingLine>;

bool is_closed(const DifferingLine& line) { return line.from == line.to; }

// The distance between two pairs of points, if both points of a pair are shifted alike.
std::optional<double> shift(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1, double tolerance) {
  const Vec2 d = b0 - a0;
  if (glm::distance(d, b1 - a1) > 2 * tolerance) return std::nullopt;
  return glm::length(d);
}

std::optional<double> parallel_shift(const DifferingLine& a, const DifferingLine& b, double tolerance) {
  if (a.look != b.look || is_closed(a) != is_closed(b)) return std::nullopt;
  if (std::abs(a.length - b.length) > 2 * tolerance + 1e-6 * a.length) return std::nullopt;
  const auto boxes = shift(a.min, a.max, b.min, b.max, tolerance);
  if (!boxes || is_closed(a)) return boxes;
  const auto straight = shift(a.from, a.to, b.from, b.to, tolerance);
  return straight ? straight : shift(a.from, a.to, b.to, b.from, tolerance);
}

double farthest_ends(const DifferingLine& a, const DifferingLine& b) {
  const auto farther = [&](const Vec2& from, const Vec2& to) {
    return std::max(glm::distance(a.from, from), glm::distance(a.to, to));
  };
  return std::min(farther(b.from, b.to), farther(b.to, b.from));
}

// Whether one continues along the other: then it became longer or shorter, or both.
bool in_one_line(const DifferingLine& a, const DifferingLine& b, double tolerance) {
  if (a.from == a.to) return false;
  const drawing::Ruler line(a.from, a.to);
  return std::abs(line.local(b.from).y) <= 2 * tolerance && std::abs(line.local(b.to).y) <= 2 * tolerance;
}

// The line of each edge that has only one; -1 if there are several.
std::map<std::string, int> lines_by_edge(const Lines& lines) {
  std::map<std::string, int> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& edge = lines[i].origin;
    if (edge.empty() || edge.find(' ') != std::string::npos) continue;
    const auto [place, added] = found.emplace(edge, static_cast<int>(i));
    if (!added) place->second = -1;
  }
  return found;
}

class Pairing {
 public:
  Pairing(const Lines& before, const Lines& after, double tolerance)
      : before_(before), after_(after), tolerance_(tolerance), used_before_(before.size()), used_after_(after.size()) {}

  void by_edge() {
    const std::map<std::string, int> other = lines_by_edge(after_);
    for (const auto& [edge, a] : lines_by_edge(before_)) {
      const auto b = other.find(edge);
      if (a < 0 || b == other.end() || b->second < 0) continue;
      const DifferingLine &from = before_[std::size_t(a)], &to = after_[std::size_t(b->second)];
      const bool alike = std::tie(from.look, from.view) == std::tie(to.look, to.view);
      if (alike && !in_one_line(from, to, tolerance_)) pair(a, b->second, farthest_ends(from, to));
    }
  }

  void by_form() {
    std::vector<int> by_length(after_.size());
    for (std::size_t i = 0; i < by_length.size(); ++i) by_length[i] = static_cast<int>(i);
    const auto length = [&](int i) { return after_[std::size_t(i)].length; };
    std::stable_sort(by_length.begin(), by_length.end(), [&](int a, int b) { return length(a) < length(b); });
    for (std::size_t a = 0; a < before_.size(); ++a) {
      if (used_before_[a]) continue;
      const double slack = 2 * tolerance_ + 1e-6 * before_[a].length;
      auto b = std::lower_bound(by_length.begin(), by_length.end(), before_[a].length - slack,
                                [&](int i, double wanted) { return length(i) < wanted; });
      std::optional<MovedLine> nearest;
      for (; b != by_length.end() && length(*b) <= before_[a].length + slack; ++b) {
        if (used_after_[std::size_t(*b)]) continue;
        const auto distance = parallel_shift(before_[a], after_[std::size_t(*b)], tolerance_);
        if (distance && *distance <= (nearest ? nearest->distance : max_moved))
          nearest = MovedLine{static_cast<int>(a), *b, *distance};
      }
      if (nearest) pair(nearest->before, nearest->after, nearest->distance);
    }
  }

  std::vector<MovedLine> pairs;

 private:
  void pair(int a, int b, double distance) {
    pairs.push_back({a, b, distance});
    used_before_[std::size_t(a)] = used_after_[std::size_t(b)] = true;
  }

  const Lines &before_, &after_;
  double tolerance_;
  std::vector<char> used_before_, used_after_;
};

}  // namespace

std::vector<MovedLine> find_moved(const Lines& before, const Lines& after, double tolerance) {
  Pairing pairing(before, after, tolerance);
  pairing.by_edge();
  pairing.by_form();
  return pairing.pairs;
}

}  // namespace epura::compare
