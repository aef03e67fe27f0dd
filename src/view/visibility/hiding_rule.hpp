// SPDX-License-Identifier: Apache-2.0
// The definition of "hidden": which part of an edge one triangle hides.
//
// Planar decisions are signs of integers on the page lattice. A vertex exactly on the line of an edge counts as left of
// it, for every triangle: the line is moved right by an infinitesimal amount (simulation of simplicity in one
// dimension, after Edelsbrunner & Muecke, ACM TOG 1990). So triangles around a vertex or along an edge agree. A
// crossing is computed for the pair of edges, from their vertices in ascending order, so it is the same for any
// triangle: the intervals of neighbouring triangles abut to the last bit.
#pragma once

#include <array>
#include <optional>

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// Returns the gradient of depth over the page, or nothing if the triangle is a line there.
std::optional<Vec2> slope_of(const view::ProjectedScene& view, const view::ViewTriangle& triangle);

/// Returns the change of depth along `way` in the plane of a triangle that has a slope. It is computed along its
/// longest side and across it, since the slope of a needle is uncertain only across.
double rise_along(const view::ProjectedScene& view, const view::ViewTriangle& triangle, const Vec2& way);

/// Contact is measured along the normal of a triangle, hiding along the view. This is the factor between them.
double steepness_of(const view::ProjectedScene& view, const view::ViewTriangle& triangle);

/// An edge on the page, between two vertices of the view.
struct PageEdge {
  int p, q;  ///< vertices of the view
};

/// Returns min_piece (limits.hpp) as a fraction of the edge's length on the page.
double min_span(const view::ProjectedScene& view, const PageEdge& edge);

/// Where an edge crosses a side of a triangle.
struct SideCrossing {
  double t;  ///< page parameter of the edge
  double s;  ///< page parameter of the side
  int u, v;  ///< ends of the side
};

/// The interval in which an edge overlaps a triangle on the page, as page parameters of the edge, and the sides at
/// which it enters and leaves.
struct Overlap {
  double from, to;
  SideCrossing in, out;

  /// Returns the depth of the triangle where the edge is at t; `depth_of(vertex)` is the depth of a corner.
  template <class DepthOf>
  [[nodiscard]] double depth(double t, const DepthOf& depth_of) const {
    const auto on_side = [&](const SideCrossing& side) {
      return depth_of(side.u) + side.s * (depth_of(side.v) - depth_of(side.u));
    };
    const double at_in = on_side(in), at_out = on_side(out);
    return at_in + (at_out - at_in) * ((t - in.t) / (out.t - in.t));
  }
};

/// Whether the edge and the triangle overlap on the page, as the page grid decides.
bool meets_on_grid(const view::ProjectedScene& view, const PageEdge& edge, const view::ViewTriangle& triangle);

/// Returns nothing if they do not overlap.
std::optional<Overlap> overlap_of(const view::ProjectedScene& view, const PageEdge& edge,
                                  const view::ViewTriangle& triangle);

/// Returns the page parameters (0 at p, 1 at q) of the part that the triangle hides: where it covers the edge on the
/// page and lies in front of it by more than contact. The triangle must not be one of the edge's own.
std::optional<std::array<double, 2>> hidden_part(const view::ProjectedScene& view, const PageEdge& edge,
                                                 const view::ViewTriangle& triangle);

}  // namespace epura::visibility
