// SPDX-License-Identifier: Apache-2.0
// All edges to draw, as straight pieces between vertices of the view.
#pragma once

#include <array>
#include <vector>

#include "edges/edge_kind.hpp"
#include "edges/intersections.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

struct EdgeOptions {
  bool contour = true, boundary = true, crease = true, intersection = true;
  bool wire = true;          ///< lines of the file that bound no face
  bool tangent = false;      ///< see edges/tangent_edges.hpp
  bool smooth = false;       ///< all other edges of the mesh
  double crease_angle = 30;  ///< degrees between the triangles' normals from which an edge of a mesh is a crease
  double part_angle = 5;     ///< the same all along a border between faces of a part that are recognised
};

/// A straight piece to be split into visible and hidden spans.
struct FeatureEdge {
  std::array<int, 2> vertex;  ///< of the view
  std::array<double, 2> t;    ///< 3D parameters of the ends along the edge it comes from (Mesh::origin_of)
  EdgeKind kind;
  int model;
  int mesh_edge;                     ///< in its model; -1 for an intersection line
  int crossing;                      ///< of an intersection line, in FeatureEdges::crossings; otherwise -1
  std::array<int, 2> shown{-1, -1};  ///< vertices of the view where its ends are drawn; -1: where they are
};

/// The triangles of a model that meet in an edge next to slivers: those at the edge and those beyond the slivers.
struct MetAcrossSlivers {
  int model, mesh_edge;
  std::vector<int> triangles;
};

struct FeatureEdges {
  std::vector<FeatureEdge> edges;                ///< in order of model and mesh edge, then the intersection lines
  std::vector<MetAcrossSlivers> beside_slivers;  ///< of edges that have slivers, in order of model and mesh edge
  std::vector<FaceCrossing> crossings;
  double moved = 0;     ///< how far at most ink lies from the edges that it shows; view units
  double searched = 1;  ///< part of the search for crossings that was done before time was over
};

/// Without time for all crossings those that were found are there; without time for the edges of the meshes, OutOfTime
/// is thrown. `view` gets the vertices that clipping and crossings make.
FeatureEdges find_feature_edges(const scene::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                Progress progress = {});

/// The same, with intersection lines only between triangles in `candidates` (crossing_candidates.hpp).
FeatureEdges find_feature_edges(const scene::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                const std::vector<int>& candidates, Progress progress = {});

}  // namespace epura::edges
