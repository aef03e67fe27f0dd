// SPDX-License-Identifier: Apache-2.0
#include "mesh/build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "mesh/bodies.hpp"
#include "mesh/cracks.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/faces.hpp"
#include "mesh/point_marks.hpp"
#include "mesh/resolution.hpp"
#include "mesh/t_vertices.hpp"
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

/// The triangles of a mesh, their edges, and the faces that are there twice.
struct UsableTriangles {
  Faces triangles;
  EdgeTable table;
  std::vector<TwinFaces> twins{};
};

/// Drops the second ones of `equal` triangles, given by their places, unless their polygons are twins.
void drop_unknown_twins(Faces& triangles, const std::vector<int>& polygon, const std::vector<TwinFaces>& equal,
                        const std::vector<TwinFaces>& twins, MeshReport& report) {
  std::set<std::array<int, 2>> known;
  for (const auto& [first, second] : twins) known.insert({first, second});
  std::vector<int> dropped;
  for (const auto& [first, second] : equal)
    if (!known.contains({polygon[first], polygon[second]})) dropped.push_back(second);
  std::sort(dropped.begin(), dropped.end());
  drop_numbered_faces(triangles, dropped);
  report.dropped_duplicates += static_cast<int>(dropped.size());
}

/// The edge table shows whether any triangles are equal, which is rare. If they are faces of the file, pairs of them
/// become the `twins`; equal triangles of polygons stay if these are twins.
void drop_equal_triangles(UsableTriangles& usable, bool are_faces, MeshReport& report) {
  Faces& triangles = usable.triangles;
  if (!has_equal_triangles(usable.table, triangles.corners)) return;
  std::vector<int> polygon(triangles.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  polygon.swap(triangles.number);
  std::vector<TwinFaces> equal;
  report.dropped_duplicates += drop_duplicate_faces(triangles, report.vertices, equal);
  if (are_faces) {
    usable.twins.clear();
    for (const auto& [first, second] : equal) usable.twins.push_back({polygon[first], polygon[second]});
  } else {
    drop_unknown_twins(triangles, polygon, equal, usable.twins, report);
  }
  for (int& number : triangles.number) number = polygon[number];
  usable.table = edges_of(triangles, report);
}

/// Welds across cracks, such as the seam of a surface of revolution whose first and last points are computed from the
/// cosines and sines of 0 and of a full turn; some triangles may then be equal. Vertices that the file numbers keep
/// their numbers.
void close_cracks(Soup& soup, UsableTriangles& usable, bool are_faces, const CrackLimits& limits, MeshReport& report) {
  Faces& triangles = usable.triangles;
  Mending mending = mend_cracks(soup.points, usable.table, limits);
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
  report.dropped_degenerate += drop_faces_without_three_corners(triangles);
  usable.table = edges_of(triangles, report);
  drop_equal_triangles(usable, are_faces, report);
}

void divide_open_edges(const Points& points, UsableTriangles& usable, double width, MeshReport& report,
                       const Progress& progress) {
  const int divided = insert_t_vertices(usable.triangles, points, usable.table, width, progress);
  if (divided == 0) return;
  usable.triangles = triangulate(std::move(usable.triangles), points, progress).triangles;
  usable.table = edges_of(usable.triangles, report);
  report.remarks.push_back(std::to_string(divided) + (divided == 1 ? " open edge" : " open edges") +
                           " divided where other edges end on " + (divided == 1 ? "it" : "them"));
}

/// Of twins between ends that were merged, nothing may be left.
void drop_twins_without_triangles(UsableTriangles& usable) {
  const std::vector<int>& numbers = usable.triangles.number;  // ascending
  const auto is_left = [&](int face) { return std::binary_search(numbers.begin(), numbers.end(), face); };
  std::erase_if(usable.twins, [&](const TwinFaces& pair) { return !is_left(pair.first) || !is_left(pair.second); });
}

bool has_open_edges(const EdgeTable& table) {
  return std::any_of(table.edges.begin(), table.edges.end(), [](const MeshEdge& edge) { return edge.count == 1; });
}

void note_unfinished(const std::vector<int>& faces, MeshReport& report) {
  if (faces.empty()) return;
  const std::size_t others = faces.size() - 1;
  const std::string face = "face " + std::to_string(faces.front());
  report.notes.push_back(others == 0
                             ? face + " is too intricate to divide: some of its triangles may lie outside"
                             : face + " and " + std::to_string(others) +
                                   " more are too intricate to divide: some of their triangles may lie outside");
}

UsableTriangles usable_triangles(Soup& soup, MeshReport& report, const Progress& progress) {
  UsableTriangles usable;
  Faces faces = usable_faces(soup, report);
  const bool polygons = faces.corners.size() != 3 * faces.size();
  if (polygons) report.dropped_duplicates = drop_duplicate_faces(faces, report.vertices, usable.twins);
  progress.expect_time();
  Triangulation divided = triangulate(std::move(faces), soup.points, progress);
  usable.triangles = std::move(divided.triangles);
  note_unfinished(divided.unfinished, report);
  progress.expect_time();
  usable.table = edges_of(usable.triangles, report);
  if (!polygons) drop_equal_triangles(usable, true, report);
  progress.expect_time();
  if (!has_open_edges(usable.table)) return usable;
  const CrackLimits limits = limits_of_cracks(soup.points, usable.triangles.corners, report.resolution);
  close_cracks(soup, usable, !polygons, limits, report);
  divide_open_edges(soup.points, usable, limits.width, report, progress);
  drop_twins_without_triangles(usable);
  return usable;
}

/// The triangles of a face are consecutive.
int count_faces(const Mesh& mesh) {
  int count = 0;
  for (std::size_t t = 0; t < mesh.polygon.size(); ++t) count += t == 0 || mesh.polygon[t] != mesh.polygon[t - 1];
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

std::vector<int> bodies_of(const Mesh& mesh, const Soup& soup, const EdgeTable& table) {
  if (soup.body_names.size() < 2) return connected_parts(mesh, table);
  std::vector<int> body;
  for (const int face : mesh.polygon) body.push_back(soup.face_body[face]);
  return body;
}

/// What a body has in common with each of the others.
struct SharedFaces {
  int triangles = 0;
  std::map<int, int> by_other{};  ///< shared triangles
  bool is_open = false;           ///< has an edge with one triangle
};

void find_open_bodies(const Mesh& mesh, const EdgeTable& table, std::vector<SharedFaces>& bodies) {
  for (const MeshEdge& edge : table.edges) {
    const auto halfedges = table.halfedges_of(edge);
    for (const int halfedge : halfedges) {
      const int body = mesh.body[halfedge / 3];
      if (std::count_if(halfedges.begin(), halfedges.end(), [&](int h) { return mesh.body[h / 3] == body; }) == 1)
        bodies[body].is_open = true;
    }
  }
}

/// One face of each of those twins at which no two bodies touch: both belong to one body, to two that have the same
/// faces, or to one and an incomplete copy of it.
std::vector<int> duplicates_among(const Mesh& mesh, const EdgeTable& table, const std::vector<TwinFaces>& twins) {
  std::unordered_map<int, std::pair<int, int>> of_face;  // its body and number of triangles
  for (const auto& [first, second] : twins) of_face[first] = of_face[second] = {-1, 0};
  std::vector<SharedFaces> bodies(mesh.body.empty() ? 0 : *std::max_element(mesh.body.begin(), mesh.body.end()) + 1);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    ++bodies[mesh.body[t]].triangles;
    if (const auto found = of_face.find(mesh.polygon[t]); found != of_face.end()) {
      found->second.first = mesh.body[t];
      ++found->second.second;
    }
  }
  const auto share = [&](int body, int other, int triangles) { bodies[body].by_other[other] += triangles; };
  for (const auto& [first, second] : twins) {
    const auto& [one, of_one] = of_face[first];
    const auto& [other, of_other] = of_face[second];
    share(one, other, of_one);
    share(other, one, of_other);
  }
  const auto is_copy = [&](int body, int other) { return bodies[body].by_other[other] == bodies[body].triangles; };
  find_open_bodies(mesh, table, bodies);
  const auto is_incomplete = [&](int body, int other) { return bodies[body].is_open && is_copy(body, other); };
  std::vector<int> duplicates;
  for (const auto& [first, second] : twins) {
    const int one = of_face[first].first, other = of_face[second].first;
    if (one == other || (is_copy(one, other) && is_copy(other, one)) || is_incomplete(other, one))
      duplicates.push_back(second);
    else if (is_incomplete(one, other))
      duplicates.push_back(first);
  }
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}

void drop_faces_of(Mesh& mesh, EdgeTable& table, const std::vector<int>& numbers) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.polygon.size(); ++t) {
    if (std::binary_search(numbers.begin(), numbers.end(), mesh.polygon[t])) continue;
    std::copy_n(mesh.corners.begin() + static_cast<std::ptrdiff_t>(3 * t), 3,
                mesh.corners.begin() + static_cast<std::ptrdiff_t>(3 * kept));
    mesh.polygon[kept++] = mesh.polygon[t];
  }
  mesh.corners.resize(3 * kept);
  mesh.polygon.resize(kept);
  mesh.report.dropped_duplicates += static_cast<int>(numbers.size());
  table = make_edge_table(mesh.corners, mesh.polygon, mesh.report.vertices);
}

