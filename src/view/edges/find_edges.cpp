// SPDX-License-Identifier: Apache-2.0
#include "edges/find_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "edges/contacts.hpp"
#include "edges/crossing_candidates.hpp"
#include "edges/dihedral.hpp"
#include "edges/feature_edges.hpp"
#include "edges/limits.hpp"
#include "edges/slivers.hpp"
#include "edges/smooth_contours.hpp"
#include "edges/thread_lines.hpp"
#include "refine/facing.hpp"

namespace epura::edges {

namespace {

// The triangles that meet in the edge, including slivers next to it; empty if no slivers are there.
std::vector<int> met_across_slivers(const EdgeSurroundings& around, const Slivers& slivers,
                                    const mesh::MeshEdge& edge) {
  const auto triangles = around.world.models[around.model].mesh->triangles_of(edge);
  if (std::none_of(triangles.begin(), triangles.end(), [&](int t) { return slivers.contain(t); })) return {};
  const int first = around.world.first_vertex[around.model];
  const std::array<int, 2> ends{first + edge.vertex[0], first + edge.vertex[1]};
  std::vector<int> met;
  for (const int t : triangles)
    if (const auto beyond = slivers.across(ends, t, &met).triangle) met.push_back(*beyond);
  return met;
}

void add_mesh_edges(const EdgeSurroundings& around, view::ProjectedScene& view, const EdgeOptions& options,
                    FeatureEdges& drawn, const Progress& progress) {
  const world::World& world = around.world;
  const int model = around.model;
  const mesh::Mesh* uncut = world.models[model].mesh->uncut.get();
  const std::vector<signed char> facing = refine::facing_by_surface(world.models[model], view.projection);
  const EdgeSurroundings whole{world, model, around.normalisation, uncut, facing};
  const Slivers of_whole(whole, view, progress);
  const std::vector<std::optional<EdgeKind>> kinds = feature_edges(view, options, whole, of_whole, progress);
  // Edges are judged by the uncut faces, but the triangles that meet in them are the pieces that a cut left; and beside
  // a contour, low triangles lead to others, though their surface tells how they turn.
  const Slivers of_pieces(around, SliverRule(around, view));
  const Slivers& slivers = uncut == nullptr && facing.empty() ? of_whole : of_pieces;
  const auto& edges = world.models[model].mesh->edges;
  const int first = world.first_vertex[model];
  check(kinds.size() == edges.size(), "every edge of a mesh is judged");
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!kinds[e]) continue;
    // A part of an edge of the file runs as that does.
    mesh::EdgeOrigin origin = world.models[model].mesh->origin_of(edges[e]);
    std::array<int, 2> ends = edges[e].vertex;
    if (origin.t[0] > origin.t[1]) {
      std::swap(origin.t[0], origin.t[1]);
      std::swap(ends[0], ends[1]);
    }
    const auto part = view::clip_edge(view, first + ends[0], first + ends[1]);
    if (!part) continue;
    const std::array<double, 2>& from_to = origin.t;
    const auto in_file = [&](double t) { return t == 0 ? from_to[0] : from_to[0] + t * (from_to[1] - from_to[0]); };
    drawn.edges.push_back(
        {part->vertex, {in_file(part->t[0]), in_file(part->t[1])}, *kinds[e], model, static_cast<int>(e), -1});
    std::vector<int> met = met_across_slivers(around, slivers, edges[e]);
    if (!met.empty()) drawn.beside_slivers.push_back({model, static_cast<int>(e), std::move(met)});
  }
}

// Crossings that could not be judged in time count as not searched.
void drop_contacts(const world::World& world, double normalisation, const ContactLimits& limits, FeatureEdges& drawn,
                   const Progress& progress) {
  const std::vector<Contact> contacts = judge_contacts(world, normalisation, limits, drawn.crossings, progress);
  check(contacts.size() == drawn.crossings.size(), "every crossing is judged");
  const auto unjudged = std::count(contacts.begin(), contacts.end(), Contact::unjudged);
  if (unjudged > 0) drawn.searched *= 1 - static_cast<double>(unjudged) / static_cast<double>(contacts.size());
  std::vector<FaceCrossing> real;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i] == Contact::none) real.push_back(drawn.crossings[i]);
    if (contacts[i] == Contact::contact) drawn.contacts.push_back(drawn.crossings[i]);
  }
  drawn.crossings = std::move(real);
}

