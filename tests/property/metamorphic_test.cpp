// SPDX-License-Identifier: Apache-2.0
// What must not change a drawing: numbering, orientation, triangulation, size, place, copies, things out of sight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>

#include "base/parallel.hpp"
#include "mesh/read.hpp"
#include "shapes.hpp"

namespace epura::test::metamorphic_test {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double min, double max) {
  return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
}

// --- a zoo of meshes

Shape torus(int around, int across) {
  Shape shape;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across;
      const double r = 3 + std::cos(b);
      shape.points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
      const int k = (i + 1) % around, l = (j + 1) % across;
      shape.faces.push_back({i * across + j, k * across + j, k * across + l, i * across + l});
    }
  return shape;
}

// A plate, an upright on it, a rib that runs into both.
Shape bracket() {
  Shape shape = box({0, 0, 0}, {8, 5, 1});
  shape.add(box({0, 0, 1}, {1, 5, 6}));
  shape.add(box({0.5, 2, 0.5}, {5, 2.75, 3}));
  return shape;
}

Shape random_boxes(unsigned seed, int count) {
  Random random(seed);
  Shape shape;
  for (int i = 0; i < count; ++i) {
    Point a{}, b{};
    for (int k = 0; k < 3; ++k) {
      a[k] = uniform(random, 0, 8);
      b[k] = a[k] + uniform(random, 0.5, 4);
    }
    shape.add(box(a, b));
  }
  return shape;
}

// Boxes whose faces, edges and corners touch and overlap in one plane.
Shape lattice_boxes(unsigned seed, int count) {
  Random random(seed);
  Shape shape;
  for (int i = 0; i < count; ++i) {
    Point a{}, b{};
    for (int k = 0; k < 3; ++k) {
      a[k] = static_cast<double>(random() % 4);
      b[k] = a[k] + 1 + static_cast<double>(random() % 2);
    }
    shape.add(box(a, b));
  }
  return shape;
}

Shape random_triangles(unsigned seed, int count) {
  Random random(seed);
  Shape shape;
  for (int i = 0; i < 3 * count; ++i)
    shape.points.push_back({uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)});
  for (int i = 0; i < count; ++i) shape.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return shape;
}

Shape sample(const std::string& name) {
  const mesh::Mesh mesh = mesh::read_mesh(EPURA_TEST_SAMPLES "/models/" + name);
  Shape shape;
  shape.points = mesh.points;
  for (int f = 0; f < mesh.report.triangles; ++f) {
    const auto c = mesh.triangle(f);
    shape.faces.push_back({c[0], c[1], c[2]});
  }
  return shape;
}

const std::map<std::string, Shape>& zoo() {
  static const std::map<std::string, Shape> shapes{{"cube", box({0, 0, 0}, {1, 1, 1})},
                                                   {"bracket", bracket()},
                                                   {"torus", torus(24, 12)},
                                                   {"moebius", moebius(40)},
                                                   {"boxes", random_boxes(3, 8)},
                                                   {"triangles", random_triangles(4, 30)},
                                                   {"lattice", lattice_boxes(1, 6)},
                                                   {"sample_bracket", sample("bracket.obj")},
                                                   {"sample_house", sample("house.obj")},
                                                   {"sample_shaft", sample("shaft.obj")},
                                                   {"sample_gear", sample("gear.stl")}};
  return shapes;
}

// --- views of a shape

Box box_of(const Shape& shape) {
  Box box;
  for (const Point& p : shape.points) box.add({p[0], p[1], p[2]});
  return box;
}

std::map<std::string, projection::Projection> views(const Box& box) {
  // On a coarse lattice, so that moving and scaling the eye is exact.
  const double size = std::ldexp(1.0, std::ilogb(glm::length(box.size())) + 1);
  const Vec3 middle = glm::round(box.centre() / size * 64.0) / 64.0 * size;
  const auto eye = [&](const Vec3& away) { return perspective(middle + size * away, middle, away, {0, 0, 1}); };
  return {{"isometric", orthographic({1, -1, 1})},
          {"generic", orthographic({0.3, -0.8, 0.5})},
          {"front", orthographic({0, -1, 0})},
          {"central", eye({0.875, -1.5, 0.75})},
          {"wide", eye({0.5, -0.75, 0.375})}};
}

// --- what is drawn

using Ink = std::map<std::string, double>;

Ink ink_of(const std::vector<drawing::Segment>& segments, double unit) {
  Ink ink;
  for (const drawing::Segment& s : segments)
    ink[std::string(s.visible ? "visible " : "hidden ") + std::string(edges::name_of(s.kind))] +=
        unit * glm::length(s.to - s.from);
  return ink;
}

double total(const Ink& ink) {
  return std::accumulate(ink.begin(), ink.end(), 0.0, [](double sum, const auto& part) { return sum + part.second; });
}

void expect_same(const Ink& expected, Ink ink, double tolerance) {
  for (const auto& [name, length] : expected) EXPECT_NEAR(ink[name], length, tolerance * total(expected)) << name;
  for (const auto& [name, length] : ink)
    EXPECT_TRUE(expected.contains(name) || length <= tolerance * total(expected)) << name;
}

