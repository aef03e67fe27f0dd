// SPDX-License-Identifier: Apache-2.0
// Meshes that are split along the contours of their cylinders and cones, against the formulas of these contours.
#include "refine/refine_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/nearest.hpp"
#include "cut/cut_world.hpp"
#include "scene/cutting_plane.hpp"
#include "shapes.hpp"

namespace epura::test::refine_world_test {
namespace {

using refine::refine_world;

constexpr double degree = std::numbers::pi / 180;

Result draw_refined(world::World world, const projection::Projection& view) {
  std::optional<world::World> refined = refine_world(world, view);
  return draw(refined ? std::move(*refined) : std::move(world), view);
}

Vec3 tilted(double degrees, double turn) {
  return {std::sin(degrees * degree) * std::cos(turn * degree), std::sin(degrees * degree) * std::sin(turn * degree),
          std::cos(degrees * degree)};
}

// A frustum about z with these radii at the heights 0 and 30.
constexpr double height = 30;
world::World frustum_world(double radius, double top, int sides) {
  return recognised(world_of(frustum(radius, top, height, sides)));
}

/// The frustum's own n . (towards the viewer), times a positive factor.
struct Formula {
  double radius, top;

  [[nodiscard]] double facing(const Vec3& p, const projection::Projection& view) const {
    const double slope = (top - radius) / height, out = std::hypot(p.x, p.y);
    const Vec3 normal(p.x / out, p.y / out, -slope);
    const Vec3 to = view.central ? view.projector - p : view.projector;
    return glm::dot(normal, glm::normalize(to)) / glm::length(normal);
  }
  [[nodiscard]] double off(const Vec3& p) const {
    return std::abs(std::hypot(p.x, p.y) - (radius + (top - radius) * p.z / height));
  }
};

// The angle of a contour beside the direction across the axis to the viewer, by the formula for parallel projectors.
double contour_angle(double radius, double top, const Vec3& towards) {
  const double slope = (top - radius) / height;
  return std::acos(slope * towards.z / std::hypot(towards.x, towards.y));
}

// Every contour segment of the drawing of one frustum, and how long they are in all.
double length_of_contours(const Result& drawn, bool visible) {
  double length = 0;
  for (const drawing::Segment& s : drawn.drawing.segments)
    if (s.kind == EdgeKind::contour && s.visible == visible && s.crossing >= 0) length += glm::distance(s.from, s.to);
  return length * drawn.unit;
}

void expect_closed(const mesh::Mesh& mesh) {
  for (const mesh::MeshEdge& edge : mesh.edges) EXPECT_EQ(edge.count, 2);
}

// No facet of a round face reaches across the contour, and new vertices lie on the surface.
void expect_split(const world::World& world, const Formula& formula, const projection::Projection& view) {
  const world::Placed& placed = world.models.front();
  const mesh::Mesh& mesh = *placed.mesh;
  expect_closed(mesh);
  for (std::size_t v = static_cast<std::size_t>(mesh.first_cut_vertex); v < mesh.points.size(); ++v) {
    const Vec3 p = mesh.point(static_cast<int>(v));
    EXPECT_LT(formula.off(p), 1e-9);
    EXPECT_NEAR(formula.facing(p, view), 0, 1e-9);
    EXPECT_GE(p.z, -1e-9);
    EXPECT_LE(p.z, height + 1e-9);
  }
  // A hundredth of what a corner may be beside the plane of the contours.
  double slack = 0;
  const auto beside = [&](int v) {
    return formula.facing(mesh.point(v), view) * std::hypot(mesh.point(v).x, mesh.point(v).y);
  };
  for (const int v : mesh.corners) slack = std::max(slack, 0.01 * std::abs(beside(v)));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int face = placed.part->face_of_triangle[static_cast<std::size_t>(t)];
    if (placed.part->faces[static_cast<std::size_t>(face)].surface.kind == surfaces::SurfaceKind::plane) continue;
    double low = 0, high = 0;
    for (const int v : mesh.triangle(t)) {
      low = std::min(low, beside(v));
      high = std::max(high, beside(v));
    }
    EXPECT_LE(std::min(-low, high), slack) << t;
  }
}

// The corners of a triangle and of those beside it, whichever number these have.
std::vector<std::array<int, 3>> surroundings(const mesh::Mesh& mesh, int triangle) {
  const auto sorted = [&](int t) {
    std::array<int, 3> corners = mesh.triangle(t);
    std::ranges::sort(corners);
    return corners;
  };
  std::vector<std::array<int, 3>> found;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const auto there = mesh.triangles_of(edge);
    if (std::ranges::count(there, triangle) > 0)
      for (const int t : there) found.push_back(sorted(t));
  }
  std::ranges::sort(found);
  return found;
}

