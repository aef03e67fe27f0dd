// SPDX-License-Identifier: Apache-2.0
#include "refine/facing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "refine/contour_plane.hpp"
#include "refine/limits.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::refine {

namespace {

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// How the triangles of a polygon of the file, or of a face of the part, turn.
struct Turn {
  double outwards = 0;  ///< positive if its triangles turn counterclockwise seen from outside of their surface
  double area = 0;      ///< twice its area
  double longest = 0;   ///< side of a triangle
  Vec3 across{0};       ///< twice its vector area

  void add(const std::array<Vec3, 3>& p, const Vec3& out) {
    const Vec3 own = glm::cross(p[1] - p[0], p[2] - p[0]);
    across += own;
    outwards += glm::dot(own, out);
    area += glm::length(own);
    longest = std::max({longest, glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  }
  /// Whether rounding does not decide how it turns.
  [[nodiscard]] bool is_told(double tolerance) const {
    return area > told_from * tolerance * longest && std::abs(outwards) >= surfaces::min_facing * area;
  }
};

struct Turns {
  std::vector<Turn> of_polygon, of_face;
};

Turns turns_of(const mesh::Mesh& mesh, const surfaces::PartFaces& part, const std::vector<int>& faces) {
  Turns turns;
  turns.of_face.resize(part.faces.size());
  for (std::size_t t = 0; t < mesh.polygon.size(); ++t) {
    const auto number = static_cast<std::size_t>(mesh.polygon[t]);
    if (number >= turns.of_polygon.size()) turns.of_polygon.resize(number + 1);
    const auto [a, b, c] = mesh.triangle(static_cast<int>(t));
    const std::array<Vec3, 3> corners{mesh.point(a), mesh.point(b), mesh.point(c)};
    if (faces[t] < 0) {
      turns.of_polygon[number].add(corners, Vec3(0));
      continue;
    }
    const auto face = static_cast<std::size_t>(faces[t]);
    const surfaces::PartSurface& surface = part.faces[face].surface;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3 out = has_contour_plane(surface.kind) ? surfaces::normal_near(surface, middle) : Vec3(0);
    turns.of_polygon[number].add(corners, out);
    turns.of_face[face].add(corners, out);
  }
  return turns;
}

// The side of a contour plane on which a triangle lies: that of its farthest corner.
int side_of(const ContourPlane& plane, const mesh::Mesh& mesh, int triangle) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const int v : mesh.triangle(triangle)) {
    low = std::min(low, plane.height(mesh.point(v)));
    high = std::max(high, plane.height(mesh.point(v)));
  }
  return sign_of(low + high);
}

// Which way the viewer sees a triangle of a model turn: 1 counterclockwise, -1 clockwise.
int seen_turn(const mesh::Mesh& mesh, int triangle, const Viewer& viewer) {
  const auto [a, b, c] = mesh.triangle(triangle);
  const Vec3 p = mesh.point(a);
  return sign_of(glm::dot(glm::cross(mesh.point(b) - p, mesh.point(c) - p), viewer.seen_from(p)));
}

// Lets the page tell how triangles turn that are folded over a contour: chords lie below the surface, so that a corner
// in front of the contour may be seen beyond it. One that is folded within its face is turned over by its tessellation.
void unfold(const mesh::Mesh& mesh, std::vector<int> folded, const auto& seen, std::vector<signed char>& facing) {
  const auto is_at_contour = [&](int triangle) {
    const std::array<int, 3> corners = mesh.triangle(triangle);
    const int told = facing[static_cast<std::size_t>(triangle)];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      for (const int other : mesh.triangles_of(*mesh.edge_between({low, high}))) {
        const int beyond = facing[static_cast<std::size_t>(other)];
        if ((beyond != 0 ? beyond : seen(other)) == -told) return true;
      }
    }
    return false;
  };
  for (std::size_t count = folded.size() + 1; count != folded.size();) {
    count = folded.size();
    std::erase_if(folded, [&](int triangle) {
      const bool is_at = is_at_contour(triangle);
      if (is_at) facing[static_cast<std::size_t>(triangle)] = 0;
      return is_at;
    });
  }
}

}  // namespace

std::vector<signed char> facing_by_surface(const world::Placed& placed, const projection::Projection& projection) {
  const auto is_told = [](const surfaces::PartFace& face) { return has_contour_plane(face.surface.kind); };
  if (placed.part == nullptr || std::ranges::none_of(placed.part->faces, is_told)) return {};
  const mesh::Mesh& mesh = *placed.mesh;
  const surfaces::PartFaces& part = *placed.part;
  const std::vector<int> faces = world::faces_of_triangles(placed);
  const Viewer viewer = viewer_of(placed, projection);
  std::vector<std::optional<ContourPlane>> planes;
  for (const surfaces::PartFace& face : part.faces) planes.push_back(contour_plane(face.surface, viewer));
  const Turns turns = turns_of(mesh, part, faces);
  const int mirrored = glm::determinant(Mat3(placed.to_world)) < 0 ? -1 : 1;
  const auto seen = [&](int triangle) { return mirrored * seen_turn(mesh, triangle, viewer); };
  std::vector<signed char> facing(faces.size(), 0);
  std::vector<int> folded;
  for (std::size_t t = 0; t < facing.size(); ++t) {
    if (faces[t] < 0) {
      const Vec3 corner = mesh.point(mesh.triangle(static_cast<int>(t))[0]);
      // A contour that ends at a cut may fold a triangle of that over.
      const Vec3& across = turns.of_polygon[static_cast<std::size_t>(mesh.polygon[t])].across;
      facing[t] = static_cast<signed char>(mirrored * sign_of(glm::dot(across, viewer.seen_from(corner))));
      continue;
    }
    const auto face = static_cast<std::size_t>(faces[t]);
    if (!planes[face]) continue;
    // Where all triangles are joined in one sense, one that turns against its face is folded over.
    const Turn& polygon = turns.of_polygon[static_cast<std::size_t>(mesh.polygon[t])];
    const bool decides = mesh.report.misoriented_edges > 0 && polygon.is_told(part.tolerance);
    const Turn& turn = decides ? polygon : turns.of_face[face];
    const int side = side_of(*planes[face], mesh, static_cast<int>(t));
    facing[t] = static_cast<signed char>(mirrored * sign_of(turn.outwards) * side);
    if (facing[t] * seen(static_cast<int>(t)) < 0 && polygon.is_told(part.tolerance))
      folded.push_back(static_cast<int>(t));
  }
  unfold(mesh, std::move(folded), seen, facing);
  return facing;
}

}  // namespace epura::refine
