// SPDX-License-Identifier: Apache-2.0
#include "verify/fold_rule.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angle.hpp"

namespace epura::verify {

namespace {

// Rounding of doubles after a few operations, as a fraction of the size of the world.
constexpr double few_operations = 0x1p-40;
// Multiples of the precision of the coordinates: how far it may move a corner out of its plane, and the height below
// which a triangle may have no plane.
constexpr double turned_by = 4, needle = 16;
// In degrees. A fold this close to the threshold may be meant to lie exactly on it.
constexpr double angle_margin = 1e-3;
// Coinciding facets of curved surfaces cross at angles of up to their turns. A crossing is beyond doubt above this
// multiple of that angle.
constexpr double clearly = 1.5;

double size_of(const world::World& world) {
  const Vec3 size = world.box.size();
  return std::max({size.x, size.y, size.z});
}

double normalisation_of(const world::World& world) {
  const double size = size_of(world);
  return size > 0 ? std::ldexp(1.0, -std::ilogb(size)) : 1;
}

double precision_of(const world::World& world) { return std::max(world.rounding, few_operations * size_of(world)); }

double angle_between(const Vec3& a, const Vec3& b) {
  return degrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Returns the border of the part that an edge belongs to, or null. An edge of a cut mesh has the border of its edge in
// the whole mesh.
const surfaces::PartBorder* border_at(const world::Placed& placed, const mesh::MeshEdge* edge) {
  const mesh::Mesh& whole = placed.mesh->whole();
  if (edge != nullptr && &whole != placed.mesh.get()) edge = whole.edge_between(placed.mesh->origin_of(*edge).vertex);
  return edge != nullptr ? placed.part->border_at(edge - whole.edges.data()) : nullptr;
}

}  // namespace

FoldRule::FoldRule(const world::World& world, const edges::EdgeOptions& options, double small)
    : world_(world),
      options_(options),
      normalisation_(normalisation_of(world)),
      precision_(precision_of(world) * normalisation_),
      small_(std::max(small * normalisation_, needle * precision_)) {}

FoldRule::Sheets FoldRule::sheets_at(const std::array<int, 2>& edge) const {
  const auto above = std::ranges::upper_bound(world_.first_vertex, edge[0]);
  const int model = static_cast<int>(above - world_.first_vertex.begin()) - 1;
  const mesh::Mesh& mesh = *world_.models[model].mesh;
  const mesh::MeshEdge* found =
      mesh.edge_between({edge[0] - world_.first_vertex[model], edge[1] - world_.first_vertex[model]});
  if (found == nullptr) return {};
  std::map<int, std::vector<int>> bodies;
  for (const int t : mesh.triangles_of(*found)) bodies[mesh.body[t]].push_back(world_.first_triangle[model] + t);
  Sheets sheets{found, model, {}};
  for (auto& [body, triangles] : bodies) sheets.bodies.push_back(std::move(triangles));
  return sheets;
}

// The normal, with a length of twice the area.
Vec3 FoldRule::area(int triangle) const {
  const auto& [a, b, c] = world_.triangles[triangle];
  return glm::cross(point(b) - point(a), point(c) - point(a));
}

double FoldRule::normalised_height(int triangle) const {
  const auto& [a, b, c] = world_.triangles[triangle];
  const Vec3 p = point(a), q = point(b), r = point(c);
  const double longest = std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
  return longest > 0 ? glm::length(area(triangle)) / longest : 0;
}

bool FoldRule::is_needle(int triangle, Needle kind) const {
  const double limit = kind == Needle::surely ? precision_ : kind == Needle::perhaps ? needle * precision_ : small_;
  return normalised_height(triangle) <= limit;
}

bool FoldRule::same_polygon(int first, int second) const {
  const int model = world_.model_of_triangle(first);
  if (world_.model_of_triangle(second) != model) return false;
  const auto& polygon = world_.models[model].mesh->polygon;
  return polygon[first - world_.first_triangle[model]] == polygon[second - world_.first_triangle[model]];
}

// The angle by which the surface turns at the edge; 0 where it is flat. Each triangle is represented by the direction
// from the edge to its farthest corner.
double FoldRule::fold_angle(const std::array<int, 2>& edge, int first, int second) const {
  const Vec3 from = point(edge[0]);
  const Vec3 along = glm::normalize(point(edge[1]) - from);
  const auto away = [&](int triangle) {
    Vec3 farthest(0);
    for (const int v : world_.triangles[triangle]) {
      const Vec3 to = point(v) - from, beside = to - glm::dot(to, along) * along;
      if (glm::length(beside) > glm::length(farthest)) farthest = beside;
    }
    return farthest;
  };
  return angle_between(away(first), -away(second));
}

// Uncertainty of the plane of a triangle, in degrees.
double FoldRule::doubt(int triangle) const {
  return degrees * turned_by * precision_ / std::max(normalised_height(triangle), precision_);
}

// The angle in degrees between a triangle and the mean plane of its polygon: a bent polygon has no plane.
double FoldRule::bend(int triangle) const {
  const int model = world_.model_of_triangle(triangle), first = world_.first_triangle[model];
  const auto& polygon = world_.models[model].mesh->polygon;
  const int last = first + static_cast<int>(polygon.size());
  Vec3 mean(0);
  const auto belongs = [&](int t) { return polygon[t - first] == polygon[triangle - first]; };
  for (int t = triangle; t < last && belongs(t); ++t) mean += area(t);
  for (int t = triangle - 1; t >= first && belongs(t); --t) mean += area(t);
  return glm::length(mean) > 0 ? angle_between(area(triangle), mean) : 180;
}

// The largest angle at the sides of a triangle that is not a crease: how much its surface turns from facet to facet.
double FoldRule::turn(int triangle) const {
  const auto& corner = world_.triangles[triangle];
  double max = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [a, b] = std::minmax(corner[i], corner[(i + 1) % 3]);
    for (const auto& body : sheets_at({a, b}).bodies) {
      if (body.size() != 2) continue;
      const double fold = fold_angle({a, b}, body[0], body[1]);
      if (fold < options_.crease_angle) max = std::max(max, fold);
    }
  }
  return max;
}

// Where the faces of the part are known, their borders decide. Next to needles, an edge may represent a border beside
// it.
std::optional<Need> FoldRule::between_faces(const std::array<int, 2>& edge, int first, int second) const {
  const int model = world_.model_of_triangle(first);
  const world::Placed& placed = world_.models[model];
  if (placed.part == nullptr || world_.model_of_triangle(second) != model) return std::nullopt;
  if (const surfaces::PartBorder* border = border_at(placed, sheets_at(edge).edge)) {
    if (border->angle > options_.part_angle) return Need::asked;
    return options_.tangent ? Need::possible : Need::none;
  }
  if (placed.mesh->uncut != nullptr) return Need::possible;
  const auto face = [&](int triangle) {
    return placed.part->face_of_triangle[triangle - world_.first_triangle[model]];
  };
  return face(first) == face(second) ? Need::none : Need::possible;
}

Need FoldRule::fold(const std::array<int, 2>& edge, int first, int second) const {
  if (same_polygon(first, second)) return Need::none;
  if (options_.smooth) return Need::asked;
  if (!options_.crease) return Need::none;
  if (const auto need = between_faces(edge, first, second)) return *need;
  const double fold = fold_angle(edge, first, second);
  const double margin = angle_margin + doubt(first) + doubt(second) + bend(first) + bend(second);
  if (fold >= options_.crease_angle + margin) return Need::asked;
  // A smaller one may continue a crease.
  return fold <= std::min(options_.crease_angle, options_.weak_angle) - margin ? Need::none : Need::possible;
}

Need FoldRule::crossing(int first, int second, double contact) const {
  if (!options_.intersection) return Need::none;
  for (const int v : world_.triangles[first])
    if (std::ranges::count(world_.triangles[second], v) > 0) return Need::possible;
  const Vec3 n1 = glm::normalize(area(first)), n2 = glm::normalize(area(second));
  const double angle = degrees * std::asin(std::min(1.0, glm::length(glm::cross(n1, n2))));
  if (!(angle > clearly * (turn(first) + turn(second)) / 2 + doubt(first) + doubt(second))) return Need::possible;
  const auto goes_through = [&](int triangle, int plane, const Vec3& n) {
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const int v : world_.triangles[triangle]) {
      const double distance = glm::dot(n, point(v) - point(world_.triangles[plane][0]));
      min = std::min(min, distance);
      max = std::max(max, distance);
    }
    return min < -contact * normalisation_ && max > contact * normalisation_;
  };
  return goes_through(first, second, n2) && goes_through(second, first, n1) ? Need::asked : Need::possible;
}

