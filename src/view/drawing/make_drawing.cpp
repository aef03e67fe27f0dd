// SPDX-License-Identifier: Apache-2.0
#include "drawing/make_drawing.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/chains.hpp"
#include "drawing/continue_lines.hpp"
#include "drawing/dangles.hpp"
#include "drawing/edge_on.hpp"
#include "drawing/forwards.hpp"
#include "drawing/ink.hpp"
#include "drawing/ink_distance.hpp"
#include "drawing/limits.hpp"
#include "drawing/moved_contours.hpp"
#include "drawing/near_ink.hpp"
#include "drawing/settled_pieces.hpp"
#include "visibility/limits.hpp"

namespace epura::drawing {

namespace {

// Whether an edge ends at a vertex that refinement put inside a face of the part or on its border.
bool ends_at_new_vertex(const visibility::ResolvedView& lines, const edges::FeatureEdge& edge, std::size_t end) {
  const mesh::Mesh& mesh = *lines.world.models[edge.model].mesh;
  const int vertex = edge.vertex[end] - lines.world.first_vertex[edge.model];
  return edge.mesh_edge >= 0 && !mesh.cut_vertices.empty() && vertex >= mesh.first_cut_vertex &&
         vertex < static_cast<int>(mesh.points.size());
}

// Contours of cylinders and cones run straight on from facet to facet: their parts rank as the line does.
void measure_straight_lines(std::vector<Piece>& pieces, const visibility::ResolvedView& lines, double tolerance) {
  struct NewEnd {
    int vertex, piece, end;
  };
  std::vector<NewEnd> ends;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const std::size_t end : {0, 1}) {
      const edges::FeatureEdge& edge = lines.drawn.edges[pieces[i].edge];
      if (edge.kind == EdgeKind::contour && pieces[i].s[end] == static_cast<double>(end) &&
          ends_at_new_vertex(lines, edge, end) && length_of(pieces[i]) > tolerance)
        ends.push_back({edge.vertex[end], static_cast<int>(i), static_cast<int>(end)});
    }
  if (ends.empty()) return;
  std::ranges::sort(ends, {}, [](const NewEnd& e) { return std::tuple(e.vertex, e.piece, e.end); });
  const auto along = [&](const NewEnd& e) {
    const Piece& piece = pieces[static_cast<std::size_t>(e.piece)];
    return e.end == 0 ? piece.to - piece.from : piece.from - piece.to;
  };
  DisjointSets joined(pieces.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size() && ends[j].vertex == ends[i].vertex; ++j) {
      const Vec2 one = along(ends[i]), other = along(ends[j]);
      const double off = std::abs(cross(one, other)) / std::max(glm::length(one), glm::length(other));
      if (glm::dot(one, other) < 0 && off <= tolerance) joined.join(ends[i].piece, ends[j].piece);
    }
  const std::vector<int> line = std::move(joined).roots();
  std::vector<double> lengths(pieces.size(), 0);
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[static_cast<std::size_t>(line[i])] += length_of(pieces[i]);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    pieces[i].line = lengths[static_cast<std::size_t>(line[i])];
    check(pieces[i].line >= length_of(pieces[i]), "a line is as long as its parts");
  }
}

// Returns the edge of a file that a line shows; nothing for intersection lines and cuts through faces.
std::optional<std::array<int, 2>> edge_in_file(const world::World& world, const edges::FeatureEdge& edge) {
  if (edge.mesh_edge < 0) return std::nullopt;
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[edge.mesh_edge]);
  return origin.in_file ? std::optional(origin.vertex) : std::nullopt;
}

