// SPDX-License-Identifier: Apache-2.0
// Soup -> Mesh: weld, drop invalid faces, triangulate, build the edge table, and add wires to it.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// Never fails on imperfect data: dropped faces and open edges are reported. Throws OutOfTime.
Mesh build_mesh(Soup soup, std::string name, const Progress& progress = {});

}  // namespace epura::mesh
