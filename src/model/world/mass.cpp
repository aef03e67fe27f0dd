// SPDX-License-Identifier: Apache-2.0
#include "world/mass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace epura::world {

namespace {

constexpr double cubic_metre = 1e9;  // mm³
constexpr double flat = 1e-12;       // volume relative to that of the box

/// A shell while it is measured.
struct Shell {
  Solid solid;
  Box box;
  Vec3 moment{0};  ///< integral of the position over the volume, relative to the origin of the sum
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

// The smallest body around a shell that is turned inwards; null if there is none.
Shell* around(std::vector<Shell>& shells, const Shell& cavity) {
  Shell* best = nullptr;
  for (Shell& one : shells)
    if (one.solid.volume > 0 && is_inside(cavity.box, one.box) &&
        (best == nullptr || one.solid.volume < best->solid.volume))
      best = &one;
  return best;
}

std::vector<Shell> shells_of(const mesh::Mesh& mesh, const Mat4& to_world, const Vec3& origin) {
  std::vector<Shell> shells;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int body = mesh.body[static_cast<std::size_t>(t)];
    while (static_cast<int>(shells.size()) <= body) shells.push_back({{static_cast<int>(shells.size())}, {}});
    std::array<Vec3, 3> p;
    const auto corners = mesh.triangle(t);
    for (std::size_t i = 0; i < 3; ++i) p[i] = Vec3(to_world * Vec4(mesh.point(corners[i]), 1));
    add_triangle(shells[static_cast<std::size_t>(body)], p, origin);
  }
  return shells;
}

void turn(Shell& shell) {
  shell.solid.volume = -shell.solid.volume;
  shell.moment = -shell.moment;
}

// If the largest one is turned inwards, all are turned round.
void turn_outwards(std::vector<Shell>& shells) {
  const auto largest = std::max_element(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
    return std::abs(a.solid.volume) < std::abs(b.solid.volume);
  });
  if (largest == shells.end() || largest->solid.volume >= 0) return;
  for (Shell& shell : shells) turn(shell);
}

}  // namespace

std::vector<Solid> solids_of(const mesh::Mesh& mesh, const Mat4& to_world) {
  Box box;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int v : mesh.triangle(t)) box.add(Vec3(to_world * Vec4(mesh.point(v), 1)));
  const Vec3 origin = box.empty() ? Vec3(0) : box.centre();
  std::vector<Shell> shells = shells_of(mesh, to_world, origin);
  turn_outwards(shells);
  const std::vector<EdgeFaults> faults = faults_of(mesh, shells.size());
  std::vector<Solid> solids;
  std::vector<char> is_cavity(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    Shell& shell = shells[i];
    shell.solid.fault = fault_text(faults[i]);
    if (!shell.solid.fault.empty() || !(shell.solid.volume < 0)) continue;
    if (Shell* body = around(shells, shell)) {
      body->solid.volume += shell.solid.volume;
      body->solid.area += shell.solid.area;
      body->moment += shell.moment;
      is_cavity[i] = 1;
    } else {
      turn(shell);
      shell.solid.turned = true;
    }
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (is_cavity[i] != 0) continue;
    Solid& solid = solids.emplace_back(std::move(shells[i].solid));
    const Vec3 size = shells[i].box.empty() ? Vec3(0) : shells[i].box.size();
    if (solid.fault.empty() && !(solid.volume > flat * size.x * size.y * size.z)) solid.fault = "it encloses no volume";
    if (solid.fault.empty()) solid.centre = origin + shells[i].moment / solid.volume;
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
