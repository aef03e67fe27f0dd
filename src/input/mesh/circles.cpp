// SPDX-License-Identifier: Apache-2.0
#include "mesh/circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>

#include "base/angle.hpp"
#include "base/circle_fit.hpp"
#include "base/curve_runs.hpp"
#include "base/portable_math.hpp"

namespace epura::mesh {

namespace {

constexpr int min_edges = 5;
constexpr double min_sweep = 60 * degree;
constexpr double max_step = 45 * degree;       // for one edge
constexpr double max_mean_step = 30 * degree;  // twelve edges per turn
constexpr double max_step_in_means = 4;
constexpr double angle_slack = 1e-3 * degree;

struct Fit {
  Vec3 centre, axis;
  double radius, deviation, tolerance;
};

double angle_between(const Vec3& a, const Vec3& b) {
  return portable_atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// A line of feature edges, with circles fitted to runs of it.
struct Line {
  const PlacedMesh& mesh;
  const FeatureLine& line;
  double tolerance;

  [[nodiscard]] int size() const { return static_cast<int>(line.vertices.size()); }
  [[nodiscard]] int vertex(int i) const { return line.vertices[static_cast<std::size_t>((i + size()) % size())]; }
  [[nodiscard]] const Vec3& point(int i) const { return mesh.point(vertex(i)); }
  [[nodiscard]] Vec3 step(int i) const { return point(i + 1) - point(i); }

  // End of the shortest run that turns far enough to determine its circle.
  [[nodiscard]] int window(int first, int max) const {
    for (int last = first + min_edges; last <= max; ++last) {
      const double turned = angle_between(step(first), step(last - 1));
      if (turned + angle_between(step(last - 2), step(last - 1)) >= min_sweep - angle_slack) return last;
    }
    return max;
  }

  [[nodiscard]] std::optional<Fit> fit(int first, int last) const;
};

// Whether the steps have one direction of rotation, none is much longer than the others, and there are twelve or more
// per turn.
bool steps_of_circle(std::span<const Vec2> points, const Vec2& centre, bool whole) {
  double sweep = 0, longest = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 a = points[i] - centre, b = points[i + 1] - centre;
    const double angle = portable_atan2(cross(a, b), glm::dot(a, b));
    if (!(angle > 0)) return false;
    sweep += angle;
    longest = std::max(longest, angle);
  }
  const double mean = sweep / static_cast<double>(points.size() - 1);
  if (longest > std::min(max_step, max_step_in_means * mean) + angle_slack) return false;
  const double turn = 2 * std::numbers::pi;
  return mean <= max_mean_step + angle_slack && sweep >= min_sweep - angle_slack &&
         (whole ? std::abs(sweep - turn) < angle_slack : sweep < turn);
}

std::optional<Fit> Line::fit(int first, int last) const {
  if (last - first < min_edges) return std::nullopt;
  // The plane is that of the area between the run and its chord.
  const auto count = static_cast<double>(last - first + 1);
  Vec3 middle(0), area(0);
  for (int i = first; i <= last; ++i) middle += point(i) / count;
  for (int i = first; i < last; ++i) area += glm::cross(point(i) - middle, point(i + 1) - middle);
  area += glm::cross(point(last) - middle, point(first) - middle);
  if (!(glm::length(area) > 0)) return std::nullopt;
  const Vec3 axis = glm::normalize(area);
  const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const Vec3 v = glm::cross(axis, u);

  std::vector<Vec2> points;
  double off_plane = 0;
  for (int i = first; i <= last; ++i) {
    const Vec3 p = point(i) - middle;
    points.emplace_back(glm::dot(p, u), glm::dot(p, v));
    off_plane = std::max(off_plane, std::abs(glm::dot(p, axis)));
  }
  const auto circle = fit_circle(points);
  if (!circle || std::hypot(circle->deviation, off_plane) > tolerance * circle->radius) return std::nullopt;
  const bool whole = line.closed && last - first == size();
  if (!steps_of_circle(points, circle->centre, whole)) return std::nullopt;
  return Fit{middle + circle->centre.x * u + circle->centre.y * v, axis, circle->radius,
             std::hypot(circle->deviation, off_plane), tolerance * circle->radius};
}

// Starts at the lowest vertex and continues to its lower neighbour; an arc starts at the lower one of its ends.
void order_vertices(MeshCircle& circle) {
  std::vector<int>& vertices = circle.vertices;
  if (circle.whole) std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
  const bool backwards = circle.whole ? vertices.back() < vertices[1] : vertices.back() < vertices.front();
  if (!backwards) return;
  std::reverse(vertices.begin() + (circle.whole ? 1 : 0), vertices.end());
  circle.axis = -circle.axis;
}

MeshCircle circle_of(const Line& line, const CurveRun<Fit>& run) {
  const Fit& fit = run.curve;
  MeshCircle circle{fit.centre, fit.axis, fit.radius, fit.deviation, {}, run.last - run.first == line.size()};
  for (int i = run.first; i <= run.last - (circle.whole ? 1 : 0); ++i) circle.vertices.push_back(line.vertex(i));
  order_vertices(circle);
  return circle;
}

}  // namespace

std::vector<MeshCircle> find_circles(const PlacedMesh& mesh, double crease_angle, double tolerance) {
  std::vector<MeshCircle> circles;
  for (const FeatureLine& features : find_feature_lines(mesh, crease_angle, max_step + angle_slack)) {
    const Line line{mesh, features, tolerance};
    const auto window = [&](int first, int max) { return line.window(first, max); };
    const auto fit = [&](int first, int last) { return line.fit(first, last); };
    for (const CurveRun<Fit>& run : find_curve_runs<Fit>(line.size(), features.closed, window, fit))
      circles.push_back(circle_of(line, run));
  }
  std::sort(circles.begin(), circles.end(),
            [](const MeshCircle& a, const MeshCircle& b) { return a.vertices < b.vertices; });
  return circles;
}

std::vector<MeshCircle> find_circles(const Mesh& mesh, double crease_angle, double tolerance) {
  std::vector<Vec3> points;
  for (const auto& [x, y, z] : mesh.points) points.emplace_back(x, y, z);
  std::vector<std::array<int, 3>> triangles;
  for (int t = 0; t < mesh.triangle_count(); ++t) triangles.push_back(mesh.triangle(t));
  return find_circles(PlacedMesh{mesh, points, triangles}, crease_angle, tolerance);
}

}  // namespace epura::mesh
