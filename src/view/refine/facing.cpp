// SPDX-License-Identifier: Apache-2.0
#include "refine/facing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "refine/contour_plane.hpp"
#include "refine/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::refine {

namespace {

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// How the triangles of a polygon of the file, or of a face of the part, turn.
struct Turn {
  double outwards = 0;  ///< positive if its triangles turn counterclockwise seen from outside of their surface
  double area = 0;      ///< twice its area
  double longest = 0;   ///< side of a triangle

  void add(const std::array<Vec3, 3>& p, const Vec3& out) {
    const Vec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
    outwards += glm::dot(across, out);
    area += glm::length(across);
    longest = std::max({longest, glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  }
  /// Whether rounding does not decide how it turns.
  [[nodiscard]] bool is_told(double tolerance) const {
    return area > told_from * tolerance * longest && std::abs(outwards) >= min_agreement * area;
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
    if (faces[t] < 0) continue;
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

// Whether the viewer sees a triangle turn the other way than its surface, and not by rounding: chords lie below the
// surface, so what is in front of a contour may be seen beyond it.
bool is_folded(const mesh::Mesh& mesh, int triangle, const surfaces::PartSurface& surface, int side,
               const Viewer& viewer, double tolerance) {
  const auto [a, b, c] = mesh.triangle(triangle);
  const std::array<Vec3, 3> corners{mesh.point(a), mesh.point(b), mesh.point(c)};
  Turn own, seen;
  own.add(corners, surfaces::normal_near(surface, corners[0]));
  seen.add(corners, viewer.seen_from(corners[0]));
  return side * seen.outwards < 0 && own.is_told(tolerance);
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
  std::vector<signed char> facing(faces.size(), 0);
  for (std::size_t t = 0; t < facing.size(); ++t) {
    if (faces[t] < 0) continue;
    const auto face = static_cast<std::size_t>(faces[t]);
    if (!planes[face]) continue;
    // Where all triangles are joined in one sense, one that turns against its face is folded over.
    const Turn& polygon = turns.of_polygon[static_cast<std::size_t>(mesh.polygon[t])];
    const bool decides = mesh.report.misoriented_edges > 0 && polygon.is_told(part.tolerance);
    const Turn& turn = decides ? polygon : turns.of_face[face];
    const int side = sign_of(turn.outwards) * side_of(*planes[face], mesh, static_cast<int>(t));
    if (!is_folded(mesh, static_cast<int>(t), part.faces[face].surface, side, viewer, part.tolerance))
      facing[t] = static_cast<signed char>(mirrored * side);
  }
  return facing;
}

}  // namespace epura::refine
