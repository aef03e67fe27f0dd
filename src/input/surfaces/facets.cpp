// SPDX-License-Identifier: Apache-2.0
#include "surfaces/facets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/convex_hull.hpp"
#include "base/parallel.hpp"
#include "mesh/resolution.hpp"
#include "surfaces/estimates.hpp"
#include "surfaces/least_squares.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

bool is_before(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

// The result must not depend on which corner of a triangle comes first in the file.
std::vector<std::array<int, 3>> begun_at_first_corners(std::vector<std::array<int, 3>> triangles,
                                                       const std::vector<Vec3>& points) {
  parallel_for(triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      auto& corners = triangles[t];
      const auto first = std::min_element(corners.begin(), corners.end(),
                                          [&](int a, int b) { return is_before(points[a], points[b]); });
      std::rotate(corners.begin(), first, corners.end());
    }
  });
  return triangles;
}

// The corners of triangles, in coordinates near 1, and how exact these are.
Facets read_triangles(const mesh::Mesh& mesh) {
  Facets f;
  const std::size_t count = mesh.polygon.size();
  f.corners.resize(count);
  parallel_for(count, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) f.corners[t] = mesh.triangle(static_cast<int>(t));
  });
  int last = -1;
  for (const auto& corners : f.corners) last = std::max({last, corners[0], corners[1], corners[2]});
  f.points.resize(static_cast<std::size_t>(last + 1));
  std::vector<char> used(f.points.size());
  for (const auto& corners : f.corners)
    for (const int v : corners) used[v] = 1;
  Box box;
  double farthest = 0;
  for (std::size_t v = 0; v < f.points.size(); ++v) {
    if (used[v] == 0) continue;
    const Vec3 p = f.points[v] = mesh.point(static_cast<int>(v));
    box.add(f.points[v]);
    farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }
  if (box.empty()) box.add(Vec3(0));
  f.origin = box.centre();
  // Not the diagonal, which may exceed the largest double.
  const Vec3 half = box.max * 0.5 - box.min * 0.5;
  const double size = 2 * std::max({half.x, half.y, half.z});
  f.scale = size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000)) : 1;
  for (Vec3& p : f.points) p = (p - f.origin) * f.scale;
  f.corners = begun_at_first_corners(std::move(f.corners), f.points);
  const double rounding =
      std::max(farthest * (mesh.report.single_precision ? 0x1p-24 : 0x1p-51), mesh.report.weld_distance);
  const double by_rounding = std::max(mesh::roundings * rounding, min_tolerance * size);
  const double by_grid = mesh::roundings * mesh.report.resolution / 2;
  f.tolerance = std::max(by_rounding, by_grid) * f.scale;
  // The step of a grid is all that vertices are off: how many lie so near is judged as evidence.
  f.slack = by_grid > by_rounding ? 1 : usual_slack;
  return f;
}

// The triangle on the other side of an edge, of the same body if several touch there; -1 if there is none, or more.
int partner_at(const mesh::Mesh& mesh, std::span<const int> triangles, int triangle) {
  if (triangles.size() == 2) return triangles[0] == triangle ? triangles[1] : triangles[0];
  int partner = -1, count = 0;
  for (const int other : triangles)
    if (other != triangle && mesh.body[other] == mesh.body[triangle]) {
      partner = other;
      ++count;
    }
  return count == 1 ? partner : -1;
}

std::vector<std::array<Side, 3>> sides_of(const mesh::Mesh& mesh, const std::vector<std::array<int, 3>>& corners) {
  std::vector<std::array<Side, 3>> sides(corners.size());
  const auto find_at = [&](int number) {
    const mesh::MeshEdge& edge = mesh.edges[number];
    const auto triangles = mesh.triangles_of(edge);
    for (const int t : triangles)
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(corners[t][k], corners[t][(k + 1) % 3]);
        if (low == edge.vertex[0] && high == edge.vertex[1]) sides[t][k] = {partner_at(mesh, triangles, t), number};
      }
  };
  parallel_for(mesh.edges.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) find_at(static_cast<int>(e));
  });
  return sides;
}

// Exchanges the sides of a triangle; its first corner stays.
void turn(Facets& f, int triangle) {
  std::swap(f.corners[triangle][1], f.corners[triangle][2]);
  std::swap(f.sides[triangle][0], f.sides[triangle][2]);
}

// Whether a triangle turns against its neighbour at a side: both have it in the same direction.
bool turns_against(const Facets& f, int triangle, int side) {
  const int from = f.corners[triangle][side], to = f.corners[triangle][(side + 1) % 3];
  const auto& other = f.corners[f.sides[triangle][side].neighbour];
  for (int k = 0; k < 3; ++k)
    if (other[k] == from && other[(k + 1) % 3] == to) return true;
  return false;
}