TEST(RefineWorld, TellsWhichTrianglesStayAsTheyAre) {
  const world::World world =
      recognised(world_of(std::vector<Shape>{box({30, 0, 0}, {1, 2, 3}), frustum(10, 6, height, 24)}));
  const auto refined = refine_world(world, orthographic(tilted(60, 10)));
  ASSERT_TRUE(refined);
  ASSERT_EQ(refined->kept.size(), refined->triangles.size());
  std::vector<int> times(world.triangles.size(), 0);
  for (std::size_t t = 0; t < refined->kept.size(); ++t) {
    const int before = refined->kept[t];
    if (before < 0) continue;
    ++times[static_cast<std::size_t>(before)];
    const int model = world.model_of_triangle(before);
    EXPECT_EQ(surroundings(*refined->models[model].mesh, static_cast<int>(t) - refined->first_triangle[model]),
              surroundings(*world.models[model].mesh, before - world.first_triangle[model]));
  }
  EXPECT_EQ(std::ranges::count(times, 2), 0);
  EXPECT_EQ(std::count(times.begin(), times.begin() + world.first_triangle[1], 1), world.first_triangle[1]);
  // At each of two contours, two facets and those beside them; at both ends of it, one of the plane and two beside it.
  EXPECT_EQ(std::ranges::count(times, 0), 2 * (4 + 2 * 3));
}

TEST(RefineWorld, SplitsFrustumsAlongTheirContours) {
  for (const double top : {10.0, 6.0, 1.0})
    for (const int sides : {12, 17, 48})
      for (const double tilt : {35.0, 60.0, 75.0, 90.0, 110.0}) {
        const projection::Projection view = orthographic(tilted(tilt, 21));
        const auto refined = refine_world(frustum_world(10, top, sides), view);
        ASSERT_TRUE(refined) << top << " " << sides << " " << tilt;
        expect_split(*refined, {10, top}, view);
      }
}

TEST(RefineWorld, SplitsFrustumsInPerspective) {
  for (const double top : {10.0, 6.0})
    for (const Vec3 eye : {Vec3(40, 25, 50), Vec3(15, 3, 10), Vec3(100, -70, -40)}) {
      const projection::Projection view = perspective(eye, {0, 0, 15}, glm::normalize(eye - Vec3(0, 0, 15)), {0, 0, 1});
      const auto refined = refine_world(frustum_world(10, top, 19), view);
      ASSERT_TRUE(refined);
      expect_split(*refined, {10, top}, view);
    }
}

// Along the axis there is no contour; a plane and a ball have none of this kind.
TEST(RefineWorld, LeavesWhatHasNoContour) {
  EXPECT_FALSE(refine_world(frustum_world(10, 10, 24), orthographic({0, 0, 1}, {0, 1, 0})));
  EXPECT_FALSE(refine_world(frustum_world(10, 6, 24), orthographic({0, 0, 1}, {0, 1, 0})));
  EXPECT_FALSE(refine_world(recognised(world_of(box({0, 0, 0}, {1, 2, 3}))), orthographic({1, 2, 3})));
  EXPECT_FALSE(refine_world(world_of(frustum(10, 10, height, 24)), orthographic({1, 2, 3})));
}

// A contour that passes a corner within a hundredth of a facet passes through it.
TEST(RefineWorld, AddsNoNeedlesAtCorners) {
  const int sides = 24;
  EXPECT_FALSE(refine_world(frustum_world(10, 10, sides), orthographic(tilted(60, 0))));
  EXPECT_FALSE(refine_world(frustum_world(10, 10, sides), orthographic(tilted(60, 0.005 * 360 / sides))));
  EXPECT_TRUE(refine_world(frustum_world(10, 10, sides), orthographic(tilted(60, 0.02 * 360 / sides))));
}

