// SPDX-License-Identifier: Apache-2.0
#include "surfaces/borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/angle.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "surfaces/free_normals.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

/// One mesh edge between two faces.
struct BorderEdge {
  int edge;
  std::array<int, 2> faces;
  std::array<int, 2> vertex;
  double angle, length;
  bool open;
};

class BorderFinder {
 public:
  BorderFinder(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
               const std::vector<Region>& regions, double tangent_angle)
      : mesh_(mesh),
        facets_(facets),
        region_of_(region_of),
        regions_(regions),
        free_normals_(facets, region_of, regions),
        tangent_angle_(tangent_angle) {}

  std::vector<PartBorder> find() {
    find_edges();
    // By vertex: the border edges there.
    at_vertex_ = Groups<int>(facets_.points.size(), [&](const auto& visit) {
      for (int i = 0; i < static_cast<int>(edges_.size()); ++i)
        for (const int v : edges_[i].vertex) visit(static_cast<std::size_t>(v), i);
    });
    std::vector<char> used(edges_.size());
    std::vector<PartBorder> borders;
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i)
      if (used[i] == 0) borders.push_back(border_of(chain(i, used)));
    return borders;
  }

 private:
  struct Chain {
    std::vector<int> edges;
    bool closed;
  };

  void find_edges() {
    const std::size_t count = mesh_.edges.size();
    std::vector<std::vector<BorderEdge>> found((count + grain::light - 1) / grain::light);
    parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        for (std::size_t e = b * grain::light; e < std::min(count, (b + 1) * grain::light); ++e)
          if (const auto edge = border_edge(static_cast<int>(e))) found[b].push_back(*edge);
    });
    for (const auto& some : found) edges_.insert(edges_.end(), some.begin(), some.end());
  }

  [[nodiscard]] int region_at(int triangle) const { return region_of_[facets_.facet_of[triangle]]; }

  [[nodiscard]] std::optional<BorderEdge> border_edge(int number) const {
    const mesh::MeshEdge& edge = mesh_.edges[number];
    const auto triangles = mesh_.triangles_of(edge);
    if (triangles.empty()) return std::nullopt;
    auto border =
        triangles.size() == 2 ? border_between(number, {triangles[0], triangles[1]}) : border_of_several(number);
    if (!border) return std::nullopt;
    border->length = glm::distance(facets_.points[edge.vertex[0]], facets_.points[edge.vertex[1]]);
    return border;
  }

  [[nodiscard]] std::optional<BorderEdge> border_between(int number, const TrianglePair& pair) const {
    const mesh::MeshEdge& edge = mesh_.edges[number];
    BorderEdge border{number, {region_at(pair[0]), region_at(pair[1])}, edge.vertex, 90, 0, false};
    if (border.faces[0] != border.faces[1])
      border.angle = angle_at(edge, pair);
    else if (!fades(pair))
      return std::nullopt;
    if (border.faces[0] > border.faces[1]) std::swap(border.faces[0], border.faces[1]);
    return border;
  }

  // Where bodies touch, the sharpest border of any of them.
  [[nodiscard]] std::optional<BorderEdge> border_of_several(int number) const {
    const std::vector<TrianglePair> pairs = pairs_by_body(mesh_, mesh_.edges[number]);
    if (pairs.empty()) return open_border(number);
    std::optional<BorderEdge> sharpest;
    for (const TrianglePair& pair : pairs) {
      const auto border = border_between(number, pair);
      if (!border) continue;
      const double angle = std::max(border->angle, sharpest ? sharpest->angle : 0);
      // Of several sharp ones, the faces of the first body, so that they are the same all along the border.
      const auto is_sharp = [&](const BorderEdge& one) { return one.angle > tangent_angle_; };
      if (!sharpest || (is_sharp(*border) && !is_sharp(*sharpest))) sharpest = border;
      sharpest->angle = angle;
    }
    return sharpest;
  }

  // If several faces end here, the first and the last one are taken, so that the order of triangles in the file does
  // not matter.
  [[nodiscard]] BorderEdge open_border(int number) const {
    const mesh::MeshEdge& edge = mesh_.edges[number];
    const auto triangles = mesh_.triangles_of(edge);
    BorderEdge border{number, {-1, region_at(triangles[0])}, edge.vertex, 180, 0, true};
    if (triangles.size() > 2) border.faces[0] = border.faces[1];
    for (const int t : triangles.subspan(1))
      border.faces = {std::min(border.faces[0], region_at(t)), std::max(border.faces[1], region_at(t))};
    return border;
  }

  // Returns the side of the first triangle at which the second one lies.
  [[nodiscard]] int side_between(int first, int second) const {
    for (int k = 0; k < 3; ++k)
      if (facets_.sides[first][k].neighbour == second) return k;
    return -1;
  }

  [[nodiscard]] bool fades(std::span<const int> triangles) const {
    const int f = facets_.facet_of[triangles[0]], g = facets_.facet_of[triangles[1]];
    if (f == g || regions_[region_of_[f]].surface.kind != SurfaceKind::free_form) return false;
    if (facets_.is_sliver(f) || facets_.is_sliver(g)) return false;
    const int side = side_between(triangles[0], triangles[1]);
    return side >= 0 && facets_.cosine_of_fold(triangles[0], side) < fading_cosine;
  }

  /// The normal of a face at a vertex, in the direction in which its triangle faces.
  struct Normal {
    Vec3 direction;
    double doubt;  ///< degrees
  };

  // `half_turn` is that of the triangle's facet, of free forms only.
  [[nodiscard]] Normal normal_at(int triangle, int vertex, bool by_vertices, double half_turn) const {
    const int facet = facets_.facet_of[triangle];
    const PartSurface& surface = regions_[region_of_[facet]].surface;
    const Vec3& facing = facets_.facets[facet].normal;
    if (surface.kind == SurfaceKind::free_form) {
      const auto free = by_vertices ? free_normals_.at(facet, vertex) : std::nullopt;
      return free ? Normal{free->direction, free->doubt * degrees} : Normal{facing, half_turn};
    }
    const Vec3 normal = normal_near(surface, facets_.points[vertex]);
    if (normal == Vec3(0)) return {facing, 0};
    // The normal of a sliver is arbitrary, but its neighbours were considered when it was assigned to the face.
    return {glm::dot(normal, facing) < 0 ? -normal : normal, 0};
  }

  // Whether the second triangle, which has a side in common with the first one, lies behind that.
  [[nodiscard]] bool is_convex(int first, int second) const {
    const auto& own = facets_.corners[first];
    const Vec3& normal = facets_.facets[facets_.facet_of[first]].normal;
    double height = 0;
    for (const int v : facets_.corners[second])
      if (std::find(own.begin(), own.end(), v) == own.end())
        height = glm::dot(normal, facets_.points[v] - facets_.points[own[0]]);
    return height < 0;
  }

  // A small fold in degrees, by its cosine.
  static double turn_at(double cosine) { return std::sqrt(2 * std::max(0.0, 1 - cosine)) * degrees; }

  // The greatest fold in degrees of a face near a facet, about a border, the same way as at the border. The fold behind
  // a facet may be one of its neighbours': that of the other half of a quadrilateral.
  [[nodiscard]] double turn_of(int facet, const Vec3& along, bool convex) const {
    double most = 0;
    const auto look = [&](int t, int side) {
      const double cosine = facets_.cosine_of_fold(t, side);
      if (cosine <= fading_cosine || is_convex(t, facets_.sides[t][side].neighbour) != convex) return;
      const auto [a, b] = facets_.ends_of(t, side);
      const double along_border = std::abs(glm::dot(b - a, along)) / glm::distance(a, b);
      most = std::max(most, turn_at(cosine) * along_border);
    };
    const int own = region_of_[facet];
    facets_.for_sides(facet, [&](int t, int side, int other) {
      if (region_of_[other] != own) return;
      look(t, side);
      facets_.for_sides(other, [&](int u, int k, int next) {
        if (region_of_[next] == own) look(u, k);
      });
    });
    return most;
  }

  // Whether facets fold at the side of a triangle by no more than those of the round face at one side of it do, to one
  // part in a hundred, by which folds of a sphere differ. Rounded edges made of facets often begin half a step from the
  // plane to which they are tangent.
  [[nodiscard]] bool goes_on(std::span<const int> triangles, const Vec3& along) const {
    const int side = side_between(triangles[0], triangles[1]);
    if (side < 0) return false;
    const double fold = 0.99 * turn_at(facets_.cosine_of_fold(triangles[0], side));
    return fold <= turn_of(facets_.facet_of[triangles[0]], along, is_convex(triangles[0], triangles[1])) ||
           fold <= turn_of(facets_.facet_of[triangles[1]], along, is_convex(triangles[1], triangles[0]));
  }

  // Facets of a free form tilt, and the vertices of a narrow face determine its normals poorly. Either only increases
  // the angle, so the smaller result is right.
  [[nodiscard]] double angle_at(const mesh::MeshEdge& edge, std::span<const int> triangles) const {
    const auto is_free = [&](int t) {
      return regions_[region_of_[facets_.facet_of[t]]].surface.kind == SurfaceKind::free_form;
    };
    const Vec3 along = glm::normalize(facets_.points[edge.vertex[1]] - facets_.points[edge.vertex[0]]);
    const auto half_turn = [&](int t, int other) {
      return is_free(t) ? 0.75 * turn_of(facets_.facet_of[t], along, is_convex(t, other)) : 0;
    };
    const std::array<double, 2> half_turns{half_turn(triangles[0], triangles[1]),
                                           half_turn(triangles[1], triangles[0])};
    const double angle = angle_at(edge, triangles, false, half_turns);
    if (angle <= tangent_angle_) return angle;
    if (!is_free(triangles[0]) && !is_free(triangles[1])) return goes_on(triangles, along) ? 0 : angle;
    return std::min(angle, angle_at(edge, triangles, true, half_turns));
  }

  // The angle in degrees between the faces on both sides, at the better end of the edge: at a corner, a third face may
  // interfere.
  [[nodiscard]] double angle_at(const mesh::MeshEdge& edge, std::span<const int> triangles, bool by_vertices,
                                const std::array<double, 2>& half_turns) const {
    const int side = side_between(triangles[0], triangles[1]);
    double angle = 180;
    for (const int v : edge.vertex) {
      const Normal one = normal_at(triangles[0], v, by_vertices, half_turns[0]);
      const Normal two = normal_at(triangles[1], v, by_vertices, half_turns[1]);
      double cosine = glm::dot(one.direction, two.direction);
      // The fold tells whether the triangles are oriented alike.
      const double facing = glm::dot(facets_.facets[facets_.facet_of[triangles[0]]].normal,
                                     facets_.facets[facets_.facet_of[triangles[1]]].normal);
      if (side >= 0 && facing * facets_.cosine_of_fold(triangles[0], side) < 0) cosine = -cosine;
      const double sine = glm::length(glm::cross(one.direction, two.direction));
      angle = std::min(angle, portable_atan2(sine, cosine) * degrees - one.doubt - two.doubt);
    }
    return std::max(0.0, angle);
  }

  // The edge that continues another one beyond a vertex: the only other border edge there, if it lies between the same
  // faces.
  [[nodiscard]] int next(int edge, int vertex) const {
    const auto there = at_vertex_[static_cast<std::size_t>(vertex)];
    if (there.size() != 2) return -1;
    const int other = there[0] == edge ? there[1] : there[0];
    return edges_[other].faces == edges_[edge].faces && edges_[other].open == edges_[edge].open ? other : -1;
  }

  [[nodiscard]] Chain chain(int first, std::vector<char>& used) const {
    std::array<std::vector<int>, 2> ways;
    used[first] = 1;
    for (int way = 0; way < 2; ++way) {
      int vertex = edges_[first].vertex[way];
      for (int e = next(first, vertex); e >= 0; e = next(e, vertex)) {
        if (e == first) return {joined(first, ways), true};
        if (used[e] != 0) break;
        used[e] = 1;
        ways[way].push_back(e);
        vertex = edges_[e].vertex[edges_[e].vertex[0] == vertex ? 1 : 0];
      }
    }
    return {joined(first, ways), false};
  }

  static std::vector<int> joined(int first, const std::array<std::vector<int>, 2>& ways) {
    std::vector<int> edges(ways[0].rbegin(), ways[0].rend());
    edges.push_back(first);
    edges.insert(edges.end(), ways[1].begin(), ways[1].end());
    return edges;
  }

  [[nodiscard]] PartBorder border_of(const Chain& chain) const {
    const BorderEdge& any = edges_[chain.edges.front()];
    PartBorder border{any.faces, any.open ? BorderKind::open : BorderKind::tangent, 0, {}, chain.closed};
    for (const int e : chain.edges) border.edges.push_back(edges_[e].edge);
    border.angle = angle_along(chain.edges, max_of_border);
    if (!any.open && border.angle > tangent_angle_ && border.angle <= 2 * tangent_angle_ && is_beside_free_form(any))
      border.angle = angle_along(chain.edges, max_of_estimated);
    if (!any.open && border.angle > tangent_angle_) border.kind = BorderKind::sharp;
    return border;
  }

  [[nodiscard]] bool is_beside_free_form(const BorderEdge& edge) const {
    return std::any_of(edge.faces.begin(), edge.faces.end(),
                       [&](int face) { return face >= 0 && regions_[face].surface.kind == SurfaceKind::free_form; });
  }

  [[nodiscard]] double angle_along(const std::vector<int>& chain, double most) const {
    std::vector<AngleAlong> angles;
    for (const int e : chain) angles.push_back({edges_[e].angle, edges_[e].length});
    return angle_of_most(std::move(angles), most);
  }

  const mesh::Mesh& mesh_;
  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
  FreeNormals free_normals_;
  double tangent_angle_;
  std::vector<BorderEdge> edges_;
  Groups<int> at_vertex_;
};

}  // namespace

