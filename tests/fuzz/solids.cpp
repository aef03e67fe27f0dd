// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "known_parts.hpp"
#include "laboratory/shapes.hpp"
#include "mesh/read.hpp"
#include "numbers.hpp"

namespace epura::fuzz {

namespace {

using laboratory::Point;
using laboratory::Shape;

Shape shape_of(const std::string& obj) {
  const mesh::Soup soup = mesh::format_named("obj")->read(obj, "made", {});
  Shape shape;
  shape.points.assign(soup.points.begin(), soup.points.end());
  int begin = 0;
  for (const int end : soup.face_ends) {
    shape.faces.emplace_back(soup.corners.begin() + begin, soup.corners.begin() + end);
    begin = end;
  }
  return shape;
}

double size(Numbers& numbers, double least, double step) { return least + step * numbers.below(8); }

// Through, blind, with a drill point, counterbored or countersunk.
std::vector<Vec2> stepped(Numbers& numbers, double thickness) {
  const double radius = size(numbers, 2, 0.5), deep = thickness / 3;
  switch (numbers.below(5)) {
    case 0:
      return {{radius, thickness}, {radius, 0}};
    case 1:
      return {{radius, thickness}, {radius, deep}};
    case 2:
      return {{radius, thickness}, {radius, deep}, {1e-9, deep / 2}};
    case 3:
      return {{1.8 * radius, thickness}, {1.8 * radius, 2 * deep}, {radius, 2 * deep}, {radius, 0}};
    default:
      return {{radius + deep, thickness}, {radius, 2 * deep}, {radius, 0}};
  }
}

std::string holed_plate(Numbers& numbers) {
  const Vec2 cell{size(numbers, 24, 4), size(numbers, 24, 4)};
  const int columns = 1 + numbers.below(3), rows = 1 + numbers.below(2);
  const double thickness = size(numbers, 4, 3);
  if (numbers.below(4) > 0)
    return test::plate(cell, columns, rows, thickness, test::stepped_hole(stepped(numbers, thickness)));
  const double radius = size(numbers, 2, 0.5), length = size(numbers, 4, 0.5);
  const double floor = numbers.below(2) * thickness / 2;
  return test::plate(cell, columns, rows, thickness, [=](const Vec2& middle) {
    const test::Loop slot = test::slot(middle, radius, length);
    return test::Hole{{slot, thickness}, {slot, floor}};
  });
}

// Steps, cones, and edges that are rounded.
std::string turned_part(Numbers& numbers) {
  std::vector<Vec2> profile{{0, numbers.below(2) == 0 ? 1e-9 : 3.0}};
  const double bore = profile.front().y;
  double x = 0, radius = size(numbers, 4, 2);
  profile.emplace_back(x, radius);
  const int steps = 1 + numbers.below(5);
  for (int i = 0; i < steps; ++i) {
    profile.emplace_back(x += size(numbers, 2, 4), radius);
    const double next = size(numbers, 4, 2);
    const int kind = numbers.below(4);
    const double rise = next - radius, reach = std::abs(rise);
    if (kind == 1) x += reach;  // a cone or chamfer
    if (kind == 2 && reach > 0)
      for (int k = 1; k < 8; ++k) {
        const double angle = 90.0 * k / 8;
        const double along = rise > 0 ? 1 - test::cosine(angle) : test::sine(angle);
        const double across = rise > 0 ? test::sine(angle) : 1 - test::cosine(angle);
        profile.emplace_back(x + reach * along, radius + rise * across);
      }
    if (kind == 2) x += reach;
    radius = next;
    if (glm::distance(profile.back(), Vec2(x, radius)) > 0) profile.emplace_back(x, radius);
  }
  profile.emplace_back(x, bore);
  if (bore == 3) profile.emplace_back(0, bore);
  return test::shaft(profile);
}

Shape ring(Numbers& numbers) {
  const double tube = size(numbers, 2, 1), radius = size(numbers, 5, 3);
  const int steps = 6 + numbers.below(12);
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i < steps; ++i) {
    const double angle = 360.0 * i / steps;
    profile.push_back({radius + tube * test::cosine(angle), tube * test::sine(angle)});
  }
  profile.push_back(profile.front());
  return laboratory::revolved(profile, 12 + 4 * numbers.below(8));
}

// Triangles between points of a lattice, which touch, cross or cover each other.
Shape loose_triangles(Numbers& numbers) {
  Shape shape;
  const int count = 1 + numbers.below(12);
  for (int i = 0; i < 3 * count; ++i) {
    const int at = numbers.below(64);
    shape.points.push_back({5.0 * (at % 4), 5.0 * (at / 4 % 4), 5.0 * (at / 16)});
  }
  for (int i = 0; i < count; ++i) shape.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return shape;
}

Shape wires(Numbers& numbers) {
  Shape shape = laboratory::box({0, 0, 0}, {10, 10, 10});
  const int count = 2 + numbers.below(8), first = static_cast<int>(shape.points.size());
  for (int i = 0; i < count; ++i) {
    const int at = numbers.below(64);
    shape.points.push_back({5.0 * (at % 4), 5.0 * (at / 4 % 4), 5.0 * (at / 16)});
    if (i > 0) shape.wires.push_back({first + i - 1, first + i});
  }
  return shape;
}

Shape known_part(Numbers& numbers) {
  static const std::vector<test::KnownPart> all = [] {
    std::vector<test::KnownPart> parts;
    for (const auto& some : {test::plates(), test::round_parts(), test::interrupted_circles(), test::blocks()})
      parts.insert(parts.end(), some.begin(), some.end());
    return parts;
  }();
  return shape_of(all[static_cast<std::size_t>(numbers.below(static_cast<int>(all.size())))].obj);
}

Shape surface(Numbers& numbers) {
  const int kind = numbers.below(4), first = numbers.below(240), second = numbers.below(240);
  switch (kind) {
    case 0:
      return laboratory::moebius(8 + first % 24).scaled(10);
    case 1:
      return laboratory::klein_bottle(8 + first % 8, 4 + second % 6).scaled(10);
    case 2:
      return laboratory::sombrero(2 + 0.5 * (first % 8), 6 + second % 14).scaled(10);
    default:
      return laboratory::uv_sphere(6 + first % 30, 4 + second % 16).scaled(10);
  }
}

Shape cone(Numbers& numbers) {
  const double radius = size(numbers, 5, 2), top = size(numbers, 1, 2), height = size(numbers, 5, 5);
  const int sides = 3 + numbers.below(48);
  return laboratory::frustum(radius, top, height, sides);
}

// Plates behind one another: exactly, a little aside, anywhere, or five in each place.
Shape stack(Numbers& numbers) {
  const int count = 60 * (1 + numbers.below(4)), kind = numbers.below(4);
  const double pitch = std::ldexp(1, -numbers.below(20));
  Shape shape;
  for (int i = 0; i < count; ++i) {
    const Vec2 shift = kind == 1 ? Vec2(pitch * i) : kind == 2 ? Vec2(0.3 * (i * 7 % 10), 0.2 * (i * 3 % 10)) : Vec2(0);
    shape.add(laboratory::plate(shift.x, shift.y, 20 + shift.x, 15 + shift.y, -pitch * (kind == 3 ? i / 5 : i)));
  }
  return shape;
}

// Blades around one point, upright or flat, several of them above one another.
Shape hub(Numbers& numbers) {
  const int blades = 64 * (1 + numbers.below(4)), levels = 1 + numbers.below(3);
  Shape shape;
  for (int i = 0; i < levels; ++i) shape.add(laboratory::fan(blades).scaled(10).moved(0, 0, i));
  if (numbers.below(2) == 1)
    for (std::size_t i = 0; i < shape.points.size(); ++i) shape.points[i][2] += 0.5 * static_cast<double>(i % 3);
  return shape;
}

Shape one_body(Numbers& numbers) {
  switch (numbers.below(14)) {
    case 0:
      return laboratory::box({0, 0, 0}, {size(numbers, 5, 5), size(numbers, 5, 5), size(numbers, 5, 5)});
    case 1:
      return shape_of(holed_plate(numbers));
    case 2:
      return shape_of(turned_part(numbers));
    case 3: {
      const double pitch = size(numbers, 20, 2);
      const int holes = 3 + numbers.below(4);
      return shape_of(test::flange(holes, {10, 2 * pitch - 10, pitch, size(numbers, 2, 0.5)}, 8));
    }
    case 4: {
      const double radius = size(numbers, 1, 1);
      const Vec2 sides{size(numbers, 20, 5), size(numbers, 20, 5)};
      const double depth = size(numbers, 5, 5);
      return shape_of(test::block(test::rounded_rectangle(sides, radius), depth));
    }
    case 5:
      return shape_of(test::waves());
    case 6:
      return cone(numbers);
    case 7:
      return ring(numbers);
    case 8:
      return loose_triangles(numbers);
    case 9:
      return wires(numbers);
    case 10:
      return surface(numbers);
    case 12:
      return stack(numbers);
    case 13:
      return hub(numbers);
    default:
      return known_part(numbers);
  }
}

// With another axis upright.
Shape turned(Shape shape, int axis) {
  for (Point& p : shape.points) std::rotate(p.begin(), p.begin() + axis, p.end());
  return shape;
}

}  // namespace

