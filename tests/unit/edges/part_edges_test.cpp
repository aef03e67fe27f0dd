// SPDX-License-Identifier: Apache-2.0
// Edges, contacts and contours of meshes whose parts are recognised.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "cut/cut_world.hpp"
#include "edges/crossing_candidates.hpp"
#include "edges/find_edges.hpp"
#include "refine/refine_world.hpp"
#include "shapes.hpp"
#include "surfaces/declared_part.hpp"

namespace epura::test::part_edges_test {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3 corner(1.1, -2, 1.3);

using Profile = std::vector<std::array<double, 2>>;

Shape cylinder(double radius, double from, double to, int sides) {
  return revolved({{0, from}, {radius, from}, {radius, to}, {0, to}}, sides);
}

Shape turned(Shape shape, double degrees) {
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  for (auto& p : shape.points) p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return shape;
}

// The axis goes from z to x.
Shape laid_down(Shape shape) {
  for (auto& p : shape.points) p = {p[2], p[0], p[1]};
  return shape;
}

Shape moved(Shape shape, double x) {
  for (auto& p : shape.points) p[0] += x;
  return shape;
}

// From the pole below to the pole above.
Profile arc(double radius, int bands) {
  Profile profile;
  for (int i = 0; i <= bands; ++i) {
    const double a = pi * (double(i) / bands - 0.5);
    profile.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return profile;
}

Profile ring(double radius, double tube, int steps) {
  Profile profile;
  for (int i = 0; i <= steps; ++i) {
    const double a = -2 * pi * (i % steps) / steps;
    profile.push_back({radius - tube * std::cos(a), tube * std::sin(a)});
  }
  return profile;
}

// Joins rings of vertices, each of which follows the one below it, by `bands` bands of triangles, and closes both ends.
void close_rings(Shape& shape, int sides, int bands) {
  std::vector<int> below, above;
  for (int i = 0; i < sides; ++i) {
    below.insert(below.begin(), i);
    above.push_back(bands * sides + i);
    for (int row = 0; row < bands; ++row) {
      const int a = row * sides + i, b = row * sides + (i + 1) % sides;
      shape.faces.push_back({a, b, b + sides});
      shape.faces.push_back({a, b + sides, a + sides});
    }
  }
  shape.faces.push_back(below);
  shape.faces.push_back(above);
}

// A cylinder with a rounded foot, on which the vertices of the tessellation have no order.
Shape rounded_foot(int rows, int sides) {
  std::mt19937 random(1);
  const auto shift = [&] { return 0.8 * (double(random()) / double(std::mt19937::max()) - 0.5); };
  Shape shape;
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < sides; ++i) {
      const bool inside = row > 0 && row < rows;
      const double v = (row + (inside ? shift() : 0) - rows) * pi / 2 / rows;
      const double u = 2 * pi * (i + (inside ? shift() : 0)) / sides, radius = 37 + 3 * std::cos(v);
      shape.points.push_back({radius * std::cos(u), radius * std::sin(u), 3 + 3 * std::sin(v)});
    }
  for (int i = 0; i < sides; ++i) {
    const auto& p = shape.points[std::size_t(rows * sides + i)];
    shape.points.push_back({p[0], p[1], 30});
  }
  close_rings(shape, sides, rows + 1);
  return shape;
}

std::map<EdgeKind, int> count_kinds(const world::World& world, const edges::EdgeOptions& options = {},
                                    const Vec3& from = corner) {
  view::ProjectedScene view = view::project_scene(world, orthographic(from), {});
  std::map<EdgeKind, int> count;
  for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, options).edges) ++count[edge.kind];
  return count;
}

const edges::EdgeOptions creases{.contour = false, .intersection = false};

