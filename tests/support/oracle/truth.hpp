// SPDX-License-Identifier: Apache-2.0
// The truth about drawn edges, in rational numbers.
//
// Every edge is tested against every triangle that overlaps its box on the page. Corners are mapped to the page from
// the doubles of the model and of the projection without rounding, by (3.10) and (3.20) of seed 003 with a depth that
// keeps planes flat, and the part of the edge that a triangle hides is a rational interval. It shares nothing with the
// methods under test except the list of edges and the unit of the page: triangles that a view has lost are detected.
//
// There are two answers: the spans that remain hidden if the triangles shrink by 1e-9 of the drawing and move away from
// the viewer by twice the contact tolerance, and the spans that may be hidden if they grow and move towards the viewer
// by the same amounts. Between the two, the input leaves the answer open. A side shared by two triangles, one on either
// side of it, is not a border and does not shrink.
#pragma once

#include <array>
#include <vector>

#include "verify/verify_input.hpp"
#include "visibility/spans.hpp"

namespace epura {

struct EdgeTruth {
  int edge;                   ///< number among the drawn edges
  visibility::Spans surely;   ///< certainly hidden
  visibility::Spans perhaps;  ///< hidden, or left open; contains `surely`
};

/// Which edges are tested: the first ones in a random order (with a fixed seed), until so many pairs of edge and
/// triangle have been examined exactly.
struct TruthEffort {
  double pairs = 2e5;
};

/// In the order of the edges.
std::vector<EdgeTruth> find_truth(const verify::VerifyInput& input, const view::ProjectedScene& view,
                                  const TruthEffort& effort);

/// A triangle and a point of an edge, exactly, from their positions on the page.
struct PointTruth {
  double inside;     ///< distance of the point from the nearest side; negative outside
  double ahead;      ///< distance of the triangle's plane in front of it
  double steepness;  ///< of that plane, 1 if perpendicular to the line of sight
};

/// For the point at page parameter `s` of the edge.
PointTruth truth_of_point(const std::array<view::PageVertex, 3>& triangle, const std::array<view::PageVertex, 2>& edge,
                          double s);

/// The correct classification closest to the one shown: where the truth is left open, the one shown.
visibility::Spans nearest_right(const visibility::Spans& shown, const EdgeTruth& truth);

}  // namespace epura
