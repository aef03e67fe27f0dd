// SPDX-License-Identifier: Apache-2.0
// Replaces helical threads by the cylinders through their crests.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "design/helical_threads.hpp"
#include "design/tolerances.hpp"
#include "mesh/edge_table.hpp"

namespace epura::design {

namespace {

using features::SurfaceKind;

constexpr double same_radius = 1e-6;      // relative to the radius
constexpr double clear_of_crests = 0.05;  // of the depth of a thread
constexpr std::size_t least_points = 48;  // of a circle
constexpr double backwards = 0.02;        // turns by which a line may run back around the axis

/// A closed line at an end of a thread. Its angles, in turns, increase by one along it.
struct EndLine {
  std::vector<int> vertices;
  std::vector<double> angles;
  double height = 0;  ///< mean
};

class Replacer {
 public:
  Replacer(mesh::Mesh& mesh, const features::PartFaces& part, const HelicalThread& thread)
      : mesh_(mesh), part_(part), thread_(thread), removed_(mesh.polygon.size(), 0) {
    const Vec3 aside = std::abs(thread.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    u_ = glm::normalize(glm::cross(thread.axis, aside));
    v_ = glm::cross(thread.axis, u_);
    double least = HUGE_VAL, most = 0;
    for (const int t : thread.triangles) {
      removed_[static_cast<std::size_t>(t)] = 1;
      for (const int v : mesh.triangle(t)) {
        least = std::min(least, radius(mesh.point(v)));
        most = std::max(most, radius(mesh.point(v)));
      }
    }
    clearance_ = clear_of_crests * (most - least);
  }

  std::optional<std::vector<int>> replace() {
    mesh::Points old = mesh_.points;
    if (auto lines = lines_of_cylinder()) {
      rebuild(*lines);
      check(faces_.size() == mesh_.polygon.size(), "every triangle has a face");
      return std::move(faces_);
    }
    mesh_.points = std::move(old);
    return std::nullopt;
  }

 private:
  [[nodiscard]] double height(const Vec3& p) const { return glm::dot(p - thread_.origin, thread_.axis); }
  [[nodiscard]] double radius(const Vec3& p) const { return glm::length(glm::cross(p - thread_.origin, thread_.axis)); }
  [[nodiscard]] double angle(const Vec3& p) const {
    return portable_atan2(glm::dot(p - thread_.origin, v_), glm::dot(p - thread_.origin, u_)) / full_turn;
  }
  [[nodiscard]] bool is_across(const features::PartSurface& surface) const {
    return surface.kind == SurfaceKind::plane && are_parallel(surface.axis, thread_.axis);
  }
  [[nodiscard]] bool is_around(const features::PartSurface& surface) const {
    return surface.kind == SurfaceKind::cone && are_parallel(surface.axis, thread_.axis);
  }

  [[nodiscard]] double reach_of(int triangle) const {
    double most = 0;
    for (const int v : mesh_.triangle(triangle)) most = std::max(most, radius(mesh_.point(v)));
    return most;
  }

  // The face beside a line, if that is a single one; -1: otherwise.
  [[nodiscard]] int face_beside(const EndLine& line) const {
    int found = -1;
    for (std::size_t i = 0; i < line.vertices.size(); ++i) {
      const auto [a, b] = std::minmax(line.vertices[i], line.vertices[(i + 1) % line.vertices.size()]);
      for (const int t : mesh_.triangles_of(*mesh_.edge_between({a, b}))) {
        if (removed_[static_cast<std::size_t>(t)] != 0) continue;
        const int face = part_.face_of_triangle[static_cast<std::size_t>(t)];
        if (face < 0 || (found >= 0 && face != found)) return -1;
        found = face;
      }
    }
    return found;
  }

  /// What is done with the face beside an end of the thread.
  enum class Ending {
    moved,    ///< its border is moved to the crests
    clipped,  ///< it surrounds the thread: what is within the thread is cut off
    remade    ///< a chamfer, cut by the thread: it is made anew between its other end and the crests
  };
  struct End {
    Ending ending = Ending::moved;
    int face = -1;
    double outermost = 0;  ///< radius of the line
  };

  End end_at(const EndLine& line) const {
    End end{Ending::moved, face_beside(line)};
    for (const int v : line.vertices) end.outermost = std::max(end.outermost, radius(mesh_.point(v)));
    if (end.face < 0) return end;
    const features::PartSurface& surface = part_.faces[static_cast<std::size_t>(end.face)].surface;
    double farthest = 0;
    for (int t = 0; t < mesh_.triangle_count(); ++t)
      if (part_.face_of_triangle[static_cast<std::size_t>(t)] == end.face) farthest = std::max(farthest, reach_of(t));
    const bool surrounds = farthest > end.outermost * (1 + same_radius);
    if (surrounds && (is_across(surface) || is_around(surface))) end.ending = Ending::clipped;
    if (!surrounds && is_around(surface)) end.ending = Ending::remade;
    return end;
  }

  // Height at which a plane or cone has a radius.
  [[nodiscard]] double height_at(int face, double of_radius) const {
    const features::PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
    if (!is_around(surface)) return height(surface.origin);
    return height(surface.origin + (of_radius - surface.radius) / surface.slope * surface.axis);
  }

  // From below: closed lines around the axis, with those of the cylinder between the others; nothing if there are none.
  std::optional<std::vector<EndLine>> lines_of_cylinder() {
    std::vector<EndLine> lines = end_lines();
    if (lines.size() != 2) return std::nullopt;
    std::array<End, 2> ends{end_at(lines[0]), end_at(lines[1])};
    if (lines[0].height > lines[1].height) std::swap(ends[0], ends[1]);
    for (const End& end : ends)
      for (int t = 0; end.ending == Ending::remade && t < mesh_.triangle_count(); ++t)
        if (part_.face_of_triangle[static_cast<std::size_t>(t)] == end.face) removed_[static_cast<std::size_t>(t)] = 1;
    lines = end_lines();
    if (lines.size() != 2) return std::nullopt;
    if (lines[0].height > lines[1].height) std::swap(lines[0], lines[1]);
    for (const std::size_t i : {0U, 1U}) {
      if (ends[i].ending == Ending::moved && !move_to_crests(lines[i])) return std::nullopt;
      if (ends[i].ending == Ending::clipped && !clip(ends[i], lines[i])) return std::nullopt;
      if (!set_angles(lines[i])) return std::nullopt;
    }
    std::vector<EndLine> all{lines[0]};
    const int cylinder = static_cast<int>(part_.faces.size());
    for (const std::size_t i : {0U, 1U}) {
      const bool is_there = ends[i].ending == Ending::moved || std::abs(radius(mesh_.point(lines[i].vertices.front())) -
                                                                        thread_.crest) <= same_radius * thread_.crest;
      if (!is_there) all.push_back(circle_beside(lines[i], height_at(ends[i].face, thread_.crest)));
      if (i == 0 && !is_there) strips_.push_back(ends[i].face);
      if (i == 0) strips_.push_back(cylinder);
      if (i == 1 && !is_there) strips_.push_back(ends[i].face);
    }
    all.push_back(lines[1]);
    return all;
  }

  // Cuts off what a face has within a circle around the thread, which the line becomes.
  bool clip(const End& end, EndLine& line) {
    const double limit = std::max(end.outermost, thread_.crest) + clearance_;
    const double at = height_at(end.face, limit);
    std::map<std::array<int, 2>, int> crossings;  // of edges with the circle
    std::map<int, int> next;
    const auto is_out = [&](int v) { return radius(mesh_.point(v)) > limit * (1 + same_radius); };
    const auto crossing = [&](int a, int b) {
      const auto [known, is_new] = crossings.try_emplace({std::min(a, b), std::max(a, b)}, -1);
      if (is_new) known->second = add_crossing(mesh_.point(a), mesh_.point(b), limit, at);
      return known->second;
    };
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      if (part_.face_of_triangle[static_cast<std::size_t>(t)] != end.face) continue;
      std::array<int, 3> c = mesh_.triangle(t);
      const auto out = std::count_if(c.begin(), c.end(), is_out);
      if (out == 3) continue;
      removed_[static_cast<std::size_t>(t)] = 1;
      if (out == 0) continue;
      // The corner that is alone on its side comes first.
      while (is_out(c[0]) != (out == 1) || is_out(c[1]) == is_out(c[0])) std::rotate(c.begin(), c.begin() + 1, c.end());
      const int p = crossing(c[0], c[1]), q = crossing(c[0], c[2]);
      if (out == 1) {
        added_.push_back({{c[0], p, q}, t});
        next[q] = p;
      } else {
        added_.push_back({{p, c[1], c[2]}, t});
        added_.push_back({{p, c[2], q}, t});
        next[p] = q;
      }
    }
    // Each crossing is in two triangles, unless another face is beside one.
    line.vertices.clear();
    line.height = at;
    if (next.size() != crossings.size() || next.empty()) return false;
    for (int v = next.begin()->first; line.vertices.size() <= next.size();) {
      line.vertices.push_back(v);
      const auto following = next.find(v);
      if (following == next.end()) return false;
      v = following->second;
      if (v == line.vertices.front()) break;
    }
    return line.vertices.size() == next.size();
  }

