// SPDX-License-Identifier: Apache-2.0
// Edges that bound no face, as polylines: those that share a vertex share its point.
#pragma once

#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <vector>

#include "body_mesh.hpp"
#include "model.hpp"
#include "tessellation.hpp"

namespace occt {

struct Wire {
  TopoDS_Edge edge;
  Along along;  ///< a closed one repeats its first point at the end
};

struct WireMesh {
  std::vector<epura::plugin::Point> points;
  std::vector<Wire> wires;
};

/// Vertex numbers begin with `first_point`.
WireMesh mesh_of(const std::vector<TopoDS_Edge>& edges, std::uint32_t first_point, const Fineness& fineness);

}  // namespace occt
