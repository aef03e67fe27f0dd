// SPDX-License-Identifier: Apache-2.0
// Interrupted and partial views: parts of a drawing that are left out, and the lines that limit the rest. ISO 128-3.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"

namespace epura::drawing {

struct ViewDrawing;

/// A part of a view that is left out: a strip of the plane between two places on an axis. An infinite place is the end
/// of the view, which is then not interrupted but partial.
struct LeftOut {
  double from, to;
  bool symmetric = false;  ///< limited by a line of symmetry instead of a break line

  /// Whether something is drawn on both sides.
  [[nodiscard]] bool is_between() const;
};

/// What is left out of a view: for the x and the y axis, strips in ascending order that do not overlap. Lengths in mm
/// on paper, positions as if the whole view were drawn.
struct Breaks {
  std::array<std::vector<LeftOut>, 2> along{};
  double gap = 0;         ///< between the remaining parts once they are moved together
  bool freehand = false;  ///< whether the remaining parts end at freehand lines

  [[nodiscard]] bool any() const { return !along[0].empty() || !along[1].empty(); }
  /// Whether a point is drawn.
  [[nodiscard]] bool keeps(const Vec2& p) const;
  /// Where a point of the whole view is once the parts are moved together. Strips become gaps, linearly.
  [[nodiscard]] Vec2 moved(const Vec2& p) const;
  /// Where a drawn point would be in the whole view.
  [[nodiscard]] Vec2 restored(const Vec2& p) const;
  /// Position of the line of symmetry perpendicular to an axis, before the move, if the view is a half.
  [[nodiscard]] std::optional<double> mirror(int axis) const;
  /// Whether a half view shows one of two points of the whole view and leaves out the other, its mirror image within
  /// `slack`, along an axis.
  [[nodiscard]] bool are_mirrored(const Vec2& p, const Vec2& q, int axis, double slack) const;
  /// Length of all gaps along an axis.
  [[nodiscard]] double gaps(int axis) const;
};

/// The same breaks after scale * p + shift, with a gap that is not scaled.
Breaks mapped(const Breaks& breaks, double scale, const Vec2& shift, double gap);

/// A part of a view that remains: a rectangle of the whole view, which may be infinite, and how far it is moved.
struct KeptPart {
  Vec2 min, max;
  Vec2 shift;
};

std::vector<KeptPart> kept_parts(const Breaks& breaks);

/// Returns the parts of a line of the whole view that are drawn, as parameters in ascending order from 0 to 1.
std::vector<std::array<double, 2>> kept_of_line(const Breaks& breaks, const Vec2& from, const Vec2& to);

/// Returns what remains of a line of the whole view, where it is after the move. A line along an axis continues across
/// the gaps.
std::vector<std::array<Vec2, 2>> remaining_line(const Breaks& breaks, const Vec2& from, const Vec2& to);

/// The position on paper of a point of the world, in a parallel view.
Vec2 position_on_page(const ViewDrawing& drawing, const Vec3& point);

/// A line where a part of the view ends, across its visible ink; where it is after the move.
struct Limit {
  Vec2 from, to;
  bool symmetric;
  std::array<bool, 2> meets{};   ///< by end: whether it is at a line of symmetry
  std::vector<Vec2> freehand{};  ///< the line, if it is a freehand one
};

/// Leaves parts of a parallel view out, exactly, up to straight or freehand lines, moves the others together, and
/// chains the lines anew, without curves. The view must not show a detail. Throws OutOfTime.
void break_drawing(ViewDrawing& drawing, const Breaks& breaks, const Progress& progress = {});

}  // namespace epura::drawing
