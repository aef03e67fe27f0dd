// SPDX-License-Identifier: Apache-2.0
#include "world/mass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "base/portable_math.hpp"

namespace epura::world {

namespace {

constexpr double cubic_metre = 1e9;  // mm³
constexpr double flat = 1e-12;       // volume relative to that of the box

/// A shell while it is measured.
struct Shell {
  Solid solid;
  Box box;
  Vec3 moment{0};  ///< integral of the position over the volume, relative to the origin of the sum
  std::vector<int> triangles{};
};

/// Places of the corners of triangles.
struct Corners {
  const mesh::Mesh& mesh;
  const Mat4& to_world;

  [[nodiscard]] std::array<Vec3, 3> of(int triangle) const {
    std::array<Vec3, 3> places;
    const auto corners = mesh.triangle(triangle);
    for (std::size_t i = 0; i < 3; ++i) places[i] = Vec3(to_world * Vec4(mesh.point(corners[i]), 1));
    return places;
  }
};

/// Numbers of edges with a missing triangle, and of those that triangles do not use as often in one direction as in the
/// other.
struct EdgeFaults {
  int open = 0, turned = 0;
};

// Whether a triangle uses the edge from its first vertex to the second one.
bool runs_along(const mesh::Mesh& mesh, int triangle, const mesh::MeshEdge& edge) {
  const auto corners = mesh.triangle(triangle);
  for (std::size_t i = 0; i < 3; ++i)
    if (corners[i] == edge.vertex[0] && corners[(i + 1) % 3] == edge.vertex[1]) return true;
  return false;
}

std::vector<EdgeFaults> faults_of(const mesh::Mesh& mesh, std::size_t bodies) {
  std::vector<EdgeFaults> faults(bodies);
  for (const mesh::MeshEdge& edge : mesh.edges) {
    std::vector<std::pair<int, int>> uses;  // body, direction
    for (const int t : mesh.triangles_of(edge))
      uses.emplace_back(mesh.body[static_cast<std::size_t>(t)], runs_along(mesh, t, edge) ? 1 : -1);
    std::sort(uses.begin(), uses.end());
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
      int direction = 0;
      for (; end < uses.size() && uses[end].first == uses[begin].first; ++end) direction += uses[end].second;
      EdgeFaults& of_body = faults[static_cast<std::size_t>(uses[begin].first)];
      if ((end - begin) % 2 != 0)
        ++of_body.open;
      else if (direction != 0)
        ++of_body.turned;
    }
  }
  return faults;
}

std::string counted(int count, const std::string& what) {
  return "it has " + std::to_string(count) + " " + what + (count == 1 ? "edge" : "edges");
}

std::string fault_text(const EdgeFaults& faults) {
  if (faults.open > 0) return counted(faults.open, "open ");
  if (faults.turned > 0) return counted(faults.turned, "") + " between faces that are turned to different sides";
  return {};
}

// Sums over tetrahedra between each triangle and the middle of the model, so that little is lost far from the origin.
void add_triangle(Shell& shell, const std::array<Vec3, 3>& p, const Vec3& origin) {
  const Vec3 a = p[0] - origin, b = p[1] - origin, c = p[2] - origin;
  const double six = glm::dot(a, glm::cross(b, c));
  shell.solid.volume += six / 6;
  shell.moment += six / 24 * (a + b + c);
  shell.solid.area += glm::length(glm::cross(b - a, c - a)) / 2;
  for (const Vec3& corner : p) shell.box.add(corner);
}

bool is_inside(const Box& inner, const Box& outer) {
  return glm::all(glm::lessThan(outer.min, inner.min)) && glm::all(glm::lessThan(inner.max, outer.max));
}

// Whether the middle of the first triangle of a shell lies in what another one encloses, not on it: by the solid angle
// of that, which is 4 pi from within, 0 from outside, and 2 pi from a face.
bool is_enclosed(const Shell& inner, const Shell& outer, const Corners& corners) {
  if (!is_inside(inner.box, outer.box)) return false;
  const auto [p, q, r] = corners.of(inner.triangles.front());
  const Vec3 eye = (p + q + r) / 3.0;
  double angle = 0;
  for (const int triangle : outer.triangles) {
    const auto places = corners.of(triangle);
    const Vec3 a = places[0] - eye, b = places[1] - eye, c = places[2] - eye;
    const double length_a = glm::length(a), length_b = glm::length(b), length_c = glm::length(c);
    angle +=
        2 * portable_atan2(glm::dot(a, glm::cross(b, c)), length_a * length_b * length_c + glm::dot(a, b) * length_c +
                                                              glm::dot(b, c) * length_a + glm::dot(c, a) * length_b);
  }
  return std::abs(angle) > 3 * std::numbers::pi;
}

// For each triangle the first one of its shell: those of one body that edges connect.
std::vector<int> first_of_shells(const mesh::Mesh& mesh) {
  std::vector<int> first(static_cast<std::size_t>(mesh.triangle_count()));
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&](int t) {
    while (first[t] != t) t = first[t] = first[first[t]];
    return t;
  };
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const std::span<const int> triangles = mesh.triangles_of(edge);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        if (mesh.body[triangles[i]] != mesh.body[triangles[k]]) continue;
        const int one = root(triangles[i]), other = root(triangles[k]);
        first[std::max(one, other)] = std::min(one, other);
        break;
      }
  }
  for (int& t : first) t = root(t);
  return first;
}

