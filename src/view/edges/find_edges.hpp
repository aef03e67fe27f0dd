// SPDX-License-Identifier: Apache-2.0
// Finds all edges to draw, as straight segments between vertices of the view.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "edges/edge_kind.hpp"
#include "edges/intersections.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

struct EdgeOptions {
  bool contour = true, boundary = true, crease = true, intersection = true;
  bool wire = true;          ///< lines of the file (see MeshEdge::wire)
  bool tangent = false;      ///< see edges/tangent_edges.hpp
  bool smooth = false;       ///< all other edges of the mesh
  double crease_angle = 30;  ///< least angle between the triangles' normals at a crease of a mesh, degrees
  double weak_angle = 180;   ///< the same where the edge continues a crease; without effect from crease_angle on
  double part_angle = 5;     ///< the same for a border between recognised faces of a part, along all of it
  double thread_depth = 0;   ///< least distance between the lines of crests and roots of threads, units of the world
};

/// A straight segment, to be split into visible and hidden spans.
struct FeatureEdge {
  std::array<int, 2> vertex;  ///< of the view
  std::array<double, 2> t;    ///< 3D parameters of its ends along the original edge (Mesh::origin_of)
  EdgeKind kind;
  int model;
  int mesh_edge;                     ///< number in its model; -1 for a line of an intersection or thread
  int crossing;                      ///< index in FeatureEdges::crossings of such a line; otherwise -1
  std::array<int, 2> shown{-1, -1};  ///< vertices of the view at which its ends are drawn; -1: not moved
  bool by_chance = false;            ///< a contour of facets where their surface has none: drawn as an outline only
  float hollow = 0;  ///< the part of a contour beyond a cusp, where its surface hides it: seen as an outline only; up
                     ///< to 1 from its start if positive, from its end if negative
  float clear = 0;   ///< distance towards the viewer, in units of the file, in which the surface does not hide its
                     ///< contour; 0 where that is not known

  /// Whether it is drawn in another place than its edge of the mesh.
  [[nodiscard]] bool is_moved() const { return shown[0] >= 0 || shown[1] >= 0; }
  /// The vertex of the view at which an end is drawn.
  [[nodiscard]] int drawn_vertex(std::size_t end) const { return shown[end] < 0 ? vertex[end] : shown[end]; }
  /// The parameters of the hollow part.
  [[nodiscard]] std::array<double, 2> hollow_part() const {
    return hollow > 0 ? std::array{0.0, double{hollow}} : std::array{1.0 + double{hollow}, 1.0};
  }
};

/// The triangles of a model that meet in an edge next to slivers: those at the edge and those beyond the slivers.
struct MetAcrossSlivers {
  int model, mesh_edge;
  std::vector<int> triangles;
};

/// A contour of which facets of its own face would hide a part, though their surface does not: facets from whose middle
/// it is less than `clear` back to `from`, along the projector `towards` the viewer, never hide it. In the file's
/// units.
struct ClearContour {
  int model, mesh_edge, face;
  Vec3 from, towards;
  double clear;
};

struct FeatureEdges {
  std::vector<FeatureEdge>
      edges;  ///< in order of model and mesh edge, then the intersection lines, then those of threads
  // In order of model and mesh edge:
  std::vector<MetAcrossSlivers> beside_slivers;
  std::vector<ClearContour> clear_contours;
  std::vector<FaceCrossing> crossings;  ///< intersections; lines of threads, with one triangle twice
  std::vector<FaceCrossing> contacts;   ///< not drawn: facets cross, but their surfaces only touch (contacts.hpp)
  double moved = 0;                     ///< greatest distance between ink and the edges that it shows; view units
  double searched = 1;                  ///< fraction of the search for crossings that was completed
  bool too_many_crossings = false;      ///< whether it ended for their number, not for lack of time
};

/// If time runs out during the search for crossings, those found so far are returned; if it runs out before, OutOfTime
/// is thrown. Vertices created by clipping and by crossings are added to `view`.
FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                Progress progress = {});

/// The same, with intersection lines only between the candidates (crossing_candidates.hpp).
FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                const CrossingCandidates& candidates, Progress progress = {});

/// The same, with the intersections that another view of the world has: which facets cross depends on the world, on
/// `view.map.normalisation` and `view.contact.in_space` alone, and where they only touch, on the angles of a crease and
/// a part.
FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                const std::vector<FaceCrossing>& intersections, Progress progress = {});

/// Returns the intersections among the crossings, which come before those of threads.
std::vector<FaceCrossing> intersections_of(const FeatureEdges& drawn);

}  // namespace epura::edges
