// SPDX-License-Identifier: Apache-2.0
#include "visibility/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "shapes.hpp"

namespace epura::test::visibility_test {
namespace {

// A wide ground far below, so that lines beside the plates lie inside the drawing.
Shape ground() { return plate(-4, -4, 4, 4, -10); }

TEST(Hidden, IsWhatLiesBehindAFace) {
  const world::World world = world_of({plate(0, 0, 1, 1, 1), ground()});
  const auto behind = hidden_of_line(world, from_above(), {-1, 0.5, 0}, {3, 0.5, 0});
  ASSERT_EQ(behind.size(), 1U);
  EXPECT_NEAR(behind[0][0], 0.25, 1e-9);
  EXPECT_NEAR(behind[0][1], 0.5, 1e-9);
  EXPECT_TRUE(hidden_of_line(world, from_above(), {-1, 0.5, 2}, {3, 0.5, 2}).empty()) << "before it";
  EXPECT_TRUE(hidden_of_line(world, from_above(), {-1, 1.5, 0}, {3, 1.5, 0}).empty()) << "beside it";
}

// A viewer in a face sees it edge-on, wherever rounding puts what is left of it near the viewer.
TEST(Hidden, IsNothingBehindAFaceInWhichTheViewerIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 40; ++i) {
    const Vec3 x = glm::normalize(Vec3(number(random), number(random), number(random)));
    const Vec3 y = glm::normalize(glm::cross(x, Vec3(number(random), number(random), number(random))));
    const Vec3 z = glm::cross(x, y), middle(30 * number(random), -20, 12);
    Shape room = box({-10, -10, 0}, {10, 10, 20});
    for (auto& p : room.points) {
      const Vec3 q = middle + p[0] * x + p[1] * y + p[2] * z;
      p = {q.x, q.y, q.z};
    }
    const Result drawn = draw(world_of(room), perspective(middle + x, middle + x + z, -z, y));
    int behind = 0;
    for (std::size_t e = 0; e < drawn.drawn.edges.size(); ++e) {
      const auto& [a, b] = drawn.world.models[0].mesh->edges[drawn.drawn.edges[e].mesh_edge].vertex;
      const auto depth = [&](int v) { return glm::dot(drawn.world.points[v] - middle, z); };
      if (depth(a) < 1 || depth(b) < 1) continue;
      ++behind;
      drawn.hidden.visit_parts(e, [&](double, double, bool visible) { EXPECT_TRUE(visible) << i; });
    }
    EXPECT_EQ(behind, 4) << i;
  }
}

TEST(Hidden, PartsAreParametersOnThePage) {
  // The eye at the origin looks along +y at a line that recedes from (-1, 1) to (3, 3): on the page from -1 to 1. A
  // plate at y = 0.5 covers x/y from 0 to 0.5, that is half to three quarters of the line on the page.
  const Shape screen{{{0, 0.5, -1}, {0.25, 0.5, -1}, {0.25, 0.5, 1}, {0, 0.5, 1}}, {{0, 1, 2, 3}}, {}};
  const Shape backdrop{{{-8, 4, -8}, {8, 4, -8}, {8, 4, 8}, {-8, 4, 8}}, {{0, 1, 2, 3}}, {}};
  const projection::Projection eye = perspective({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1});
  const auto spans = hidden_of_line(world_of({screen, backdrop}), eye, {-1, 1, 0}, {3, 3, 0});
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_NEAR(spans[0][0], 0.5, 1e-8);
  EXPECT_NEAR(spans[0][1], 0.75, 1e-8);
}

TEST(Hidden, SpansOfEveryEdgeAscendAndDoNotTouch) {
  Shape boxes;
  for (int i = 0; i < 6; ++i) boxes.add(box({i * 0.7, i * 0.3, i * 0.2}, {i * 0.7 + 1.1, i * 0.3 + 2, i * 0.2 + 1.5}));
  const Result result = draw(world_of(boxes), orthographic({0.4, -1, 0.6}));
  ASSERT_EQ(result.hidden.first.size(), result.drawn.edges.size() + 1);
  EXPECT_EQ(result.hidden.first.front(), 0U);
  EXPECT_EQ(result.hidden.first.back(), result.hidden.spans.size());
  EXPECT_FALSE(result.hidden.spans.empty());
  for (std::size_t e = 0; e < result.drawn.edges.size(); ++e)
    for (std::size_t i = result.hidden.first[e]; i < result.hidden.first[e + 1]; ++i) {
      const auto& [from, to] = result.hidden.spans[i];
      EXPECT_TRUE(0 <= from && from < to && to <= 1);
      if (i == result.hidden.first[e]) continue;
      EXPECT_LT(result.hidden.spans[i - 1][1], from);
    }
}

TEST(Hidden, IsWhatTheTrianglesHideOneByOne) {
  std::size_t spans = 0;
  for (const Shape& shape : {four_boxes(), uv_sphere(24, 12), klein_bottle(24, 12), sombrero(3, 12)}) {
    const world::World world = world_of(shape);
    view::ProjectedScene view = view::project_scene(world, orthographic({1.1, -2, 1.3}), {});
    const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
    const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
    const visibility::HiddenSpans directly = visibility::find_hidden_directly(world, view, drawn);
    EXPECT_EQ(hidden.first, directly.first);
    EXPECT_EQ(hidden.spans, directly.spans);
    spans += hidden.spans.size();
  }
  EXPECT_GT(spans, 0U);
}

void expect_hidden_as_directly(const Shape& shape, const projection::Projection& projection) {
  const Result r = draw(world_of(shape), projection);
  const visibility::HiddenSpans directly = visibility::find_hidden_directly(r.world, r.view, r.drawn);
  EXPECT_EQ(r.hidden.first, directly.first);
  EXPECT_EQ(r.hidden.spans, directly.spans);
  EXPECT_FALSE(directly.spans.empty());
}

// From above the first plate to below the last, at some places at once.
TEST(Hidden, OfALineThroughAPileOfPlates) {
  Shape plates;
  for (int i = 0; i < 1000; ++i) plates.add(plate(0, 0, 1, 1, -1e-3 * i));
  for (int i = 0; i < 40; ++i) {
    const int first = static_cast<int>(plates.points.size());
    const double x = 0.1 + 0.02 * i;
    plates.points.insert(plates.points.end(), {{x, 0.2, 0.3 - 0.03 * i}, {x + 0.01, 0.8, -1.3 + 0.02 * i}});
    plates.wires.push_back({first, first + 1});
  }
  expect_hidden_as_directly(plates, from_above());
}

// A ground of few or many triangles covers whole cells of the search.
TEST(Hidden, OfLinesThroughACover) {
  for (const auto& [slope, n] : {std::pair(0.0, 1), std::pair(0.4, 1), std::pair(0.0, 40), std::pair(0.4, 40)}) {
    Shape ground;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) ground.points.push_back({i / double(n), j / double(n), slope * i / n});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int at = j * (n + 1) + i;
        ground.faces.push_back({at, at + 1, at + n + 2, at + n + 1});
      }
    for (int i = 0; i < 300; ++i) {
      const int first = static_cast<int>(ground.points.size());
      const double x = 0.05 + 0.003 * i, y = 0.05 + std::fmod(0.377 * i, 0.85), z = slope * x;
      ground.points.insert(ground.points.end(), {{x, y, z + 0.2}, {x + 0.01, y + 0.03, z - 0.3}});
      ground.wires.push_back({first, first + 1});
    }
    expect_hidden_as_directly(ground, from_above());
  }
}

