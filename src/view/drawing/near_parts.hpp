// SPDX-License-Identifier: Apache-2.0
// Ink that stays, found where it runs along members of polylines.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drawing/beside.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/near_prefilter.hpp"

namespace epura::drawing {

/// A kept part (`by`), and the stretch of the member along which it runs, mm.
struct NearPart {
  Interval stretch;
  int by;
  Interval apart;  ///< how far from it the ends of the stretch are, mm
};

/// What runs along members: the lists of one member after the other.
struct NearParts {
  std::vector<NearPart> parts;
  std::vector<double> contacts;  ///< where the members meet it

  void clear() {
    parts.clear();
    contacts.clear();
  }
};

class KeptInk {
 public:
  KeptInk(const std::vector<Piece>& pieces, const AlongLimits& limits);

  void add(const InkPart& part, const Vec2& direction);
  [[nodiscard]] const InkParts& parts() const { return parts_; }

  /// Appends what runs along a member, the strongest first. If there is very much of it, some is left out once the rest
  /// covers the member.
  void find_near(const MeasuredPolyline& polyline, std::size_t member, NearParts& found) const;

  /// What is added from now on is newer.
  void begin_newer();
  /// Completes what `find_near` found for a member before `begin_newer`.
  void find_newer(const MeasuredPolyline& polyline, std::size_t member, NearParts& found) const;

 private:
  /// What was found for a member: `near`, whose parts from `first` on belong to it.
  struct Found {
    std::size_t first;
    NearParts& near;
  };

  void append(const std::vector<int>& numbers, const MeasuredPolyline& polyline, std::size_t member,
              const Found& found) const;

  AlongLimits limits_;
  std::array<Vec2, 2> box_;
  InkParts parts_;
  std::vector<std::array<float, 2>> directions_{};  ///< by part
  InkCells newer_;                                  ///< few, so that they are found without waiting for memory
  int first_newer_ = 0;
};

/// The kept ink along the next members, found on several threads before any of these members is added.
class NearAhead {
 public:
  /// Looks at the members that are taken from `first` to before `last`. What is added from now on is newer.
  void look(const NearPrefilter& prefilter, KeptInk& kept, std::size_t first, std::size_t last);

  /// Whether no newer ink can run along a member.
  [[nodiscard]] bool has_seen(const Member& member) const { return member.after < static_cast<int>(first_); }
  /// Appends what was found for the member that is taken at this time.
  void append(std::size_t turn, NearParts& found) const;

 private:
  static constexpr std::size_t size = 32;  // members of a block
  struct Block {
    NearParts near;
    std::array<std::array<std::size_t, 2>, size + 1> first;  ///< by member, in the lists of `near`
  };

  std::size_t first_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace epura::drawing