// Turns the triangles of a file that turns them either way like their neighbours, and outwards what encloses something:
// the result must not depend on how they turn.
void turn_alike(Facets& f) {
  std::vector<char> is_reached(f.corners.size(), 0);
  for (std::size_t t = 0; t < f.corners.size(); ++t) {
    if (is_reached[t] != 0) continue;
    std::vector<int> joined{static_cast<int>(t)};
    is_reached[t] = 1;
    double volume = 0;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      const auto& [a, b, c] = f.corners[joined[i]];
      volume += glm::dot(f.points[a], glm::cross(f.points[b], f.points[c]));
      for (int side = 0; side < 3; ++side) {
        const int next = f.sides[joined[i]][side].neighbour;
        if (next < 0 || is_reached[next] != 0) continue;
        if (turns_against(f, joined[i], side)) turn(f, next);
        is_reached[next] = 1;
        joined.push_back(next);
      }
    }
    if (volume < 0)
      for (const int one : joined) turn(f, one);
  }
}

/// Largest first; among equals, the first by position. Both are rounded, so that it does not matter which corner of a
/// triangle comes first in the file.
struct Key {
  float area;
  std::array<float, 3> place;
  int triangle;

  bool operator<(const Key& other) const {
    if (area != other.area) return area > other.area;
    return place != other.place ? place < other.place : triangle < other.triangle;
  }
};

/// Of triangles.
struct Triangles {
  std::vector<Vec3> normals;  ///< unit; zero without an area
  std::vector<double> areas, widths;
  std::vector<Key> order;  ///< sorted
};

Triangles measured(const Facets& f) {
  const std::size_t count = f.corners.size();
  Triangles of{std::vector<Vec3>(count), std::vector<double>(count), std::vector<double>(count),
               std::vector<Key>(count)};
  parallel_for(count, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = f.corners[t];
      const Vec3 u = f.points[b] - f.points[a], v = f.points[c] - f.points[a];
      const Vec3 area = glm::cross(u, v);
      const double length = glm::length(area);
      const double longest = std::sqrt(std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(v - u, v - u)}));
      of.normals[t] = length > 0 ? area / length : Vec3(0);
      of.areas[t] = length / 2;
      of.widths[t] = longest > 0 ? length / longest : 0;
      const Vec3 place = (f.points[a] + f.points[b] + f.points[c]) * 0x1p20;
      int exponent = 0;
      const double mantissa = std::frexp(of.areas[t], &exponent);
      of.order[t] = {static_cast<float>(std::ldexp(std::nearbyint(mantissa * 0x1p20), exponent - 20)),
                     {static_cast<float>(std::nearbyint(place.x)), static_cast<float>(std::nearbyint(place.y)),
                      static_cast<float>(std::nearbyint(place.z))},
                     static_cast<int>(t)};
    }
  });
  parallel_sort(of.order.begin(), of.order.end());
  return of;
}

/// Turns pieces of the file's polygons into facets, largest first, so that their order in the file does not matter.
class Flattening {
 public:
  Flattening(const mesh::Mesh& mesh, const Triangles& of, Facets read)
      : mesh_(mesh), of_(of), f_(std::move(read)), seen_(of.areas.size(), -1), has_vertex_(f_.points.size(), -1) {}

  /// The facets with their triangles and vertices.
  Facets run() {
    f_.facet_of.assign(f_.corners.size(), -1);
    f_.first_triangle = {0};
    f_.first_vertex = {0};
    const std::vector<char> is_lone = lone();
    for (const Key& key : of_.order) {
      if (f_.facet_of[key.triangle] >= 0) continue;
      number_ = static_cast<int>(f_.first_triangle.size()) - 1;
      if (is_lone[key.triangle] != 0)
        add(key.triangle);
      else
        grow(key.triangle);
      f_.first_triangle.push_back(static_cast<int>(f_.triangles.size()));
      f_.first_vertex.push_back(static_cast<int>(f_.vertices.size()));
    }
    return std::move(f_);
  }

 private:
  [[nodiscard]] bool same_polygon(int one, int two) const { return mesh_.polygon[one] == mesh_.polygon[two]; }

  void add(int triangle) {
    f_.facet_of[triangle] = number_;
    f_.triangles.push_back(triangle);
    for (const int v : f_.corners[triangle])
      if (std::exchange(has_vertex_[v], number_) != number_) f_.vertices.push_back(v);
  }

