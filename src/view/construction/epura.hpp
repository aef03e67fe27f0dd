// SPDX-License-Identifier: Apache-2.0
// Constructions of an épura (Monge): plan and elevation about one ground line LT, in first angle. The plan of a point
// A is A₁, its elevation A₂; both lie on one correspondence line perpendicular to LT.
//
// Distances on paper: a point has a position x along LT, a depth in front of the vertical plane, which the plan shows
// below LT, and a height above the horizontal plane, which the elevation shows above LT.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "construction/figure.hpp"
#include "construction/picture_plane.hpp"
#include "construction/request.hpp"

namespace epura::construction {

struct Epura {
  PicturePlane plan, elevation;
  double ground = 0;  ///< y of LT on paper, mm
  Vec2 ends{0, 0};    ///< from which x to which the views are, mm
};

/// The triangles of one flat face of a model.
using FaceTriangles = std::vector<std::array<Vec3, 3>>;

/// What an épura shows of the models.
struct EpuraModels {
  std::vector<Vec3> corners{};         ///< for the request of that name
  std::vector<FaceTriangles> faces{};  ///< for intersections
};

/// Throws Error{input} for more corners than can be named, and for lines and planes that meet no face.
Figure epura_figure(const Epura& epura, std::span<const Request> requests, const EpuraModels& models);

/// A point of an épura, in mm on paper.
struct EpuraPoint {
  Vec2 plan, elevation;
};
EpuraPoint epura_point(const Epura& epura, const Vec3& point);

/// The corners of a flat face turned into the horizontal plane of its lowest corner, about the horizontal line of the
/// face through it; in plan.
struct Rabatment {
  Vec2 hinge;               ///< the lowest corner
  Vec2 along;               ///< direction of the hinge; length 1. Zero: the face is horizontal
  std::vector<Vec2> shape;  ///< the corners in true shape
};
Rabatment rabatment(const Epura& epura, std::span<const Vec3> face);

/// A view on a plane that replaces one of the two before it: on a plane perpendicular to the other.
struct AuxiliaryView {
  std::array<Vec2, 2> ground;  ///< the new ground line, past the points
  std::vector<Vec2> points;    ///< as far behind it as they are from the ground line in the view that is replaced
};

/// The views in which an edge or a flat face is seen in true length or shape, which the last one of them shows: for a
/// face of general position, first edge-on, on a plane perpendicular to its horizontal lines. None if the plan shows
/// it. `clear_of`: plans of points beyond which the first ground line lies.
std::vector<AuxiliaryView> change_of_planes(const Epura& epura, std::span<const Vec3> element,
                                            std::span<const Vec3> clear_of);

}  // namespace epura::construction