// A vertex off the surface by a little, which stands out over the contour beside it, would hide it: it is the contour.
TEST(RefineWorld, ContoursPassThroughVerticesThatStandOut) {
  for (const double off : {0.0, 2e-5}) {
    Shape shape = frustum(10, 10, height, 48);
    double& x = shape.points[48][0];
    x += off;
    const projection::Projection view = orthographic(tilted(60, 90 - 0.014 * 360 / 48));
    const Result drawn = draw_refined(recognised(world_of(shape)), view);
    double visible = 0;
    for (const drawing::Segment& s : drawn.drawing.segments)
      if (s.kind == EdgeKind::contour && s.visible && std::abs(s.from.x - s.to.x) < 1e-4 * std::abs(s.from.y - s.to.y))
        visible += glm::distance(s.from, s.to) * drawn.unit;
    EXPECT_NEAR(visible, 2 * height * std::sin(60 * degree), 0.05) << off;
    EXPECT_NEAR(length_of_contours(drawn, false), 0, 0.05) << off;
  }
}

Vec2 on_page(const Result& drawn, const Vec3& point) {
  const Vec4 page = drawn.drawing.world_to_page * Vec4(point, 1);
  return Vec2(page) / page.w;
}

using Polygons = std::vector<std::vector<Vec3>>;

// What is left of a convex body in front of a plane: normal . p < offset.
Polygons clipped(const Polygons& body, const Vec3& normal, double offset) {
  Polygons left;
  std::vector<Vec3> cap;
  for (const std::vector<Vec3>& face : body) {
    std::vector<Vec3> part;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 p = face[i], q = face[(i + 1) % face.size()];
      const double from = offset - glm::dot(normal, p), to = offset - glm::dot(normal, q);
      if (from > 0) part.push_back(p);
      if (from * to < 0) cap.push_back(part.emplace_back(p + from / (from - to) * (q - p)));
    }
    if (!part.empty()) left.push_back(part);
  }
  Vec3 middle(0);
  for (const Vec3& p : cap) middle += p / static_cast<double>(cap.size());
  const Vec3 one = glm::normalize(cap.at(0) - middle), other = glm::cross(normal, one);
  std::ranges::sort(cap, {}, [&](const Vec3& p) { return std::atan2(glm::dot(p - middle, other), glm::dot(p, one)); });
  std::vector<Vec3> rim;  // each point is that of two faces
  for (const Vec3& p : cap)
    if (rim.empty() || glm::distance(rim.back(), p) > 1e-9) rim.push_back(p);
  if (glm::distance(rim.front(), rim.back()) < 1e-9) rim.pop_back();
  left.push_back(rim);
  return left;
}

// A hexagon, 10 from its middle to its flats, whose upper corners are cut off by a cone of facets: where they meet the
// flats, vertices lie on chords.
Polygons chamfered_hexagon(int sides) {
  const Shape cone = frustum(14, 9.5, 2.6, sides);
  Polygons body;
  for (const std::vector<int>& face : cone.faces)
    for (body.emplace_back(); const int v : face) {
      const Point& p = cone.points[static_cast<std::size_t>(v)];
      body.back().emplace_back(p[0], p[1], p[2]);
    }
  for (int i = 0; i < 6; ++i) {
    const double turn = (30.01 + 60 * i) * degree;  // no generator meets a corner
    body = clipped(body, {std::cos(turn), std::sin(turn), 0}, 10);
  }
  return body;
}

Shape shape_of(const Polygons& body) {
  Shape shape;
  for (const std::vector<Vec3>& face : body)
    for (shape.faces.emplace_back(); const Vec3& p : face) {
      const auto same = std::ranges::find_if(
          shape.points, [&](const Point& q) { return glm::distance(Vec3(q[0], q[1], q[2]), p) < 1e-9; });
      shape.faces.back().push_back(static_cast<int>(same - shape.points.begin()));
      if (same == shape.points.end()) shape.points.push_back({p.x, p.y, p.z});
    }
  return shape;
}