  // The point of a segment at a distance from the axis, at a certain height.
  int add_crossing(const Vec3& a, const Vec3& b, double limit, double at) {
    const auto flat = [&](const Vec3& p) { return p - thread_.origin - height(p) * thread_.axis; };
    const Vec3 from = flat(a), step = flat(b) - from;
    const double square = glm::dot(step, step), half = glm::dot(from, step);
    const double rest = glm::dot(from, from) - limit * limit;
    const double root = std::sqrt(std::max(half * half - square * rest, 0.0));
    // The way out of the circle, in the direction in which the distance grows.
    const bool outwards = glm::length(flat(b)) > glm::length(from);
    const double t = std::clamp((-half + (outwards ? root : -root)) / square, 0.0, 1.0);
    const Vec3 place = thread_.origin + at * thread_.axis + limit * glm::normalize(from + t * step);
    mesh_.points.push_back({place.x, place.y, place.z});
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  // The closed lines between the triangles that are removed and the others; empty if they are no lines.
  [[nodiscard]] std::vector<EndLine> end_lines() const {
    std::map<int, std::vector<int>> beside;
    for (const mesh::MeshEdge& edge : mesh_.edges) {
      int removed = 0;
      for (const int t : mesh_.triangles_of(edge)) removed += removed_[static_cast<std::size_t>(t)];
      if (removed == 0 || removed == edge.count) {
        if (removed == 1) return {};  // the thread ends in nothing
        continue;
      }
      if (removed != 1 || edge.count != 2) return {};
      beside[edge.vertex[0]].push_back(edge.vertex[1]);
      beside[edge.vertex[1]].push_back(edge.vertex[0]);
    }
    std::vector<EndLine> lines;
    while (!beside.empty()) {
      EndLine line;
      int at = beside.begin()->first, before = -1;
      for (auto next = beside.find(at); next != beside.end(); next = beside.find(at)) {
        if (next->second.size() != 2) return {};
        line.vertices.push_back(at);
        line.height += height(mesh_.point(at));
        const int to = next->second[0] == before ? next->second[1] : next->second[0];
        beside.erase(next);
        before = std::exchange(at, to);
      }
      if (line.vertices.size() < 3) return {};
      line.height /= static_cast<double>(line.vertices.size());
      lines.push_back(std::move(line));
    }
    return lines;
  }

  [[nodiscard]] Vec3 on_crests(int vertex) const {
    const Vec3 p = mesh_.point(vertex);
    const Vec3 flat = p - thread_.origin - height(p) * thread_.axis;
    return p - flat + thread_.crest * glm::normalize(flat);
  }

  [[nodiscard]] Vec3 area_of(int triangle) const {
    const auto [a, b, c] = mesh_.triangle(triangle);
    return glm::cross(mesh_.point(b) - mesh_.point(a), mesh_.point(c) - mesh_.point(a));
  }

  // Moves a line to the cylinder, and says whether no face beside it is turned over.
  bool move_to_crests(const EndLine& line) {
    std::vector<int> vertices = line.vertices;
    std::sort(vertices.begin(), vertices.end());
    std::vector<std::pair<int, Vec3>> areas;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const std::array<int, 3> corners = mesh_.triangle(t);
      if (removed_[static_cast<std::size_t>(t)] == 0 && std::any_of(corners.begin(), corners.end(), [&](int v) {
            return std::binary_search(vertices.begin(), vertices.end(), v);
          }))
        areas.emplace_back(t, area_of(t));
    }
    for (const int v : line.vertices) {
      const Vec3 place = on_crests(v);
      mesh_.points[static_cast<std::size_t>(v)] = {place.x, place.y, place.z};
    }
    const double least = same_radius * thread_.crest * thread_.crest;
    return std::all_of(areas.begin(), areas.end(), [&](const auto& of_triangle) {
      const Vec3 now = area_of(of_triangle.first), before = of_triangle.second;
      return glm::length(now) <= least || glm::length(before) <= least || glm::dot(now, before) > 0;
    });
  }