TEST(PartEdges, AShallowConeMeetsItsCylinderInACrease) {
  const double slope = std::tan(15.6 * pi / 180);
  const Shape shape = revolved({{0, 0}, {20, 0}, {20, 30}, {20 - 10 * slope, 40}, {0, 40}}, 48);
  EXPECT_EQ(count_kinds(world_of(shape), creases)[EdgeKind::crease], 2 * 48);
  EXPECT_EQ(count_kinds(recognised(world_of(shape)), creases)[EdgeKind::crease], 3 * 48);
}

TEST(PartEdges, NothingIsACreaseInsideACoarseCylinder) {
  const world::World world = world_of(cylinder(10, 0, 30, 12));
  EXPECT_EQ(count_kinds(world, creases)[EdgeKind::crease], 3 * 12);
  EXPECT_EQ(count_kinds(recognised(world), creases)[EdgeKind::crease], 2 * 12);
}

TEST(PartEdges, PrismsKeepTheirEdges) {
  for (const int sides : {5, 6, 8})
    EXPECT_EQ(count_kinds(recognised(world_of(cylinder(10, 0, 30, sides))), creases)[EdgeKind::crease], 3 * sides);
}

TEST(PartEdges, ACreaseAngleHoldsForBordersToo) {
  const double slope = std::tan(15.6 * pi / 180);
  const world::World world =
      recognised(world_of(revolved({{0, 0}, {20, 0}, {20, 30}, {20 - 10 * slope, 40}, {0, 40}}, 48)));
  edges::EdgeOptions options = creases;
  options.part_angle = 15.5;
  EXPECT_EQ(count_kinds(world, options)[EdgeKind::crease], 3 * 48);
  options.part_angle = 15.7;
  EXPECT_EQ(count_kinds(world, options)[EdgeKind::crease], 2 * 48);
  options.tangent = true;
  EXPECT_EQ(count_kinds(world, options)[EdgeKind::tangent], 48);
}

TEST(PartEdges, OfARoundedRimAreTangent) {
  Profile profile{{0, 0}, {20, 0}, {20, 30}};
  for (int i = 1; i <= 6; ++i) {
    const double a = i * pi / 12;
    profile.push_back({15 + 5 * std::cos(a), 30 + 5 * std::sin(a)});
  }
  profile.push_back({0, 35});
  const world::World world = recognised(world_of(revolved(profile, 48)));
  edges::EdgeOptions options = creases;
  options.tangent = true;
  auto count = count_kinds(world, options);
  EXPECT_EQ(count[EdgeKind::crease], 48);
  EXPECT_EQ(count[EdgeKind::tangent], 2 * 48);
}

// The wall of a hole, and that of a bolt in it, whose facets turn by as much as creases do.
std::vector<Shape> bolt_in_hole() {
  return {revolved({{10, 0}, {10, 10}, {10, 20}}, 12), turned(revolved({{10, -5}, {10, 25}}, 12), 7)};
}

TEST(Contacts, OfMatingFacesAreNoLines) {
  EXPECT_GT(count_kinds(world_of(bolt_in_hole()))[EdgeKind::intersection], 0);
  EXPECT_EQ(count_kinds(recognised(world_of(bolt_in_hole())))[EdgeKind::intersection], 0);
}

// A bolt that is thicker or thinner than its hole by less than its arcs are high, with vertices below those of the
// hole.
TEST(Contacts, OfMatingFacesMayDifferByTheHeightOfTheirArcs) {
  const double sagitta = 10 * (1 - std::cos(pi / 12));
  for (const double part : {-0.5, 0.3, 0.5}) {
    const double radius = 10 + part * sagitta;
    const std::vector<Shape> shapes{revolved({{10, 0}, {10, 10}, {10, 20}}, 12),
                                    turned(revolved({{radius, -5}, {radius, 25}}, 12), 7)};
    const world::World world = world_of(shapes);
    EXPECT_GT(count_kinds(world)[EdgeKind::intersection], 0) << part;
    EXPECT_EQ(count_kinds(recognised(world))[EdgeKind::intersection], 0) << part;
  }
}

