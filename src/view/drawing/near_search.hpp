// SPDX-License-Identifier: Apache-2.0
// Finds the parts of polylines that lie near stronger ink; near_ink.hpp defines "near".
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/measured_polyline.hpp"
#include "drawing/near_parts.hpp"
#include "drawing/near_prefilter.hpp"
#include "visibility/spans.hpp"

namespace epura::drawing {

class NearSearch {
 public:
  /// Lines within `limits.touching` of each other meet.
  NearSearch(const std::vector<Piece>& pieces, const NearPrefilter& prefilter, const AlongLimits& limits);

  /// Decides for one polyline after the other which parts stay and which are removed. Throws OutOfTime.
  void add_all(const Progress& progress);

  [[nodiscard]] const InkParts& kept() const { return kept_.parts(); }
  [[nodiscard]] const std::vector<InkPart>& dangles() const { return dangles_; }
  [[nodiscard]] const TakenInk& taken() const { return taken_; }

 private:
  using Stretch = MeasuredPolyline::Stretch;
  /// A stretch near ink that stays.
  struct Near {
    Stretch stretch;
    int by;
    Interval apart;  ///< at its ends, mm
  };
  using Run = std::array<double, 2>;
  // Least number of members that are searched together before their polylines are added.
  static constexpr std::size_t looked_ahead = 8192;

  void add(std::size_t line);
  [[nodiscard]] visibility::Spans near_parts(std::size_t member, std::size_t turn);
  void add_run(const Run& run);
  void add_apart(const Stretch& stretch);
  void end_gap(bool is_near);
  [[nodiscard]] bool has_ink_around(const Stretch& stretch);
  [[nodiscard]] int nearest_kept(const Vec2& place) const;
  [[nodiscard]] bool is_bridge(const Vec2& from, const Vec2& to) const;
  [[nodiscard]] std::array<bool, 2> goes_on(const Run& run, bool is_closed) const;
  [[nodiscard]] std::optional<double> closest_approach(const Run& run) const;
  [[nodiscard]] Run between_contacts(const Run& run, const std::array<bool, 2>& goes_on) const;
  void keep(const Stretch& stretch);
  void keep(const Run& run);
  void settle(bool is_closed);
  void take_away(const std::vector<Run>& runs);

  const NearPrefilter& prefilter_;
  AlongLimits limits_;
  KeptInk kept_;
  NearAhead ahead_;
  std::vector<InkPart> dangles_;  ///< kept, but too short to be drawn instead of others
  TakenInk taken_;

  // The current polyline:
  MeasuredPolyline polyline_;
  NearParts found_;  ///< along one member
  std::vector<Near> near_;
  std::vector<double> contacts_;  ///< where it meets stronger ink near it
  std::vector<Run> runs_;         ///< near stretches: ascending, disjoint
  std::vector<Stretch> gap_;      ///< the part after the last run, while it is short
  bool is_apart_ = false;         ///< whether that part has become too long for a gap
};

}  // namespace epura::drawing
