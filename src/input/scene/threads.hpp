// SPDX-License-Identifier: Apache-2.0
// Metric screw threads: their designations (ISO 965-1), the diameters and pitches of ISO 261, and the basic dimensions
// of ISO 724.
#pragma once

#include <string>
#include <string_view>

namespace epura::scene {

struct Thread {
  double diameter;   ///< nominal, which is the major diameter, mm
  double pitch;      ///< mm
  std::string text;  ///< as it is written on drawings: "M6", "M6×0.75", "M6-6H"

  /// Minor diameter of the internal and external thread, D1 and d1: five eighths of the height of the fundamental
  /// triangle lie between it and the major diameter on either side. ISO 724.
  [[nodiscard]] double minor() const;
};

/// Parses "M6", "M6x0.75", "M6×0.75", with a tolerance class or LH behind a hyphen: "M6-6H", "M6-5g6g-LH". Throws
/// Error{input} with `where` as the location for sizes and pitches that ISO 261 does not have.
Thread parse_thread(std::string_view text, const std::string& where);

/// A cylinder of a part that has a thread. Lengths are those of the world.
struct ThreadedFace {
  int face;         ///< of the part
  bool internal;    ///< of a hole
  bool from_high;   ///< it begins at the end of the face that is farther along the axis of its surface
  double length;    ///< from there
  bool is_partial;  ///< it ends before the cylinder does
  int number;       ///< of its description in the scene
  Thread thread;
};

}  // namespace epura::scene
