// SPDX-License-Identifier: Apache-2.0
#include "scene/cut_world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/edge_table.hpp"
#include "scene/cut_bodies.hpp"
#include "scene/cut_doubts.hpp"
#include "scene/cut_gaps.hpp"
#include "scene/cut_mesh.hpp"
#include "scene/cut_outline.hpp"

namespace epura::scene {

namespace {

constexpr double least_gap = 0x1p-44;  // of the world's size; narrower gaps are rounding errors, and are not reported

/// The cut of one model.
struct ModelCut {
  const World& world;
  int model;
  const PlaneFrame& frame;
  CutMesh cut;
  std::size_t of_surface = 0;  ///< number of triangles before those of cut faces
  std::vector<WorldCutFace> faces{};
  std::vector<CutSegment> loose{};  ///< of outlines that are open, or that bound no certain area
  std::vector<OpenOutline> open{};
  std::vector<BridgedGaps> bridged{};

  [[nodiscard]] const mesh::Mesh& mesh() const { return *world.models[model].mesh; }
  [[nodiscard]] int file_vertices() const { return world.first_vertex[model + 1] - world.first_vertex[model]; }
  [[nodiscard]] CutPlaces places() const {
    const auto first = static_cast<std::size_t>(world.first_vertex[model]);
    return {{world.points.data() + first, static_cast<std::size_t>(file_vertices())}, cut.points};
  }

  void close();
  [[nodiscard]] GapLimits gap_limits() const;
  void tell_outlines_apart();
  void say_bridged(int body, const std::vector<Bridge>& bridges);
  void leave_out_doubtful();
  void take_faces_in_plane(const std::vector<int>& material, const std::vector<char>& is_open);
  void keep_triangle(int triangle, int body, std::vector<CutSegment>& segments);
  void add_face(int body, std::span<const CutSegment> segments);
  [[nodiscard]] mesh::Mesh make_mesh() const;
};

void ModelCut::close() {
  const std::vector<char> is_open = open_bodies(mesh());
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
  of_surface = cut.triangles.size();
  visit_bodies(cut.segments, [&](int body, std::span<const CutSegment> segments) { add_face(body, segments); });
}

GapLimits ModelCut::gap_limits() const {
  const scene::Placed& placed = world.models[model];
  const Mat3 turn(placed.to_world);
  const double shortest = std::min({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
  const auto sagitta = [part = placed.part, scale = shortest * frame.normalisation](int triangle) {
    const int face = part == nullptr || part->faces.empty() ? -1 : part->face_of_triangle[triangle];
    return face < 0 ? std::nullopt : std::optional(part->faces[face].sagitta * scale);
  };
  return {world.rounding * frame.normalisation, sagitta};
}

void ModelCut::tell_outlines_apart() {
  const GapLimits limits = gap_limits();
  const double nothing = std::max(limits.rounding, least_gap);
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
  cut_away.cut_vertices = cut.vertices;
  cut_away.first_cut_vertex = file_vertices();
  cut_away.uncut = world.models[model].mesh;
  mesh::EdgeTable table =
      mesh::make_edge_table(cut_away.corners, cut.polygon, static_cast<int>(cut_away.points.size()));
  for (int& halfedge : table.halfedges) halfedge /= 3;
  if (!cut.wires.empty()) mesh::add_wires(table, cut.wires);
  cut_away.edges = std::move(table.edges);
  cut_away.edge_triangles = std::move(table.halfedges);

  std::vector<std::array<int, 2>> outline;
  for (const CutSegment& segment : cut.segments) outline.push_back(segment.vertex);
  for (const CutSegment& segment : loose) outline.push_back(segment.vertex);
  std::sort(outline.begin(), outline.end());
  for (mesh::MeshEdge& edge : cut_away.edges) {
    // Triangles of cut faces are last.
    const bool in_face = edge.count > 0 && cut_away.triangles_of(edge).front() >= static_cast<int>(of_surface);
    if (std::binary_search(outline.begin(), outline.end(), edge.vertex))
      edge.cut = mesh::CutEdge::outline;
    else if (in_face || !cut_away.origin_of(edge).in_file)
      edge.cut = mesh::CutEdge::inside;
  }
  return cut_away;
}

void append(World& world, const ModelCut& cut) {
  const int first = world.first_vertex.back();
  const CutPlaces places = cut.places();
  world.points.insert(world.points.end(), places.file.begin(), places.file.end());
  world.points.insert(world.points.end(), places.made.begin(), places.made.end());
  for (std::array<int, 3> corners : cut.cut.triangles) {
    for (int& v : corners) v += first;
    world.triangles.push_back(corners);
  }
  world.first_vertex.push_back(static_cast<int>(world.points.size()));
  world.first_triangle.push_back(static_cast<int>(world.triangles.size()));
  const Placed& whole = cut.world.models[cut.model];
  world.models.push_back(
      {std::make_shared<const mesh::Mesh>(cut.make_mesh()), whole.to_world, whole.part, whole.styles});
  if (!cut.world.wires.empty()) append_wires(world, *world.models.back().mesh, first);
}

[[noreturn]] void refuse(const CuttingPlane& plane, const std::string& what, const Box& box) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                 (corner & 4) != 0 ? box.max.z : box.min.z);
    const double height = glm::dot(plane.normal, p - plane.point);
    least = std::min(least, height);
    most = std::max(most, height);
  }
  throw Error(ErrorKind::input, plane.where, what,
              "along its normal, the models reach from " + format_rounded(least, 6) + " to " + format_rounded(most, 6) +
                  " of its point: move the point or turn the normal");
}

}  // namespace

CutWorld cut_world(const World& world, const CuttingPlane& plane, const Progress& progress) {
  const Sides sides = find_sides(world, plane);
  const PlaneFrame frame(world, plane, sides.normalisation);
  CutWorld result;
  result.world.first_vertex = {0};
  result.world.first_triangle = {0};
  result.world.box = world.box;
  result.world.rounding = world.rounding;
  result.world.one_rounding = world.one_rounding;
  bool cuts = false;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    ModelCut cut{world, model, frame, cut_mesh(world, model, sides)};
    progress.expect_time();
    cut.close();
    progress.expect_time();
    const int first = result.world.first_vertex.back();
    for (WorldCutFace& face : cut.faces) {
      for (auto& ring : face.rings)
        for (int& v : ring) v += first;
      result.faces.push_back(std::move(face));
    }
    result.open.insert(result.open.end(), cut.open.begin(), cut.open.end());
    result.bridged.insert(result.bridged.end(), cut.bridged.begin(), cut.bridged.end());
    for (const int triangle : cut.cut.uncut) result.uncut.push_back(result.world.first_triangle.back() + triangle);
    cuts = cuts || !cut.cut.segments.empty() || !cut.loose.empty() || cut.cut.cuts_wires;
    append(result.world, cut);
  }
  if (result.world.triangles.empty() && result.world.wires.empty())
    refuse(plane, "the cutting plane removes everything", world.box);
  if (!cuts) refuse(plane, "the plane cuts nothing", world.box);
  return result;
}

}  // namespace epura::scene
