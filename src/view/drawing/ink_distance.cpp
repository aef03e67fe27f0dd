// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/range.hpp"
#include "search/bounds_tree.hpp"

namespace epura::drawing {

namespace {

auto key_of(const Piece& p) { return std::tuple(p.from.x, p.from.y, p.to.x, p.to.y, p.visible); }

bool is_before(const Piece& a, const Piece& b) { return key_of(a) < key_of(b); }

// Drawn pieces, by place.
std::vector<Piece> drawn_by_place(const std::vector<Piece>& pieces) {
  std::vector<Piece> ink;
  ink.reserve(pieces.size());
  for (const Piece& piece : pieces)
    if (piece.drawn) ink.push_back(piece);
  std::sort(ink.begin(), ink.end(), is_before);
  return ink;
}

// Ink that is in order of its place, in rows: what is near on the page is near in the list, too.
std::vector<Piece> in_rows(std::vector<Piece> ink) {
  Range heights;
  for (const Piece& piece : ink) heights.add(piece.from.y);
  const double rows = std::sqrt(static_cast<double>(ink.size()));
  const auto row_of = [&](const Piece& piece) {
    return heights.size() > 0 ? std::floor(rows * ((piece.from.y - heights.from) / heights.size())) : 0;
  };
  std::stable_sort(ink.begin(), ink.end(), [&](const Piece& a, const Piece& b) { return row_of(a) < row_of(b); });
  return ink;
}

/// Measures how far pieces are from ink, which is in order of its place.
class DistanceFrom {
 public:
  DistanceFrom(std::vector<Piece> ink, double precision, double most)
      : ink_(in_rows(std::move(ink))), precision_(precision), most_(most), tree_(ink_.size(), [&](std::size_t i) {
          const Vec2 low = glm::min(ink_[i].from, ink_[i].to), high = glm::max(ink_[i].from, ink_[i].to);
          return search::Bounds<2>{{{low.x, high.x}, {low.y, high.y}}};
        }) {}

  void add(const Piece& piece) {
    is_visible_ = piece.visible;
    halve(nearest(piece.from), nearest(piece.to));
  }

  /// To within the precision.
  [[nodiscard]] double farthest() const { return farthest_ > 0 ? std::min(most_, farthest_ + precision_) : 0; }

 private:
  struct Place {
    Vec2 at;
    double distance;
    const Piece* ink;  ///< null: none within the greatest distance
  };

  [[nodiscard]] Place nearest(const Vec2& at) const {
    Place found{at, most_, nullptr};
    search::Bounds<2> wanted{{{at.x - most_, at.x + most_}, {at.y - most_, at.y + most_}}};
    tree_.visit(wanted, [&](std::size_t i) {
      if (is_visible_ && !ink_[i].visible) return true;
      const double distance = distance_to_segment(at, ink_[i].from, ink_[i].to);
      if (distance > found.distance) return true;
      found = {at, distance, &ink_[i]};
      wanted = {{{at.x - distance, at.x + distance}, {at.y - distance, at.y + distance}}};
      return distance > 0;
    });
    check(found.distance <= most_, "ink is nearest within the distance that is asked for");
    return found;
  }

  void halve(const Place& from, const Place& to) {
    farthest_ = std::max({farthest_, from.distance, to.distance});
    double between = most_;
    for (const Piece* ink : {from.ink, to.ink})
      if (ink != nullptr)
        between = std::min(between, std::max(distance_to_segment(from.at, ink->from, ink->to),
                                             distance_to_segment(to.at, ink->from, ink->to)));
    if (between <= farthest_ + precision_ || glm::distance(from.at, to.at) <= precision_) return;
    const Place middle = nearest(0.5 * (from.at + to.at));
    halve(from, middle);
    halve(middle, to);
  }

  std::vector<Piece> ink_;
  double precision_, most_;
  search::BoundsTree<2> tree_;
  bool is_visible_ = true;
  double farthest_ = 0;
};

// From pieces that are not among the ink as they are.
double farthest_from(const std::vector<Piece>& ink, const std::vector<Piece>& pieces, double precision, double most,
                     const Progress& progress) {
  DistanceFrom distance(ink, precision, most);
  constexpr std::size_t at_once = 1024;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i % at_once == 0) progress.expect_time();
    const auto same = std::lower_bound(ink.begin(), ink.end(), pieces[i], is_before);
    if (same == ink.end() || is_before(pieces[i], *same)) distance.add(pieces[i]);
  }
  return distance.farthest();
}

}  // namespace

double ink_distance(const std::vector<Piece>& before, const std::vector<Piece>& after, double precision, double most,
                    const Progress& progress) {
  check(precision > 0, "what is halved has a least length");
  const std::vector<Piece> one = drawn_by_place(before), other = drawn_by_place(after);
  return std::max(farthest_from(one, other, precision, most, progress),
                  farthest_from(other, one, precision, most, progress));
}

}  // namespace epura::drawing
