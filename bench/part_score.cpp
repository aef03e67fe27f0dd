// SPDX-License-Identifier: Apache-2.0
#include "part_score.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>

#include "base/nearest.hpp"
#include "drawing/near_lines.hpp"
#include "search/line_cells.hpp"

namespace epura::bench {

namespace {

constexpr double beside = 0.4, sample_step = 0.2, touching = 0.06;

bool is_finite(const Vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Lines of a page, searched for by distance from a point.
class NearLines {
 public:
  NearLines(std::span<const PageLine> lines, double distance) : lines_(lines), distance_(distance) {
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (const PageLine& line : lines) {
      min = glm::min(min, glm::min(line.from, line.to));
      max = glm::max(max, glm::max(line.from, line.to));
    }
    if (lines.empty()) return;
    // About a millimetre wide: a sheet of paper has some 60 000 such cells.
    const auto cells = [](double length) { return static_cast<int>(std::clamp(length, 1.0, 1000.0)); };
    const Vec2 size = glm::max(max - min, Vec2(1));
    grid_ = {min, {size.x / cells(size.x), size.y / cells(size.y)}, cells(size.x), cells(size.y)};
    in_cell_.resize(static_cast<std::size_t>(grid_.count()));
    for (std::size_t i = 0; i < lines.size(); ++i)
      search::visit_cells(grid_, lines[i].from, lines[i].to, distance,
                          [&](int cell, double, double) { in_cell_[cell].push_back(i); });
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Whether a line other than `except` passes near `p`.
  [[nodiscard]] bool pass(const Vec2& p, std::size_t except = none) const {
    if (lines_.empty()) return false;
    const auto& candidates = in_cell_[grid_.cell(grid_.column(p.x), grid_.row(p.y))];
    return std::any_of(candidates.begin(), candidates.end(), [&](std::size_t i) {
      return i != except && distance_to_segment(p, lines_[i].from, lines_[i].to) <= distance_;
    });
  }

 private:
  std::span<const PageLine> lines_;
  double distance_;
  search::CellGrid grid_{};
  std::vector<std::vector<std::size_t>> in_cell_;
};

double length_of(std::span<const PageLine> lines) {
  double length = 0;
  for (const PageLine& line : lines) length += glm::distance(line.from, line.to);
  return length;
}

/// The fraction of the length of `lines` that lies beside `others`.
double share_beside(std::span<const PageLine> lines, std::span<const PageLine> others) {
  const NearLines near(others, beside);
  double found = 0;
  for (const PageLine& line : lines) {
    const double length = glm::distance(line.from, line.to);
    const auto samples = std::max<long long>(1, static_cast<long long>(length / sample_step));
    const double each = 1.0 / static_cast<double>(samples);
    for (long long i = 0; i < samples; ++i)
      if (near.pass(glm::mix(line.from, line.to, (static_cast<double>(i) + 0.5) * each))) found += length * each;
  }
  const double whole = length_of(lines);
  return whole > 0 ? found / whole : 1;
}

int loose_ends_of(std::span<const PageLine> lines) {
  const NearLines near(lines, touching);
  int count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const Vec2& end : {lines[i].from, lines[i].to}) count += near.pass(end, i) ? 0 : 1;
  return count;
}

PageLines together(std::initializer_list<std::span<const PageLine>> sets) {
  PageLines lines;
  for (const auto& set : sets) lines.insert(lines.end(), set.begin(), set.end());
  return lines;
}

}  // namespace

Score score_of(const Ink& ink, const ExactLines& exact) {
  const PageLines may_be_seen = together({exact.visible, exact.smooth_visible});
  const PageLines may_be_hidden = together({may_be_seen, exact.hidden, exact.smooth_hidden});
  const PageLines all_ink = together({ink.visible, ink.hidden});
  for (const PageLines* lines : {&may_be_hidden, &all_ink})
    for (const PageLine& line : *lines)
      if (!is_finite(line.from) || !is_finite(line.to)) throw std::runtime_error("a line has no end on the page");
  Score score{};
  score.recall = share_beside(exact.visible, ink.visible);
  score.precision = share_beside(ink.visible, may_be_seen);
  score.recall_hidden = share_beside(exact.hidden, all_ink);
  score.precision_hidden = share_beside(ink.hidden, may_be_hidden);
  score.exact = length_of(exact.visible);
  score.ink = length_of(ink.visible);
  score.loose_ends = loose_ends_of(ink.visible);
  return score;
}

}  // namespace epura::bench
