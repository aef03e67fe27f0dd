// SPDX-License-Identifier: Apache-2.0
#include "features/end_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "features/limits.hpp"

namespace epura::features {

namespace {

// For each vertex of edges between removed triangles and others, the ends of these edges; empty if some edge is no
// border between two.
std::map<int, std::vector<int>> border_of(const mesh::Mesh& mesh, const std::vector<char>& removed) {
  std::map<int, std::vector<int>> links;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    int count = 0;
    for (const int t : mesh.triangles_of(edge)) count += removed[static_cast<std::size_t>(t)];
    if (count == 0 || count == edge.count) {
      if (count == 1) return {};  // the triangles end in nothing
      continue;
    }
    if (count != 1 || edge.count != 2) return {};
    links[edge.vertex[0]].push_back(edge.vertex[1]);
    links[edge.vertex[1]].push_back(edge.vertex[0]);
  }
  return links;
}

std::vector<double> angles_along(const std::vector<int>& vertices, const mesh::Points& points,
                                 const AroundAxis& around) {
  std::vector<double> angles;
  for (const int v : vertices) {
    double at = around.turn(point_at(points, v));
    if (!angles.empty()) at += std::round(angles.back() - at);
    angles.push_back(at);
  }
  return angles;
}

// The same line, begun at another vertex.
EndLine begun_at(EndLine line, std::ptrdiff_t first) {
  for (std::ptrdiff_t i = 0; i < first; ++i) line.angles[static_cast<std::size_t>(i)] += 1;
  std::rotate(line.angles.begin(), line.angles.begin() + first, line.angles.end());
  std::rotate(line.vertices.begin(), line.vertices.begin() + first, line.vertices.end());
  return line;
}

// The same line, begun at the vertex that is nearest to an angle.
EndLine begun_near(EndLine line, double angle) {
  const auto off = [&](double at) { return at - angle - std::round(at - angle); };
  const auto nearest = std::min_element(line.angles.begin(), line.angles.end(),
                                        [&](double a, double b) { return std::abs(off(a)) < std::abs(off(b)); });
  const double shift = std::round(*nearest - angle);
  const auto first = nearest - line.angles.begin();
  for (double& at : line.angles) at -= shift;
  return begun_at(std::move(line), first);
}

double angle_at(const EndLine& line, std::size_t i) {
  const std::size_t n = line.angles.size();
  return line.angles[i % n] + (i < n ? 0 : 1);
}

}  // namespace

std::vector<EndLine> end_lines(const mesh::Mesh& mesh, const std::vector<char>& removed, const AroundAxis& around) {
  std::map<int, std::vector<int>> links = border_of(mesh, removed);
  std::vector<EndLine> lines;
  while (!links.empty()) {
    EndLine line;
    int at = links.begin()->first, before = -1;
    for (auto next = links.find(at); next != links.end(); next = links.find(at)) {
      if (next->second.size() != 2) return {};
      line.vertices.push_back(at);
      line.height += around.height(mesh.point(at));
      const int to = next->second[0] == before ? next->second[1] : next->second[0];
      links.erase(next);
      before = std::exchange(at, to);
    }
    if (line.vertices.size() < 3) return {};
    line.height /= static_cast<double>(line.vertices.size());
    lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<EndLine> unrolled(EndLine line, const mesh::Points& points, const AroundAxis& around) {
  const auto turns = [&line] { return std::round(line.angles.back() - line.angles.front()); };
  line.angles = angles_along(line.vertices, points, around);
  if (turns() < 0) {
    std::reverse(line.vertices.begin(), line.vertices.end());
    line.angles = angles_along(line.vertices, points, around);
  }
  if (turns() != 1) return std::nullopt;
  for (std::size_t i = 1; i < line.angles.size(); ++i)
    if (line.angles[i] < line.angles[i - 1] - backwards) return std::nullopt;
  const auto lowest = std::min_element(line.angles.begin(), line.angles.end()) - line.angles.begin();
  return begun_at(std::move(line), lowest);
}

EndLine circle_line(double height, double first_angle, std::size_t count, int first) {
  EndLine circle{{}, {}, height};
  for (std::size_t i = 0; i < count; ++i) {
    circle.angles.push_back(first_angle + static_cast<double>(i) / static_cast<double>(count));
    circle.vertices.push_back(first + static_cast<int>(i));
  }
  return circle;
}

std::vector<std::array<int, 3>> strip_between(const EndLine& low, EndLine high) {
  high = begun_near(std::move(high), low.angles.front());
  std::vector<std::array<int, 3>> strip;
  const std::size_t m = low.vertices.size(), n = high.vertices.size();
  for (std::size_t i = 0, j = 0; i < m || j < n;) {
    const int a = low.vertices[i % m], b = high.vertices[j % n];
    const bool lower = j == n || (i < m && angle_at(low, i + 1) <= angle_at(high, j + 1));
    strip.push_back({a, lower ? low.vertices[++i % m] : high.vertices[++j % n], b});
  }
  return strip;
}

std::map<int, int> coinciding(const std::vector<EndLine>& lines, const mesh::Points& points, double reach) {
  std::map<int, int> same;
  for (const EndLine& line : lines)
    for (std::size_t i = 1; i < line.vertices.size(); ++i) {
      const int before = line.vertices[i - 1], v = line.vertices[i];
      if (glm::distance(point_at(points, before), point_at(points, v)) > reach) continue;
      const auto known = same.find(before);
      same[v] = known == same.end() ? before : known->second;
    }
  return same;
}

}  // namespace epura::features