  // A circle of the cylinder, with at least as many points as a line.
  EndLine circle_beside(const EndLine& line, double at) {
    EndLine circle{{}, {}, at};
    const std::size_t points = std::max(line.vertices.size(), least_points);
    for (std::size_t i = 0; i < points; ++i) {
      circle.angles.push_back(line.angles.front() + static_cast<double>(i) / static_cast<double>(points));
      const double around = circle.angles.back() * full_turn;
      const Vec3 out = portable_cos(around) * u_ + portable_sin(around) * v_;
      const Vec3 place = thread_.origin + at * thread_.axis + thread_.crest * out;
      circle.vertices.push_back(static_cast<int>(mesh_.points.size()));
      mesh_.points.push_back({place.x, place.y, place.z});
    }
    return circle;
  }

  // Unrolls a line counterclockwise; false if it does not run around the axis once, or back and forth.
  [[nodiscard]] bool set_angles(EndLine& line) const {
    const auto unroll = [&] {
      line.angles.clear();
      for (const int v : line.vertices) {
        double at = angle(mesh_.point(v));
        if (!line.angles.empty()) at += std::round(line.angles.back() - at);
        line.angles.push_back(at);
      }
      return std::round(line.angles.back() - line.angles.front());
    };
    double around = unroll();
    if (around < 0) {
      std::reverse(line.vertices.begin(), line.vertices.end());
      around = unroll();
    }
    if (around != 1) return false;
    for (std::size_t i = 1; i < line.angles.size(); ++i)
      if (line.angles[i] < line.angles[i - 1] - backwards) return false;
    const auto lowest = std::min_element(line.angles.begin(), line.angles.end()) - line.angles.begin();
    for (std::ptrdiff_t i = 0; i < lowest; ++i) line.angles[static_cast<std::size_t>(i)] += 1;
    std::rotate(line.angles.begin(), line.angles.begin() + lowest, line.angles.end());
    std::rotate(line.vertices.begin(), line.vertices.begin() + lowest, line.vertices.end());
    return true;
  }

