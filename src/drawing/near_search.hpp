// SPDX-License-Identifier: Apache-2.0
// Which stretches of polylines lie near stronger ink: near_ink.hpp says what near is.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "drawing/kept_ink.hpp"
#include "drawing/partners.hpp"
#include "visibility/spans.hpp"

namespace epura::drawing {

class NearSearch {
 public:
  /// Lines within `touching` mm meet.
  NearSearch(const std::vector<Piece>& pieces, double distance, double touching);

  /// What of a polyline stays, and what is taken away. Those before are stronger.
  void add(std::span<const End> polyline, bool is_closed);

  [[nodiscard]] const InkParts& kept() const { return kept_; }
  [[nodiscard]] const std::vector<InkPart>& specks() const { return specks_; }
  [[nodiscard]] const TakenInk& taken() const { return taken_; }

 private:
  /// A piece of the polyline, entered by an end. mm along the polyline.
  struct Member {
    End end;
    double from, to;
  };
  /// A stretch of a member.
  struct Stretch {
    std::size_t member;
    double from, to;
  };
  /// Ink that stays lies near a stretch.
  struct Near {
    Stretch stretch;
    int by;
  };
  using Run = std::array<double, 2>;
  /// What the search for ink near a member knows of a kept part.
  struct Candidate {
    std::array<float, 2> direction;
    int member = -1;  ///< that was compared with it last, counted through all polylines
    bool is_near = false;
  };

  [[nodiscard]] Vec2 place(std::size_t member, double x) const;
  [[nodiscard]] Vec2 place(double x) const;
  [[nodiscard]] std::size_t member_at(double x) const;
  [[nodiscard]] Vec2 direction_of(std::size_t member) const;
  [[nodiscard]] InkPart part_of(const Stretch& stretch) const;
  [[nodiscard]] double length() const { return members_.back().to; }

  void begin(std::span<const End> polyline);
  [[nodiscard]] visibility::Spans near_parts(std::size_t member);
  void add_near(const Run& run);
  void add_apart(const Stretch& stretch);
  void end_gap(bool is_near);
  [[nodiscard]] bool has_ink_around(const Stretch& stretch);
  [[nodiscard]] int nearest_kept(const Vec2& place) const;
  [[nodiscard]] bool is_bridge(const Vec2& from, const Vec2& to) const;
  [[nodiscard]] std::array<bool, 2> goes_on(const Run& run, bool is_closed) const;
  [[nodiscard]] Run between_contacts(const Run& run, const std::array<bool, 2>& goes_on) const;
  void keep(const Stretch& stretch);
  void keep(const Run& run);
  void settle(bool is_closed);
  void take_away(const std::vector<Run>& runs);

  const std::vector<Piece>& pieces_;
  double distance_, touching_;
  InkParts kept_;
  std::vector<Candidate> candidates_;  ///< by kept part
  int members_before_ = 0;             ///< in all polylines
  std::vector<InkPart> specks_;        ///< kept, and too short to draw anything for others
  TakenInk taken_;

  // Of the polyline.
  std::vector<Member> members_;
  std::vector<Near> near_;
  std::vector<double> contacts_;  ///< where it meets stronger ink that is near
  std::vector<Run> runs_;         ///< near stretches: ascending, disjoint
  std::vector<Stretch> gap_;      ///< the stretch behind the last run, while it is short
  bool is_apart_ = false;         ///< that stretch is no gap any more
};

}  // namespace epura::drawing