  // Adds a triangle with all others of its polygon that are connected to it.
  void add_polygon(int triangle) {
    std::size_t next = f_.triangles.size();
    add(triangle);
    for (; next < f_.triangles.size(); ++next)
      for (const Side& side : f_.sides[f_.triangles[next]])
        if (side.neighbour >= 0 && f_.facet_of[side.neighbour] < 0 && same_polygon(side.neighbour, triangle))
          add(side.neighbour);
  }

  [[nodiscard]] std::optional<PartSurface> plane() const {
    std::vector<Vec3> points;
    const std::size_t first = static_cast<std::size_t>(f_.first_vertex.back());
    const std::size_t step = 1 + (f_.vertices.size() - first) / 256;
    for (std::size_t i = first; i < f_.vertices.size(); i += step) points.push_back(f_.points[f_.vertices[i]]);
    if (points.size() == 3) {
      const int t = f_.triangles.back();
      if (of_.normals[t] == Vec3(0)) return std::nullopt;
      return plane_of(t);
    }
    return begin_plane(points);
  }

  // Whether a triangle lies in a plane to within `reach` tolerances. A plane through few points is uncertain at a
  // distance from them and needs more.
  [[nodiscard]] bool lies_in(const PartSurface& plane, int triangle, double reach) const {
    for (const int v : f_.corners[triangle])
      if (std::abs(signed_distance(plane, f_.points[v])) > reach * f_.tolerance) return false;
    if (of_.widths[triangle] <= 16 * f_.tolerance) return true;
    return std::abs(glm::dot(of_.normals[triangle], plane.axis)) > 1 - 1e-3;
  }

  // A triangle without an adjacent one in its plane is a facet, whatever the others are.
  [[nodiscard]] std::vector<char> lone() const {
    std::vector<char> is_lone(f_.corners.size());
    parallel_for(f_.corners.size(), grain::light, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const PartSurface plane = plane_of(static_cast<int>(t));
        const auto stays_outside = [&](const Side& side) {
          if (side.neighbour < 0) return true;
          if (same_polygon(side.neighbour, static_cast<int>(t))) return false;
          return plane.axis == Vec3(0) || !lies_in(plane, side.neighbour, 2);
        };
        is_lone[t] = std::all_of(f_.sides[t].begin(), f_.sides[t].end(), stays_outside) ? 1 : 0;
      }
    });
    return is_lone;
  }

  [[nodiscard]] PartSurface plane_of(int triangle) const {
    return {SurfaceKind::plane, f_.points[f_.corners[triangle][0]], of_.normals[triangle]};
  }

  void grow(int seed) {
    add_polygon(seed);
    auto plane_found = plane();
    const auto is_in = [&](int v) { return std::abs(signed_distance(*plane_found, f_.points[v])) <= f_.tolerance; };
    const std::size_t begin = static_cast<std::size_t>(f_.first_triangle.back());
    if (!plane_found || !std::all_of(f_.vertices.begin() + f_.first_vertex.back(), f_.vertices.end(), is_in)) return;
    std::size_t refit = 2 * (f_.triangles.size() - begin) + 2;
    for (std::size_t next = begin; next < f_.triangles.size(); ++next) {
      for (const Side& side : f_.sides[f_.triangles[next]]) {
        const int t = side.neighbour;
        if (t < 0 || f_.facet_of[t] >= 0 || seen_[t] == number_) continue;
        seen_[t] = number_;
        if (polygon_lies_in(*plane_found, t, refit > 8 ? 1 : 2)) add_polygon(t);
      }
      if (f_.triangles.size() - begin < refit) continue;
      plane_found = plane();
      refit = 2 * (f_.triangles.size() - begin);
    }
  }

  [[nodiscard]] bool polygon_lies_in(const PartSurface& plane, int triangle, double reach) {
    polygon_ = {triangle};
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      if (!lies_in(plane, polygon_[i], reach)) return false;
      for (const Side& side : f_.sides[polygon_[i]])
        if (side.neighbour >= 0 && f_.facet_of[side.neighbour] < 0 && same_polygon(side.neighbour, triangle) &&
            std::find(polygon_.begin(), polygon_.end(), side.neighbour) == polygon_.end())
          polygon_.push_back(side.neighbour);
    }
    return true;
  }

  const mesh::Mesh& mesh_;
  const Triangles& of_;
  Facets f_;
  std::vector<int> seen_, has_vertex_;  ///< the last facet that reached a triangle or has a vertex
  std::vector<int> polygon_;
  int number_ = 0;
};

bool is_between(const Facets& f, const Vec3& point, const std::array<int, 2>& ends) {
  const Vec3 along = f.points[ends[1]] - f.points[ends[0]], to = point - f.points[ends[0]];
  const double length = glm::length(along), at = glm::dot(to, along);
  return at > 0 && at < length * length && glm::length(glm::cross(along, to)) <= 2 * f.tolerance * length;
}

