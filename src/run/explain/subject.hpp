// SPDX-License-Identifier: Apache-2.0
// The view that questions refer to, and the subject of a question: an edge of a model or an intersection line, drawn or
// not.
//
// Names, as in SVG and JSON, with numbers from 0: an edge is MODEL:VERTEX-VERTEX, a face (and the line along which a
// plane cuts it) MODEL:FACE, and the intersection line of two faces MODEL:FACExMODEL:FACE.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/find_edges.hpp"
#include "explain/edge_question.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"
#include "world/world.hpp"

namespace epura::explain {

/// One view with everything that was computed for its drawing.
struct ExplainInput : visibility::ResolvedView {
  const edges::EdgeOptions& options;
  const view::PaperMap& paper;
  const drawing::ViewDrawing& drawing;
  bool keep_hidden;  ///< whether hidden lines are drawn, too
};

struct Subject {
  int model;
  int mesh_edge;                 ///< number in its model; -1 for an intersection line
  int drawn;                     ///< index in FeatureEdges::edges; -1 if no part of it is drawn
  std::optional<double> away{};  ///< distance on the sheet from the place that was asked about, mm
};

/// Returns the face to which a triangle of the world belongs.
FaceName face_of(const world::World& world, int triangle);

/// Returns the faces of the file that meet in an edge, without duplicates, or that cross in an intersection line.
std::vector<FaceName> faces_at(const ExplainInput& drawn_view, const Subject& subject);

std::string name_of(const FaceName& face);
std::string name_of(const ExplainInput& drawn_view, const Subject& subject);
/// A list in words: "face 0:1" or "faces 0:1, 0:2 and 0:3".
std::string names_of(const std::vector<FaceName>& faces);

/// Returns what a face belongs to: "part.step", or "'bolt' in part.step" if the bodies of the file have names.
std::string owner_of(const world::World& world, const FaceName& face);
/// The same of an edge: of its first face, or of the model if it bounds no face.
std::string owner_of(const ExplainInput& drawn_view, const Subject& subject);

/// Returns the ends in world coordinates.
std::array<Vec3, 2> ends_of(const ExplainInput& drawn_view, const Subject& subject);

/// Returns the e-th drawn edge as a subject.
Subject drawn_subject(const ExplainInput& drawn_view, std::size_t e);

/// A part of a drawn edge, as page parameters.
struct Span {
  double from, to;
  bool visible;
};

/// Returns all spans of the e-th drawn edge, in order.
std::vector<Span> spans_of(const visibility::HiddenSpans& hidden, std::size_t e);

}  // namespace epura::explain