std::vector<Shell> shells_of(const Corners& corners, const Vec3& origin) {
  const mesh::Mesh& mesh = corners.mesh;
  const std::vector<int> first = first_of_shells(mesh);
  std::vector<Shell> shells;
  std::vector<int> shell(first.size());  // of each triangle
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (first[t] == t) {
      shell[t] = static_cast<int>(shells.size());
      shells.push_back({{mesh.body[t]}, {}});
    } else {
      shell[t] = shell[first[t]];
    }
    add_triangle(shells[shell[t]], corners.of(t), origin);
    shells[shell[t]].triangles.push_back(t);
  }
  return shells;
}

void turn(Shell& shell) {
  shell.solid.volume = -shell.solid.volume;
  shell.moment = -shell.moment;
}

void add(Shell& body, const Shell& other) {
  body.solid.volume += other.solid.volume;
  body.solid.area += other.solid.area;
  body.solid.turned = body.solid.turned || other.solid.turned;
  body.moment += other.moment;
  body.box.add(other.box.min);
  body.box.add(other.box.max);
}

void subtract(Shell& body, Shell& cavity) {
  if (cavity.solid.volume > 0) turn(cavity);
  add(body, cavity);
}

// Turns all bodies outwards, and subtracts cavities from those that are around them: shells turned the other way round.
// Returns which shells are cavities.
std::vector<char> separate(std::vector<Shell>& shells, const Corners& corners) {
  std::vector<std::size_t> closed;
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (shells[i].solid.fault.empty() && shells[i].solid.volume != 0) closed.push_back(i);
  std::stable_sort(closed.begin(), closed.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(shells[a].solid.volume) > std::abs(shells[b].solid.volume);
  });
  std::vector<char> is_cavity(shells.size(), 0);
  std::array<std::vector<std::size_t>, 2> bodies;  // turned outwards, and inwards, the largest first
  for (const std::size_t i : closed) {
    Shell& shell = shells[i];
    const bool is_inwards = shell.solid.volume < 0;
    const std::vector<std::size_t>& others = bodies[is_inwards ? 0 : 1];
    const auto around = std::find_if(others.rbegin(), others.rend(),
                                     [&](std::size_t other) { return is_enclosed(shell, shells[other], corners); });
    if (around != others.rend()) {
      subtract(shells[*around], shell);
      is_cavity[i] = 1;
      continue;
    }
    bodies[is_inwards ? 1 : 0].push_back(i);
    if (is_inwards) turn(shell);
  }
  const bool is_mirrored = glm::determinant(Mat3(corners.to_world)) < 0;
  if (!bodies[0].empty() && !bodies[1].empty())
    for (const std::size_t i : bodies[is_mirrored ? 0 : 1]) shells[i].solid.turned = true;
  return is_cavity;
}

}  // namespace

std::vector<Solid> solids_of(const mesh::Mesh& mesh, const Mat4& to_world) {
  Box box;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int v : mesh.triangle(t)) box.add(Vec3(to_world * Vec4(mesh.point(v), 1)));
  const Vec3 origin = box.empty() ? Vec3(0) : box.centre();
  const Corners corners{mesh, to_world};
  std::vector<Shell> shells = shells_of(corners, origin);
  const int bodies = mesh.body.empty() ? 0 : *std::max_element(mesh.body.begin(), mesh.body.end()) + 1;
  const std::vector<EdgeFaults> faults = faults_of(mesh, static_cast<std::size_t>(bodies));
  for (Shell& shell : shells) shell.solid.fault = fault_text(faults[shell.solid.body]);
  const std::vector<char> is_cavity = separate(shells, corners);
  std::map<int, Shell> of_bodies;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (is_cavity[i] != 0) continue;
    const int number = shells[i].solid.body;
    const auto [body, is_first] = of_bodies.try_emplace(number, std::move(shells[i]));
    if (!is_first) add(body->second, shells[i]);
  }
  std::vector<Solid> solids;
  for (auto& [number, body] : of_bodies) {
    Solid& solid = solids.emplace_back(std::move(body.solid));
    const Vec3 size = body.box.empty() ? Vec3(0) : body.box.size();
    if (solid.fault.empty() && !(solid.volume > flat * size.x * size.y * size.z)) solid.fault = "it encloses no volume";
    if (solid.fault.empty()) solid.centre = origin + body.moment / solid.volume;
  }
  return solids;
}

double density_of(const World& world, int model, const scene::ModelDescription& description, int body) {
  if (const auto styles = world.styles_of(model); !styles.empty())
    if (const auto& density = styles[static_cast<std::size_t>(body)].density; density.given()) return *density;
  return description.density.value_or(0);
}

MassProperties sum_of(std::span<const Solid> solids, std::span<const double> densities) {
  MassProperties sum;
  const bool has_mass = std::all_of(densities.begin(), densities.end(), [](double density) { return density > 0; });
  double weights = 0, mass = 0;
  Vec3 moment(0);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const double weight = has_mass ? solids[i].volume * densities[i] : solids[i].volume;
    sum.volume += solids[i].volume;
    sum.area += solids[i].area;
    mass += solids[i].volume / cubic_metre * densities[i];
    moment += weight * solids[i].centre;
    weights += weight;
  }
  if (weights > 0) sum.centre = moment / weights;
  if (has_mass && !solids.empty()) sum.mass = mass;
  return sum;
}

}  // namespace epura::world