// Closer together than many of the lengths that are forgiven.
TEST(Hidden, OfPlatesCloseBehindOneAnother) {
  const auto stack = [](double apart) {
    Shape plates;
    for (int i = 0; i < 1500; ++i) plates.add(plate(1e-6 * i, 1e-6 * i, 1 + 1e-6 * i, 1 + 1e-6 * i, -apart * i));
    return plates;
  };
  const view::ProjectedScene view = view::project_scene(world_of(stack(1e-6)), from_above(), {});
  const double contact = view.contact.touching / (view.map.normalisation * view.map.unit);
  expect_hidden_as_directly(stack(12 * contact), from_above());
}

// Two plates of one model over each other, of which the upper one is said to meet the edges of the lower one, too.
TEST(OwnTriangles, NeverHideTheirEdges) {
  const Shape above = plate(-1, -1, 2, 2, 1), below = plate(0, 0, 1, 1, 0);
  for (const bool told : {false, true}) {
    Shape both = below;
    both.add(above);
    Result r = draw(world_of(std::vector<Shape>{four_boxes().moved(9, 0, 0), both}), from_above());
    for (const edges::FeatureEdge& edge : r.drawn.edges)
      if (told) r.drawn.beside_slivers.push_back({edge.model, edge.mesh_edge, {2, 3}});
    const visibility::HiddenSpans hidden = visibility::find_hidden(r.world, r.view, r.drawn);
    const visibility::HiddenSpans directly = visibility::find_hidden_directly(r.world, r.view, r.drawn);
    int covered = 0;
    for (std::size_t e = 0; e < r.drawn.edges.size(); ++e) {
      if (r.drawn.edges[e].model == 0) continue;
      const visibility::OwnTriangles own(r.world, r.drawn, r.drawn.edges[e]);
      const int first = r.world.first_triangle[1];
      EXPECT_EQ(own.contain(first + 2) || own.contain(first + 3),
                told || r.drawn.edges[e].vertex[0] >= r.world.first_vertex[1] + 4);
      covered += static_cast<int>(hidden.first[e + 1] - hidden.first[e]);
    }
    EXPECT_EQ(covered, told ? 0 : 4);
    EXPECT_EQ(hidden.spans, directly.spans);
  }
}