bool FoldRule::ends_at_cut(const Sheets& sheets) const {
  const mesh::Mesh& mesh = *world_.models[static_cast<std::size_t>(sheets.model)].mesh;
  if (mesh.uncut == nullptr) return false;
  const mesh::EdgeOrigin origin = mesh.origin_of(*sheets.edge);
  const mesh::MeshEdge* whole = origin.in_file ? mesh.uncut->edge_between(origin.vertex) : nullptr;
  return whole != nullptr && whole->count > sheets.edge->count;
}

bool FoldRule::are_one_face(const std::array<int, 2>& edge, int triangle) const {
  const int model = world_.model_of_triangle(triangle);
  const world::Placed& placed = world_.models[model];
  const Sheets sheets = sheets_at(edge);
  if (placed.part == nullptr || placed.mesh->uncut != nullptr || sheets.model != model) return false;
  const auto face = [&](int t) { return placed.part->face_of_triangle[t - world_.first_triangle[model]]; };
  return std::ranges::all_of(sheets.bodies, [&](const std::vector<int>& body) {
    return std::ranges::all_of(body, [&](int t) { return face(t) == face(triangle); });
  });
}

bool FoldRule::is_of_torus(int triangle) const {
  const int model = world_.model_of_triangle(triangle);
  const world::Placed& placed = world_.models[model];
  if (placed.part == nullptr || placed.mesh->uncut != nullptr) return false;
  const int face = placed.part->face_of_triangle[triangle - world_.first_triangle[model]];
  return placed.part->faces[face].surface.kind == surfaces::SurfaceKind::torus;
}

Need FoldRule::outline(const std::array<int, 2>& edge) const {
  const Sheets sheets = sheets_at(edge);
  if (sheets.edge == nullptr || sheets.edge->cut == mesh::CutEdge::inside) return Need::possible;
  if (sheets.edge->cut == mesh::CutEdge::outline) return Need::asked;
  if (ends_at_cut(sheets)) return Need::possible;
  const bool asked = std::ranges::any_of(sheets.bodies, [&](const std::vector<int>& body) {
    return body.size() == 1 ? options_.boundary : body.size() == 2 ? options_.contour : options_.crease;
  });
  return asked ? Need::asked : Need::possible;
}

}  // namespace epura::verify
