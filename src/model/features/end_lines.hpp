// SPDX-License-Identifier: Apache-2.0
// Closed lines around an axis, in which triangles of a mesh end that are taken out, and strips between two of them.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "features/around_axis.hpp"
#include "mesh/mesh.hpp"

namespace epura::features {

/// A closed line of vertices.
struct EndLine {
  std::vector<int> vertices;
  std::vector<double> angles{};  ///< of an unrolled line: turns, which increase by one along it
  double height = 0;             ///< mean
};

/// The closed lines between the triangles that are removed (1, by triangle) and the others; empty if they are no lines,
/// or if the removed ones end in nothing.
std::vector<EndLine> end_lines(const mesh::Mesh& mesh, const std::vector<char>& removed, const AroundAxis& around);

/// Turns a line counterclockwise, with the angles of its vertices among `points`, the least first. Nothing if it does
/// not run around the axis once, or back and forth.
std::optional<EndLine> unrolled(EndLine line, const mesh::Points& points, const AroundAxis& around);

/// The angles of an unrolled circle with `count` vertices, which are numbered from `first`.
EndLine circle_line(double height, double first_angle, std::size_t count, int first);

/// The triangles between two unrolled lines, with their fronts away from the axis.
std::vector<std::array<int, 3>> strip_between(const EndLine& low, EndLine high);

/// For each vertex of lines that is within `reach` of the one before it: the first vertex in that place.
std::map<int, int> coinciding(const std::vector<EndLine>& lines, const mesh::Points& points, double reach);

/// The place of a vertex.
inline Vec3 point_at(const mesh::Points& points, int vertex) {
  const auto& [x, y, z] = points[static_cast<std::size_t>(vertex)];
  return {x, y, z};
}

}  // namespace epura::features