TEST(Contacts, HoldForModelsThatAreScaledAndTurned) {
  world::World world = recognised(world_of(bolt_in_hole()));
  Mat4 place(0);
  place[0][1] = 25.4, place[1][2] = 25.4, place[2][0] = -25.4, place[3] = {3, 4, 5, 1};
  std::vector<world::Placed> models = world.models;
  for (world::Placed& model : models) model.to_world = place;
  EXPECT_EQ(count_kinds(world::make_world(models))[EdgeKind::intersection], 0);
}

// How many ends of intersection lines lie where no other one does.
int loose_ends(const world::World& world) {
  view::ProjectedScene view = view::project_scene(world, orthographic(corner), {});
  std::vector<Vec3> ends;
  for (const edges::FaceCrossing& crossing : edges::find_feature_edges(world, view, {}).crossings)
    ends.insert(ends.end(), crossing.ends.begin(), crossing.ends.end());
  return static_cast<int>(std::count_if(ends.begin(), ends.end(), [&](const Vec3& end) {
    return std::count_if(ends.begin(), ends.end(), [&](const Vec3& e) { return glm::distance(e, end) < 1e-9; }) < 2;
  }));
}

TEST(Contacts, EqualPipesCrossInWholeCurves) {
  const std::vector<Shape> pipes{cylinder(10, -30, 30, 24), laid_down(turned(cylinder(10, -30, 30, 24), 3))};
  EXPECT_GT(loose_ends(world_of(pipes)), 0);
  EXPECT_EQ(loose_ends(recognised(world_of(pipes))), 0);
}

TEST(Contacts, SpheresThatTouchFlatlyCrossInAWholeCircle) {
  const Shape sphere = revolved(arc(10, 16), 24);
  const std::vector<Shape> spheres{sphere, moved(turned(sphere, 5), 1.2)};
  EXPECT_GT(loose_ends(world_of(spheres)), 0);
  EXPECT_GT(count_kinds(recognised(world_of(spheres)))[EdgeKind::intersection], 24);
  EXPECT_EQ(loose_ends(recognised(world_of(spheres))), 0);
}

// A ball in the groove of a race that fits it, and in one that is a little wider: the facets cross, though the surfaces
// only touch.
TEST(Contacts, OfSurfacesThatTouchAlongALineAreNoLines) {
  const Shape ball = moved(turned(revolved(arc(5, 24), 36), 2), 30);
  for (const double groove : {5.0, 5.05}) {
    Profile race;
    for (int i = 0; i <= 12; ++i) {
      const double a = pi * (i / 24.0 - 0.25);
      race.push_back({30 - (groove - 5) + groove * std::cos(a), groove * std::sin(a)});
    }
    const std::vector<Shape> shapes{revolved(race, 90), ball};
    const world::World world = recognised(world_of(shapes));
    const view::ProjectedScene view = view::project_scene(world, orthographic(corner), {});
    const edges::FaceCrossings crossings =
        edges::find_intersections(world, view.map.normalisation, view.contact.in_space, edges::all_triangles(world));
    EXPECT_FALSE(crossings.found.empty()) << groove;
    EXPECT_EQ(count_kinds(world)[EdgeKind::intersection], 0) << groove;
  }
}

struct ShownContours {
  std::vector<Vec2> places;  ///< of ends that are moved
  double moved;              ///< as the edges say; both in lengths of the world
};

ShownContours shown_contours(const world::World& world, const Vec3& from) {
  view::ProjectedScene view = view::project_scene(world, orthographic(from), {});
  const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  // Page lengths by those of the world: the way between two points.
  const Vec3 up = glm::normalize(Vec3(0, 0, 1) - glm::normalize(from) * glm::normalize(from).z);
  const auto page = [&](const Vec3& p) {
    const view::PageVertex& v = view.vertices[view::add_point(view, p)];
    return Vec2(v.x, v.y);
  };
  const Vec2 origin = page(Vec3(0));
  const double unit = glm::distance(origin, page(up));
  ShownContours shown{{}, drawn.moved / unit};
  for (const edges::FeatureEdge& edge : drawn.edges)
    for (const int v : edge.shown)
      if (v >= 0) shown.places.push_back((Vec2(view.vertices[v].x, view.vertices[v].y) - origin) / unit);
  return shown;
}