// Everywhere on the outline of a convex body there is ink: where one face is seen from outside and the next is not.
TEST(RefineWorld, LeavesNoGapsInOutlinesOfFacetsOnChords) {
  for (const int sides : {32, 48, 64}) {
    const Shape shape = shape_of(chamfered_hexagon(sides));
    const auto at = [&](int v) {
      const Point& p = shape.points[static_cast<std::size_t>(v)];
      return Vec3(p[0], p[1], p[2]);
    };
    for (int i = 0; i < 24; ++i) {
      const Vec3 towards = tilted(50 + i, 17 * i);
      std::map<std::array<int, 2>, int> seen;  // by directed side: whether its face is seen
      for (const std::vector<int>& face : shape.faces)
        for (std::size_t i = 0; i < face.size(); ++i)
          seen[{face[i], face[(i + 1) % face.size()]}] =
              glm::dot(glm::cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0])), towards) > 0 ? 1 : 0;
      const projection::Projection view = orthographic(towards);
      const world::World world = recognised(world_of(shape));
      ASSERT_EQ(world.models[0].part->faces.size(), 9U);
      const Result drawn = draw_refined(world, view);
      double farthest = 0;
      for (const auto& [side, is_seen] : seen) {
        if (is_seen == 0 || seen.at({side[1], side[0]}) == 1) continue;
        for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
          const Vec2 place = on_page(drawn, at(side[0]) + t * (at(side[1]) - at(side[0])));
          double nearest = HUGE_VAL;
          for (const drawing::Segment& s : drawn.drawing.segments)
            if (s.visible) nearest = std::min(nearest, distance_to_segment(place, s.from, s.to) * drawn.unit);
          farthest = std::max(farthest, nearest);
        }
      }
      EXPECT_LT(farthest, 0.06) << sides << " sides, view " << i;
    }
  }
}

// A plane through both contours of a cylinder: what is left of them ends on the surface, and in the plane to within
// what the surface rises over a facet.
TEST(RefineWorld, SplitsCutFacets) {
  const double rise = 10 * (1 - std::cos(6 * degree));
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.3, 0.2, 1), Vec3(-0.5, 0.1, 0.8)}) {
    const world::World whole = frustum_world(10, 10, 30);
    const scene::CuttingPlane plane = scene::make_cutting_plane({{"A", ""}, Vec3(0, 0, 15), normal});
    const cut::CutWorld cut = cut::cut_world(whole, plane);
    const Vec3 towards = tilted(65, 17);
    const projection::Projection view = orthographic(towards);
    const auto refined = refine_world(cut.world, view);
    ASSERT_TRUE(refined);
    const mesh::Mesh& mesh = *refined->models.front().mesh;
    int in_plane = 0;
    for (std::size_t v = cut.world.points.size(); v < mesh.points.size(); ++v) {
      const Vec3 p = mesh.point(static_cast<int>(v));
      EXPECT_NEAR(std::hypot(p.x, p.y), 10, 1e-9);
      EXPECT_NEAR(glm::dot(Vec3(p.x, p.y, 0), towards), 0, 1e-9);
      in_plane += std::abs(glm::dot(p - plane.point, plane.normal)) < rise ? 1 : 0;
    }
    EXPECT_EQ(in_plane, 2);
    const Result drawn = draw(*refined, view);
    double expected = 0, contours = 0;
    for (const double side : {-90.0, 90.0}) {
      const Vec3 foot = 10.0 * Vec3(std::cos((17 + side) * degree), std::sin((17 + side) * degree), 0);
      expected += (15 - glm::dot(foot, normal) / normal.z) * std::sin(65 * degree);
    }
    for (const drawing::Segment& s : drawn.drawing.segments)
      if (s.kind == EdgeKind::contour && std::abs(s.from.x - s.to.x) < 1e-9 * std::abs(s.from.y - s.to.y))
        contours += glm::distance(s.from, s.to) * drawn.unit;
    EXPECT_NEAR(contours, expected, 2 * rise);
  }
}