void add_intersections(const world::World& world, view::ProjectedScene& view, FeatureEdges& drawn) {
  for (std::size_t i = 0; i < drawn.crossings.size(); ++i) {
    const FaceCrossing& crossing = drawn.crossings[i];
    const int a = view::add_point(view, crossing.ends[0]);
    const int b = view::add_point(view, crossing.ends[1]);
    if (const auto part = view::clip_edge(view, a, b))
      drawn.edges.push_back({part->vertex, part->t, EdgeKind::intersection,
                             world.model_of_triangle(crossing.triangles[0]), -1, static_cast<int>(i)});
  }
}

FeatureEdges edges_of_meshes(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                             Progress& progress) {
  std::size_t edges = 0;
  for (const world::Placed& model : world.models) edges += model.mesh->edges.size();
  progress.begin("finding edges", edges);
  FeatureEdges drawn;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model)
    add_mesh_edges({world, model, view.map.normalisation}, view, options, drawn, progress);
  smooth_contours(world, view, options, drawn);
  return drawn;
}

void check_sound(const FeatureEdges& drawn, const view::ProjectedScene& view) {
  const auto vertices = static_cast<int>(view.vertices.size()), crossings = static_cast<int>(drawn.crossings.size());
  const auto is_vertex = [&](int v) { return v >= 0 && v < vertices; };
  const auto is_part = [](double t) { return t >= -rounding_part && t <= 1 + rounding_part; };
  int model = 0;
  for (const FeatureEdge& edge : drawn.edges) {
    check(is_vertex(edge.vertex[0]) && is_vertex(edge.vertex[1]), "an edge ends at vertices of the view");
    check(edge.shown[0] < vertices && edge.shown[1] < vertices, "an edge is shown at vertices of the view");
    check(is_part(edge.t[0]) && is_part(edge.t[1]), "the parameters of an edge are from 0 to 1");
    check(edge.t[0] <= edge.t[1], "a part of an edge runs as the edge does");
    check(edge.mesh_edge >= 0 ? edge.crossing == -1 : edge.crossing >= 0 && edge.crossing < crossings,
          "an edge belongs to a mesh or to a crossing");
    check(edge.model >= model || edge.crossing >= 0, "edges are in the order of their models");
    if (edge.crossing < 0) model = edge.model;
  }
  check(is_part(drawn.searched), "the searched part of the crossings is from 0 to 1");
  check(drawn.moved >= 0, "a distance is not negative");
}

void add_lines_in_faces(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                        FeatureEdges& drawn) {
  add_intersections(world, view, drawn);
  add_thread_lines(world, view, options.thread_depth, drawn);
  check_sound(drawn, view);
}

}  // namespace

FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                Progress progress) {
  return find_feature_edges(world, view, options, all_triangles(world), progress);
}

FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                const CrossingCandidates& candidates, Progress progress) {
  FeatureEdges drawn = edges_of_meshes(world, view, options, progress);
  if (options.intersection) {
    const double normalisation = view.map.normalisation;
    FaceCrossings crossings = find_intersections(world, normalisation, view.contact.in_space, candidates,
                                                 progress.with_part_of_the_time(part_for_search));
    drawn.crossings = std::move(crossings.found);
    drawn.searched = crossings.searched;
    drawn.too_many_crossings = crossings.too_many;
    drop_contacts(world, normalisation, {options.crease_angle, options.part_angle}, drawn,
                  progress.with_part_of_the_time(part_for_search));
  }
  add_lines_in_faces(world, view, options, drawn);
  return drawn;
}

FeatureEdges find_feature_edges(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                                const std::vector<FaceCrossing>& intersections, Progress progress) {
  FeatureEdges drawn = edges_of_meshes(world, view, options, progress);
  if (options.intersection) drawn.crossings = intersections;
  add_lines_in_faces(world, view, options, drawn);
  return drawn;
}

std::vector<FaceCrossing> intersections_of(const FeatureEdges& drawn) {
  const auto is_of_thread = [](const FaceCrossing& crossing) { return crossing.triangles[0] == crossing.triangles[1]; };
  return {drawn.crossings.begin(), std::find_if(drawn.crossings.begin(), drawn.crossings.end(), is_of_thread)};
}

}  // namespace epura::edges
