// SPDX-License-Identifier: Apache-2.0
// One view as plain 2D ink, in millimetres on paper, y up, without styles.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "drawing/boundary.hpp"
#include "drawing/breaks.hpp"
#include "drawing/curve_part.hpp"
#include "edges/edge_kind.hpp"
#include "projection/projection.hpp"

namespace epura::construction {
struct Figure;
}

namespace epura::drawing {

/// A straight piece of ink and its origin. Coincident pieces are resolved, touching ones of one edge merged. If both
/// parameters are equal, it is a link: a line ends there, and the link leads to the line that is drawn instead of what
/// lay at that end (drawing/near_ink.hpp).
struct Segment {
  Vec2 from, to;
  bool visible;
  EdgeKind kind;
  int model;                ///< of the world that the view shows
  std::array<int, 2> edge;  ///< vertex numbers in the file; {-1, -1} for a line that is not an edge of a file
  int crossing;             ///< for such a line: its index in ViewDrawing::crossings; otherwise -1
  std::array<double, 2> t;  ///< 3D parameters along the edge, `from` at t[0]
  int body = -1;            ///< of its model; -1 if the file does not name bodies
};

constexpr bool is_link(const Segment& segment) { return segment.t[0] == segment.t[1]; }

/// Where a line comes from that is not an edge of a file, in addition to its segment.
struct CrossingSegment {
  /// (model in the scene, face) of both faces that cross; for a cut, those of the face that is cut (-1 if it is left
  /// out), and {-1, -1} for the cutting plane.
  std::array<std::array<int, 2>, 2> faces;
  std::array<Vec3, 2> world;  ///< ends in world coordinates
};

/// Segments with the same appearance, model and named body, chained end to end.
struct Chain {
  std::vector<Vec2> points;  ///< the closing point of a closed chain is not repeated
  bool closed;
  bool visible;
  EdgeKind kind;                    ///< the first of those of its segments, which look the same
  std::vector<int> segments;        ///< indices into ViewDrawing::segments, in order along the chain
  std::vector<CurvePart> curves{};  ///< ascending and disjoint
};

/// A face made by a cutting plane, to be hatched.
struct CutFace {
  int model, body;                       ///< in the scene; body numbers are those of the model's file
  std::vector<std::vector<Vec2>> rings;  ///< outlines on paper, even-odd; the first point is not repeated
};

/// What a detail view shows. ISO 128-3.
struct DetailFrame {
  std::string name;    ///< "X"
  std::string parent;  ///< name of the view that it enlarges
  Boundary boundary;   ///< in the detail view
};

/// A broken-out section: inside a closed line, the view shows the models cut. ISO 128-3.
struct BrokenOut {
  std::vector<Vec2> ring;                ///< the closed line; before breaks.moved
  std::vector<std::vector<Vec2>> lines;  ///< what is drawn of it: where something is removed
};

/// A revolved section on a view: the outlines of a cut face turned into the picture. ISO 128-3.
struct RevolvedFace {
  std::vector<std::vector<Vec2>> rings;
  std::array<Vec2, 2> axis;  ///< the part inside the outlines of the line about which it is turned
};

/// Triangles on paper.
using PaperTriangle = std::array<Vec2, 3>;

/// What cutting planes show.
struct CutAreas {
  std::vector<CutFace> faces;
  std::vector<PaperTriangle> before;   ///< parts of bodies that the cutting plane leaves whole, in front of it
  std::vector<BrokenOut> broken_out;   ///< areas that do not overlap
  std::vector<RevolvedFace> revolved;  ///< where they are after the move; `faces` has them, too
  std::vector<int> numbers_in_scene;   ///< of the models of segments, if they differ (World::number_in_scene)
};

/// Which part of the view is shown.
struct ShownPart {
  std::optional<DetailFrame> detail;  ///< only of a detail view
  Breaks breaks;                      ///< parts left out; all else is where it is after the move
  std::vector<Limit> limits;          ///< where parts are left out
};

/// Lines and points that explain the view, beside those of the models.
struct DrawingAids {
  std::array<std::optional<Vec2>, 3> vanishing_points;       ///< of the world axes, on the page
  std::vector<std::array<Vec2, 2>> traces;                   ///< of bodies moved apart: visible lines from their places
  std::shared_ptr<const construction::Figure> construction;  ///< of the projection; in the elevation, that of an
                                                             ///< épura; null: none
};

/// By how much lines were moved, and within which distances they are one, mm.
struct LineDistances {
  double contours_moved = 0;  ///< greatest distance at which contours of curved faces are drawn from edges of the mesh
  double outlines_moved = 0;  ///< the same of outlines of cut faces, from where the plane cuts the mesh
  double coincident = 0;      ///< lines this close coincide, and their ends meet
  double unseen = 0;          ///< ends this close are drawn as one line, since nobody sees the gap
  double joined_within = 0;   ///< omitted lines have ink of at least the same strength within this distance
};

struct ViewDrawing {
  std::string name;  ///< of the view
  projection::Projection projection;
  double scale = 1;    ///< mm of paper per unit of the world, in the projection plane
  Mat4 world_to_page;  ///< page = (row0/row3, row1/row3) in mm, before breaks.moved; row2/row3 grows towards
                       ///< the viewer
  std::vector<Segment> segments;
  std::vector<CrossingSegment> crossings;  ///< for the segments that are not edges of a file, in their order
  std::vector<Chain> chains;
  projection::Window box{{0, 0}, {0, 0}};  ///< of the ink
  CutAreas cuts{};
  ShownPart shown{};
  DrawingAids aids{};
  LineDistances distances{};

  [[nodiscard]] int number_in_scene(int model) const {
    return cuts.numbers_in_scene.empty() ? model : cuts.numbers_in_scene[static_cast<std::size_t>(model)];
  }
};

}  // namespace epura::drawing
