// SPDX-License-Identifier: Apache-2.0
// Circles of round features as a view shows them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "features/centred_features.hpp"

namespace epura::sheet {

/// Up to which part of its radius a circle or its axis looks like a point or a line.
constexpr double edge_on = 1e-4;

/// The image of a circle, in mm on paper.
struct SeenCircle {
  Vec2 centre;
  Vec2 u, v;                    ///< images of two perpendicular radii
  Vec2 axis;                    ///< image of the unit normal
  std::optional<Vec2> spoke{};  ///< of a hole on a pitch circle: from the centre of the pitch circle to the hole
  Vec2 beside{1, 0};            ///< along one line of its cross

  [[nodiscard]] double radius() const;
  [[nodiscard]] bool is_round() const;
  /// Whether its axis is seen as a line.
  [[nodiscard]] bool is_slanted() const;
  /// Whether its axis is parallel to the paper.
  [[nodiscard]] bool is_edge_on() const;
  /// A point in units of the radius, in the plane of the circle.
  [[nodiscard]] Vec2 local(const Vec2& p) const;
  /// Whether a point is on the image of the circle, or of a polygon instead of it.
  [[nodiscard]] bool has(const Vec2& p) const;
  [[nodiscard]] double angle_between(const Vec2& p, const Vec2& q) const;
  /// How far the image reaches from its centre in a direction.
  [[nodiscard]] double reach(const Vec2& direction) const;
};

/// The image of a point (`w` 1) or a vector (0) of the world.
Vec2 image_of(const drawing::ViewDrawing& drawing, const Vec3& p, double w);

SeenCircle see(const drawing::ViewDrawing& drawing, const Vec3& axis, const features::Ring& ring);
std::vector<SeenCircle> see(const drawing::ViewDrawing& drawing, const features::CentredRound& feature);

/// The apex of a cone has a radius of 0 and looks the same from everywhere: the largest circle tells how a feature is
/// seen.
const SeenCircle& largest_of(std::span<const SeenCircle> circles);

}  // namespace epura::sheet
