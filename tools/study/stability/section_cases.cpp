// SPDX-License-Identifier: Apache-2.0
// Cutting planes.
#include <algorithm>
#include <cmath>
#include <vector>

#include "cut/cut_world.hpp"
#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

struct Face {
  std::vector<Vec3> ring;
  Vec3 normal;  ///< outward
};

/// A side of a convex body between two of its faces: visible if one of these is.
struct Side {
  Vec3 from, to;
  Vec3 normal, other_normal;
};

struct ConvexBody {
  std::vector<Face> faces;
  std::vector<Side> sides;
};

ConvexBody regular_prism(int corners, double height) {
  const auto corner = [&](int i, double z) {
    const double a = 2 * M_PI * (i % corners) / corners;
    return Vec3(std::cos(a), std::sin(a), z);
  };
  ConvexBody body;
  Face top{{}, {0, 0, 1}}, bottom{{}, {0, 0, -1}};
  for (int i = 0; i < corners; ++i) {
    top.ring.push_back(corner(i, height));
    bottom.ring.push_back(corner(corners - i, 0));
    const double middle = M_PI * (2 * i + 1) / corners, before = middle - 2 * M_PI / corners;
    const Vec3 normal(std::cos(middle), std::sin(middle), 0), last(std::cos(before), std::sin(before), 0);
    const std::vector<Vec3> ring{corner(i, 0), corner(i + 1, 0), corner(i + 1, height), corner(i, height)};
    body.faces.push_back({ring, normal});
    body.sides.push_back({ring[0], ring[1], normal, bottom.normal});
    body.sides.push_back({ring[2], ring[3], normal, top.normal});
    body.sides.push_back({ring[3], ring[0], normal, last});
  }
  body.faces.push_back(top);
  body.faces.push_back(bottom);
  return body;
}

// Each face as a fan of triangles around its first corner, including the caps around one corner of the body.
Shape fans_of(const ConvexBody& body) {
  Shape shape;
  for (const Face& face : body.faces) {
    const int first = static_cast<int>(shape.points.size()), count = static_cast<int>(face.ring.size());
    for (const Vec3& p : face.ring) shape.points.push_back({p.x, p.y, p.z});
    for (int i = 2; i < count; ++i) shape.faces.push_back({first, first + i - 1, first + i});
  }
  return shape;
}

// The sides of the part of a body that a plane leaves.
std::vector<Side> cut_sides(const ConvexBody& body, const scene::CuttingPlane& plane) {
  const auto distance = [&](const Vec3& p) { return glm::dot(plane.normal, p - plane.point); };
  const auto meet = [&](const Vec3& a, const Vec3& b) {
    return a + distance(a) / (distance(a) - distance(b)) * (b - a);
  };
  std::vector<Side> left;
  for (Side side : body.sides) {
    const double from = distance(side.from), to = distance(side.to);
    if (from >= 0 && to >= 0) continue;
    if (from > 0) side.from = meet(side.from, side.to);
    if (to > 0) side.to = meet(side.from, side.to);
    left.push_back(side);
  }
  for (const auto& [ring, normal] : body.faces) {
    std::vector<Vec3> met;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((distance(a) < 0) != (distance(b) < 0)) met.push_back(meet(a, b));
    }
    if (met.size() == 2) left.push_back({met[0], met[1], normal, plane.normal});
  }
  return left;
}

// The plane passes a corner of a prism, which is also the hub of the fan of its cap, closely on either side, and cuts
// that fan into thin triangles, the closer the thinner. No edge lies along it: all lengths change continuously with the
// distance.
Measured cut_beside_a_vertex(const Lab& lab, double distance) {
  const ConvexBody body = regular_prism(11, 3);
  const world::World world = lab.world_of(fans_of(body));
  const Vec3 viewer = glm::normalize(Vec3(1, -1, 1)), normal = glm::normalize(Vec3(0.21, -0.9, 0.37));
  Measured measured;
  for (const double side : {-distance, distance}) {
    const scene::CuttingPlane plane =
        scene::make_cutting_plane({{"A", "study"}, Vec3(1, 0, 3) + side * normal, normal});
    double seen = 0, hidden = 0;
    for (const Side& edge : cut_sides(body, plane)) {
      const bool is_seen = glm::dot(edge.normal, viewer) > 0 || glm::dot(edge.other_normal, viewer) > 0;
      (is_seen ? seen : hidden) += glm::length(glm::cross(edge.to - edge.from, viewer));
    }
    append(measured, lengths(lab.draw(cut::cut_world(world, plane).world, {orthographic(viewer)}), seen, hidden));
  }
  return measured;
}