// Where an end of a drawn line would be on an edge of the file, as a part of which it was drawn or made; nothing for
// other lines.
std::optional<Vec3> place_in_file(const world::World& world, const edges::FeatureEdge& edge, std::size_t end) {
  if (edge.mesh_edge < 0) return std::nullopt;
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[edge.mesh_edge]);
  const int first = world.first_vertex[edge.model], vertex = edge.vertex[end] - first;
  mesh::CutVertex on{origin.vertex, edge.t[end]};
  if (!origin.in_file) {
    if (edge.kind != EdgeKind::contour || vertex < mesh.first_cut_vertex || vertex >= std::ssize(mesh.points))
      return std::nullopt;
    on = mesh.cut_vertices[vertex - mesh.first_cut_vertex];
    if (on.edge[0] < 0) return std::nullopt;
  }
  const Vec3 a = world.points[first + on.edge[0]], b = world.points[first + on.edge[1]];
  return a + on.t * (b - a);
}

// The greatest distance at which parts of edges of the file end beside them, on the surfaces that meet there; mm.
double moved_by_refinement(const visibility::ResolvedView& lines, const view::PaperMap& paper) {
  const Mat4 to_page = view::world_to_page(lines.view, paper);
  double largest = 0;
  for (const edges::FeatureEdge& edge : lines.drawn.edges) {
    if (edge.mesh_edge < 0 || lines.world.models[edge.model].mesh->cut_vertices.empty()) continue;
    for (const std::size_t end : {0, 1}) {
      const std::optional<Vec3> in_file = place_in_file(lines.world, edge, end);
      const Vec4 place = in_file ? to_page * Vec4(*in_file, 1) : Vec4(0);
      if (place.w > 0)
        largest = std::max(largest, glm::distance(Vec2(place) / place.w, paper(lines.view.vertices[edge.vertex[end]])));
    }
  }
  return largest > coincidence_on_paper(lines.view, paper).tolerance ? largest : 0;
}

// Returns the named body of its model that a line belongs to; -1 if it is none.
int body_of(const world::World& world, const edges::FeatureEdges& drawn, const edges::FeatureEdge& edge) {
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  if (mesh.report.body_names.empty()) return -1;
  if (edge.mesh_edge < 0)
    return mesh.body[drawn.crossings[edge.crossing].triangles[0] - world.first_triangle[edge.model]];
  const std::span<const int> triangles = mesh.triangles_of(mesh.edges[edge.mesh_edge]);
  return triangles.empty() ? -1 : mesh.body[triangles.front()];
}

// `crossing` is its number among the lines that are not edges of a file, if it is one of these.
Segment segment_of(const visibility::ResolvedView& lines, const Piece& piece, int crossing) {
  const edges::FeatureEdge& edge = lines.drawn.edges[piece.edge];
  const auto in_file = edge_in_file(lines.world, edge);
  return {piece.from,
          piece.to,
          piece.visible,
          piece.kind,
          edge.model,
          in_file.value_or(std::array{-1, -1}),
          in_file ? -1 : crossing,
          {parameter_in_space(lines.view, edge, piece.s[0]), parameter_in_space(lines.view, edge, piece.s[1])},
          body_of(lines.world, lines.drawn, edge)};
}

CrossingSegment cut_segment(const world::World& world, const edges::FeatureEdge& edge, const std::array<double, 2>& t) {
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  const mesh::MeshEdge& cut = mesh.edges[edge.mesh_edge];
  const int first = world.first_vertex[edge.model];
  const Vec3& p = world.points[first + cut.vertex[0]];
  const Vec3& q = world.points[first + cut.vertex[1]];
  // The triangles of the cut face come last. They need not have all vertices of its outline.
  const std::span<const int> triangles = mesh.triangles_of(cut);
  const int face = triangles.empty() ? -1 : mesh.polygon[triangles.front()];
  return {{{{world.number_in_scene(edge.model), face}, {-1, -1}}}, {p + t[0] * (q - p), p + t[1] * (q - p)}};
}

CrossingSegment crossing_segment(const world::World& world, const edges::FaceCrossing& crossing,
                                 const std::array<double, 2>& t) {
  CrossingSegment segment;
  for (int i = 0; i < 2; ++i) {
    const int model = world.model_of_triangle(crossing.triangles[i]);
    const mesh::Mesh& mesh = *world.models[model].mesh;
    segment.faces[i] = {world.number_in_scene(model),
                        mesh.polygon[crossing.triangles[i] - world.first_triangle[model]]};
    segment.world[i] = crossing.ends[0] + t[i] * (crossing.ends[1] - crossing.ends[0]);
  }
  return segment;
}

