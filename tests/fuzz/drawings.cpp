// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cut/cut_world.hpp"
#include "numbers.hpp"
#include "report/format.hpp"
#include "targets.hpp"
#include "verify/verify.hpp"
#include "wrong_span.hpp"

namespace epura::fuzz {

namespace {

using test::Point;
using test::Result;
using test::Shape;

struct Scene {
  Shape shape;
  projection::Projection view;
  bool is_recognised;
  edges::EdgeOptions options{};
  view::ViewLimits limits{};
  std::optional<std::array<Vec3, 2>> cut{};  ///< point and normal of a plane
};

[[noreturn]] void refuse(const char* reason) { throw Error(ErrorKind::input, "scene", reason); }

// Parallel, oblique or central.
projection::Projection view_of(Numbers& numbers) {
  const int kind = numbers.below(256);
  const Vec3 away = numbers.vector(3);
  if (away == Vec3(0)) refuse("no direction");
  const Vec3 up = away.x == 0 && away.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  if (kind % 2 == 1) return test::perspective(Vec3(1.5) + 2.0 * away, Vec3(1.5), away, up);
  projection::Projection view = test::orthographic(away, up);
  if (kind % 8 == 6) {
    const double right = numbers.whole(4) / 4, above = numbers.whole(4) / 4;
    view.projector = view.n + right * view.u + above * view.v;
  }
  return view;
}

// Corners on a lattice of 4 x 4 x 4 points, so that most triangles touch, cross or cover each other; some scenes are
// flattened to needles, some vertices lie off the lattice by a little.
void add_triangles(Shape& shape, Numbers& numbers) {
  constexpr std::size_t max_triangles = 16;
  const std::array<double, 4> heights{1, 0x1p-10, 0x1p-20, 3};
  const double height = heights[static_cast<std::size_t>(numbers.below(4))];
  while (!numbers.at_end() && shape.faces.size() < max_triangles) {
    const int first = static_cast<int>(shape.points.size());
    for (int corner = 0; corner < 3; ++corner) {
      const int at = numbers.below(256);
      const double off = at >= 192 ? 0x1p-12 : 0;
      shape.points.push_back({at % 4 + off, at / 4 % 4 + off, height * (at / 16 % 4)});
    }
    shape.faces.push_back({first, first + 1, first + 2});
  }
}

void add_boxes(Shape& shape, Numbers& numbers) {
  constexpr int max_boxes = 6;
  for (int i = 0; i < max_boxes && !numbers.at_end(); ++i) {
    Point from{}, to{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int at = numbers.below(16);
      from[k] = at % 4;
      to[k] = from[k] + 1 + at / 4 % 2 + (at / 8 == 1 ? 0x1p-12 : 0);
    }
    shape.add(test::box(from, to));
  }
}

// Round and pointed bodies, and one-sided surfaces: contours, fans around one point, graphs of functions.
void add_round(Shape& shape, Numbers& numbers) {
  constexpr int max_bodies = 3;
  for (int i = 0; i < max_bodies && !numbers.at_end(); ++i) {
    const int kind = numbers.below(6), sides = 3 + numbers.below(6);
    const double radius = 1 + numbers.below(4) / 2.0, height = 1 + numbers.below(3);
    const Vec3 at = numbers.vector(2);
    const auto body = [&] {
      switch (kind) {
        case 0:
          return test::frustum(radius, radius / 2, height, sides);
        case 1:
          return test::frustum(radius, radius, height, sides);
        case 2:
          return test::fan(sides).scaled(radius);
        case 3:
          return test::moebius(sides + 2);
        case 4:
          return test::uv_sphere(sides, 3).scaled(radius);
        default:
          return test::sombrero(radius, 3).scaled(2);
      }
    };
    shape.add(body().moved(at.x, at.y, at.z));
  }
}

// Lines of the file between points of the lattice.
void add_wires(Shape& shape, Numbers& numbers) {
  const int count = numbers.below(4), first = static_cast<int>(shape.points.size());
  for (int i = 0; i < 2 * count; ++i) {
    const int at = numbers.below(64);
    shape.points.push_back({double(at % 4), double(at / 4 % 4), double(at / 16)});
    if (i % 2 == 1) shape.wires.push_back({first + i - 1, first + i});
  }
}

// What is drawn, and from which angle on folds are creases.
edges::EdgeOptions options_of(int choice) {
  edges::EdgeOptions options;
  options.crease = choice / 2 % 2 == 0;
  options.contour = choice / 4 % 2 == 0;
  options.intersection = choice / 8 % 2 == 0;
  options.tangent = choice / 16 % 2 == 1;
  options.smooth = choice / 32 % 2 == 1;
  constexpr std::array<double, 4> angles{30, 0, 90, 180};
  options.crease_angle = angles[static_cast<std::size_t>(choice / 64)];
  return options;
}

// What is less usual than a mesh that is drawn as a whole.
void add_extra(Scene& scene, int extra, Numbers& numbers) {
  const auto depth = [&] { return numbers.below(32) / 4.0; };
  if (extra == 1 || extra == 9) {
    const Vec3 normal = numbers.vector(2), point = numbers.vector(6) / 2.0;
    scene.cut = std::array{point, normal};
  }
  if (extra == 2 || extra == 9) scene.limits.near = depth();
  if (extra == 3 || extra == 9) scene.limits.far = depth();
  if (extra == 4) scene.limits.contact = std::ldexp(1, -numbers.below(24));
  if (extra == 5) add_wires(scene.shape, numbers);
  if (extra == 7) scene.options.weak_angle = 5 * numbers.below(36);
}

Scene scene_of(const std::string& bytes) {
  Numbers numbers(bytes);
  Scene scene{{}, view_of(numbers), false};
  const int choice = numbers.below(256);
  scene.is_recognised = choice % 2 == 1;
  scene.options = options_of(choice);
  const int kind = numbers.below(256), extra = kind / 2 % 16;
  add_extra(scene, extra, numbers);
  if (extra >= 13)
    add_round(scene.shape, numbers);
  else if (kind % 2 == 0)
    add_triangles(scene.shape, numbers);
  else
    add_boxes(scene.shape, numbers);
  if (scene.shape.faces.empty()) refuse("no faces");
  return scene;
}

Result draw(const Shape& shape, const Scene& scene) {
  world::World world = test::world_of(shape);
  if (scene.is_recognised) world = test::recognised(std::move(world));
  if (scene.cut) {
    const auto& [point, normal] = *scene.cut;
    world = cut::cut_world(world, scene::make_cutting_plane({{"A", "section"}, point, normal})).world;
  }
  return test::draw(std::move(world), scene.view, scene.options, scene.limits);
}

std::array<double, 2> ink_of(const Result& result) { return {result.visible(), result.hidden_length()}; }

void expect_same_ink(const Result& one, const Result& other, const char* sentence) {
  const auto [visible, hidden] = ink_of(one);
  const auto [other_visible, other_hidden] = ink_of(other);
  const double slack = 1e-7 * (visible + hidden);
  check(std::abs(visible - other_visible) <= slack && std::abs(hidden - other_hidden) <= slack, sentence);
}

bool are_same(const Result& one, const Result& other) {
  return std::equal(one.drawing.segments.begin(), one.drawing.segments.end(), other.drawing.segments.begin(),
                    other.drawing.segments.end(), [](const drawing::Segment& a, const drawing::Segment& b) {
                      return a.from == b.from && a.to == b.to && a.visible == b.visible && a.edge == b.edge;
                    });
}

void judge_hidden_lines(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  const Result result = draw(scene.shape, scene);
  const test::WrongSpan wrong = test::longest_wrong(result, scene.limits);
  check(wrong.longest < test::most_wrong, wrong.words.c_str());
}

// The order of faces, their first corners and their orientation.
void renumber(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  Shape other = scene.shape;
  std::reverse(other.faces.begin(), other.faces.end());
  for (std::size_t f = 0; f < other.faces.size(); ++f) {
    auto& face = other.faces[f];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(f % face.size()), face.end());
    if (f % 2 == 1) std::reverse(face.begin(), face.end());
  }
  expect_same_ink(draw(scene.shape, scene), draw(other, scene), "the numbering of faces changes the drawing");
}

// Powers of two are exact.
void scale(const std::string& bytes) {
  Scene scene = scene_of(bytes);
  const Result result = draw(scene.shape, scene);
  constexpr double factor = 0x1p+40;
  scene.view.point *= factor;
  if (scene.view.central) scene.view.projector *= factor;
  for (std::optional<double>* length : {&scene.limits.near, &scene.limits.far, &scene.limits.contact})
    if (*length) **length *= factor;
  if (scene.cut) scene.cut->front() *= factor;
  const Result scaled = draw(scene.shape.scaled(factor), scene);
  check(are_same(result, scaled), "a power of two in size changes the drawing");
}

void draw_on_threads(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  std::vector<Result> results;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    results.push_back(draw(scene.shape, scene));
  }
  check(are_same(results[0], results[1]), "the number of threads changes the drawing");
}

// As --verify does: points of lines, and lines across the page.
void verify_drawing(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  const Result r = draw(scene.shape, scene);
  if (r.drawing.segments.empty()) refuse("no lines");
  constexpr int samples = 50;
  const report::Verification found =
      verify::verify({r.world, r.view.projection, scene.limits, r.drawn, r.hidden, r.drawing},
                     {r.view.extent, r.view.contact.touching}, samples, true);
  check(found.is_right(), report::format_verification(found).c_str());
}

// Without a section: what is inside one body is outside of two that are the same.
void copy(const std::string& bytes) {
  Scene scene = scene_of(bytes);
  scene.cut.reset();
  Shape twice = scene.shape;
  twice.add(scene.shape);
  expect_same_ink(draw(scene.shape, scene), draw(twice, scene), "a second copy changes the drawing");
}

}  // namespace

std::span<const Target> drawings() {
  static constexpr std::array<Target, 6> all{{{"hidden-lines", judge_hidden_lines},
                                              {"numbering", renumber},
                                              {"scale", scale},
                                              {"copies", copy},
                                              {"threads", draw_on_threads},
                                              {"verify", verify_drawing}}};
  return all;
}

}  // namespace epura::fuzz