/// Assigns triangles to bodies. Where two of these touch, each may have a face with the same vertices; other twins are
/// dropped. Without these, more of them may be in one body.
void divide_into_bodies(Mesh& mesh, const Soup& soup, EdgeTable& table, std::vector<TwinFaces> twins) {
  constexpr int max_rounds = 4;
  mesh.body = bodies_of(mesh, soup, table);
  for (int round = 1; !twins.empty(); ++round) {
    std::vector<int> dropped = duplicates_among(mesh, table, twins);
    if (dropped.empty()) return;
    if (round == max_rounds) {
      dropped.clear();
      for (const TwinFaces& pair : twins) dropped.push_back(pair.second);
      std::sort(dropped.begin(), dropped.end());
    }
    drop_faces_of(mesh, table, dropped);
    const auto is_dropped = [&](int face) { return std::binary_search(dropped.begin(), dropped.end(), face); };
    std::erase_if(twins, [&](const TwinFaces& pair) { return is_dropped(pair.first) || is_dropped(pair.second); });
    mesh.body = bodies_of(mesh, soup, table);
  }
}

void number_bodies(Mesh& mesh, const Soup& soup) {
  const bool named = soup.body_names.size() > 1;
  if (!named) {
    if (!soup.body_names.empty()) mesh.report.only_body = soup.body_names.front();
    mesh.report.body_colours = soup.body_colours;
  } else {
    for (const int body : renumber_labels(mesh.body)) {
      mesh.report.body_names.push_back(soup.body_names[body]);
      if (!soup.body_colours.empty()) mesh.report.body_colours.push_back(soup.body_colours[body]);
    }
  }
  const auto last = std::max_element(mesh.body.begin(), mesh.body.end());
  mesh.report.bodies = last == mesh.body.end() ? 0 : *last + 1;
}

}  // namespace

Mesh build_mesh(Soup soup, std::string name, const Progress& progress, std::optional<double> step) {
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
  // Doubles in memory are what their program computed.
  const bool is_written = soup.printed || soup.single_precision;
  report.resolution = step ? *step : is_written ? resolution_of(soup.points, !soup.printed) : 0;
  auto [triangles, table, twins] = usable_triangles(soup, report, progress);

  progress.expect_time();
  const PointMarks marks = add_crosses(soup, report.name);
  report.points = marks.points;
  report.point_arms = marks.arms;
  mesh.points = std::move(soup.points);
  mesh.corners = std::move(triangles.corners);
  mesh.polygon = std::move(triangles.number);
  divide_into_bodies(mesh, soup, table, std::move(twins));
  report.faces = count_faces(mesh);
  report.triangles = mesh.triangle_count();
  note_triangles_without_area(mesh);
  number_bodies(mesh, soup);
  count_edges(mesh, table);
  take_wires(mesh, soup, table, report);

  set_edges(mesh, std::move(table));
  return mesh;
}

}  // namespace epura::mesh
