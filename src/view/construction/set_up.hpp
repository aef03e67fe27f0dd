// SPDX-License-Identifier: Apache-2.0
// A projection seen from outside: the picture plane with the image on it, the centre or the direction of the
// projectors, rays through chosen points, the view volume, and the normalised volume beside it. All of it follows from
// the plane and the projectors, so that projections of other authors are shown, too. The names are those of seed
// document 003.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "projection/influence.hpp"
#include "scene/construction_choice.hpp"
#include "view/viewing_model.hpp"

namespace epura::construction {

enum class SetUpPart { image, plane, rays, volume, normalised };

/// The lines of a part in space.
struct SetUpLines {
  SetUpPart part;
  std::vector<std::array<Vec3, 2>> segments{};
};

struct SetUpPoint {
  scene::NamedPoint point;
  std::optional<projection::Quantity> quantity{};  ///< that it shows
};

/// A point and its image on the plane as it is drawn.
struct Ray {
  Vec3 point, image;
};

struct SetUp {
  std::vector<SetUpLines> lines{};
  std::vector<SetUpPoint> points{};
  std::vector<Ray> rays{};
  double plane = 0;             ///< n of the plane as it is drawn; 0: where it is
  std::optional<double> far{};  ///< distance of a centre that is too far away to be drawn, from the middle of the box
  bool has_window = true;       ///< false: it is too large to be drawn
  Mat4 to_image{1.0};           ///< (u, v, 0) of the plane -> its position as it is drawn
  bool is_flat = false;  ///< the models fill too little of the normalised volume to be drawn: the centre is far away
  Mat4 normalised{1.0};  ///< the world -> normalised coordinates, where they are drawn
  Vec3 seen_from{0.0};   ///< direction towards who looks at all of it; length 1
};

struct SetUpInput {
  const projection::Projection& projection;
  const view::ViewingModel& model;
  Box box{};                                     ///< of the models
  std::span<const std::array<Vec2, 2>> image{};  ///< lines of the drawing, in (u, v) of the plane
  std::span<const Vec3> points{};                ///< through which rays run; those behind the viewer have none
  bool keeps_plane = false;                      ///< it is not moved clear of the models
  std::optional<Vec3> seen_from{};               ///< by default from the side
};

/// A plane that cuts the models, or is many times their size away, is moved clear of them: along the projectors, which
/// changes nothing of the image but its size, if they meet in a centre.
SetUp set_up(const SetUpInput& input);

/// Of these points, those that span the image: at most `most` corners of its convex hull, the sharpest ones, in order
/// around it. Points outside the volume are left out.
std::vector<Vec3> outline_points(const projection::Projection& projection, const projection::ViewVolume& volume,
                                 std::span<const Vec3> points, std::size_t most);

}  // namespace epura::construction
