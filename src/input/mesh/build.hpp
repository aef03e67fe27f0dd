// SPDX-License-Identifier: Apache-2.0
// Soup -> Mesh: weld, drop invalid faces, triangulate, build the edge table, and add wires to it.
#pragma once

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// Never fails on imperfect data: dropped faces and open edges are reported. Throws OutOfTime. `step` is the distance
/// between neighbouring values of coordinates, 0 for full numbers; without it, the coordinates tell.
Mesh build_mesh(Soup soup, std::string name, const Progress& progress = {}, std::optional<double> step = {});

}  // namespace epura::mesh
