// SPDX-License-Identifier: Apache-2.0
// Ink that stays, found where it runs along members of polylines.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drawing/beside.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/near_glance.hpp"

namespace epura::drawing {

/// A kept part (`by`), and the stretch of the member along which it runs, mm.
struct NearPart {
  Range stretch;
  int by;
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

  /// Appends what runs along a member. If there is very much of it, some is left out once the rest covers the member.
  void find_near(const MeasuredPolyline& polyline, std::size_t member, NearParts& found) const;

 private:
  AlongLimits limits_;
  InkParts parts_;
  std::vector<std::array<float, 2>> directions_{};  ///< by part
};

/// The kept ink along the next members, found on several threads before any of these members is added.
class NearAhead {
 public:
  /// Looks at members that are taken from `first` to before `last`, if only ink that was already added can run along
  /// them.
  void look(const NearGlance& glance, const KeptInk& kept, std::size_t first, std::size_t last);

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