double distance_to(const std::vector<drawing::Segment>& segments, const Vec2& p, bool visible) {
  double nearest = HUGE_VAL;
  for (const drawing::Segment& s : segments) {
    if (s.visible != visible) continue;
    const Vec2 along = s.to - s.from;
    const double at = std::clamp(glm::dot(p - s.from, along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, s.from + at * along));
  }
  return nearest;
}

// How far some point of `segments` is from what `other` shows alike, in drawings.
double farthest(const Result& result, const Result& other) {
  double worst = 0;
  for (const drawing::Segment& s : result.drawing.segments)
    for (const double at : {0.001, 0.25, 0.5, 0.75, 0.999})
      worst = std::max(worst, distance_to(other.drawing.segments, s.from + at * (s.to - s.from), s.visible));
  return worst / result.view.extent;
}

void expect_near_each_other(const Result& one, const Result& other) {
  if (one.drawing.segments.size() > 400) return;  // every point is compared with every segment
  EXPECT_LT(farthest(one, other), 1e-7);
  EXPECT_LT(farthest(other, one), 1e-7);
}

void expect_same(const Result& expected, const Result& result, double tolerance) {
  expect_same(ink_of(expected.drawing.segments, expected.unit), ink_of(result.drawing.segments, result.unit),
              tolerance);
  expect_near_each_other(expected, result);
}

// Calls `check(shape, projection, drawing)` for the whole zoo in all views.
template <class Check>
void in_all_views(const Check& check) {
  for (const auto& [name, shape] : zoo())
    for (const auto& [view, projection] : views(box_of(shape))) {
      SCOPED_TRACE(name + ", " + view);
      check(shape, projection, draw(world_of(shape), projection));
    }
}

// --- the laws

Shape renumbered(const Shape& shape, unsigned seed) {
  Random random(seed);
  std::vector<int> place(shape.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Shape result = shape;
  for (std::size_t v = 0; v < place.size(); ++v) result.points[place[v]] = shape.points[v];
  for (auto& face : result.faces)
    for (int& v : face) v = place[v];
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  return result;
}

TEST(Metamorphic, NumberingDoesNotMatter) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    expect_same(expected, draw(world_of(renumbered(shape, 7)), view), 1e-9);
  });
}

TEST(Metamorphic, FirstCornersAndOrientationDoNotMatter) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    Random random(5);
    Shape turned = shape;
    for (auto& face : turned.faces) {
      std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
      if (random() % 2 == 0) std::reverse(face.begin(), face.end());
    }
    expect_same(expected, draw(world_of(turned), view), 1e-9);
  });
}

Shape in_quarters(const Shape& shape) {
  Shape result{shape.points, {}, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, made] = middles.try_emplace(std::minmax(a, b), static_cast<int>(result.points.size()));
    if (made) {
      Point p{};
      for (int i = 0; i < 3; ++i) p[i] = (shape.points[a][i] + shape.points[b][i]) / 2;
      result.points.push_back(p);
    }
    return place->second;
  };
  for (const auto& face : shape.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const int a = face[0], b = face[i - 1], c = face[i];
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& part : {std::vector{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        result.faces.push_back(part);
    }
  return result;
}

TEST(Metamorphic, FinerTrianglesDoNotMatter) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    // Kinds may change: where bodies without names touch, their finer edges become one.
    const Result result = draw(world_of(in_quarters(shape)), view);
    EXPECT_NEAR(result.visible(), expected.visible(), 1e-9 * expected.visible());
    EXPECT_NEAR(result.hidden_length(), expected.hidden_length(), 1e-9 * expected.visible());
    expect_near_each_other(expected, result);
  });
}

TEST(Metamorphic, PowersOfTwoInSizeAreExact) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    for (const int k : {-300, -1, 5, 300}) {
      projection::Projection scaled = view;
      scaled.point *= std::ldexp(1.0, k);
      if (view.central) scaled.projector *= std::ldexp(1.0, k);
      const Result result = draw(world_of(shape.scaled(std::ldexp(1.0, k))), scaled);
      ASSERT_EQ(result.drawing.segments.size(), expected.drawing.segments.size()) << k;
      for (std::size_t i = 0; i < result.drawing.segments.size(); ++i) {
        const drawing::Segment &a = result.drawing.segments[i], &b = expected.drawing.segments[i];
        ASSERT_TRUE(a.from == b.from && a.to == b.to && a.visible == b.visible && a.edge == b.edge) << k;
      }
    }
  });
}

// Coordinates as multiples of a 2^-16th of the size, which moving by 2^10 sizes keeps to the last bit.
Shape on_a_lattice(Shape shape, double size) {
  for (Point& p : shape.points)
    for (double& c : p) c = std::round(c / size * 65536) / 65536 * size;
  return shape;
}

