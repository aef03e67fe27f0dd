// SPDX-License-Identifier: Apache-2.0
#include "mesh/point_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "base/vec.hpp"

namespace epura::mesh {

namespace {

// Half the length of a cross as a fraction of the diagonal of the box: about 2 mm where the drawing fills A4.
constexpr double half_of_diagonal = 0.008;

Vec3 vector_of(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

}  // namespace

void mark_lone_points(Soup& soup) {
  if (!soup.marked_points.empty() || !soup.face_ends.empty() || !soup.wires.empty()) return;
  soup.marked_points.resize(soup.points.size());
  std::iota(soup.marked_points.begin(), soup.marked_points.end(), 0);
  if (soup.points.size() > 1) soup.notes.emplace_back("has no faces and no lines: its points are drawn as crosses");
}

PointMarks add_crosses(Soup& soup, const std::string& name) {
  std::vector<int>& marked = soup.marked_points;
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  if (marked.empty()) return {};
  if (marked.size() > max_marks)
    throw Error(ErrorKind::input, name,
                "has " + std::to_string(marked.size()) + " points, of which at most " + std::to_string(max_marks) +
                    " can be drawn",
                "thin them out, or make a surface of them");
  Box box;
  for (const auto& point : soup.points)
    if (finite(vector_of(point))) box.add(vector_of(point));
  const double half = half_of_diagonal * std::hypot(box.size().x, box.size().y, box.size().z);
  PointMarks marks;
  for (const int number : marked) {
    const Vec3 at = vector_of(soup.points[static_cast<std::size_t>(number)]);
    if (!finite(at)) continue;
    ++marks.points;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 from = at, to = at;
      from[axis] = std::max(at[axis] - half, box.min[axis]);
      to[axis] = std::min(at[axis] + half, box.max[axis]);
      if (!(from[axis] < to[axis])) continue;
      const auto first = static_cast<int>(soup.points.size());
      soup.points.push_back({from.x, from.y, from.z});
      soup.points.push_back({to.x, to.y, to.z});
      soup.wires.push_back({first, first + 1});
      ++marks.arms;
    }
  }
  return marks.arms > 0 ? marks : PointMarks();
}

}  // namespace epura::mesh