  // Begins a line at the vertex that is nearest to an angle.
  static void begin_near(EndLine& line, double angle) {
    const auto off = [&](double at) { return at - angle - std::round(at - angle); };
    const auto nearest = std::min_element(line.angles.begin(), line.angles.end(),
                                          [&](double a, double b) { return std::abs(off(a)) < std::abs(off(b)); });
    const double shift = std::round(*nearest - angle);
    const auto first = nearest - line.angles.begin();
    for (double& at : line.angles) at -= shift;
    for (std::ptrdiff_t i = 0; i < first; ++i) line.angles[static_cast<std::size_t>(i)] += 1;
    std::rotate(line.angles.begin(), line.angles.begin() + first, line.angles.end());
    std::rotate(line.vertices.begin(), line.vertices.begin() + first, line.vertices.end());
  }

  static double angle_at(const EndLine& line, std::size_t i) {
    const std::size_t n = line.angles.size();
    return line.angles[i % n] + (i < n ? 0 : 1);
  }

  // The strip between two lines, with its front away from the axis.
  static std::vector<std::array<int, 3>> strip_between(const EndLine& low, EndLine high) {
    begin_near(high, low.angles.front());
    std::vector<std::array<int, 3>> strip;
    const std::size_t m = low.vertices.size(), n = high.vertices.size();
    for (std::size_t i = 0, j = 0; i < m || j < n;) {
      const int a = low.vertices[i % m], b = high.vertices[j % n];
      const bool lower = j == n || (i < m && angle_at(low, i + 1) <= angle_at(high, j + 1));
      strip.push_back({a, lower ? low.vertices[++i % m] : high.vertices[++j % n], b});
    }
    return strip;
  }

