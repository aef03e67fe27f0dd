// SPDX-License-Identifier: Apache-2.0
#include "drawing/piece_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace epura::drawing {

namespace {

Vec2 across(const Vec2& direction) { return {-direction.y, direction.x}; }

// The angle is doubled, since a line has no sense.
Vec2 on_circle(const Vec2& d) { return Vec2(d.x * d.x - d.y * d.y, 2 * d.x * d.y) / glm::dot(d, d); }

}  // namespace

PieceTree::PieceTree(const std::vector<Piece>& pieces, std::vector<int> members, double tolerance, double spread,
                     Order has_higher_rank)
    : pieces_(&pieces),
      by_rank_(std::move(members)),
      tolerance_(tolerance),
      spread_(spread),
      has_higher_rank_(has_higher_rank) {
  // Pieces of equal rank are ordered by their numbers, since members come in any order.
  std::sort(by_rank_.begin(), by_rank_.end(), [&](int a, int b) {
    if (has_higher_rank(pieces[a], pieces[b])) return false;
    return has_higher_rank(pieces[b], pieces[a]) || b < a;
  });
  choose_normals();
  sort_by_direction();
  tree_ = {members_.size(), [&](std::size_t i) {
             const Piece& piece = pieces[members_[i]];
             Bounds bounds = bounds_of(piece.from, piece.to);
             bounds[order].fill(place_[i]);
             return bounds;
           }};
}

// Each normal is that of the piece that extends farthest across all earlier ones.
void PieceTree::choose_normals() {
  std::vector<double> reach(by_rank_.size());
  const auto along = [&](std::size_t i) { return (*pieces_)[by_rank_[i]].to - (*pieces_)[by_rank_[i]].from; };
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = glm::length(along(i));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto farthest = static_cast<std::size_t>(std::max_element(reach.begin(), reach.end()) - reach.begin());
    normals_[k] = across(glm::normalize(along(farthest)));
    for (std::size_t i = 0; i < reach.size(); ++i)
      reach[i] = std::min(reach[i], std::abs(glm::dot(normals_[k], along(i))));
  }
  normals_[3] = across(normals_[0]);
}

// Groups pieces by their nearest normal, each group in order of rank.
void PieceTree::sort_by_direction() {
  std::vector<std::size_t> nearest(by_rank_.size()), sorted(by_rank_.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const Piece& piece = (*pieces_)[by_rank_[i]];
    const auto slant = [&](const Vec2& normal) { return std::abs(glm::dot(normal, piece.to - piece.from)); };
    const auto less = [&](const Vec2& a, const Vec2& b) { return slant(a) < slant(b); };
    nearest[i] =
        static_cast<std::size_t>(std::min_element(normals_.begin(), normals_.begin() + 3, less) - normals_.begin());
  }
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return nearest[a] < nearest[b]; });
  for (const std::size_t i : sorted) {
    members_.push_back(by_rank_[i]);
    place_.push_back(static_cast<double>(i));
  }
}

PieceTree::Bounds PieceTree::bounds_of(const Vec2& from, const Vec2& to) const {
  Bounds bounds;
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const auto [low, high] = std::minmax({glm::dot(normals_[i], from), glm::dot(normals_[i], to)});
    bounds[i] = {low, high};
  }
  const Vec2 circle = on_circle(to - from);
  bounds[direction].fill(circle.x);
  bounds[direction + 1].fill(circle.y);
  return bounds;
}

PieceTree::Bounds PieceTree::covering(int piece, const std::array<double, 2>& part) const {
  const Piece& own = (*pieces_)[piece];
  const Ruler line(own.from, own.to);
  Bounds bounds = bounds_of(line.from + part[0] * line.along, line.from + part[1] * line.along);
  const Vec2 circle = on_circle(line.along);
  for (std::size_t i = 0; i < order; ++i) {
    const bool is_place = i < direction;
    if (!is_place) bounds[i].fill(circle[static_cast<int>(i - direction)]);
    // The tolerance counts once for covering and once for rounding; on the circle, angles are doubled.
    const double slack = 2 * (is_place ? tolerance_ : spread_);
    bounds[i] = {bounds[i][0] - slack, bounds[i][1] + slack};
  }
  const auto higher = [&](int a, int b) { return has_higher_rank_((*pieces_)[b], (*pieces_)[a]); };
  const auto first = std::upper_bound(by_rank_.begin(), by_rank_.end(), piece, higher);
  bounds[order] = {static_cast<double>(first - by_rank_.begin()), HUGE_VAL};
  return bounds;
}

}  // namespace epura::drawing