// A round boss on a square plate, whose triangles are as thin beside the foot of the boss as they get. Its new vertices
// lie beyond some of them.
TEST(RefineWorld, FoldsNoTrianglesOfPlanesAtHollowRims) {
  constexpr int sides = 24;
  Shape shape;
  const std::array<Vec2, 4> plate{Vec2(60, -50), Vec2(50, 60), Vec2(-60, 50), Vec2(-50, -60)};
  for (const double z : {0.0, 20.0})
    for (int i = 0; i < sides; ++i)
      shape.points.push_back({10 * std::cos(360.0 / sides * i * degree), 10 * std::sin(360.0 / sides * i * degree), z});
  for (const Vec2& corner : plate) shape.points.push_back({corner.x, corner.y, 0});
  const auto at = [&](int v) {
    const auto& p = shape.points[static_cast<std::size_t>(v)];
    return Vec2(p[0], p[1]);
  };
  for (int i = 1; i + 1 < sides; ++i) shape.faces.push_back({sides, sides + i, sides + i + 1});
  int corner = 0;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    shape.faces.push_back({i, next, sides + next});
    shape.faces.push_back({i, sides + next, sides + i});
    const auto is_beside = [&](int k) { return cross(at(next) - at(i), at(2 * sides + k % 4) - at(i)) < -1; };
    for (; !is_beside(corner); ++corner)
      shape.faces.push_back({i, 2 * sides + corner % 4, 2 * sides + (corner + 1) % 4});
    shape.faces.push_back({next, i, 2 * sides + corner % 4});
  }
  for (; corner < 4; ++corner) shape.faces.push_back({0, 2 * sides + corner % 4, 2 * sides + (corner + 1) % 4});
  const world::World world = recognised(world_of(shape));
  int split = 0;
  for (double turn = 0; turn < 180; turn += 1.25) {
    const auto refined = refine_world(world, orthographic(tilted(60, turn)));
    if (!refined) continue;
    const world::Placed& placed = refined->models.front();
    for (int t = 0; t < placed.mesh->triangle_count(); ++t) {
      const std::array<int, 3> c = placed.mesh->triangle(t);
      const Vec3 a = placed.mesh->point(c[0]), b = placed.mesh->point(c[1]), d = placed.mesh->point(c[2]);
      if (a.z != 0 || b.z != 0 || d.z != 0) continue;
      ++split;
      EXPECT_GT(glm::cross(b - a, d - a).z, 0) << turn;
    }
  }
  EXPECT_GT(split, 1000);
}

TEST(RefineWorld, KeepsTheNamesOfEdgesAndFaces) {
  const world::World world = frustum_world(10, 10, 20);
  const world::World refined = *refine_world(world, orthographic(tilted(60, 10)));
  const mesh::Mesh &whole = *world.models.front().mesh, &mesh = *refined.models.front().mesh;
  const surfaces::PartFaces &faces = *world.models.front().part, &parts = *refined.models.front().part;
  ASSERT_EQ(parts.borders.size(), faces.borders.size());
  int split = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[e]);
    const mesh::MeshEdge* original = whole.edge_between(origin.vertex);
    if (!origin.in_file) {
      EXPECT_EQ(parts.border_of_edge[e], -1);
      EXPECT_TRUE(mesh.edges[e].diagonal);
      continue;
    }
    ASSERT_NE(original, nullptr);
    EXPECT_EQ(parts.border_of_edge[e], faces.border_of_edge[static_cast<std::size_t>(original - whole.edges.data())]);
    EXPECT_EQ(mesh.edges[e].diagonal, original->diagonal);
    split += origin.t != std::array<double, 2>{0, 1} ? 1 : 0;
  }
  EXPECT_EQ(split, 2 * 2 * 3);  // of two quadrilaterals: both rims and the diagonal
  for (const surfaces::PartBorder& border : parts.borders)
    for (std::size_t i = 1; i < border.edges.size(); ++i) {
      const auto& a = mesh.edges[static_cast<std::size_t>(border.edges[i - 1])].vertex;
      const auto& b = mesh.edges[static_cast<std::size_t>(border.edges[i])].vertex;
      EXPECT_TRUE(std::ranges::any_of(a, [&](int v) { return v == b[0] || v == b[1]; })) << "in order along the border";
    }
}

// Where a chamfer meets a shaft, both have contours through one chord of their common rim.
TEST(RefineWorld, SplitsARimAtTheContoursOfBothFaces) {
  for (const double turn : {4.0, 7.0, 11.0}) {
    Shape shape = revolved({{10, 0}, {10, 20}, {7, 24}}, 24);
    std::vector<int> below, above;
    for (int i = 0; i < 24; ++i) {
      below.push_back(23 - i);
      above.push_back(48 + i);
    }
    shape.faces.push_back(below);
    shape.faces.push_back(above);
    const projection::Projection view = orthographic(tilted(70, turn));
    const auto refined = refine_world(recognised(world_of(shape)), view);
    ASSERT_TRUE(refined);
    const mesh::Mesh& mesh = *refined->models.front().mesh;
    expect_closed(mesh);
    for (std::size_t v = static_cast<std::size_t>(mesh.first_cut_vertex); v < mesh.points.size(); ++v) {
      const Vec3 p = mesh.point(static_cast<int>(v));
      if (std::abs(p.z - 20) < 1e-6) {
        EXPECT_NEAR(std::hypot(p.x, p.y), 10, 1e-9);
      }
    }
  }
}

