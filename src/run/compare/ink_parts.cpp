// SPDX-License-Identifier: Apache-2.0
#include "compare/ink_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "base/nearest.hpp"
#include "drawing/covers.hpp"
#include "drawing/ink.hpp"
#include "search/bounds_tree.hpp"
#include "search/line_cells.hpp"

namespace epura::compare {

namespace {

// Lengths on paper, mm. Lines of one drawing closer than `same_place` coincide; parts shorter than `shortest` are
// ignored; a remainder just above that length is not a difference from one just below.
constexpr double same_place = 0.0002, shortest = 0.002, min_reported = 0.004;
// Least length of an overlap: well below the shortest piece, which may be shifted along itself.
constexpr double min_overlap = 0.0005;
// Overlaps longer than this many times the tolerance are found first: they are between lines of nearly one direction,
// which are found quickly.
constexpr double long_overlap = 25;

constexpr double same_length = 1e-3;  // of widths and dashes, mm: they are rounded in files

bool same_dashes(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) <= same_length; });
}

bool same_look(const PictureLook& a, const PictureLook& b) {
  if (a.filled != b.filled || a.colour != b.colour) return false;
  return a.filled ||
         (a.visible == b.visible && std::abs(a.width - b.width) <= same_length && same_dashes(a.dashes, b.dashes));
}

// Wide before narrow, continuous before dashed: the one that is seen comes first.
auto seen_first(const PictureLook& look) {
  return std::tuple(look.filled, -look.width, !look.visible, look.dashes, look.colour, look.name);
}

std::vector<int> places_in(const std::vector<PictureLook>& table, const std::vector<PictureLook>& looks) {
  std::vector<int> places;
  for (const PictureLook& look : looks) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const PictureLook& other) { return same_look(look, other); });
    places.push_back(static_cast<int>(found - table.begin()));
  }
  return places;
}

// From left to right, vertical lines upwards: the direction of drawing does not matter.
InkPart in_one_direction(InkPart part) {
  if (std::tuple(part.from.x, part.from.y) > std::tuple(part.to.x, part.to.y)) std::swap(part.from, part.to);
  return part;
}

auto by_look_and_place(const InkPart& p) { return std::tuple(p.look, p.from.x, p.from.y, p.to.x, p.to.y); }

InkPart cut(const InkPart& part, double from, double to) {
  const double length = length_of(part);
  const Vec2 along = (part.to - part.from) / length;
  InkPart result = part;
  if (from > 0) result.from = part.from + from * along;
  if (to < length) result.to = part.from + to * along;
  return result;
}

// The overlaps of one part, joined if the remainder between them is negligible.
void append_divided(const InkPart& part, std::span<const drawing::Cover> covers, double tolerance,
                    DividedInk& divided) {
  const double length = length_of(part);
  if (covers.empty()) {
    if (length > min_reported) divided.rest.push_back(part);
    return;
  }
  const double min = std::max(tolerance, min_reported);
  double done = 0, met = 0;  // the current overlap begins at `met`; nothing is open before `done`
  for (const drawing::Cover& cover : covers) {
    if (cover.from - done > min) {
      if (done > met) divided.met.push_back(cut(part, met, done));
      divided.rest.push_back(cut(part, done, cover.from));
      met = cover.from;
    }
    done = std::max(done, cover.to);
  }
  const bool ends_open = length - done > min;
  divided.met.push_back(cut(part, met, ends_open ? done : length));
  if (ends_open) divided.rest.push_back(cut(part, done, length));
}

DividedInk divide_by(const std::vector<InkPart>& parts, const std::vector<InkPart>& others, double tolerance,
                     double min) {
  // Pieces of one side do not cover each other.
  const auto is_other = [](const drawing::Piece& a, const drawing::Piece& b) { return a.visible && !b.visible; };
  std::vector<drawing::Piece> pieces;
  pieces.reserve(others.size() + parts.size());
  for (const InkPart& part : others) pieces.push_back({part.from, part.to, true, true, EdgeKind{}, 0, {0, 0}});
  for (const InkPart& part : parts) pieces.push_back({part.from, part.to, false, true, EdgeKind{}, 0, {0, 0}});
  const std::vector<drawing::Cover> covers = drawing::find_covers(pieces, tolerance, min, {}, is_other);
  pieces = std::vector<drawing::Piece>();  // freed, so that two copies rarely exist at a time
  DividedInk divided;
  std::size_t next = static_cast<std::size_t>(
      std::lower_bound(covers.begin(), covers.end(), drawing::Cover{static_cast<int>(others.size()), 0, 0}) -
      covers.begin());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t first = next;
    while (next < covers.size() && covers[next].piece == static_cast<int>(others.size() + i)) ++next;
    append_divided(parts[i], std::span(covers).subspan(first, next - first), tolerance, divided);
  }
  return divided;
}

// Those of `others` in a page cell through which some of `parts` pass.
std::vector<InkPart> those_near(const std::vector<InkPart>& others, const std::vector<InkPart>& parts,
                                double tolerance) {
  constexpr int cells = 256;  // per side
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (const InkPart& part : parts) {
    min = glm::min(min, glm::min(part.from, part.to));
    max = glm::max(max, glm::max(part.from, part.to));
  }
  min -= tolerance;
  max += tolerance;
  const search::CellGrid grid{min, (max - min) / double(cells), cells, cells};
  std::vector<char> used(static_cast<std::size_t>(grid.count()));
  const auto visit = [&](const InkPart& part, const auto& see) {
    search::visit_cells(grid, part.from, part.to, tolerance,
                        [&](int cell, double, double) { see(used[static_cast<std::size_t>(cell)]); });
  };
  for (const InkPart& part : parts) visit(part, [](char& cell) { cell = 1; });
  std::vector<InkPart> near;
  for (const InkPart& part : others) {
    bool meets = false;
    visit(part, [&](char cell) { meets = meets || cell != 0; });
    if (meets) near.push_back(part);
  }
  return near;
}

