// SPDX-License-Identifier: Apache-2.0
#include "surfaces/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace epura::surfaces {

namespace {

/// What is numbered: a class before a place before a size.
struct Numbered {
  int kind;
  Vec3 place;
  double size;
};

// Equal ranks for values that differ by `slack` or less from the next one.
std::vector<int> ranks_of(const std::vector<double>& values, double slack) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<int> ranks(values.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k)
    ranks[order[k]] = ranks[order[k - 1]] + (values[order[k]] - values[order[k - 1]] > slack ? 1 : 0);
  return ranks;
}

std::vector<int> order_of(const std::vector<Numbered>& all) {
  Vec3 min(HUGE_VAL), max(-HUGE_VAL);
  for (const Numbered& one : all) {
    min = glm::min(min, one.place);
    max = glm::max(max, one.place);
  }
  const double slack = all.empty() ? 0 : 1e-4 * glm::length(max - min);
  std::vector<std::array<int, 4>> keys(all.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Numbered& one : all) values.push_back(one.place[axis]);
    const std::vector<int> ranks = ranks_of(values, slack);
    for (std::size_t i = 0; i < all.size(); ++i) keys[i][static_cast<std::size_t>(axis) + 1] = ranks[i];
  }
  for (std::size_t i = 0; i < all.size(); ++i) keys[i][0] = all[i].kind;
  std::vector<int> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const auto one = static_cast<std::size_t>(a), other = static_cast<std::size_t>(b);
    return keys[one] != keys[other] ? keys[one] < keys[other] : all[one].size < all[other].size;
  });
  return order;
}

}  // namespace

std::vector<Vec3> middles_of_faces(const mesh::Mesh& mesh, const PartFaces& part) {
  std::vector<Vec3> middles(part.faces.size(), Vec3(0));
  std::vector<double> areas(part.faces.size(), 0);
  for (int t = 0; t < static_cast<int>(part.face_of_triangle.size()); ++t) {
    const int face = part.face_of_triangle[static_cast<std::size_t>(t)];
    if (face < 0) continue;
    const std::array<int, 3> corners = mesh.triangle(t);
    const Vec3 a = mesh.point(corners[0]), b = mesh.point(corners[1]), c = mesh.point(corners[2]);
    const double area = glm::length(glm::cross(b - a, c - a));
    middles[static_cast<std::size_t>(face)] += area / 3 * (a + b + c);
    areas[static_cast<std::size_t>(face)] += area;
  }
  for (std::size_t face = 0; face < middles.size(); ++face)
    if (areas[face] > 0) middles[face] /= areas[face];
  return middles;
}

Vec3 mouth_of(const Hole& hole) {
  if (!hole.through) return hole.closed[0] && !hole.closed[1] ? hole.to : hole.from;
  const Vec3 way = hole.to - hole.from;
  const double slack = 1e-6 * glm::length(way);
  for (const int axis : {2, 0, 1})
    if (std::abs(way[axis]) > slack) return way[axis] > 0 ? hole.to : hole.from;
  return hole.from;
}

std::vector<int> numbered_faces(const PartFaces& part, const std::vector<Vec3>& middles) {
  std::vector<Numbered> all;
  for (std::size_t i = 0; i < middles.size(); ++i)
    all.push_back({static_cast<int>(part.faces[i].surface.kind), middles[i], part.faces[i].area});
  return order_of(all);
}

std::vector<int> numbered_holes(const std::vector<Hole>& holes) {
  std::vector<Numbered> all;
  for (const Hole& hole : holes) all.push_back({0, mouth_of(hole), hole.diameters.back()});
  return order_of(all);
}

std::vector<int> numbers_in(const std::vector<int>& order) {
  std::vector<int> numbers(order.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) numbers[static_cast<std::size_t>(order[i])] = static_cast<int>(i) + 1;
  return numbers;
}

std::string numbers_text(const std::string& what, const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? what + " " : ", ") + std::to_string(numbers[i]);
    if (last > i) text += (last > i + 1 ? " to " : ", ") + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace epura::surfaces
