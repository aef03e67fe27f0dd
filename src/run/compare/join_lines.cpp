// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "base/text.hpp"
#include "compare/differing_lines.hpp"

namespace epura::compare {

namespace {

// A line continues as long as it turns by less than this: cos 20 degrees.
constexpr double min_cosine = 0.94;

// An end of a part.
struct End {
  std::array<long long, 2> cell;
  int part;
  Vec2 at, inwards;  // `inwards` has length 1
};

class LineJoiner {
 public:
  LineJoiner(const std::vector<DifferingPart>& parts, double reach)
      : parts_(parts), reach_(reach), groups_(parts.size()), joined_(2 * parts.size(), false) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const InkPart& p = parts[i].part;
      const Vec2 along = (p.to - p.from) / length_of(p);
      ends_.push_back({cell_of(p.from), static_cast<int>(i), p.from, along});
      ends_.push_back({cell_of(p.to), static_cast<int>(i), p.to, -along});
    }
    for (std::size_t i = 0; i < ends_.size(); ++i) order_.push_back(i);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return std::tie(ends_[a].cell, a) < std::tie(ends_[b].cell, b); });
  }

  void join() {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      for (const long long column : {-1, 0, 1})
        for (const long long row : {-1, 0, 1}) join_with(i, {ends_[i].cell[0] + column, ends_[i].cell[1] + row});
  }

  int group_of(int part) { return groups_.root(part); }

  /// Ends of a part without a continuation.
  [[nodiscard]] std::vector<Vec2> free_ends(std::size_t part) const {
    std::vector<Vec2> free;
    for (const std::size_t end : {2 * part, 2 * part + 1})
      if (!joined_[end]) free.push_back(ends_[end].at);
    return free;
  }

 private:
  [[nodiscard]] std::array<long long, 2> cell_of(const Vec2& p) const {
    return {std::llround(p.x / reach_), std::llround(p.y / reach_)};
  }

  [[nodiscard]] bool goes_on(const End& a, const End& b) const {
    const DifferingPart &p = parts_[static_cast<std::size_t>(a.part)], &q = parts_[static_cast<std::size_t>(b.part)];
    return std::tie(p.part.look, p.other, p.part.view) == std::tie(q.part.look, q.other, q.part.view) &&
           glm::distance(a.at, b.at) <= reach_ && glm::dot(a.inwards, b.inwards) <= -min_cosine;
  }

  void join_with(std::size_t end, const std::array<long long, 2>& cell) {
    auto other = std::lower_bound(order_.begin(), order_.end(), cell,
                                  [&](std::size_t i, const auto& wanted) { return ends_[i].cell < wanted; });
    for (; other != order_.end() && ends_[*other].cell == cell; ++other) {
      if (ends_[*other].part == ends_[end].part || !goes_on(ends_[end], ends_[*other])) continue;
      joined_[end] = true;
      groups_.join(ends_[end].part, ends_[*other].part);
    }
  }

  const std::vector<DifferingPart>& parts_;
  double reach_;
  std::vector<End> ends_;           // two for each part
  std::vector<std::size_t> order_;  // of the ends by cell
  DisjointSets groups_;             // of parts
  std::vector<char> joined_;
};

bool comes_before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

// `origins` are lists of edges separated by spaces.
std::string edges_of(const std::vector<InkPart>& parts, const Picture& picture) {
  std::set<std::string_view> edges;
  for (const InkPart& part : parts)
    if (part.origin >= 0)
      for (const std::string_view edge : split(picture.origins[static_cast<std::size_t>(part.origin)], ' '))
        edges.insert(edge);
  std::string text;
  for (const std::string_view edge : edges) text.append(text.empty() ? "" : " ").append(edge);
  return text;
}

void finish(DifferingLine& line, std::vector<Vec2> free, const Picture& picture) {
  line.min = Vec2(HUGE_VAL);
  line.max = Vec2(-HUGE_VAL);
  line.centre = Vec2(0);
  line.length = 0;
  Vec2 first = line.parts.front().from;
  for (const InkPart& part : line.parts) {
    for (const Vec2& p : {part.from, part.to}) {
      line.min = glm::min(line.min, p);
      line.max = glm::max(line.max, p);
      if (comes_before(p, first)) first = p;
    }
    line.centre += length_of(part) * (part.from + part.to) / 2.0;
    line.length += length_of(part);
  }
  line.centre /= line.length;
  std::sort(free.begin(), free.end(), comes_before);
  line.from = free.empty() ? first : free.front();
  line.to = free.empty() ? first : free.back();
  line.name = picture.looks[static_cast<std::size_t>(line.parts.front().own_look)].name;
  line.view = picture.views[static_cast<std::size_t>(line.parts.front().view)];
  line.origin = edges_of(line.parts, picture);
}

}  // namespace

std::vector<DifferingLine> join_lines(std::vector<DifferingPart> parts, const Picture& picture, double reach) {
  const auto key = [](const DifferingPart& p) {
    return std::tuple(p.part.look, p.other, p.part.from.x, p.part.from.y, p.part.to.x, p.part.to.y);
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const DifferingPart& a, const DifferingPart& b) { return key(a) < key(b); });
  LineJoiner joiner(parts, reach);
  joiner.join();
  std::vector<DifferingLine> lines;
  std::vector<std::vector<Vec2>> free;
  std::vector<std::size_t> line_of(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto group = static_cast<std::size_t>(joiner.group_of(static_cast<int>(i)));
    if (group == i) {  // the first of its group
      line_of[i] = lines.size();
      lines.emplace_back().look = parts[i].part.look;
      lines.back().other = parts[i].other;
      free.emplace_back();
    }
    lines[line_of[group]].parts.push_back(parts[i].part);
    for (const Vec2& end : joiner.free_ends(i)) free[line_of[group]].push_back(end);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) finish(lines[i], std::move(free[i]), picture);
  return lines;
}

}  // namespace epura::compare