mesh::Soup made_model(const std::string& bytes) {
  Numbers numbers(bytes);
  constexpr int max_bodies = 4;
  const int style = numbers.below(8);
  Shape all;
  int count = 0;
  while (!numbers.at_end() && count < max_bodies) {
    Shape body = one_body(numbers);
    body = turned(std::move(body), numbers.below(3));
    body.bodies.assign(body.faces.size(), count++);
    const double x = 5 * numbers.whole(4), y = 5 * numbers.whole(4), z = 5 * numbers.whole(4);
    all.add(body.moved(x, y, z));
  }
  if (count == 0) throw Error(ErrorKind::input, "made", "no bodies");
  mesh::Soup soup;
  soup.format = "made";
  soup.single_precision = style % 4 == 1;
  soup.printed = style % 4 == 2;
  for (Point& p : all.points)
    for (double& c : p) {
      if (soup.single_precision) c = static_cast<float>(c);
      if (soup.printed) c = *parse_number(format_fixed(c, 4));
    }
  soup.points.assign(all.points.begin(), all.points.end());
  for (const auto& face : all.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  soup.wires = all.wires;
  if (style < 4) return soup;
  soup.face_body = all.bodies;
  for (int i = 0; i < count; ++i) soup.body_names.push_back("body " + std::to_string(i + 1));
  return soup;
}

}  // namespace epura::fuzz