// Empty if the models have the same numbers as in the scene.
std::vector<int> numbers_in_scene(const world::World& world) {
  std::vector<int> numbers;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model)
    numbers.push_back(world.number_in_scene(model));
  const bool is_scene = std::all_of(world.models.begin(), world.models.end(),
                                    [](const world::Placed& placed) { return placed.copy_of < 0; });
  return is_scene ? std::vector<int>() : numbers;
}

void add_segments(const visibility::ResolvedView& lines, const std::vector<Piece>& pieces, ViewDrawing& drawing,
                  const Progress& progress) {
  const world::World& world = lines.world;
  const edges::FeatureEdges& drawn = lines.drawn;
  std::vector<int> crossing(pieces.size());  // number of crossings before each piece
  int crossings = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    crossing[i] = crossings;
    crossings += edge_in_file(world, drawn.edges[pieces[i].edge]) ? 0 : 1;
  }
  drawing.segments.resize(pieces.size());
  drawing.crossings.resize(static_cast<std::size_t>(crossings));
  parallel_for(pieces.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Segment& segment = drawing.segments[i];
      segment = segment_of(lines, pieces[i], crossing[i]);
      check(std::min(segment.t[0], segment.t[1]) >= -rounding_part &&
                std::max(segment.t[0], segment.t[1]) <= 1 + rounding_part,
            "the parameters of a line are from 0 to 1");
      if (segment.crossing < 0) continue;
      const edges::FeatureEdge& edge = drawn.edges[pieces[i].edge];
      drawing.crossings[segment.crossing] = edge.crossing < 0
                                                ? cut_segment(world, edge, segment.t)
                                                : crossing_segment(world, drawn.crossings[edge.crossing], segment.t);
    }
  });
}

int strength_of(const Piece& piece, const visibility::ResolvedView& lines, const NearLines& near) {
  const edges::FeatureEdge& edge = lines.drawn.edges[piece.edge];
  return near.strength(edge.model, body_of(lines.world, lines.drawn, edge), piece.kind, piece.visible);
}

// Whether each piece has ink, and which ones are steps between the rims of a face.
std::vector<Piece> with_looks(std::vector<Piece> pieces, const visibility::ResolvedView& lines, const NearLines& near) {
  const FacesEdgeOn edge_on(lines);
  for (Piece& piece : pieces) {
    piece.is_step = edge_on.has_step(lines.drawn.edges[piece.edge]);
    if (near.strength) piece.drawn = strength_of(piece, lines, near) >= 0;
  }
  return pieces;
}

// Whether each piece is drawn in another place than its edge of the mesh.
std::vector<char> are_moved(const std::vector<Piece>& pieces, const visibility::ResolvedView& lines) {
  std::vector<char> moved;
  moved.reserve(pieces.size());
  for (const Piece& piece : pieces) moved.push_back(lines.drawn.edges[piece.edge].is_moved() ? 1 : 0);
  return moved;
}

// Of lines that look the same, outlines of cut faces are the first, and steps the last to be drawn.
signed char rank_of(const Piece& piece, const visibility::ResolvedView& lines, const NearLines& near) {
  Piece contour = piece;
  contour.kind = EdgeKind::contour;
  const bool cut = piece.kind == EdgeKind::section;
  const int own = strength_of(piece, lines, near);
  if (own < 0) return -1;
  const int strength = cut ? std::max(own, strength_of(contour, lines, near)) : own;
  return static_cast<signed char>(3 * strength + (cut ? 2 : piece.is_step ? 0 : 1));
}

std::vector<signed char> ranks_of(const std::vector<Piece>& pieces, const visibility::ResolvedView& lines,
                                  const NearLines& near) {
  std::vector<signed char> ranks;
  ranks.reserve(pieces.size());
  for (const Piece& piece : pieces) ranks.push_back(rank_of(piece, lines, near));
  return ranks;
}

double length_of_all(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) length += length_of(piece);
  return length;
}

