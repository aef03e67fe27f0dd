// SPDX-License-Identifier: Apache-2.0
#include "mesh/build.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/vec.hpp"
#include "mesh/bodies.hpp"
#include "mesh/cracks.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/faces.hpp"
#include "mesh/point_marks.hpp"
#include "mesh/resolution.hpp"
#include "mesh/triangulate.hpp"
#include "mesh/weld.hpp"

namespace epura::mesh {

namespace {

int count_non_finite(const Points& points) {
  int count = 0;
  for (const auto& p : points) count += !finite(Vec3(p[0], p[1], p[2]));
  return count;
}

void weld(Soup& soup, MeshReport& report) {
  std::vector<int> first = same_places(soup.points);
  if (soup.corners_repeat_points) return renumber(soup.points, soup.corners, std::move(first));
  for (int v = 0; v < static_cast<int>(first.size()); ++v) report.welded_vertices += first[v] != v;
  if (report.welded_vertices == 0) return;
  for (int& corner : soup.corners) corner = first[corner];
  for (auto& wire : soup.wires) wire = {first[wire[0]], first[wire[1]]};
}

Faces usable_faces(Soup& soup, MeshReport& report) {
  Faces faces{.corners = std::move(soup.corners), .ends = std::move(soup.face_ends), .number = {}};
  faces.number.resize(faces.size());
  std::iota(faces.number.begin(), faces.number.end(), 0);
  report.dropped_degenerate = drop_faces_without_three_corners(faces) - soup.wire_faces;
  if (report.non_finite_vertices > 0)
    report.dropped_non_finite = drop_faces_with_non_finite_corners(faces, soup.points);
  return faces;
}

EdgeTable edges_of(const Faces& triangles, const MeshReport& report) {
  return make_edge_table(triangles.corners, triangles.number, report.vertices);
}

/// If all faces are triangles, the edge table shows whether any are equal, which is rare.
void drop_equal_triangles(Faces& triangles, EdgeTable& table, MeshReport& report) {
  if (!has_equal_triangles(table, triangles.corners)) return;
  report.dropped_duplicates += drop_duplicate_faces(triangles, report.vertices);
  table = edges_of(triangles, report);
}

/// Welds across cracks, such as the seam of a surface of revolution whose first and last points are computed from the
/// cosines and sines of 0 and of a full turn; some triangles may then be equal. Vertices that the file numbers keep
/// their numbers.
void close_cracks(Soup& soup, Faces& triangles, EdgeTable& table, MeshReport& report) {
  const bool single = soup.single_precision || soup.corners_repeat_points;  // text STL usually holds floats
  Mending mending = mend_cracks(soup.points, triangles.corners, table, single ? 0x1p-23 : 0x1p-52);
  if (mending.joined == 0) return;
  report.welded_vertices += mending.joined;
  report.weld_distance = mending.distance;
  if (soup.corners_repeat_points) {
    renumber(soup.points, triangles.corners, std::move(mending.representative));
    report.vertices = static_cast<int>(soup.points.size());
  } else {
    for (int& corner : triangles.corners) corner = mending.representative[corner];
    for (auto& wire : soup.wires) wire = {mending.representative[wire[0]], mending.representative[wire[1]]};
  }
  table = edges_of(triangles, report);
  drop_equal_triangles(triangles, table, report);
}

/// Puts their edges into `table`.
Faces usable_triangles(Soup& soup, EdgeTable& table, MeshReport& report, const Progress& progress) {
  Faces faces = usable_faces(soup, report);
  const bool polygons = faces.corners.size() != 3 * faces.size();
  if (polygons) report.dropped_duplicates = drop_duplicate_faces(faces, report.vertices);
  progress.expect_time();
  Faces triangles = triangulate(std::move(faces), soup.points, progress);
  progress.expect_time();
  table = edges_of(triangles, report);
  if (!polygons) drop_equal_triangles(triangles, table, report);
  progress.expect_time();
  close_cracks(soup, triangles, table, report);
  return triangles;
}

/// The triangles of a face are consecutive.
int count_faces(const Faces& triangles) {
  int count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) count += t == 0 || triangles.number[t] != triangles.number[t - 1];
  return count;
}

/// Bodies that touch in an edge share it; each of them may be manifold.
bool is_non_manifold(const MeshEdge& edge, const EdgeTable& table, const std::vector<int>& body) {
  std::vector<int> bodies;
  for (const int halfedge : table.halfedges_of(edge)) bodies.push_back(body[halfedge / 3]);
  std::sort(bodies.begin(), bodies.end());
  for (std::size_t i = 2; i < bodies.size(); ++i)
    if (bodies[i] == bodies[i - 2]) return true;
  return false;
}

/// Segments of zero length are ignored.
void take_wires(const Mesh& mesh, Soup& soup, EdgeTable& table, MeshReport& report) {
  if (soup.wires.empty()) return;
  const std::size_t all = soup.wires.size();
  std::erase_if(soup.wires, [&](const std::array<int, 2>& wire) {
    return !finite(mesh.point(wire[0])) || !finite(mesh.point(wire[1]));
  });
  if (const std::size_t dropped = all - soup.wires.size(); dropped > 0)
    report.notes.push_back(std::to_string(dropped) + (dropped == 1 ? " piece" : " pieces") +
                           " of lines left out, whose coordinates are not finite");
  add_wires(table, soup.wires);
  for (const MeshEdge& edge : table.edges) report.wires += edge.wire;
}

void count_edges(Mesh& mesh, const EdgeTable& table) {
  MeshReport& report = mesh.report;
  for (const MeshEdge& edge : table.edges) {
    report.open_edges += edge.count == 1;
    report.non_manifold_edges += edge.count > 2 && is_non_manifold(edge, table, mesh.body);
    report.misoriented_edges += edge.count == 2 && !is_two_sided(table, edge, mesh.corners);
  }
}

/// Such triangles are kept, since dropping them would open the edges next to them.
void note_triangles_without_area(Mesh& mesh) {
  MeshReport& report = mesh.report;
  int count = 0;
  for (int t = 0; t < report.triangles; ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    const Vec3 u = mesh.point(b) - mesh.point(a), v = mesh.point(c) - mesh.point(a);
    count += u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
  }
  if (count == 0) return;
  auto& sentences = are_many(count, report.triangles) ? report.notes : report.remarks;
  sentences.push_back(std::to_string(count) + (count == 1 ? " triangle has" : " triangles have") + " no area");
}

void number_bodies(Mesh& mesh, const Soup& soup, const EdgeTable& table) {
  const bool named = soup.body_names.size() > 1;
  if (!named) {
    mesh.body = connected_parts(mesh, table);
    if (!soup.body_names.empty()) mesh.report.only_body = soup.body_names.front();
    mesh.report.body_colours = soup.body_colours;
  } else {
    for (const int face : mesh.polygon) mesh.body.push_back(soup.face_body[face]);
    for (const int body : renumber_labels(mesh.body)) {
      mesh.report.body_names.push_back(soup.body_names[body]);
      if (!soup.body_colours.empty()) mesh.report.body_colours.push_back(soup.body_colours[body]);
    }
  }
  const auto last = std::max_element(mesh.body.begin(), mesh.body.end());
  mesh.report.bodies = last == mesh.body.end() ? 0 : *last + 1;
}

}  // namespace