  // Vertices that have come to lie in one place are one.
  [[nodiscard]] std::map<int, int> merged(const std::vector<EndLine>& lines) const {
    std::map<int, int> same;
    for (const EndLine& line : lines)
      for (std::size_t i = 1; i < line.vertices.size(); ++i) {
        const int before = line.vertices[i - 1], v = line.vertices[i];
        if (glm::distance(mesh_.point(before), mesh_.point(v)) > same_radius * thread_.crest) continue;
        const auto known = same.find(before);
        same[v] = known == same.end() ? before : known->second;
      }
    return same;
  }

  void rebuild(const std::vector<EndLine>& lines) {
    const std::map<int, int> same = merged(lines);
    const auto of = [&](int v) {
      const auto at = same.find(v);
      return at == same.end() ? v : at->second;
    };
    mesh::Mesh made;
    const auto add = [&](const std::array<int, 3>& corners, int polygon, int body, int face) {
      const std::array<int, 3> c{of(corners[0]), of(corners[1]), of(corners[2])};
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
      made.corners.insert(made.corners.end(), c.begin(), c.end());
      made.polygon.push_back(polygon);
      made.body.push_back(body);
      faces_.push_back(face);
    };
    const auto face_of = [this](int t) { return part_.face_of_triangle[static_cast<std::size_t>(t)]; };
    const auto body_of = [this](int t) { return mesh_.body[static_cast<std::size_t>(t)]; };
    int next = 0;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const int polygon = mesh_.polygon[static_cast<std::size_t>(t)];
      next = std::max(next, polygon + 1);
      if (removed_[static_cast<std::size_t>(t)] == 0) add(mesh_.triangle(t), polygon, body_of(t), face_of(t));
    }
    for (const auto& [corners, t] : added_) add(corners, next++, body_of(t), face_of(t));
    const int body = body_of(thread_.triangles.front());
    check(strips_.size() + 1 == lines.size(), "there is a strip between two lines");
    for (std::size_t i = 1; i < lines.size(); ++i)
      for (auto [a, b, c] : strip_between(lines[i - 1], lines[i])) {
        if (thread_.internal) std::swap(b, c);
        add({a, b, c}, next++, body, strips_[i - 1]);
      }
    finish(std::move(made));
  }

  void finish(mesh::Mesh made) {
    made.points = std::move(mesh_.points);
    made.report = std::move(mesh_.report);
    mesh::make_edges(made, mesh::wires_of(mesh_));
    mesh_ = std::move(made);
  }

  mesh::Mesh& mesh_;
  const features::PartFaces& part_;
  const HelicalThread& thread_;
  std::vector<char> removed_;                              // by triangle
  std::vector<std::pair<std::array<int, 3>, int>> added_;  // in the place of triangles that are cut
  std::vector<int> strips_;                                // the faces of those between the lines
  std::vector<int> faces_;                                 // of the new triangles
  Vec3 u_{}, v_{};
  double clearance_ = 0;  // between the thread and the circle at which faces around it are cut
};

}  // namespace

std::optional<std::vector<int>> replace_by_cylinder(mesh::Mesh& mesh, const features::PartFaces& part,
                                                    const HelicalThread& thread) {
  return Replacer(mesh, part, thread).replace();
}

}  // namespace epura::design