double angle_of_most(std::vector<AngleAlong> angles, double most) {
  std::sort(angles.begin(), angles.end());
  double length = 0, below = 0;
  for (const auto& [angle, part] : angles) length += part;
  for (const auto& [angle, part] : angles) {
    below += part;
    if (below >= most * length) return angle;
  }
  return angles.back()[0];
}

std::vector<PartBorder> find_borders(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
                                     const std::vector<Region>& regions, double tangent_angle) {
  return BorderFinder(mesh, facets, region_of, regions, tangent_angle).find();
}

std::vector<TrianglePair> pairs_by_body(const mesh::Mesh& mesh, const mesh::MeshEdge& edge) {
  const std::span<const int> triangles = mesh.triangles_of(edge);
  if (triangles.size() == 2) return {{triangles[0], triangles[1]}};
  if (triangles.size() % 2 != 0) return {};
  std::vector<int> sorted(triangles.begin(), triangles.end());
  const auto body = [&](std::size_t i) { return mesh.body[static_cast<std::size_t>(sorted[i])]; };
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return mesh.body[static_cast<std::size_t>(a)] < mesh.body[static_cast<std::size_t>(b)];
  });
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    if (body(i) != body(i + 1) || (i > 0 && body(i - 1) == body(i))) return {};
    pairs.push_back({sorted[i], sorted[i + 1]});
  }
  return pairs;
}

}  // namespace epura::surfaces
