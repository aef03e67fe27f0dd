// SPDX-License-Identifier: Apache-2.0
#include "mesh/contact_faces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edge_table.hpp"

namespace epura::mesh {

namespace {

// Triangles of the faces that were there twice, ascending.
std::vector<int> twin_triangles(const Mesh& mesh, const std::vector<TwinFaces>& twins) {
  std::vector<int> faces;
  for (const TwinFaces& twin : twins) faces.push_back(twin.kept);
  std::sort(faces.begin(), faces.end());
  std::vector<int> triangles;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (std::binary_search(faces.begin(), faces.end(), mesh.polygon[t])) triangles.push_back(t);
  return triangles;
}

/// A mesh with some triangles twice, the second ones at its end.
struct DoubledMesh {
  Mesh mesh;
  EdgeTable table;
};

DoubledMesh doubled_mesh(const Mesh& mesh, const std::vector<int>& twice) {
  DoubledMesh doubled;
  doubled.mesh.points = mesh.points;
  doubled.mesh.corners = mesh.corners;
  doubled.mesh.polygon = mesh.polygon;
  for (const int t : twice) {
    const auto [a, b, c] = mesh.triangle(t);
    doubled.mesh.corners.insert(doubled.mesh.corners.end(), {a, c, b});
    doubled.mesh.polygon.push_back(mesh.polygon[t]);
  }
  doubled.table = make_edge_table(doubled.mesh.corners, doubled.mesh.polygon, mesh.report.vertices);
  doubled.mesh.body = connected_parts(doubled.mesh, doubled.table);
  return doubled;
}

// The bodies that have an edge of a doubled triangle at which not just two of their triangles meet.
std::set<int> badly_closed(const DoubledMesh& doubled, int first_double) {
  std::set<int> found;
  for (const MeshEdge& edge : doubled.table.edges) {
    const auto halfedges = doubled.table.halfedges_of(edge);
    const auto is_double = [&](int halfedge) { return halfedge / 3 >= first_double; };
    if (std::none_of(halfedges.begin(), halfedges.end(), is_double)) continue;
    std::vector<int> bodies;
    for (const int halfedge : halfedges) bodies.push_back(doubled.mesh.body[halfedge / 3]);
    for (const int body : bodies)
      if (std::count(bodies.begin(), bodies.end(), body) != 2) found.insert(body);
  }
  return found;
}

// Those at which two closed bodies touch. Both have other triangles: all of a copy of a body is there twice.
std::vector<int> contacts_of(const DoubledMesh& doubled, const std::vector<int>& twice) {
  const int first = doubled.mesh.triangle_count() - static_cast<int>(twice.size());
  const std::set<int> bad = badly_closed(doubled, first);
  std::set<int> has_more;
  for (int t = 0; t < first; ++t)
    if (!std::binary_search(twice.begin(), twice.end(), t)) has_more.insert(doubled.mesh.body[t]);
  const auto is_good = [&](int body) { return !bad.contains(body) && has_more.contains(body); };
  std::vector<int> contacts;
  for (std::size_t i = 0; i < twice.size(); ++i) {
    const int one = doubled.mesh.body[twice[i]], other = doubled.mesh.body[static_cast<std::size_t>(first) + i];
    if (one != other && is_good(one) && is_good(other)) contacts.push_back(twice[i]);
  }
  return contacts;
}

// Of the two triangles at one place, the one that is kept belongs to the body whose other triangles turn like it.
void turn_like_neighbours(DoubledMesh& doubled, const std::vector<int>& twice) {
  const std::vector<int>& corners = doubled.mesh.corners;
  std::vector<int>& body = doubled.mesh.body;
  const int first = doubled.mesh.triangle_count() - static_cast<int>(twice.size());
  std::map<std::array<int, 2>, int> votes;  // by bodies of the kept one and of the other one
  for (const MeshEdge& edge : doubled.table.edges)
    for (const int one : doubled.table.halfedges_of(edge)) {
      const auto at = std::lower_bound(twice.begin(), twice.end(), one / 3);
      if (at == twice.end() || *at != one / 3) continue;
      const int other_body = body[static_cast<std::size_t>(first + (at - twice.begin()))];
      for (const int other : doubled.table.halfedges_of(edge)) {
        const bool is_beside = other / 3 < first && !std::binary_search(twice.begin(), twice.end(), other / 3);
        if (is_beside && body[other / 3] == body[one / 3])
          votes[{body[one / 3], other_body}] += corners[one] != corners[other] ? 1 : -1;
      }
    }
  for (std::size_t i = 0; i < twice.size(); ++i) {
    int &one = body[twice[i]], &other = body[static_cast<std::size_t>(first) + i];
    if (votes[{one, other}] < 0) std::swap(one, other);
  }
}

}  // namespace

bool divide_at_contacts(Mesh& mesh, const std::vector<TwinFaces>& twins) {
  std::vector<int> twice = twin_triangles(mesh, twins);
  while (!twice.empty()) {
    DoubledMesh doubled = doubled_mesh(mesh, twice);
    std::vector<int> contacts = contacts_of(doubled, twice);
    if (contacts.size() < twice.size()) {
      // Without the others, some of these may not be contacts, either.
      twice = std::move(contacts);
      continue;
    }
    turn_like_neighbours(doubled, twice);
    const auto first = static_cast<std::size_t>(mesh.triangle_count());
    for (std::size_t i = 0; i < twice.size(); ++i) mesh.contacts.push_back({twice[i], doubled.mesh.body[first + i]});
    doubled.mesh.body.resize(first);
    mesh.body = std::move(doubled.mesh.body);
    check(!mesh.contacts.empty(), "touching bodies have a face in common");
    return true;
  }
  return false;
}

std::optional<int> body_behind(const Mesh& mesh, int triangle) {
  const auto before = [](const ContactTriangle& contact, int number) { return contact.triangle < number; };
  const auto found = std::lower_bound(mesh.contacts.begin(), mesh.contacts.end(), triangle, before);
  return found != mesh.contacts.end() && found->triangle == triangle ? std::optional(found->body) : std::nullopt;
}

}  // namespace epura::mesh