// The rims of the shaft lie on the ball: their vertices are on both surfaces, those of the ball are not on the shaft.
TEST(Contacts, AreFoundFromEitherFace) {
  const Shape ball = revolved(arc(5, 24), 48), shaft = cylinder(3, -4, 4, 24);
  edges::EdgeOptions options;
  options.contour = false;
  const auto crossings = [&](const std::vector<Shape>& shapes) {
    const world::World world = recognised(world_of(shapes));
    view::ProjectedScene view = view::project_scene(world, orthographic(corner), {});
    const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, options);
    return drawn.crossings.size();
  };
  EXPECT_EQ(crossings({ball, shaft}), crossings({shaft, ball}));
}

// Facets of a shaft of radius 10 are cut at x = 3, where its surface has y = +-sqrt(91).
TEST(PartEdges, OutlinesOfCutsLieOnTheSurface) {
  const world::World whole = recognised(world_of(cylinder(10, 0, 30, 20)));
  const auto plane = scene::make_cutting_plane({{"A", "--section"}, Vec3(3, 0, 0), Vec3(1, 0, 0)});
  const world::World world = cut::cut_world(whole, plane).world;
  for (const Vec3& from : {Vec3(1, 0.2, 0.3), Vec3(0.1, -1, 0.2)}) {
    view::ProjectedScene view = view::project_scene(world, orthographic(from), {});
    double length = 0;
    for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges) {
      if (edge.kind != EdgeKind::section || edge.mesh_edge < 0) continue;
      const mesh::MeshEdge& mesh_edge = world.models[0].mesh->edges[static_cast<std::size_t>(edge.mesh_edge)];
      const Vec3 a = world.points[mesh_edge.vertex[0]], b = world.points[mesh_edge.vertex[1]];
      if (std::abs(a.z - b.z) < 1e-9) continue;
      EXPECT_NEAR(std::abs(a.y), std::sqrt(91), 1e-9);
      EXPECT_NEAR(a.y, b.y, 1e-9);
      length += glm::distance(a, b);
    }
    EXPECT_NEAR(length, 2 * 30, 1e-9);
  }
}

TEST(SmoothContours, OfASphereIsACircle) {
  const double sagitta = 10 * (1 - std::cos(pi / 16));
  const ShownContours shown = shown_contours(recognised(world_of(revolved(arc(10, 16), 24))), {0.3, -1, 0.45});
  EXPECT_GT(shown.places.size(), 30U);
  for (const Vec2& place : shown.places) EXPECT_NEAR(glm::length(place), 10, 1e-6);
  EXPECT_LT(shown.moved, 2 * sagitta);
  EXPECT_GT(shown.moved, 0);
}

// Rounded to five digits, facets across the contour are seen edge-on: it goes past them once, not on both sides.
TEST(SmoothContours, OfABallOfRoundedVerticesGoAroundItOnce) {
  for (const int sides : {96, 128, 256}) {
    Profile profile = arc(1, sides / 2);
    profile.front()[0] = profile.back()[0] = 0;
    const auto mesh = std::make_shared<const mesh::Mesh>(mesh_of(revolved(profile, sides), 5));
    const world::World world = recognised(world::make_world({{mesh, Mat4(1.0)}}));
    ASSERT_NE(world.models[0].part, nullptr);
    ASSERT_EQ(world.models[0].part->faces.size(), 1U);
    view::ProjectedScene view = view::project_scene(world, orthographic({0.3, -0.8, 0.5}), {});
    std::map<int, int> contours_at;
    for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges)
      for (const int v : edge.vertex) ++contours_at[v];
    EXPECT_GE(static_cast<int>(contours_at.size()), sides);
    for (const auto& [vertex, count] : contours_at) EXPECT_EQ(count, 2) << sides << ' ' << vertex;
  }
}