// Draws one line where a person sees one. The distance is 0 if no ink is left out or added, but for what closes gaps
// that rounding leaves.
LeftInk join_where_near(std::vector<Piece> pieces, const visibility::ResolvedView& lines, const NearLines& near,
                        const Coincidence& limits, const Progress& progress) {
  if (!(near.distance > 0)) return {std::move(pieces)};
  const std::vector<signed char> ranks = ranks_of(pieces, lines, near);
  const double before = length_of_all(pieces);
  pieces = join_near(std::move(pieces), ranks, near.distance, limits.min, progress);
  double within = std::abs(length_of_all(pieces) - before) > 0 ? near.reach() : 0;
  std::vector<int> models;
  models.reserve(pieces.size());
  for (const Piece& piece : pieces) models.push_back(lines.drawn.edges[piece.edge].model);
  // Ink that replaces other ink may be replaced in its turn: distances add up.
  const auto take = [&](LeftInk left) {
    pieces = std::move(left.pieces);
    if (left.within > limits.tolerance) within += left.within;
  };
  take(continue_lines(std::move(pieces), models, {near.distance, limits.tolerance}, progress));
  const std::vector<signed char> left = ranks_of(pieces, lines, near);
  take(drop_dangles(std::move(pieces), left, {near.distance, limits.tolerance}, progress));
  return {std::move(pieces), within};
}

// Where a contour is moved, it may change between visible and hidden that much too early or too late, unless a person
// would see it.
double longest_spurious_change(double near, double moved) {
  return std::max(unseen_up_to * near, std::min(seen_from * near, moved));
}

// All pieces with ink, before any of them is left out beside another.
std::vector<Piece> unmerged_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                   const DrawingOptions& options, const Progress& progress) {
  const bool keep_hidden = options.hidden || !options.leave_out;
  const double moved = lines.drawn.moved * paper.scale;
  std::vector<Piece> pieces = settled_pieces(lines, paper, options, progress).pieces;
  if (!keep_hidden) std::erase_if(pieces, [](const Piece& piece) { return !piece.visible; });
  check(keep_hidden || std::ranges::all_of(pieces, &Piece::visible),
        "hidden pieces are kept only where they are asked for");
  pieces = with_looks(std::move(pieces), lines, options.near);
  const std::vector<char> in_other_places = are_moved(pieces, lines);
  return vote_on_visibility(std::move(pieces), in_other_places, longest_spurious_change(options.near.distance, moved),
                            progress);
}

// The pieces of a drawing, by place alone.
std::vector<Piece> pieces_of(const ViewDrawing& drawing, const NearLines& near) {
  std::vector<Piece> pieces;
  pieces.reserve(drawing.segments.size());
  for (const Segment& s : drawing.segments)
    pieces.push_back({s.from, s.to, s.visible, !near.strength || near.strength(s.model, s.body, s.kind, s.visible) >= 0,
                      s.kind, -1, s.t});
  check(pieces.size() == drawing.segments.size(), "every line of a drawing is a piece");
  return pieces;
}

}  // namespace

Vec2 position_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper, const edges::FeatureEdge& edge,
                       double s) {
  const auto end = [&](std::size_t i) -> const view::PageVertex& { return view.vertices[edge.drawn_vertex(i)]; };
  if (s == 0) return paper(end(0));
  if (s == 1) return paper(end(1));
  const view::PageVertex& p = end(0);
  const view::PageVertex& q = end(1);
  return paper({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), 0, 1});
}

double parameter_in_space(const view::ProjectedScene& view, const edges::FeatureEdge& edge, double s) {
  if (s == 0) return edge.t[0];
  if (s == 1) return edge.t[1];
  const double wp = view.vertices[edge.vertex[0]].w;
  const double wq = view.vertices[edge.vertex[1]].w;
  // First the position on the clipped edge in space, then on the edge of the model.
  const double part = s * wp / (s * wp + (1 - s) * wq);
  check(part >= 0 && part <= 1, "a point of an edge lies between its ends");
  return edge.t[0] + part * (edge.t[1] - edge.t[0]);
}

