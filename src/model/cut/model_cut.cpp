// SPDX-License-Identifier: Apache-2.0
#include "cut/model_cut.hpp"

#include <array>
#include <optional>
#include <utility>

#include "cut/cut_bodies.hpp"
#include "cut/cut_doubts.hpp"
#include "cut/cut_region.hpp"
#include "cut/limits.hpp"
#include "cut/true_outline.hpp"
#include "mesh/edge_table.hpp"
#include "world/placed_part.hpp"

namespace epura::cut {

void ModelCut::close() {
  const std::vector<char> is_open = open_bodies(mesh());
  moved = move_to_surfaces(cut, world, model, frame);
  keep_odd(cut.segments);
  tell_outlines_apart();
  const std::vector<int> material = material_of({world, model, cut, places(), frame}, is_open);
  for (CutSegment& segment : cut.segments) segment.body = material[segment.body];
  for (CutSegment& segment : loose) segment.body = material[segment.body];
  keep_odd(cut.segments);
  keep_odd(loose);
  leave_out_doubtful();
  take_faces_in_plane(material, is_open);
  keep_odd(cut.segments);
  if (region != nullptr) keep_region();
}

void ModelCut::divide_sides(const std::map<std::array<int, 2>, std::vector<int>>& chains) {
  const std::size_t count = cut.triangles.size();
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<int, 3> corners = cut.triangles[t];
      const int from = corners[i], to = corners[(i + 1) % 3], apex = corners[(i + 2) % 3];
      const auto found = chains.find({std::min(from, to), std::max(from, to)});
      if (found == chains.end() || found->second.size() == 2) continue;
      std::vector<int> chain = found->second;
      if (chain.front() != from) std::reverse(chain.begin(), chain.end());
      cut.triangles[t] = {chain[0], chain[1], apex};
      for (std::size_t k = 2; k < chain.size(); ++k) {
        cut.triangles.push_back({chain[k - 1], chain[k], apex});
        cut.polygon.push_back(cut.polygon[t]);
        cut.body.push_back(cut.body[t]);
        cut.source.push_back(cut.source[t]);
      }
      break;  // a triangle has one side in the plane
    }
  for (const auto& [ends, chain] : chains)
    for (std::size_t k = 1; k < chain.size(); ++k)
      divided.push_back({std::min(chain[k - 1], chain[k]), std::max(chain[k - 1], chain[k])});
}

// Adds the cut faces, within the region.
void ModelCut::finish() {
  of_surface = cut.triangles.size();
  if (region != nullptr) return clip_outlines_to_region();
  visit_bodies(cut.segments, [&](int body, std::span<const CutSegment> segments) { add_face(body, segments); });
}