// A shaft with a ball for its end, which meet in no crease: from any side, an end of a contour is drawn in one place,
// that of the straight contour at the border.
TEST(SmoothContours, OfABallBeginWhereThoseOfItsShaftEnd) {
  Profile profile{{0, -20}, {10, -20}};
  for (int i = 0; i <= 8; ++i) profile.push_back({10 * std::cos(i * pi / 16), 10 * std::sin(i * pi / 16)});
  profile.back()[0] = 0;
  const world::World world = recognised(world_of(revolved(profile, 24)));
  int met = 0;
  for (double turn = 0; turn < 15; turn += 1.3) {
    const double a = turn * pi / 180;
    view::ProjectedScene view = view::project_scene(world, orthographic({std::sin(a), -std::cos(a), 0.4}), {});
    const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
    const auto height = [&](const edges::FeatureEdge& edge, std::size_t end) {
      return world.points[edge.vertex[end]].z;
    };
    std::set<int> of_shaft;
    for (const edges::FeatureEdge& edge : drawn.edges)
      for (const std::size_t end : {0U, 1U})
        if (edge.kind == EdgeKind::contour && std::abs(height(edge, end)) < 1e-9 && height(edge, 1 - end) < -1)
          of_shaft.insert(edge.vertex[end]);
    for (const edges::FeatureEdge& edge : drawn.edges)
      for (const std::size_t end : {0U, 1U}) {
        if (edge.kind != EdgeKind::contour || !of_shaft.contains(edge.vertex[end])) continue;
        EXPECT_LT(edge.shown[end], 0) << turn;
        ++met;
      }
  }
  EXPECT_GT(met, 12);
}

// The rim of half a ball is a crease, or its border, at which its contour ends where the mesh has a vertex.
TEST(SmoothContours, EndAtCreasesAndBorders) {
  Profile closed{{0, 0}}, open;
  for (int i = 0; i <= 8; ++i) open.push_back({i == 8 ? 0 : 10 * std::cos(i * pi / 16), 10 * std::sin(i * pi / 16)});
  closed.insert(closed.end(), open.begin(), open.end());
  for (const Profile& profile : {closed, open}) {
    const world::World world = recognised(world_of(revolved(profile, 24)));
    int met = 0;
    for (double turn = 0; turn < 15; turn += 1.3) {
      const double a = turn * pi / 180;
      view::ProjectedScene view = view::project_scene(world, orthographic({std::sin(a), -std::cos(a), 0.4}), {});
      for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges)
        for (const std::size_t end : {0U, 1U}) {
          if (edge.kind != EdgeKind::contour || std::abs(world.points[edge.vertex[end]].z) > 1e-9) continue;
          EXPECT_LT(edge.shown[end], 0) << turn;
          ++met;
        }
    }
    EXPECT_GT(met, 12);
  }
}

// Seen almost along its axis, the normals of a shaft are perpendicular to the projectors everywhere, so that no contour
// of it is there because of its facets alone.
TEST(SmoothContours, WhereASurfaceFacesNowhereAreNotThereByChance) {
  const world::World world = recognised(world_of(revolved({{0, 0}, {10, 0}, {10, 30}, {10, 60}, {0, 60}}, 24)));
  view::ProjectedScene view = view::project_scene(world, orthographic({4e-6, 1e-6, 1}, {0, 1, 0}), {});
  int contours = 0;
  for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges) {
    if (edge.kind != EdgeKind::contour) continue;
    ++contours;
    EXPECT_FALSE(edge.by_chance);
  }
  EXPECT_GT(contours, 0);
}