Mesh build_mesh(Soup soup, std::string name, const Progress& progress) {
  Mesh mesh;
  MeshReport& report = mesh.report;
  report.name = std::move(name);
  report.format = soup.format;
  report.single_precision = soup.single_precision;
  mark_lone_points(soup);
  report.notes = std::move(soup.notes);

  progress.expect_time();
  weld(soup, report);
  report.vertices = static_cast<int>(soup.points.size());
  report.non_finite_vertices = count_non_finite(soup.points);
  if (soup.printed) report.resolution = decimal_resolution(soup.points);
  EdgeTable table;
  Faces triangles = usable_triangles(soup, table, report, progress);

  progress.expect_time();
  const PointMarks marks = add_crosses(soup, report.name);
  report.points = marks.points;
  report.point_arms = marks.arms;
  report.faces = count_faces(triangles);
  report.triangles = static_cast<int>(triangles.size());
  mesh.points = std::move(soup.points);
  mesh.corners = std::move(triangles.corners);
  mesh.polygon = std::move(triangles.number);
  note_triangles_without_area(mesh);
  number_bodies(mesh, soup, table);
  count_edges(mesh, table);
  take_wires(mesh, soup, table, report);

  set_edges(mesh, std::move(table));
  return mesh;
}

}  // namespace epura::mesh