// Moves short parts that lie wholly within the tolerance of another, beyond its end or across it, to those that are
// met.
void take_short(DividedInk& divided, const std::vector<InkPart>& others, double tolerance) {
  const auto is_short = [&](const InkPart& part) { return length_of(part) <= 2 * tolerance; };
  if (std::ranges::none_of(divided.rest, is_short)) return;
  const search::BoundsTree<2> tree(others.size(), [&](std::size_t i) {
    const auto [left, right] = std::minmax(others[i].from.x, others[i].to.x);
    const auto [bottom, top] = std::minmax(others[i].from.y, others[i].to.y);
    return search::Bounds<2>{{{left, right}, {bottom, top}}};
  });
  const auto is_within = [&](const InkPart& other, const Vec2& p) {
    return distance_to_segment(p, other.from, other.to) <= tolerance;
  };
  const auto is_near = [&](const InkPart& part) {
    if (!is_short(part)) return false;
    const Vec2 low = glm::max(part.from, part.to) - tolerance, high = glm::min(part.from, part.to) + tolerance;
    bool found = false;
    tree.visit({{{low.x, high.x}, {low.y, high.y}}}, [&](std::size_t i) {
      found = is_within(others[i], part.from) && is_within(others[i], part.to);
      return !found;
    });
    return found;
  };
  const auto near = std::stable_partition(divided.rest.begin(), divided.rest.end(),
                                          [&](const InkPart& part) { return !is_near(part); });
  divided.met.insert(divided.met.end(), near, divided.rest.end());
  divided.rest.erase(near, divided.rest.end());
}

}  // namespace

double length_of(const InkPart& part) { return glm::distance(part.from, part.to); }

CommonLooks common_looks(const Picture& before, const Picture& after) {
  std::vector<PictureLook> all = before.looks;
  all.insert(all.end(), after.looks.begin(), after.looks.end());
  std::sort(all.begin(), all.end(),
            [](const PictureLook& a, const PictureLook& b) { return seen_first(a) < seen_first(b); });
  CommonLooks common;
  for (const PictureLook& look : all)
    if (std::none_of(common.looks.begin(), common.looks.end(),
                     [&](const PictureLook& other) { return same_look(look, other); }))
      common.looks.push_back(look);
  common.of_before = places_in(common.looks, before.looks);
  common.of_after = places_in(common.looks, after.looks);
  return common;
}

std::vector<InkPart> seen_parts(const Picture& picture, const CommonLooks& table, const std::vector<int>& looks,
                                bool filled) {
  const auto part_of = [&](const PicturePiece& piece) {
    const int look = looks[static_cast<std::size_t>(piece.look)];
    return InkPart{piece.from, piece.to, look, piece.look, piece.view, piece.origin};
  };
  const auto is_seen = [&](const PicturePiece& piece) {
    const int look = looks[static_cast<std::size_t>(piece.look)];
    return table.looks[static_cast<std::size_t>(look)].filled == filled && length_of(part_of(piece)) > shortest;
  };
  // Small files can have very many pieces: lists are allocated with their final size.
  std::vector<InkPart> parts;
  parts.reserve(static_cast<std::size_t>(std::count_if(picture.pieces.begin(), picture.pieces.end(), is_seen)));
  for (const PicturePiece& piece : picture.pieces)
    if (is_seen(piece)) parts.push_back(in_one_direction(part_of(piece)));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const InkPart& a, const InkPart& b) { return by_look_and_place(a) < by_look_and_place(b); });
  std::vector<drawing::Piece> pieces;
  pieces.reserve(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    pieces.push_back({parts[i].from, parts[i].to, true, true, EdgeKind{}, static_cast<int>(i), {0, 0}});
  pieces = drawing::resolve_coincident(std::move(pieces), same_place, shortest);
  std::vector<InkPart> seen;
  seen.reserve(pieces.size());
  for (const drawing::Piece& piece : pieces) {
    seen.push_back(parts[static_cast<std::size_t>(piece.edge)]);
    seen.back().from = piece.from;
    seen.back().to = piece.to;
  }
  return seen;
}

DividedInk divide(const std::vector<InkPart>& parts, const std::vector<InkPart>& others, double tolerance) {
  constexpr std::size_t few = 8;  // times fewer than the others, most of which are then elsewhere
  const bool are_few = few * parts.size() < others.size() && !parts.empty();
  const std::vector<InkPart> near = are_few ? those_near(others, parts, tolerance) : others;
  DividedInk divided = divide_by(parts, near, tolerance, std::max(long_overlap * tolerance, min_overlap));
  if (divided.rest.empty() || near.empty()) return divided;
  const std::vector<InkPart> nearest = those_near(near, divided.rest, tolerance);
  DividedInk last = divide_by(divided.rest, nearest, tolerance, min_overlap);
  take_short(last, nearest, tolerance);
  divided.met.insert(divided.met.end(), last.met.begin(), last.met.end());
  divided.rest = std::move(last.rest);
  return divided;
}

}  // namespace epura::compare