TEST(Hidden, NothingInAWireframe) {
  const Result result = draw(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic({1, -2, 3}));
  const visibility::HiddenSpans none = visibility::nothing_hidden(result.drawn);
  EXPECT_TRUE(none.spans.empty());
  EXPECT_EQ(none.first, std::vector<std::size_t>(result.drawn.edges.size() + 1, 0));
}

// Lengths of wires on the page: visible, hidden.
std::array<double, 2> lengths_of_wires(const Result& result) {
  std::array<double, 2> lengths{};
  for (const drawing::Segment& s : result.drawing.segments)
    if (s.kind == EdgeKind::wire) lengths[s.visible ? 0 : 1] += glm::distance(s.from, s.to);
  return lengths;
}

TEST(Wires, AreHiddenByFacesLikeOtherEdges) {
  // Behind a cube of side 10, before it, through it, in its front face and in its back face; three segments of 20, 6
  // and 10, and two of 4.
  Shape cube = box({0, 0, 0}, {10, 10, 10});
  const std::vector<laboratory::Point> ends{{-5, 20, 5}, {15, 20, 5}, {2, -3, 2}, {8, -3, 2}, {6, -5, 6},
                                            {6, 5, 6},   {3, 0, 3},   {7, 0, 3},  {3, 10, 4}, {7, 10, 4}};
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    const int first = static_cast<int>(cube.points.size());
    cube.points.insert(cube.points.end(), {ends[i], ends[i + 1]});
    cube.wires.push_back({first, first + 1});
  }
  const auto from_the_front = lengths_of_wires(draw(world_of(cube), orthographic({0, -1, 0})));
  const double unit = from_the_front[1] / (10 + 4);  // half of the first, and the last
  EXPECT_NEAR(from_the_front[0], unit * (10 + 6 + 4), 1e-8 * unit);
  // From above: behind and before it is seen whole, the third down to the cube, those in the upright faces are seen
  // edge-on and hidden by nothing but the lid, which they are below.
  const auto from_the_top = lengths_of_wires(draw(world_of(cube), from_above()));
  EXPECT_NEAR(from_the_top[0] / from_the_top[1], (20 + 6 + 5) / 5., 1e-8);
}

TEST(Wires, AreDrawnWithoutAnyFace) {
  const Shape angle{{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, {}, {}, {{0, 1}, {1, 2}}};
  const auto lengths = lengths_of_wires(draw(world_of(angle), from_above()));
  const auto twice = lengths_of_wires(draw(world_of({angle, plate(0, 0, 3, 4, 1)}), from_above()));
  EXPECT_GT(lengths[0], 0);
  EXPECT_EQ(lengths[1], 0);
  EXPECT_EQ(twice[0], 0) << "covered by the outline of the plate";
}

TEST(Wires, InFacesAreSeenWholly) {
  // The diagonals of the faces that the triangles do not have, as they join corners.
  Shape cube = triangulated_cube();
  const mesh::Mesh mesh = mesh_of(cube), other = mesh_of(triangulated_cube(true));
  for (const mesh::MeshEdge& edge : other.edges)
    if (mesh.edge_between(edge.vertex) == nullptr) cube.wires.push_back(edge.vertex);
  ASSERT_EQ(cube.wires.size(), 6U);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const Result result = draw(world_of(cube), orthographic({number(random), number(random), number(random)}));
    int visible = 0;
    for (std::size_t e = 0; e < result.drawn.edges.size(); ++e) {
      if (result.drawn.edges[e].kind != EdgeKind::wire) continue;
      std::vector<bool> parts;
      result.hidden.visit_parts(e, [&](double, double, bool is_visible) { parts.push_back(is_visible); });
      ASSERT_EQ(parts.size(), 1U) << i;
      visible += parts[0];
    }
    EXPECT_EQ(visible, 3) << i;
  }
}