TEST(SmoothContours, OfATorusLieWhereItIsSeenEdgeOn) {
  const Vec3 from = glm::normalize(Vec3(0.1, -1, 1.2));
  const ShownContours shown = shown_contours(recognised(world_of(revolved(ring(30, 8, 20), 60))), from);
  EXPECT_GT(shown.places.size(), 50U);
  // The contour of a torus has the distance of its tube from the image of the circle that this runs along, an ellipse.
  const Vec3 right = glm::normalize(glm::cross(Vec3(0, 0, 1), from)), up = glm::cross(from, right);
  for (const Vec2& place : shown.places) {
    double nearest = HUGE_VAL;
    for (int i = 0; i < 3600; ++i) {
      const Vec3 p(30 * std::cos(i * pi / 1800), 30 * std::sin(i * pi / 1800), 0);
      nearest = std::min(nearest, std::abs(glm::distance(place, {glm::dot(p, right), glm::dot(p, up)}) - 8));
    }
    EXPECT_LT(nearest, 0.03);
  }
}

// Meshers crowd vertices around an apex, off the cone by rounding.
TEST(SmoothContours, OfTinyFacetsAreNotDrawn) {
  Shape cone = revolved({{0, 0}, {500, 0}, {0.6, 799.04}, {0.001, 799.9984}, {5e-4, 799.9992}, {0, 800}}, 48);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> aside(-1e-4, 1e-4);
  for (auto& p : cone.points)
    if (p[2] > 799.9 && p[2] < 800)
      for (double& x : p) x += aside(random);
  const world::World world = recognised(world_of(cone));
  view::ProjectedScene view = view::project_scene(world, from_above(), {});
  EXPECT_TRUE(std::ranges::any_of(view.triangles, [&](const view::ViewTriangle& t) {
    const auto& [a, b, c] = t.vertex;
    return world.points[a].z > 799 && view::cross(view.grid[a], view.grid[b], view.grid[c]) < 0;
  }));
  for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges)
    EXPECT_LT(std::min(world.points[edge.vertex[0]].z, world.points[edge.vertex[1]].z), 799.9);
}

TEST(SmoothContours, OfFacetsThatATessellationTurnsOverAreNotDrawn) {
  const world::World world = recognised(world_of(rounded_foot(8, 24)));
  const projection::Projection front = orthographic({0, -1, 0});
  view::ProjectedScene view = view::project_scene(world, front, {});
  const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  int visible = 0, other = 0;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (drawn.edges[e].by_chance)
      hidden.visit_parts(e, [&](double, double, bool is_visible) { ++(is_visible ? visible : other); });
  EXPECT_GT(visible, 0);
  EXPECT_GT(other, 0);
  // The contour of the rounding is at both sides, and where it ends above and below.
  const drawing::ViewDrawing drawing = draw(world, front).drawing;
  for (const drawing::Segment& segment : drawing.segments) {
    const bool is_level = std::abs(segment.to.y - segment.from.y) < 1e-3 * drawing.box.max.y;
    EXPECT_TRUE(is_level || std::abs(segment.from.x) > 0.8 * drawing.box.max.x)
        << segment.from.x << " " << segment.from.y << (segment.visible ? " visible" : " hidden");
  }
}

// A shaft on a plate with a fillet between them, on which the vertices of the tessellation have no order.
Shape shaft_on_plate(int rows, int sides) {
  std::mt19937 random(1);
  const auto shift = [&] { return 0.8 * (double(random()) / double(std::mt19937::max()) - 0.5); };
  Shape shape;
  const auto add_ring = [&](double radius, double z) {
    for (int i = 0; i < sides; ++i) {
      const double u = 2 * pi * i / sides;
      shape.points.push_back({radius * std::cos(u), radius * std::sin(u), z});
    }
  };
  add_ring(60, -10);
  add_ring(60, 0);
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < sides; ++i) {
      const bool inside = row > 0 && row < rows;
      const double v = (rows - row + (inside ? shift() : 0)) * pi / 2 / rows;
      const double u = 2 * pi * (i + (inside ? shift() : 0)) / sides, radius = 43 - 6 * std::cos(v);
      shape.points.push_back({radius * std::cos(u), radius * std::sin(u), 6 - 6 * std::sin(v)});
    }
  add_ring(37, 40);
  close_rings(shape, sides, rows + 3);
  return shape;
}

