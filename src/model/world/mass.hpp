// SPDX-License-Identifier: Apache-2.0
// Volume, area and centre of gravity of bodies, by the theorem of Gauss: exact for the mesh.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "world/world.hpp"

namespace epura::world {

/// A body with the cavities inside it. Units of the world.
struct Solid {
  int body;             ///< its number in the mesh
  std::string fault{};  ///< why it has no volume: "it has 3 open edges"; otherwise empty
  double volume = 0;
  double area = 0;
  Vec3 centre{0};       ///< of gravity, at constant density
  bool turned = false;  ///< its faces are turned inwards in the file, unlike those of other bodies
};

/// By number of the body; a shell turned inwards inside the box of another body is a cavity of that. Faces may be
/// turned outwards or, all of them, inwards. A shell turned inwards with no body around it is a body that was mirrored.
std::vector<Solid> solids_of(const mesh::Mesh& mesh, const Mat4& to_world);

/// The density of a body in kg/m³, of its style or its model; 0 if it has none.
double density_of(const World& world, int model, const scene::ModelDescription& description, int body);

/// The sum of several bodies.
struct MassProperties {
  double volume = 0, area = 0;
  std::optional<double> mass{};  ///< kg, if all have a density
  Vec3 centre{0};                ///< weighted by mass, or else by volume
};

/// `densities`: of the solids, kg/m³; a solid without one has 0. Lengths are mm. No solid may have a fault.
MassProperties sum_of(std::span<const Solid> solids, std::span<const double> densities);

}  // namespace epura::world