// Where a plane cuts a cylinder at a slant, the new vertices of the rim lie in the plane as well.
TEST(RefineWorld, KeepsSlantedRimsInTheirPlane) {
  Shape shape = frustum(10, 10, height, 20);
  for (int i = 20; i < 40; ++i)
    shape.points[static_cast<std::size_t>(i)][2] += 0.5 * shape.points[static_cast<std::size_t>(i)][0];
  const auto refined = refine_world(recognised(world_of(shape)), orthographic(tilted(70, 33)));
  ASSERT_TRUE(refined);
  const mesh::Mesh& mesh = *refined->models.front().mesh;
  expect_closed(mesh);
  int on_top = 0;
  for (std::size_t v = static_cast<std::size_t>(mesh.first_cut_vertex); v < mesh.points.size(); ++v) {
    const Vec3 p = mesh.point(static_cast<int>(v));
    EXPECT_NEAR(std::hypot(p.x, p.y), 10, 1e-9);
    const auto& edge = mesh.cut_vertices[v - static_cast<std::size_t>(mesh.first_cut_vertex)].edge;
    if (edge[0] < 20) continue;  // not of the upper rim
    ++on_top;
    EXPECT_NEAR(p.z, height + 0.5 * p.x, 1e-9);
  }
  EXPECT_EQ(on_top, 2);
}

// Both contours are drawn, exactly where the formula has them, from rim to rim.
TEST(RefineWorld, ContoursOfFrustumsAreDrawnWhereTheyAre) {
  for (const double top : {10.0, 6.0})
    for (const int sides : {12, 25})
      for (const double tilt : {40.0, 65.0, 88.0}) {
        const Vec3 towards = tilted(tilt, 13);
        const Result drawn = draw_refined(frustum_world(10, top, sides), orthographic(towards));
        const double angle = contour_angle(10, top, towards);
        double length = 0;
        for (const double side : {-1.0, 1.0}) {
          const double at = 13 * degree + side * angle;
          const Vec3 low(10 * std::cos(at), 10 * std::sin(at), 0), high(top * std::cos(at), top * std::sin(at), height);
          length += glm::length(glm::cross(high - low, towards));
        }
        EXPECT_NEAR(length_of_contours(drawn, true), length, 1e-6 * length) << top << " " << sides << " " << tilt;
        EXPECT_NEAR(length_of_contours(drawn, false), 0, 1e-9);
      }
}

// Two cylinders of one radius that cross at 90 and 60 degrees, as two bodies, seen at right angles to both axes: each
// hides the other's contours inside it, which meet at the ends of the rhombus of Steinmetz.
TEST(RefineWorld, ContoursOfCrossingCylindersEndInEachOther) {
  for (const double angle : {90.0, 60.0})
    for (const int sides : {24, 30}) {
      const double radius = 10, length = 80;
      const auto lying = [&](double turn) {
        Shape shape = frustum(radius, radius, length, sides);
        for (Point& p : shape.points) {
          const Vec3 q(p[2] - length / 2, p[0], p[1]);
          const double c = std::cos(turn * degree), s = std::sin(turn * degree);
          p = {c * q.x - s * q.y, s * q.x + c * q.y, q.z};
        }
        return shape;
      };
      const world::World world = recognised(world_of(std::vector<Shape>{lying(0), lying(angle)}));
      const Result drawn = draw_refined(world, orthographic({0, 0, 1}, {0, 1, 0}));
      // Along each of the four contours, the other cylinder hides 2 r / sin(angle). The four ends are seen edge-on.
      const double visible = 4 * (length - 2 * radius / std::sin(angle * degree)) + 4 * 2 * radius;
      double contours = 0;
      for (const drawing::Segment& s : drawn.drawing.segments)
        if (s.kind == EdgeKind::contour && s.visible) contours += glm::distance(s.from, s.to) * drawn.unit;
      EXPECT_NEAR(contours, visible, 1e-6 * visible) << angle << " " << sides;
    }
}

}  // namespace
}  // namespace epura::test::refine_world_test
