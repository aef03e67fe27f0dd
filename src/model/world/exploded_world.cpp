// SPDX-License-Identifier: Apache-2.0
#include "world/exploded_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/edge_table.hpp"
#include "scene/body_styles.hpp"
#include "world/explosion_order.hpp"
#include "world/placed_part.hpp"

namespace epura::world {

namespace {

double size_of(const MovedBody& body) {
  const Vec3 size = body.box.size();
  return body.box.empty() ? -1 : size.x * size.y * size.z;
}

Bodies bodies_of(const World& world) {
  Bodies bodies;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const mesh::Mesh& mesh = *world.models[m].mesh;
    std::vector<MovedBody>& here = bodies.emplace_back(static_cast<std::size_t>(mesh.report.bodies));
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (const int vertex : world.triangles[static_cast<std::size_t>(world.first_triangle[m] + t)])
        here[static_cast<std::size_t>(mesh.body[t])].box.add(world.points[static_cast<std::size_t>(vertex)]);
    const std::optional<PlacedPart> part = place_part(world.models[m]);
    if (!part) continue;
    for (const surfaces::PartFace& face : part->faces) {
      MovedBody& body = here[static_cast<std::size_t>(face.body)];
      if (face.surface.kind != surfaces::SurfaceKind::cylinder || face.surface.radius <= body.radius) continue;
      body.axis = face.surface.axis;
      body.on_axis = face.surface.origin;
      body.radius = face.surface.radius;
    }
  }
  return bodies;
}

// Of several, the one farthest along -x, -y, -z, whatever their order in the file.
Vec3 middle_of_largest(const Bodies& bodies) {
  const auto rank = [](const MovedBody& body) {
    const Vec3 middle = body.box.centre();
    return std::tuple(size_of(body), -middle.x, -middle.y, -middle.z);
  };
  const MovedBody* largest = nullptr;
  for (const std::vector<MovedBody>& of_model : bodies)
    for (const MovedBody& body : of_model)
      if (!body.box.empty() && (largest == nullptr || rank(body) > rank(*largest))) largest = &body;
  return largest == nullptr ? Vec3(0) : largest->box.centre();
}

Vec3 outward_move(const MovedBody& body, const Vec3& middle, double factor) {
  const Vec3 apart = body.box.centre() - middle;
  constexpr double least = 1e-6;  // of the distance
  const double along = glm::dot(apart, body.axis);
  if (std::abs(along) > least * glm::length(apart)) return factor * along * body.axis;
  int farthest = 0;
  for (const int axis : {1, 2})
    if (std::abs(apart[axis]) > std::abs(apart[farthest])) farthest = axis;
  Vec3 move(0);
  move[farthest] = factor * apart[farthest];
  return move;
}

std::vector<std::string> names_in(const World& world, std::span<const std::string> models) {
  std::vector<std::string> names(models.begin(), models.end());
  for (const Placed& placed : world.models)
    for (int body = 0; body < placed.mesh->report.bodies; ++body)
      if (const std::string& name = scene::name_of_body(*placed.mesh, body);
          !name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

void add_move(Bodies& bodies, const World& world, const scene::ExplodeDescription& one,
              std::span<const std::string> names) {
  scene::StyleDescription pattern;
  pattern.match.value = one.match.value_or("*");
  const Vec3 middle = middle_of_largest(bodies);
  bool any = false;
  for (std::size_t m = 0; m < bodies.size(); ++m)
    for (std::size_t b = 0; b < bodies[m].size(); ++b) {
      MovedBody& body = bodies[m][b];
      const mesh::Mesh& mesh = *world.models[m].mesh;
      if (body.box.empty() || (*pattern.match != "*" && !scene::matches(pattern, mesh, static_cast<int>(b), names[m])))
        continue;
      any = true;
      body.move += one.move.given() ? *one.move : outward_move(body, middle, *one.factor);
      body.factor = one.move.given() ? 0 : *one.factor;
      if (one.trace.given()) body.traced = one.trace.value;
    }
  if (!any)
    throw Error(ErrorKind::input, one.match.where, "no body or model is called '" + *one.match + "'",
                did_you_mean(*one.match, names_in(world, names)));
}

/// A mesh whose vertices each belong to bodies with the same move. Vertices that others share have copies at the end.
struct ApartMesh {
  mesh::Mesh mesh;
  std::vector<int> owners;     ///< by vertex: a body; -1 if none uses it
  std::vector<int> originals;  ///< by vertex
};

ApartMesh apart_mesh(const mesh::Mesh& whole, const std::vector<MovedBody>& bodies) {
  ApartMesh apart{whole, std::vector<int>(whole.points.size(), -1), std::vector<int>(whole.points.size())};
  std::iota(apart.originals.begin(), apart.originals.end(), 0);
  const auto move_of = [&](int body) { return bodies[static_cast<std::size_t>(body)].move; };
  std::map<std::array<int, 2>, int> copies;  // by vertex, and the first body with the move
  const auto first_with = [&](const Vec3& move) {
    const auto first =
        std::find_if(bodies.begin(), bodies.end(), [&](const MovedBody& body) { return body.move == move; });
    return static_cast<int>(first - bodies.begin());
  };
  for (std::size_t corner = 0; corner < apart.mesh.corners.size(); ++corner) {
    int& vertex = apart.mesh.corners[corner];
    const int body = whole.body[corner / 3];
    int& owner = apart.owners[static_cast<std::size_t>(vertex)];
    if (owner < 0) owner = body;
    if (move_of(owner) == move_of(body)) continue;
    const auto [copy, is_new] =
        copies.try_emplace({vertex, first_with(move_of(body))}, static_cast<int>(apart.owners.size()));
    if (is_new) {
      apart.mesh.points.push_back(apart.mesh.points[static_cast<std::size_t>(vertex)]);
      apart.originals.push_back(vertex);
      apart.owners.push_back(body);
    }
    vertex = copy->second;
  }
  if (copies.empty()) return apart;
  mesh::make_edges(apart.mesh, mesh::wires_of(whole));
  return apart;
}

// Faces and borders with the edges of the mesh apart. An edge that bodies shared has become several, of one border.
surfaces::PartFaces apart_part(const surfaces::PartFaces& whole, const mesh::Mesh& before, const ApartMesh& apart) {
  surfaces::PartFaces part = whole;
  part.border_of_edge.clear();
  std::vector<int> successors(before.edges.size(), -1);
  for (const mesh::MeshEdge& edge : apart.mesh.edges) {
    std::array<int, 2> ends{};
    for (const std::size_t i : {0U, 1U}) ends[i] = apart.originals[static_cast<std::size_t>(edge.vertex[i])];
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    const auto number = static_cast<std::size_t>(before.edge_between(ends) - before.edges.data());
    if (successors[number] < 0) successors[number] = static_cast<int>(part.border_of_edge.size());
    part.border_of_edge.push_back(whole.border_of_edge[number]);
  }
  for (surfaces::PartBorder& border : part.borders)
    for (int& edge : border.edges) edge = successors[static_cast<std::size_t>(edge)];
  return part;
}

// Moves the vertices and recognised faces of the bodies of a file.
void move_bodies(Placed& placed, const std::vector<MovedBody>& bodies) {
  ApartMesh apart = apart_mesh(*placed.mesh, bodies);
  const Mat3 to_file = glm::inverse(Mat3(placed.to_world));
  const auto move_of = [&](int body) { return to_file * bodies[static_cast<std::size_t>(body)].move; };
  for (std::size_t v = 0; v < apart.owners.size(); ++v) {
    if (apart.owners[v] < 0) continue;
    const Vec3 move = move_of(apart.owners[v]);
    for (int axis = 0; axis < 3; ++axis) apart.mesh.points[v][static_cast<std::size_t>(axis)] += move[axis];
  }
  if (placed.part != nullptr) {
    auto part = std::make_shared<surfaces::PartFaces>(apart_part(*placed.part, *placed.mesh, apart));
    for (surfaces::PartFace& face : part->faces) face.surface.origin += move_of(face.body);
    placed.part = std::move(part);
  }
  placed.mesh = std::make_shared<const mesh::Mesh>(std::move(apart.mesh));
}

void move_model(Placed& placed, const std::vector<MovedBody>& bodies) {
  const auto stays = [](const MovedBody& body) { return body.move == Vec3(0); };
  if (std::all_of(bodies.begin(), bodies.end(), stays)) return;
  const Vec3& first = bodies.front().move;
  if (!std::all_of(bodies.begin(), bodies.end(), [&](const MovedBody& body) { return body.move == first; }))
    return move_bodies(placed, bodies);
  placed.to_world[3] += Vec4(first, 0);
}

// The part of a line inside a box that has its second end in it: nothing outside the box is mapped to the page.
Trace clipped(const Trace& line, const Box& box) {
  double from = 0;
  const Vec3 d = line[1] - line[0];
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {box.min[axis], box.max[axis]}) {
      const bool outside = side == box.min[axis] ? line[0][axis] < side : line[0][axis] > side;
      if (outside && d[axis] != 0) from = std::max(from, (side - line[0][axis]) / d[axis]);
    }
  return {line[0] + std::min(from, 1.0) * d, line[1]};
}

// Along the axis of the body if it moves along that.
std::optional<Trace> trace_of(const MovedBody& body) {
  constexpr double parallel = 1e-6;
  const Vec3 way = body.move - body.start;
  if (way == Vec3(0) || !body.traced.value_or(true)) return std::nullopt;
  const Vec3 middle = body.box.centre();
  const bool along = body.radius > 0 && glm::length(glm::cross(way, body.axis)) <= parallel * glm::length(way);
  if (!along && !body.traced) return std::nullopt;
  const Vec3 from = along ? body.on_axis + glm::dot(middle - body.on_axis, body.axis) * body.axis : middle;
  return Trace{from + body.start, from + body.move};
}

}  // namespace

ExplodedWorld explode_world(const World& world, std::span<const scene::ExplodeDescription> moves,
                            std::span<const std::string> names) {
  Bodies bodies = bodies_of(world);
  for (const scene::ExplodeDescription& one : moves) add_move(bodies, world, one, names);
  order_by_holes(world, bodies);
  std::vector<Placed> placed = world.models;
  for (std::size_t m = 0; m < placed.size(); ++m)
    if (!bodies[m].empty()) move_model(placed[m], bodies[m]);
  ExplodedWorld exploded{make_world(std::move(placed), !world.wires.empty()), {}};
  exploded.world.styles = world.styles;
  for (const std::vector<MovedBody>& of_model : bodies)
    for (const MovedBody& body : of_model)
      if (const std::optional<Trace> trace = trace_of(body))
        exploded.traces.push_back(clipped(*trace, exploded.world.box));
  return exploded;
}

void expect_sound_moves(const scene::SceneDescription& scene) {
  std::vector<std::string> names;
  for (const scene::ViewDescription& view : scene.views) names.push_back(*view.name);
  for (const scene::ExplodeDescription& one : scene.explosions) {
    if (one.move.given() == one.factor.given())
      throw Error(ErrorKind::input, one.where,
                  one.move.given() ? "[[explode]] has both a move and a factor" : "[[explode]] has no move",
                  "give `move = [x, y, z]`, or a `factor` for moves outwards");
    if (one.view.given() && std::find(names.begin(), names.end(), *one.view) == names.end())
      throw Error(ErrorKind::input, one.view.where, "there is no view '" + *one.view + "'",
                  did_you_mean(*one.view, names));
  }
}

}  // namespace epura::world
