// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "targets.hpp"
#include "wrong_span.hpp"

namespace epura::fuzz {

namespace {

using test::Point;
using test::Result;
using test::Shape;

/// Numbers from bytes; zeros after their end.
class Numbers {
 public:
  explicit Numbers(const std::string& bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return next_ >= bytes_.size(); }
  /// From 0 to `count` - 1.
  int below(int count) { return (at_end() ? 0 : static_cast<unsigned char>(bytes_[next_++])) % count; }
  /// A whole number from -`most` to `most`.
  double whole(int most) { return below(2 * most + 1) - most; }
  Vec3 vector(int most) {
    const double x = whole(most), y = whole(most), z = whole(most);
    return {x, y, z};
  }

 private:
  const std::string& bytes_;
  std::size_t next_ = 0;
};

struct Scene {
  Shape shape;
  projection::Projection view;
  bool is_recognised;
};

[[noreturn]] void refuse(const char* reason) { throw Error(ErrorKind::input, "scene", reason); }

projection::Projection view_of(Numbers& numbers) {
  const bool is_central = numbers.below(2) == 1;
  const Vec3 away = numbers.vector(3);
  if (away == Vec3(0)) refuse("no direction");
  const Vec3 up = away.x == 0 && away.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  if (!is_central) return test::orthographic(away, up);
  const Vec3 eye = Vec3(1.5) + 2.0 * away;
  return test::perspective(eye, Vec3(1.5), away, up);
}

// Corners on a lattice of 4 x 4 x 4 points, so that most triangles touch, cross or cover each other; some scenes are
// flattened to needles, some vertices lie off the lattice by a little.
void add_triangles(Shape& shape, Numbers& numbers) {
  constexpr std::size_t most_triangles = 16;
  const std::array<double, 4> heights{1, 0x1p-10, 0x1p-20, 3};
  const double height = heights[static_cast<std::size_t>(numbers.below(4))];
  while (!numbers.at_end() && shape.faces.size() < most_triangles) {
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
  constexpr int most_boxes = 6;
  for (int i = 0; i < most_boxes && !numbers.at_end(); ++i) {
    Point from{}, to{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int at = numbers.below(16);
      from[k] = at % 4;
      to[k] = from[k] + 1 + at / 4 % 2 + (at / 8 == 1 ? 0x1p-12 : 0);
    }
    shape.add(test::box(from, to));
  }
}

Scene scene_of(const std::string& bytes) {
  Numbers numbers(bytes);
  Scene scene{{}, view_of(numbers), numbers.below(2) == 1};
  if (numbers.below(2) == 0)
    add_triangles(scene.shape, numbers);
  else
    add_boxes(scene.shape, numbers);
  if (scene.shape.faces.empty()) refuse("no faces");
  return scene;
}

Result draw(const Shape& shape, const Scene& scene) {
  scene::World world = test::world_of(shape);
  return test::draw(scene.is_recognised ? test::recognised(std::move(world)) : std::move(world), scene.view);
}

std::array<double, 2> ink_of(const Result& result) { return {result.visible(), result.hidden_length()}; }

void expect_same_ink(const Result& one, const Result& other, const char* sentence) {
  const auto [visible, hidden] = ink_of(one);
  const auto [other_visible, other_hidden] = ink_of(other);
  const double slack = 1e-7 * (visible + hidden);
  check(std::abs(visible - other_visible) <= slack && std::abs(hidden - other_hidden) <= slack, sentence);
}

void judge_hidden_lines(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  const Result result = draw(scene.shape, scene);
  const test::WrongSpan wrong = test::longest_wrong(result);
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
  const Result scaled = draw(scene.shape.scaled(factor), scene);
  const auto &one = result.drawing.segments, &other = scaled.drawing.segments;
  const bool same = std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
    return a.from == b.from && a.to == b.to && a.visible == b.visible && a.edge == b.edge;
  });
  check(same, "a power of two in size changes the drawing");
}

void copy(const std::string& bytes) {
  const Scene scene = scene_of(bytes);
  Shape twice = scene.shape;
  twice.add(scene.shape);
  expect_same_ink(draw(scene.shape, scene), draw(twice, scene), "a second copy changes the drawing");
}

}  // namespace

std::span<const Target> drawings() {
  static constexpr std::array<Target, 4> all{
      {{"hidden-lines", judge_hidden_lines}, {"numbering", renumber}, {"scale", scale}, {"copies", copy}}};
  return all;
}

}  // namespace epura::fuzz