// By vertex: whether exactly two edges between facets meet there, in one line.
std::vector<char> straight_vertices(const Facets& f) {
  struct Ends {
    int count = 0;
    std::array<int, 2> other{};
  };
  std::vector<Ends> ends(f.points.size());
  const auto add = [&](int vertex, int other) {
    Ends& at = ends[vertex];
    if (at.count < 2) at.other[at.count] = other;
    ++at.count;
  };
  for (std::size_t t = 0; t < f.corners.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int next = f.sides[t][k].neighbour;
      // An edge with two triangles is taken once.
      if (next >= 0 && (next < static_cast<int>(t) || f.facet_of[next] == f.facet_of[t])) continue;
      const int a = f.corners[t][k], b = f.corners[t][(k + 1) % 3];
      add(a, b);
      add(b, a);
    }
  std::vector<char> straight(f.points.size(), 0);
  for (std::size_t v = 0; v < ends.size(); ++v)
    if (ends[v].count == 2) straight[v] = is_between(f, f.points[v], ends[v].other) ? 1 : 0;
  return straight;
}

// With the vertices that support each facet first. Three are needed to span one.
Facets with_supports(Facets f) {
  const std::vector<char> straight = straight_vertices(f);
  const auto supports = [&](int v) { return straight[v] == 0; };
  f.end_of_supports.assign(f.first_vertex.begin() + 1, f.first_vertex.end());
  for (std::size_t facet = 0; facet < f.end_of_supports.size(); ++facet) {
    const auto first = f.vertices.begin() + f.first_vertex[facet],
               last = f.vertices.begin() + f.first_vertex[facet + 1];
    if (last - first > 3 && std::count_if(first, last, supports) >= 3)
      f.end_of_supports[facet] = static_cast<int>(std::stable_partition(first, last, supports) - f.vertices.begin());
  }
  return f;
}

// The corners of the convex hull; vertices that are not on its sides count, too.
int count_corners(const std::vector<Vec2>& p, double tolerance) {
  const double near = 4 * tolerance;
  const auto is_beside = [&](const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 along = c - a, to = b - a;
    return cross(along, to) >= -near * glm::length(along);
  };
  const std::vector<Vec2> hull = convex_hull(
      p, [](const Vec2& point) -> const Vec2& { return point; }, is_beside);
  int corners = static_cast<int>(hull.size());
  for (const Vec2& point : p) {
    bool on_side = false;
    for (std::size_t i = 0; i < hull.size() && !on_side; ++i) {
      const Vec2 a = hull[i], along = hull[(i + 1) % hull.size()] - a, to = point - a;
      on_side = std::abs(cross(along, to)) <= 2 * near * glm::length(along);
    }
    if (!on_side) ++corners;
    if (corners > 4) break;
  }
  return corners;
}

std::vector<Vec2> seen_flat(const Facets& f, const Facet& facet, std::span<const int> vertices) {
  const auto [u, v] = square_to(facet.normal);
  std::vector<Vec2> seen;
  seen.reserve(vertices.size());
  for (const int vertex : vertices) {
    const Vec3 from = f.points[vertex] - facet.middle;
    seen.emplace_back(glm::dot(from, u), glm::dot(from, v));
  }
  return seen;
}

// The extent of points across the direction in which they extend most.
double breadth_of(std::span<const Vec2> points) {
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2& p : points) {
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
  }
  const double half = (xx - yy) / 2, root = std::hypot(half, xy);
  const Vec2 along = half > 0 ? Vec2(half + root, xy) : Vec2(xy, root - half);
  const double length = glm::length(along);
  if (!(length > 0)) return 0;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Vec2& p : points) {
    least = std::min(least, cross(along, p) / length);
    most = std::max(most, cross(along, p) / length);
  }
  return most - least;
}

Facet facet_at(const Facets& f, const Triangles& of, int number) {
  Facet facet{Vec3(0), Vec3(0), 0, 0, false};
  // If triangles are oriented differently, the first one determines the direction of the facet.
  for (const int t : f.triangles_of(number)) {
    const double turned = glm::dot(f.normals[t], f.normals[f.triangles_of(number).front()]) < 0 ? -1 : 1;
    facet.normal += turned * of.areas[t] * f.normals[t];
    facet.area += of.areas[t];
    facet.width = std::max(facet.width, of.widths[t]);
  }
  const double length = glm::length(facet.normal);
  facet.normal = length > 0 ? facet.normal / length : Vec3(0);
  const auto vertices = f.vertices_of(number);
  const auto supports = f.supports_of(number);
  for (const int v : supports) facet.middle += f.points[v] / static_cast<double>(supports.size());
  // A plane meets a cylinder or cone in two lines, and a net of meridians and parallels in four points: facets of such
  // surfaces have at most four corners, and all their other vertices lie on the lines between these.
  if (facet.normal == Vec3(0) || vertices.size() <= 4) return facet;
  const std::vector<Vec2> seen = seen_flat(f, facet, vertices);
  facet.is_plane = count_corners(seen, f.tolerance) > 4;
  if (facet.is_plane) facet.width = std::max(facet.width, breadth_of(seen));
  return facet;
}

