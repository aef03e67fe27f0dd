// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <utility>

#include "compare/differing_lines.hpp"
#include "compare/ink_parts.hpp"
#include "compare/page_differences.hpp"
#include "drawing/ink_distance.hpp"

namespace epura::compare {

namespace {

constexpr double distance_step = 0.0005;  // mm: half of what is told

using Parts = std::vector<InkPart>;
using PartsByLook = std::vector<Parts>;

// Groups parts, which are sorted by look.
PartsByLook by_look(Parts parts, std::size_t looks) {
  PartsByLook sorted(looks);
  if (!parts.empty() && parts.front().look == parts.back().look) {
    sorted[static_cast<std::size_t>(parts.front().look)] = std::move(parts);
    return sorted;
  }
  for (const InkPart& part : parts) sorted[static_cast<std::size_t>(part.look)].push_back(part);
  return sorted;
}

void append(std::vector<DifferingPart>& all, const Parts& parts, int other) {
  for (const InkPart& part : parts) all.push_back({part, other});
}

// Compares either lines or areas: neither covers the other.
class Kind {
 public:
  Kind(const Picture& before, const Picture& after, const CommonLooks& table, bool filled, double tolerance)
      : before_(before), after_(after), table_(table), tolerance_(tolerance), looks_(table.looks.size()) {
    old_ = by_look(seen_parts(before, table, table.of_before, filled), looks_);
    new_ = by_look(seen_parts(after, table, table.of_after, filled), looks_);
  }

  InkDifferences compare() {
    take_same();
    take_changed();
    report();
    return std::move(found_);
  }

 private:
  [[nodiscard]] const PictureLook& look(int i) const { return table_.looks[static_cast<std::size_t>(i)]; }

  void mark(const Parts& parts, Mark how) {
    for (const InkPart& part : parts) found_.marked.push_back({part.from, part.to, look(part.look), how});
  }

  void take_same() {
    // Wider lines may cover those of other looks below them.
    const PartsByLook none(looks_), all_old = looks_ > 1 ? old_ : none, all_new = looks_ > 1 ? new_ : none;
    for (std::size_t i = 0; i < looks_; ++i) {
      DividedInk old_ones = divide(old_[i], new_[i], tolerance_), new_ones = divide(new_[i], old_[i], tolerance_);
      mark(new_ones.met, Mark::same);
      old_[i] = std::move(old_ones.rest);
      new_[i] = std::move(new_ones.rest);
    }
    leave_out_covered(old_, all_old);
    leave_out_covered(new_, all_new);
  }

  // A line this close to a wider line of its drawing may lie under it in the other drawing because of rounding alone.
  void leave_out_covered(PartsByLook& parts, const PartsByLook& all) const {
    for (std::size_t i = 0; i < looks_; ++i)
      for (std::size_t wider = 0; wider < i && !parts[i].empty(); ++wider)
        parts[i] = divide(parts[i], all[wider], tolerance_).rest;
  }

  void take_changed() {
    for (std::size_t i = 0; i < looks_; ++i)
      for (std::size_t j = 0; j < looks_; ++j) {
        if (i == j || old_[i].empty() || new_[j].empty()) continue;
        DividedInk old_ones = divide(old_[i], new_[j], tolerance_), new_ones = divide(new_[j], old_[i], tolerance_);
        if (old_ones.met.empty() || new_ones.met.empty()) continue;
        append(changed_, old_ones.met, new_ones.met.front().own_look);
        mark(new_ones.met, Mark::changed);
        old_[i] = std::move(old_ones.rest);
        new_[j] = std::move(new_ones.rest);
      }
  }

  [[nodiscard]] std::vector<DifferingLine> lines_of(const PartsByLook& parts, const Picture& picture) const {
    std::vector<DifferingPart> all;
    for (const Parts& of_look : parts) append(all, of_look, -1);
    return join_lines(std::move(all), picture, reach());
  }

  // A differing line meets the other one here and there, which does not split it into several lines.
  [[nodiscard]] double reach() const { return 0.05 + 2 * tolerance_; }

  // Where the ends of a line stay, what is between them moved.
  [[nodiscard]] double distance_between(const DifferingLine& was, const DifferingLine& is, double of_ends) const {
    if (of_ends > 2 * tolerance_) return of_ends;
    const auto pieces_of = [](const DifferingLine& line) {
      std::vector<drawing::Piece> pieces;
      for (const InkPart& part : line.parts) pieces.push_back({part.from, part.to, true, true, EdgeKind{}, 0, {0, 0}});
      return pieces;
    };
    return std::max(of_ends, drawing::ink_distance(pieces_of(was), pieces_of(is), distance_step, max_moved));
  }

  Difference difference(Change change, const DifferingLine& line) const {
    Difference found{change, 0, line.view};
    found.from = line.from;
    found.to = line.to;
    found.centre = line.centre;
    found.length = line.length;
    found.origin = line.origin;
    return found;
  }

  void report() {
    for (const DifferingLine& line : join_lines(std::move(changed_), before_, reach())) {
      const PictureLook &was = look(line.look), &is = after_.looks[static_cast<std::size_t>(line.other)];
      const bool same_side = was.filled || was.visible == is.visible;
      Difference& found =
          found_.differences.emplace_back(difference(same_side ? Change::restyled : Change::visibility, line));
      found.before = line.name;
      found.after = is.name;
    }
    const std::vector<DifferingLine> gone = lines_of(old_, before_), come = lines_of(new_, after_);
    std::vector<char> gone_moved(gone.size()), come_moved(come.size());
    for (const MovedLine& moved : find_moved(gone, come, tolerance_)) {
      const auto a = static_cast<std::size_t>(moved.before), b = static_cast<std::size_t>(moved.after);
      gone_moved[a] = come_moved[b] = true;
      Difference& found = found_.differences.emplace_back(difference(Change::moved, come[b]));
      found.before = gone[a].name;
      found.after = come[b].name;
      found.distance = distance_between(gone[a], come[b], moved.distance);
      found.old_from = gone[a].from;
      found.old_to = gone[a].to;
      found.old_length = gone[a].length;
    }
    report(gone, gone_moved, Change::removed, Mark::removed);
    report(come, come_moved, Change::added, Mark::added);
  }

  // Reports lines that only one drawing has.
  void report(const std::vector<DifferingLine>& lines, const std::vector<char>& moved, Change change, Mark how) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      mark(lines[i].parts, how);
      if (moved[i]) continue;
      Difference& found = found_.differences.emplace_back(difference(change, lines[i]));
      (change == Change::removed ? found.before : found.after) = lines[i].name;
    }
  }

  const Picture &before_, &after_;
  const CommonLooks& table_;
  double tolerance_;
  std::size_t looks_;
  PartsByLook old_, new_;
  std::vector<DifferingPart> changed_{};
  InkDifferences found_{};
};

}  // namespace

InkDifferences compare_ink(const Picture& before, const Picture& after, double tolerance) {
  const CommonLooks table = common_looks(before, after);
  InkDifferences found = Kind(before, after, table, true, tolerance).compare();
  InkDifferences lines = Kind(before, after, table, false, tolerance).compare();
  found.differences.insert(found.differences.end(), lines.differences.begin(), lines.differences.end());
  found.marked.insert(found.marked.end(), lines.marked.begin(), lines.marked.end());
  return found;
}

}  // namespace epura::compare