TEST(Metamorphic, SceneAndEyeMayMoveTogether) {
  for (const auto& [name, original] : zoo()) {
    const double size = std::ldexp(1.0, std::ilogb(glm::length(box_of(original).size())) + 1);
    const Shape shape = on_a_lattice(original, size);
    for (const auto& [view, projection] : views(box_of(shape))) {
      SCOPED_TRACE(name + ", " + view);
      const Result expected = draw(world_of(shape), projection);
      for (const double far : {-2.0, 64.0, 1024.0}) {
        projection::Projection moved = projection;
        const Vec3 by = size * far * Vec3(1, -0.5, 0.25);
        moved.point += by;
        if (moved.central) moved.projector += by;
        expect_same(expected, draw(world_of(shape.moved(by.x, by.y, by.z)), moved), 1e-9);
      }
    }
  }
}

TEST(Metamorphic, ASecondCopyDoesNotMatter) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    Shape twice = shape;
    twice.add(shape);
    expect_same(expected, draw(world_of(twice), view), 1e-9);
    expect_same(expected, draw(world_of({shape, renumbered(shape, 8)}), view), 1e-9);
  });
}

TEST(Metamorphic, SomethingBehindEverythingHidesNothing) {
  in_all_views([](const Shape& shape, const projection::Projection& view, const Result& expected) {
    // A small triangle in the middle of the page, farther from the viewer than the whole model.
    const Box box = box_of(shape);
    const double size = glm::length(box.size());
    const Vec3 towards = view.central ? glm::normalize(view.projector - box.centre()) : view.projector;
    Shape triangle{{}, {{0, 1, 2}}, {}};
    for (const Vec2& at : {Vec2(0.011, 0.007), Vec2(0.041, 0.017), Vec2(0.023, 0.029)}) {
      const Vec3 p = box.centre() + size * (at.x * view.u + at.y * view.v - towards);
      triangle.points.push_back({p.x, p.y, p.z});
    }
    Result result = draw(world_of({shape, triangle}), view);
    std::erase_if(result.drawing.segments, [](const drawing::Segment& s) { return s.model == 1; });
    expect_same(ink_of(expected.drawing.segments, expected.unit), ink_of(result.drawing.segments, result.unit), 1e-9);
  });
}

TEST(Metamorphic, VisibleAndHiddenLinesAreTheWireframe) {
  in_all_views([](const Shape&, const projection::Projection&, const Result& result) {
    const drawing::ViewDrawing wireframe =
        drawing::make_drawing({result.world, result.view, result.drawn, visibility::nothing_hidden(result.drawn)},
                              {1, Vec2(0)}, {"wireframe", true});
    const double all = total(ink_of(wireframe.segments, result.unit));
    EXPECT_NEAR(result.visible() + result.hidden_length(), all, 1e-7 * all);
    // No coincidence of lines makes ink.
    double edges = 0;
    for (const edges::FeatureEdge& e : result.drawn.edges) {
      const view::PageVertex &a = result.view.vertices[e.vertex[0]], &b = result.view.vertices[e.vertex[1]];
      edges += result.unit * std::hypot(b.x - a.x, b.y - a.y);
    }
    EXPECT_LE(all, edges * (1 + 1e-12));
  });
}

TEST(Metamorphic, InAGenericViewNothingCoincides) {
  for (const char* name : {"cube", "torus", "moebius", "boxes", "triangles"}) {
    const Result result = draw(world_of(zoo().at(name)), orthographic({0.3, -0.8, 0.5}));
    double edges = 0;
    for (const edges::FeatureEdge& e : result.drawn.edges) {
      const view::PageVertex &a = result.view.vertices[e.vertex[0]], &b = result.view.vertices[e.vertex[1]];
      edges += result.unit * std::hypot(b.x - a.x, b.y - a.y);
    }
    EXPECT_NEAR(result.visible() + result.hidden_length(), edges, 1e-9 * edges) << name;
  }
}

TEST(Metamorphic, ThreadsDoNotMatter) {
  for (const auto& [name, shape] : zoo())
    for (const auto& [view, projection] : views(box_of(shape))) {
      drawing::ViewDrawing first;
      for (const int threads : {1, 2, 3, 7}) {
        const ThreadLimit limit(threads);
        const drawing::ViewDrawing drawing = draw(world_of(shape), projection).drawing;
        if (threads == 1) first = drawing;
        const auto same = [](const drawing::Segment& a, const drawing::Segment& b) {
          return a.from == b.from && a.to == b.to && a.visible == b.visible && a.kind == b.kind && a.edge == b.edge &&
                 a.t == b.t;
        };
        const auto same_faces = [](const drawing::CrossingSegment& a, const drawing::CrossingSegment& b) {
          return a.faces == b.faces;
        };
        EXPECT_TRUE(std::ranges::equal(first.segments, drawing.segments, same) &&
                    std::ranges::equal(first.crossings, drawing.crossings, same_faces))
            << name << ", " << view << ", " << threads << " threads";
      }
    }
}

}  // namespace
}  // namespace epura::test::metamorphic_test