// Whether a facet is a strip of a round surface that another face cuts off: four supports are the ends of its only
// smooth sides, and what lies beyond these is about as wide, unlike fillets beside a flat. The others may lie anywhere
// in its plane, so they are moved behind these.
bool is_cut_strip(Facets& f, int facet) {
  std::vector<int> ends;
  for (const int t : f.triangles_of(facet))
    for (int side = 0; side < 3; ++side) {
      const int next = f.sides[t][side].neighbour;
      if (next < 0 || f.facet_of[next] == facet || f.fold_at(t, side) > coarse_fold) continue;
      const double here = f.facets[facet].width, beyond = f.facets[f.facet_of[next]].width;
      if (std::max(here, beyond) > similar_width_ratio * std::min(here, beyond)) return false;
      ends.push_back(f.corners[t][side]);
      ends.push_back(f.corners[t][(side + 1) % 3]);
    }
  const auto first = f.vertices.begin() + f.first_vertex[facet], last = f.vertices.begin() + f.end_of_supports[facet];
  const auto is_end = [&](int v) { return std::count(ends.begin(), ends.end(), v) == 1; };
  const auto is_beside = [&](int v) { return std::find(ends.begin(), ends.end(), v) != ends.end(); };
  if (std::count_if(first, last, is_end) != 4 || std::count_if(first, last, is_beside) != 4) return false;
  const auto middle = std::stable_partition(first, last, is_end);
  return std::all_of(middle, last, [&](int v) {
    return std::abs(glm::dot(f.points[v] - f.points[*first], f.facets[facet].normal)) <= 2 * f.tolerance;
  });
}

// With strips that other faces cut off supported by the ends of their long sides alone: their ends may have any
// corners.
Facets with_cut_strips(Facets f) {
  for (int number = 0; number < static_cast<int>(f.facets.size()); ++number) {
    if (f.supports_of(number).size() <= 4 || !is_cut_strip(f, number)) continue;
    f.end_of_supports[number] = f.first_vertex[number] + 4;
    Facet& facet = f.facets[number];
    facet.is_plane = false;
    facet.middle = Vec3(0);
    for (const int v : f.supports_of(number)) facet.middle += f.points[v] / 4.0;
  }
  return f;
}

}  // namespace

double Facets::cosine_of_fold(int triangle, int side) const {
  const int other = sides[triangle][side].neighbour;
  const double cosine = glm::dot(facets[facet_of[triangle]].normal, facets[facet_of[other]].normal);
  const int from = corners[triangle][side], to = corners[triangle][(side + 1) % 3];
  // A facet's normal may be that of triangles with the opposite orientation.
  const auto turned = [&](int t) { return glm::dot(normals[t], facets[facet_of[t]].normal) < 0; };
  bool same_way = false;
  for (int k = 0; k < 3; ++k) same_way = same_way || (corners[other][k] == from && corners[other][(k + 1) % 3] == to);
  return same_way != (turned(triangle) != turned(other)) ? -cosine : cosine;
}

double Facets::fold_at(int triangle, int side) const {
  const double cosine = std::clamp(cosine_of_fold(triangle, side), -1.0, 1.0);
  return cosine > -1 ? std::sqrt((1 - cosine) / (1 + cosine)) : HUGE_VAL;
}

Facets make_facets(const mesh::Mesh& mesh) {
  Facets facets = read_triangles(mesh);
  facets.sides = sides_of(mesh, facets.corners);
  if (mesh.report.misoriented_edges > 0) turn_alike(facets);
  Triangles triangles = measured(facets);
  facets = with_supports(Flattening(mesh, triangles, std::move(facets)).run());
  facets.normals = std::move(triangles.normals);
  facets.facets.resize(facets.first_triangle.size() - 1);
  parallel_for(facets.facets.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) facets.facets[f] = facet_at(facets, triangles, static_cast<int>(f));
  });
  return with_cut_strips(std::move(facets));
}

}  // namespace epura::surfaces