// The edges around each triangle of the fillet that alone is seen from the other side than all its neighbours, where no
// other such edges meet them.
std::set<std::array<int, 2>> around_single_facets(const mesh::Mesh& mesh, const Vec3& towards) {
  const auto is_front = [&](int t) {
    const auto [a, b, c] = mesh.triangle(t);
    return glm::dot(glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a)), towards) > 0;
  };
  std::map<int, std::vector<std::array<int, 2>>> turned_over;
  std::map<int, int> contours_at;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const auto two = mesh.triangles_of(edge);
    if (is_front(two[0]) == is_front(two[1])) continue;
    for (const int v : edge.vertex) ++contours_at[v];
    const auto is_on_fillet = [&](int v) { return mesh.point(v).z > -1e-9 && mesh.point(v).z < 6 + 1e-9; };
    if (!is_on_fillet(edge.vertex[0]) || !is_on_fillet(edge.vertex[1])) continue;
    for (const int t : two) turned_over[t].push_back(edge.vertex);
  }
  std::set<std::array<int, 2>> edges;
  const auto is_alone = [&](const std::array<int, 2>& edge) {
    return contours_at[edge[0]] == 2 && contours_at[edge[1]] == 2;
  };
  for (const auto& [t, around] : turned_over)
    if (around.size() == 3 && std::all_of(around.begin(), around.end(), is_alone))
      edges.insert(around.begin(), around.end());
  return edges;
}

// Where the contour of a fillet ends behind a shaft, its facets may face either way.
TEST(SmoothContours, OfSingleFacetsAreNotDrawn) {
  const world::World world = recognised(world_of(shaft_on_plate(6, 48)));
  int found = 0;
  for (int turn = 0; turn < 360; turn += 7) {
    const Vec3 towards(std::cos(turn * pi / 180), std::sin(turn * pi / 180), 0.6);
    const std::set<std::array<int, 2>> around = around_single_facets(*world.models[0].mesh, towards);
    found += static_cast<int>(around.size());
    for (const drawing::Segment& segment : draw(world, orthographic(towards)).drawing.segments)
      EXPECT_FALSE(around.contains(segment.edge)) << turn << (segment.visible ? " visible" : " hidden");
  }
  EXPECT_GT(found, 10);
}

// A pipe whose rows of vertices are turned by half a facet against each other, as meshers for computations make them.
Shape staggered_pipe(double radius, int rows, int sides) {
  Shape shape;
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * pi * (i + 0.5 * (row % 2)) / sides;
      shape.points.push_back({radius * std::cos(a), radius * std::sin(a), 2.5 * row});
    }
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < sides; ++i) {
      const int a = row * sides + i, b = row * sides + (i + 1) % sides, c = a + sides, d = b + sides;
      if (row % 2 == 0) {
        shape.faces.push_back({a, b, c});
        shape.faces.push_back({b, d, c});
      } else {
        shape.faces.push_back({a, b, d});
        shape.faces.push_back({a, d, c});
      }
    }
  return shape;
}