GapLimits ModelCut::gap_limits() const {
  const world::Placed& placed = world.models[model];
  const Mat3 turn(placed.to_world);
  const double shortest = std::min({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
  const bool has_faces = placed.part != nullptr && !placed.part->faces.empty();
  const auto sagitta = [part = placed.part, scale = shortest * frame.normalisation,
                        faces = has_faces ? world::faces_of_triangles(placed) : std::vector<int>()](int triangle) {
    const int face = faces.empty() ? -1 : faces[triangle];
    return face < 0 ? std::nullopt : std::optional(part->faces[face].sagitta * scale);
  };
  return {world.rounding * frame.normalisation, sagitta};
}

void ModelCut::tell_outlines_apart() {
  const GapLimits limits = gap_limits();
  const double nothing = std::max(limits.rounding, rounding_part);
  std::vector<CutSegment> closed;
  visit_bodies(cut.segments, [&](int body, std::span<const CutSegment> segments) {
    ToldApart apart = tell_apart(segments, places(), frame, limits);
    std::erase_if(apart.bridges, [&](const Bridge& bridge) { return bridge.width <= nothing; });
    closed.insert(closed.end(), apart.closed.begin(), apart.closed.end());
    loose.insert(loose.end(), apart.loose.begin(), apart.loose.end());
    if (!apart.bridges.empty()) say_bridged(body, apart.bridges);
    if (!apart.ends.empty()) open.push_back({model, body, places()[apart.ends.front()]});
  });
  cut.segments = std::move(closed);
}

void ModelCut::say_bridged(int body, const std::vector<Bridge>& bridges) {
  const Bridge& widest = *std::max_element(bridges.begin(), bridges.end(),
                                           [](const Bridge& a, const Bridge& b) { return a.width < b.width; });
  const auto& [a, b] = widest.vertex;
  bridged.push_back({model, body, static_cast<int>(bridges.size()), widest.width / frame.normalisation,
                     places()[a] * 0.5 + places()[b] * 0.5});
}

void ModelCut::leave_out_doubtful() {
  const std::vector<char> doubted = doubtful(cut.segments, loose, places(), frame);
  std::vector<CutSegment> certain;
  for (std::size_t s = 0; s < doubted.size(); ++s) (doubted[s] != 0 ? loose : certain).push_back(cut.segments[s]);
  cut.segments = std::move(certain);
}

// Faces in the plane are kept if there is material behind them. If this is unknown, all are kept.
void ModelCut::take_faces_in_plane(const std::vector<int>& material, const std::vector<char>& is_open) {
  std::vector<std::vector<int>> by_body(material.size());
  for (const int t : cut.in_plane) by_body[material[mesh().body[t]]].push_back(t);
  std::vector<char> unknown(material.size(), 0);
  for (std::size_t b = 0; b < material.size(); ++b)
    if (is_open[b] != 0) unknown[material[b]] = 1;
  for (const CutSegment& segment : loose) unknown[segment.body] = 1;
  std::vector<CutSegment> sides;
  for (int body = 0; body < static_cast<int>(by_body.size()); ++body) {
    std::vector<std::array<int, 3>> triangles;
    for (const int t : by_body[body]) triangles.push_back(mesh().triangle(t));
    if (triangles.empty()) continue;
    const auto before = [](const CutSegment& segment, int number) { return segment.body < number; };
    const auto first = std::lower_bound(cut.segments.begin(), cut.segments.end(), body, before);
    const auto last = std::lower_bound(first, cut.segments.end(), body + 1, before);
    const std::vector<bool> inside = lie_inside(triangles, {first, last}, places(), frame);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (inside[i])
        keep_triangle(by_body[body][i], body, sides);
      else if (unknown[body] != 0)
        keep_triangle(by_body[body][i], body, loose);
    }
  }
  cut.segments.insert(cut.segments.end(), sides.begin(), sides.end());
  keep_odd(loose);
}

void ModelCut::keep_triangle(int triangle, int body, std::vector<CutSegment>& segments) {
  const std::array<int, 3> corners = mesh().triangle(triangle);
  cut.triangles.push_back(corners);
  cut.polygon.push_back(mesh().polygon[triangle]);
  cut.body.push_back(mesh().body[triangle]);
  cut.source.push_back(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
    segments.push_back({body, {low, high}});
  }
}

void ModelCut::add_face(int body, std::span<const CutSegment> segments) {
  faces.push_back({model, body, rings_of(segments)});
  FlatOutlines flat = flatten(segments, places(), frame);
  const std::vector<std::array<int, 3>> triangles = mesh::fill_even_odd(flat.outlines);
  for (std::size_t i = flat.vertices.size(); i < flat.outlines.places.size(); ++i) {
    flat.vertices.push_back(file_vertices() + static_cast<int>(cut.points.size()));
    cut.points.push_back(frame.in_space(flat.outlines.places[i]));
    cut.vertices.push_back({{-1, -1}, 0});
  }
  const auto& polygons = mesh().polygon;
  const int face = *std::max_element(polygons.begin(), polygons.end()) + static_cast<int>(faces.size());
  for (const auto& [a, b, c] : triangles) {
    cut.triangles.push_back({flat.vertices[a], flat.vertices[b], flat.vertices[c]});
    cut.polygon.push_back(face);
    cut.body.push_back(body);
  }
}

// Also omits what is open or bridged in other regions.
void ModelCut::keep_region() {
  const int first = world.first_triangle[model];
  std::vector<int> numbers(cut.triangles.size(), -1);
  CutMesh kept;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    if (!region->has_triangle(first + cut.source[t])) continue;
    numbers[t] = static_cast<int>(kept.triangles.size());
    kept.triangles.push_back(cut.triangles[t]);
    kept.polygon.push_back(cut.polygon[t]);
    kept.body.push_back(cut.body[t]);
    kept.source.push_back(cut.source[t]);
  }
  for (const int t : cut.uncut)
    if (numbers[t] >= 0) kept.uncut.push_back(numbers[t]);
  cut.triangles = std::move(kept.triangles);
  cut.polygon = std::move(kept.polygon);
  cut.body = std::move(kept.body);
  cut.source = std::move(kept.source);
  cut.uncut = std::move(kept.uncut);
  const auto middle = [&](const std::array<int, 2>& ends) { return (places()[ends[0]] + places()[ends[1]]) / 2.0; };
  std::erase_if(cut.wires, [&](const auto& wire) { return !region->has_point(middle(wire)); });
  std::erase_if(loose, [&](const CutSegment& segment) { return !region->has_point(middle(segment.vertex)); });
  std::erase_if(open, [&](const OpenOutline& outline) { return !region->has_point(outline.end); });
  std::erase_if(bridged, [&](const BridgedGaps& gaps) { return !region->has_point(gaps.place); });
}

// Faces end at the borders of the region, where no line is drawn.
void ModelCut::clip_outlines_to_region() {
  const std::vector<CutSegment> segments = std::move(cut.segments);
  cut.segments.clear();
  visit_bodies(segments, [&](int body, std::span<const CutSegment> of_body) {
    const RegionOutlines outlines =
        clip_outlines(of_body, region->region.borders, {places().file, cut}, region->split.slack);
    cut.segments.insert(cut.segments.end(), outlines.drawn.begin(), outlines.drawn.end());
    if (!outlines.ends.empty())
      open.push_back({model, body, places()[outlines.ends.front()]});
    else if (!outlines.closed.empty())
      add_face(body, outlines.closed);
  });
}