Coincidence coincidence_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper) {
  const double tolerance = std::max(coincident_cells * view.cell, view.contact.touching) * paper.scale;
  return {tolerance, std::max(visibility::min_piece * view.extent * paper.scale, 8 * tolerance)};
}

ViewDrawing make_drawing(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                         const DrawingOptions& options, const Progress& progress) {
  const view::ProjectedScene& view = lines.view;
  ViewDrawing drawing;
  drawing.name = options.name;
  drawing.projection = view.projection;
  drawing.world_to_page = view::world_to_page(view, paper);
  drawing.cuts.numbers_in_scene = numbers_in_scene(lines.world);
  drawing.aids.vanishing_points = view::vanishing_points_on_page(view, paper);

  const Coincidence limits = coincidence_on_paper(view, paper);
  progress.begin("merging lines");
  std::vector<Piece> pieces = unmerged_pieces(lines, paper, options, progress);
  measure_straight_lines(pieces, lines, limits.tolerance);
  drawing.distances.contours_moved = std::max(lines.drawn.moved * paper.scale, moved_by_refinement(lines, paper));
  LeftInk left{std::move(pieces)};
  if (options.near.distance > 0) left = draw_circles_once(lines, paper, limits.min, std::move(left.pieces), progress);
  pieces = resolve_coincident(std::move(left.pieces), limits.tolerance, limits.min, progress);
  if (!options.hidden) std::erase_if(pieces, [](const Piece& piece) { return !piece.visible; });
  LeftInk joined = join_where_near(std::move(pieces), lines, options.near, limits, progress);
  pieces = std::move(joined.pieces);
  drawing.distances.joined_within = std::max(left.within, joined.within);
  drawing.distances.coincident = limits.tolerance;
  add_segments(lines, pieces, drawing, progress);
  pieces = std::vector<Piece>();  // to make room for the chains
  progress.begin("joining lines", drawing.segments.size());
  drawing.distances.unseen = unseen_up_to * options.near.distance;
  chain_lines(drawing, progress);
  if (options.least_crease > 0 && drop_short_creases(drawing, options.least_crease)) chain_lines(drawing, progress);
  if (options.near.distance > 0)
    for (Chain& chain : drawing.chains)
      chain.points = go_forwards(std::move(chain.points), chain.closed, on_one_line * options.near.distance);

  Vec2 max(-HUGE_VAL), low(HUGE_VAL);
  for (const Segment& s : drawing.segments) {
    low = glm::min(low, glm::min(s.from, s.to));
    max = glm::max(max, glm::max(s.from, s.to));
    check(s.from.x >= low.x && s.to.x >= low.x && s.from.y >= low.y && s.to.y >= low.y && s.from.x <= max.x &&
              s.to.x <= max.x && s.from.y <= max.y && s.to.y <= max.y,
          "the box of a drawing contains its lines");
  }
  if (!drawing.segments.empty()) {
    drawing.box.min = low;
    drawing.box.max = max;
  }
  return drawing;
}

double merged_by(const visibility::ResolvedView& lines, const view::PaperMap& paper, const DrawingOptions& options,
                 const ViewDrawing& drawing, const Progress& progress) {
  const double most = drawing.distances.joined_within, unseen = std::min(most, drawing.distances.unseen);
  // Measuring is worth less than a tenth of a second. Short creases are left out as asked, and their ink is missed.
  constexpr std::size_t max_measured = 20'000;
  if (most <= unseen || options.least_crease > 0 || drawing.segments.size() > max_measured) return most;
  std::vector<Piece> before = unmerged_pieces(lines, paper, options, progress);
  if (!options.hidden) std::erase_if(before, [](const Piece& piece) { return !piece.visible; });
  if (before.size() > max_measured) return most;
  const double precision = unseen_up_to * drawing.distances.unseen;
  check(precision > 0, "ink is left out beside other ink only within a distance");
  return std::max(unseen, ink_distance(before, pieces_of(drawing, options.near), precision, most, progress));
}

}  // namespace epura::drawing