double area_of(const cut::CutWorld& cut) {
  double area = 0;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const std::vector<int>& ring : face.rings) {
      const mesh::Mesh& mesh = *cut.world.models[static_cast<std::size_t>(face.model)].mesh;
      Vec3 sum(0);
      for (std::size_t i = 0; i < ring.size(); ++i)
        sum += glm::cross(mesh.point(ring[i]), mesh.point(ring[(i + 1) % ring.size()]));
      area += glm::length(sum) / 2;
    }
  return area;
}

cut::CutWorld cut(const world::World& world, const Vec3& point, const Vec3& normal) {
  return cut::cut_world(world, scene::make_cutting_plane({{"A", "study"}, point, normal}));
}

// What is left of a unit cube is either nearly all of it, or a sheet as thin as the distance, whose upper and lower
// sides coincide from above.
Measured cut_beside_a_face(const Lab& lab, double distance) {
  const world::World world = lab.world_of(box({0, 0, 0}, {1, 1, 1}));
  Measured measured;
  for (const double side : {1.0, -1.0}) {
    const cut::CutWorld left = cut(world, {0, 0, 1 - distance}, {0, 0, side});
    measured.push_back(length("area of the cut", 1, area_of(left), 1));
    append(measured, lengths(lab.draw(left.world, {from_above()}), 4, 0));
  }
  return measured;
}

// Half of the upper face is cut off, in a wedge.
Measured cut_at_an_angle_to_a_face(const Lab& lab, double degrees) {
  const double a = degrees * M_PI / 180;
  const world::World world = lab.world_of(box({0, 0, 0}, {1, 1, 1}));
  const cut::CutWorld left = cut(world, {0.5, 0, 1}, {std::sin(a), 0, std::cos(a)});
  return {length("area of the cut", 0.5 / std::cos(a), area_of(left), 1),
          length("visible", 5, lab.draw(left.world, {from_above()}).visible(), 1)};
}

// The outline of the cut lies on the ball and in the plane, although facets lie inside.
Measured cut_near_a_pole(const Lab& /*lab*/, double distance) {
  const world::World world = recognised(world_of(uv_sphere(64, 32)));
  const Vec3 normal = glm::normalize(Vec3(0.3, -0.5, 0.8));
  const cut::CutWorld left = cut(world, (1 - distance) * normal, normal);
  double off = left.faces.empty() ? NAN : 0;
  for (const cut::WorldCutFace& face : left.faces)
    for (const std::vector<int>& ring : face.rings)
      for (const int v : ring) {
        const Vec3 p = left.world.models[0].mesh->point(v);
        off = std::max({off, std::abs(glm::length(p) - 1), std::abs(glm::dot(p, normal) - (1 - distance))});
      }
  return {length("outline", 0, off, 1)};
}

}  // namespace

std::vector<Case> section_cases() {
  return {{"M37",
           "prism cut beside a vertex",
           "distance of the plane from the vertex",
           {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 0},
           cut_beside_a_vertex},
          {"S1",
           "cube cut beside a face",
           "distance of the plane from the face",
           {0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12},
           cut_beside_a_face},
          {"S2",
           "cube cut at a small angle to a face",
           "degrees",
           {30, 10, 1, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10},
           cut_at_an_angle_to_a_face},
          {"S3",
           "ball cut near a pole",
           "distance of the plane from the pole",
           {0.9, 0.5, 0.3, 0.1, 0.05, 0.02, 0.01, 0.003},
           cut_near_a_pole}};
}

}  // namespace epura::stability