int hidden_spans_below(double gap, std::optional<double> contact) {
  const world::World world = world_of({plate(0, 0, 1, 1, gap), ground()});
  view::ProjectedScene view = view::project_scene(world, from_above(), {.contact = contact});
  const int a = view::add_point(view, {-1, 0.5, 0});
  const int b = view::add_point(view, {2, 0.5, 0});
  edges::FeatureEdges drawn;
  drawn.edges.push_back({{a, b}, {0, 1}, EdgeKind::intersection, 0, -1, 0});
  drawn.crossings.push_back({{Vec3(-1, 0.5, 0), Vec3(2, 0.5, 0)}, {-1, -1}, 90});
  return static_cast<int>(visibility::find_hidden(world, view, drawn).spans.size());
}

TEST(Contact, IsTheLengthThatWasGiven) {
  EXPECT_EQ(hidden_spans_below(0.1001, 0.1), 1);
  EXPECT_EQ(hidden_spans_below(0.0999, 0.1), 0);
  EXPECT_EQ(hidden_spans_below(1e-4, 0), 1);
}

TEST(Contact, IsOtherwiseAFewCellsOfTheGrid) {
  // The drawing is 8 wide: a cell is 8 / 2^30 or the next power of two.
  EXPECT_EQ(hidden_spans_below(8 * 0x1p-26, std::nullopt), 1);
  EXPECT_EQ(hidden_spans_below(8 * 0x1p-30, std::nullopt), 0);
}

TEST(Contact, FollowsTheScaleOfTheProjection) {
  const world::World world = world_of(plate(0, 0, 1, 1, 0));
  projection::Projection p = from_above();
  const view::ProjectedScene plain = view::project_scene(world, p, {.contact = 0.1});
  p.scale = 3;
  const view::ProjectedScene tripled = view::project_scene(world, p, {.contact = 0.1});
  EXPECT_NEAR(tripled.contact.touching, 3 * plain.contact.touching, 1e-15);
  EXPECT_EQ(plain.contact.in_space, 0.1 * plain.map.normalisation);
}

TEST(Contact, OfSinglePrecisionModelsIsTheirRounding) {
  world::World world = world_of(plate(0, 0, 1, 1, 0));
  const view::ProjectedScene fine = view::project_scene(world, from_above(), {});
  world.rounding = 0x1p-22;
  const view::ProjectedScene coarse = view::project_scene(world, from_above(), {});
  EXPECT_EQ(coarse.contact.touching, 0x1p-22 * coarse.map.normalisation);
  EXPECT_LT(fine.contact.touching, 0x1p-25 * fine.map.normalisation);
  EXPECT_EQ(coarse.contact.in_space, 0x1p-22 * coarse.map.normalisation);
}

// Their lines cross its sides many lengths away, nearly in parallel.
TEST(Hidden, ShortLinesInALargeFaceAreNotHidden) {
  const world::World world =
      world_of(Shape{{{-13.497063, 58.462204, 0}, {0, 900, 0}, {-394.534032, 808.914642, 0}}, {{0, 1, 2}}, {}});
  std::mt19937 random(1);
  const auto any = [&](double from, double to) { return from + (to - from) * static_cast<double>(random()) / 0x1p32; };
  for (int i = 0; i < 2000; ++i) {
    const double a = any(0, 0.8), b = any(0, 0.8 - a), angle = any(0, 2 * M_PI), length = std::pow(10, any(-3, 1));
    const Vec3 from(-13.497063 + a * 13.497063 - b * 381.036969, 58.462204 + a * 841.537796 + b * 750.452438, 0);
    const Vec3 to = from + length * Vec3(std::cos(angle), std::sin(angle), 0);
    EXPECT_EQ(hidden_of_line(world, orthographic({1, -1, 1}), from, to), visibility::Spans()) << i;
  }
}

}  // namespace
}  // namespace epura::test::visibility_test
