// SPDX-License-Identifier: Apache-2.0
// A polyline, addressed by the distance along it, in mm from its beginning.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "drawing/continuations.hpp"
#include "drawing/kept_ink.hpp"

namespace epura::drawing {

/// A piece of a polyline, which is entered at one of its ends.
struct Member {
  End end = no_end;
  int after = -1;  ///< when the last member was taken that runs along this one and comes earlier; -1: there is none
  double from = 0, to = 0;
  Vec2 direction{0, 0};  ///< that of a part of the polyline if the piece is too short to have its own
};

class MeasuredPolyline {
 public:
  /// A part of a member.
  struct Stretch {
    std::size_t member;
    double from, to;
  };

  MeasuredPolyline(const std::vector<Piece>& pieces, std::span<const Member> members)
      : pieces_(&pieces), members_(members) {}

  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] const Member& operator[](std::size_t member) const { return members_[member]; }
  [[nodiscard]] double length() const { return members_.back().to; }

  [[nodiscard]] std::size_t member_at(double x) const;
  [[nodiscard]] Vec2 place(std::size_t member, double x) const;
  [[nodiscard]] Vec2 place(double x) const { return place(member_at(x), x); }
  [[nodiscard]] std::array<Vec2, 2> ends_of(std::size_t member) const {
    return {place(member, members_[member].from), place(member, members_[member].to)};
  }
  [[nodiscard]] InkPart part_of(const Stretch& stretch) const;

  /// Members of length `with_direction` have a direction of their own; a shorter one gets that of such a length of the
  /// polyline around it, unless the polyline returns there to within `touching`.
  [[nodiscard]] Vec2 direction_of(std::size_t member, double with_direction, double touching) const;

  /// Calls `visit(stretch)` for the parts of members that a run consists of.
  template <class Visit>
  void visit_stretches(const std::array<double, 2>& run, const Visit& visit) const {
    if (!(run[1] > run[0])) return;
    for (std::size_t i = member_at(run[0]); i < size() && members_[i].from < run[1]; ++i) {
      const Stretch part{i, std::max(run[0], members_[i].from), std::min(run[1], members_[i].to)};
      if (part.to > part.from) visit(part);
    }
  }

 private:
  const std::vector<Piece>* pieces_;
  std::span<const Member> members_;
};

}  // namespace epura::drawing