// The other cut is of another region of the same model.
void ModelCut::append(ModelCut&& other) {
  const int shift = static_cast<int>(cut.points.size()), file = file_vertices();
  const auto renumber = [&](auto& vertices) {
    for (int& v : vertices)
      if (v >= file) v += shift;
  };
  for (auto& triangle : other.cut.triangles) renumber(triangle);
  for (CutSegment& segment : other.cut.segments) renumber(segment.vertex);
  for (CutSegment& segment : other.loose) renumber(segment.vertex);
  for (auto& side : other.divided) renumber(side);
  for (auto& wire : other.cut.wires) renumber(wire);
  const auto split = static_cast<std::ptrdiff_t>(other.of_surface), here = static_cast<std::ptrdiff_t>(of_surface);
  for (std::size_t t = other.of_surface; t < other.cut.polygon.size(); ++t)
    other.cut.polygon[t] += static_cast<int>(faces.size());
  const auto join = [&](auto& all, auto& more) {
    all.insert(all.begin() + here, more.begin(), more.begin() + split);
    all.insert(all.end(), more.begin() + split, more.end());
  };
  join(cut.triangles, other.cut.triangles);
  join(cut.polygon, other.cut.polygon);
  join(cut.body, other.cut.body);
  const auto add = [](auto& all, auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  for (WorldCutFace& face : other.faces)
    for (auto& ring : face.rings) renumber(ring);
  add(faces, other.faces);
  add(cut.points, other.cut.points);
  add(cut.vertices, other.cut.vertices);
  add(cut.segments, other.cut.segments);
  add(loose, other.loose);
  add(divided, other.divided);
  add(cut.wires, other.cut.wires);
  add(open, other.open);
  add(bridged, other.bridged);
  cut.cuts_wires = cut.cuts_wires || other.cut.cuts_wires;
  of_surface += other.of_surface;
  moved = std::max(moved, other.moved);
}

void ModelCut::drop_surface() {
  const auto drop = [end = static_cast<std::ptrdiff_t>(of_surface)](auto& list) {
    list.erase(list.begin(), list.begin() + end);
  };
  drop(cut.triangles);
  drop(cut.polygon);
  drop(cut.body);
  // The faces need not have all vertices of their outlines.
  cut.wires.clear();
  for (const CutSegment& segment : cut.segments) cut.wires.push_back(segment.vertex);
  cut.uncut.clear();
  loose.clear();
  of_surface = 0;
}

mesh::Mesh ModelCut::make_mesh() const {
  mesh::Mesh cut_away;
  cut_away.points = mesh().points;
  const Mat4 to_file = glm::inverse(world.models[model].to_world);
  for (const Vec3& made : cut.points) {
    const Vec3 p(to_file * Vec4(made, 1));
    cut_away.points.push_back({p.x, p.y, p.z});
  }
  for (const auto& triangle : cut.triangles)
    cut_away.corners.insert(cut_away.corners.end(), triangle.begin(), triangle.end());
  cut_away.polygon = cut.polygon;
  cut_away.body = cut.body;
  cut_away.report = mesh().report;
  const bool is_split = mesh().uncut != nullptr;
  if (is_split) cut_away.cut_vertices = mesh().cut_vertices;
  cut_away.cut_vertices.insert(cut_away.cut_vertices.end(), cut.vertices.begin(), cut.vertices.end());
  cut_away.first_cut_vertex = is_split ? mesh().first_cut_vertex : file_vertices();
  cut_away.uncut = is_split ? mesh().uncut : world.models[model].mesh;
  mesh::make_edges(cut_away, cut.wires);

  std::vector<std::array<int, 2>> outline;
  for (const CutSegment& segment : cut.segments) outline.push_back(segment.vertex);
  for (const CutSegment& segment : loose) outline.push_back(segment.vertex);
  std::sort(outline.begin(), outline.end());
  std::vector<std::array<int, 2>> covered = divided;
  std::sort(covered.begin(), covered.end());
  for (mesh::MeshEdge& edge : cut_away.edges) {
    // Triangles of cut faces are last.
    const bool in_face = edge.count > 0 && cut_away.triangles_of(edge).front() >= static_cast<int>(of_surface);
    if (std::binary_search(outline.begin(), outline.end(), edge.vertex))
      edge.cut = mesh::CutEdge::outline;
    else if (in_face || !cut_away.origin_of(edge).in_file ||
             std::binary_search(covered.begin(), covered.end(), edge.vertex))
      edge.cut = mesh::CutEdge::inside;
  }
  return cut_away;
}

}  // namespace epura::cut