// Seen obliquely, vertices that lie beside the contour in space are drawn farther along it, but not beside it.
TEST(SmoothContours, OfAPipeWithoutStripsAreStraight) {
  constexpr int sides = 60;
  const double sagitta = 10 * (1 - std::cos(pi / sides));
  const world::World world = recognised(world_of(staggered_pipe(10, 12, sides)));
  for (double turn = 0; turn < 6; turn += 0.7) {
    const projection::Projection view = orthographic({std::sin(turn * pi / 180), -std::cos(turn * pi / 180), 0.7});
    const std::optional<world::World> refined = refine::refine_world(world, view);
    ASSERT_TRUE(refined && refined->points.size() >= world.points.size() + 12) << turn;
    for (std::size_t v = world.points.size(); v < refined->points.size(); ++v)
      EXPECT_NEAR(std::abs(glm::dot(refined->points[v], view.u)), 10, 1e-3 * sagitta) << turn;
    EXPECT_TRUE(shown_contours(*refined, view.n).places.empty()) << turn;
  }
}

// The head of a countersunk screw, whose cone the file describes from beyond its apex (as Euclid wrote them), and a
// lens on the inner sheet of a torus that meets itself, 12 - 2 wide at its equator.
TEST(SmoothContours, StayBesideFacetsOnTheOtherSheetOfASurface) {
  const Profile head{{0, 1}, {5, 1}, {6, 2}, {7, 3}, {7.5, 3.5}, {0, 3.5}};
  Profile lens{{0, -6}};
  for (int i = -6; i <= 6; ++i) lens.push_back({std::sqrt(12.0 * 12 - i * i) - 2, double(i)});
  lens.push_back({0, 6});
  struct Case {
    Profile profile;
    surfaces::PartSurface surface;
  };
  for (const auto& [profile, surface] :
       {Case{head, {surfaces::SurfaceKind::cone, {0, 0, -11.5}, {0, 0, -1}, 7.5, 0, 1}},
        Case{lens, {surfaces::SurfaceKind::torus, Vec3(0), {0, 0, 1}, 2, 12, 0}}}) {
    world::World world = world_of(revolved(profile, 24));
    const mesh::Mesh& mesh = *world.models[0].mesh;
    surfaces::DeclaredPart declared;
    declared.faces = {surface,
                      {surfaces::SurfaceKind::plane, {0, 0, profile[0][1]}, {0, 0, -1}},
                      {surfaces::SurfaceKind::plane, {0, 0, profile.back()[1]}, {0, 0, 1}}};
    declared.face_of_polygon.assign(mesh.polygon.size(), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (const int end : {1, 2})
        if (std::ranges::all_of(mesh.triangle(t),
                                [&](int v) { return mesh.point(v).z == declared.faces[end].origin.z; }))
          declared.face_of_polygon[mesh.polygon[t]] = end;
    world.models[0].part = std::make_shared<surfaces::PartFaces>(surfaces::part_of(mesh, declared, 5));
    EXPECT_LT(world.models[0].part->tolerance, 1e-12);
    const double from = profile[0][1], to = profile.back()[1];
    for (const Vec3& towards : {Vec3(0, -1, 0), Vec3(0.1, -1, 0)}) {
      const auto refined = refine::refine_world(world, orthographic(towards));
      for (std::size_t v = mesh.points.size(); refined && v < refined->points.size(); ++v)
        EXPECT_NEAR(glm::length(Vec2(refined->points[v])), 4 + std::clamp(refined->points[v].z, from, to), 1e-9);
      const ShownContours shown = shown_contours(world, towards);
      EXPECT_EQ(shown.places.empty(), surface.kind == surfaces::SurfaceKind::cone);
      for (const Vec2& place : shown.places) {
        EXPECT_LT(std::abs(place.x), 10.001);
        EXPECT_GT(place.y, from - 1e-9);
        EXPECT_LT(place.y, to + 1e-9);
      }
    }
  }
}

TEST(SmoothContours, OfCylindersAndMeshesStay) {
  EXPECT_TRUE(shown_contours(recognised(world_of(cylinder(10, 0, 30, 24))), corner).places.empty());
  EXPECT_TRUE(shown_contours(world_of(revolved(arc(10, 16), 24)), corner).places.empty());
}

}  // namespace
}  // namespace epura::test::part_edges_test
